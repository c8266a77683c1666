// What the data folders hold: component descriptors, and techniques by name.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "framework/data_folders.h"
#include "framework/descriptor.h"
#include "framework/technique_definition.h"

namespace croquis::framework {

class Library {
public:
    /// Reads all descriptors. Throws Error at the place of the first mistake.
    explicit Library(DataFolders folders);

    [[nodiscard]] const DataFolders& folders() const { return folders_; }
    [[nodiscard]] const Descriptors& descriptors() const { return descriptors_; }

    [[nodiscard]] std::vector<std::string> technique_names() const;

    /// Reads a technique by its name in the data folders or, when it ends in ".technique", by its path; the files it
    /// includes are then looked for beside it first. Throws Error with the nearest name.
    [[nodiscard]] TechniqueDefinition technique(const std::string& name_or_path) const;

    /// Reads a technique from its text. What it includes is looked for in the data folders. Throws Error, at places of
    /// "NAME.technique".
    [[nodiscard]] TechniqueDefinition technique_from_text(const std::string& name, const std::string& text) const;

private:
    DataFolders folders_;
    Descriptors descriptors_;
};

/// Carries out `pass.variable=value`, as the command line's --set has it, on a technique that is not open yet. Throws
/// Error with the nearest pass or variable.
void assign(TechniqueDefinition& technique, const std::string& assignment);

}  // namespace croquis::framework
