// Noticing that files changed on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace croquis::viewer {

/// Watches whole folders and single files by their files' names, times and sizes. A file that is new counts as a
/// change: it may be what a technique missed.
class FileWatch {
public:
    /// Begins anew with these; none of them need exist.
    void watch(std::vector<std::filesystem::path> places);

    /// True when anything changed since the last call, or since `watch`. Reads some hundred entries: not for every
    /// frame.
    [[nodiscard]] bool has_changed();

private:
    [[nodiscard]] std::uint64_t signature() const;

    std::vector<std::filesystem::path> places_;
    std::uint64_t last_ = 0;
};

}  // namespace croquis::viewer
