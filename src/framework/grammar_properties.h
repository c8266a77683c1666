// The properties of a variable: from settings in a descriptor file to a VariableDescriptor (seed C, 2.2.2).
#pragma once

#include <string>

#include "framework/descriptor.h"
#include "framework/grammar.h"

namespace croquis::framework {

/// Gives the variable the statement's properties and checks that its default, ranges and choices agree. Throws Error
/// at the place of the first mistake.
void apply_properties(VariableDescriptor& variable, const VariableStatement& statement, const std::string& file);

}  // namespace croquis::framework
