// Short ways to read descriptors and techniques from text in tests.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "framework/descriptor.h"
#include "framework/technique_definition.h"

namespace croquis::framework {

/// One layer of one file named "file".
inline Descriptors descriptors_of(const std::string& text) {
    const std::vector<std::vector<Descriptors::Source>> layers{{{"file", text}}};
    return Descriptors(layers);
}

/// A technique "t" in a file named "file", which finds `others` by name.
inline TechniqueDefinition technique_of(const std::string& text, const Descriptors& descriptors,
                                        const std::map<std::string, std::string>& others = {}) {
    return read_technique("t", {"file", text}, descriptors, [&](const std::string& name) -> Descriptors::Source {
        const auto found = others.find(name);
        if (found == others.end()) fail("unknown technique \"{}\"", name);
        return {name, found->second};
    });
}

/// What the action throws as Error; "no error" if nothing.
inline std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// What the action prints to standard error.
inline std::string printed_by(const std::function<void()>& action) {
    testing::internal::CaptureStderr();
    action();
    return testing::internal::GetCapturedStderr();
}

}  // namespace croquis::framework
