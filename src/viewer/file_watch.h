// Noticing that files changed on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace croquis::viewer {

/// Watches whole folders and single files by their files' names, times and sizes. A file that is new counts as a
/// change: it may be what a technique missed.
class FileWatch {
public:
    /// From now on these; none of them need exist. What changed in those that were watched before is not forgotten.
    void watch(const std::vector<std::filesystem::path>& places);

    /// True when anything changed since the last call, or since it is watched. Reads some hundred entries: not for
    /// every frame.
    [[nodiscard]] bool has_changed();

private:
    std::map<std::filesystem::path, std::uint64_t> last_;  // a signature of each place
};

}  // namespace croquis::viewer
