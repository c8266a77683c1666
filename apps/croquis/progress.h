// Progress on a terminal; nothing in a pipe.
#pragma once

#include <cstddef>
#include <string>

namespace croquis::app {

/// A line on standard error that counts through a known number of things. Silent unless standard error is a terminal.
class Progress {
public:
    explicit Progress(std::size_t total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Says what is being worked on now.
    void next(const std::string& what);

    /// Takes the line away, before something else is printed.
    void clear();

private:
    std::size_t total_;
    std::size_t done_ = 0;
    bool is_shown_;
};

/// Says on a terminal what was written; quiet in pipes.
void report(const std::string& line);

/// Says on standard error what went wrong, as one line: control characters, of a hostile file for one, are shown as
/// \xNN.
void complain(const std::string& message);

}  // namespace croquis::app
