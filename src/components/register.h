// The one place where core components are registered.
#pragma once

#include "framework/component.h"

namespace croquis::components {

/// All core components, by the name of their descriptor.
[[nodiscard]] framework::ComponentTable core_components();

}  // namespace croquis::components
