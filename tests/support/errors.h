// The text of the error that something throws.
#pragma once

#include <string>

#include "base/error.h"

namespace croquis::test_support {

/// What `act` throws as an Error; "no error" where it throws none.
template <typename Act>
[[nodiscard]] std::string error_of(const Act& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// A text with a part taken out wherever it stands: messages without their folder.
[[nodiscard]] inline std::string without(std::string text, const std::string& part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) text.erase(at, part.size());
    return text;
}

}  // namespace croquis::test_support
