// What goes wrong by a user's hand: a missing file, an unknown name, a value that makes no sense.
#pragma once

#include <stdexcept>
#include <string>

namespace croquis {

/// One line, complete in itself: what was expected, what was found and where. Text files are named as
/// `file:line:column`, and a mistyped name comes with the nearest one that exists.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace croquis
