// What stands behind the public handles.
#pragma once

#include "croquis/renderer.h"
#include "framework/technique.h"

namespace croquis {

struct Technique::Opened {
    framework::Technique technique;
};

}  // namespace croquis
