// All of Croquis in one header: load a model, open a technique, set its variables, draw, save; or draw in lines.
#pragma once

#include "croquis/error.h"
#include "croquis/face_orientation.h"
#include "croquis/lines.h"
#include "croquis/model.h"
#include "croquis/pass_variable.h"
#include "croquis/picture.h"
#include "croquis/renderer.h"
#include "croquis/view.h"
