// Reading whole files with a bound on their size, and writing files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace croquis {

/// The bytes of a file. Throws Error when it cannot be read, is not a regular file or is larger than `most_bytes`.
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes);

/// A file that something else writes, to `written()`, which lies beside its path; `keep` puts it in its place. Without
/// that nothing is left behind. Devices and pipes cannot be replaced: they are written to as they are.
class PartialFile {
public:
    /// Throws Error when the folder is missing or the path names one. Creates nothing.
    explicit PartialFile(std::filesystem::path path);
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    [[nodiscard]] const std::filesystem::path& written() const { return written_; }
    /// The file is complete. Throws Error when it cannot take its place.
    void keep();

private:
    std::filesystem::path path_, written_;
};

/// Writes a file beside `path` and renames it when all bytes are down, so that nobody ever sees half of it. The path
/// "-" is standard output. Throws Error when the folder is missing, the disk is full or the file cannot be replaced;
/// then nothing is left behind.
void write_file_whole(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file_whole(const std::filesystem::path& path, std::string_view text);

/// Throws the Error that `write_file_whole` would throw for this path, before there is anything to write. Writes
/// nothing.
void check_writable(const std::filesystem::path& path);

}  // namespace croquis
