#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "base/log.h"

namespace croquis::app {

Progress::Progress(std::size_t total) : total_(total), is_shown_(total > 1 && ::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    if (is_shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::next(const std::string& what) {
    ++done_;
    if (is_shown_) fmt::print(stderr, "\r\033[K[{}/{}] {}", done_, total_, what);
}

void report(const std::string& line) {
    if (::isatty(STDERR_FILENO) != 0) fmt::print(stderr, "{}\n", line);
}

void complain(const std::string& message) { fmt::print(stderr, "croquis: {}\n", printable(message)); }

}  // namespace croquis::app
