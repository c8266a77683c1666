#include "base/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include "base/error.h"

namespace croquis {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

bool write_all(std::FILE* file, std::span<const std::byte> bytes) {
    return std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
}

void write_standard_output(std::span<const std::byte> bytes) {
    if (!write_all(stdout, bytes)) fail("standard output: cannot write: {}", std::strerror(errno));
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

void check_place(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder_of(path), error)) {
        fail("{}: folder {} does not exist", path.string(), folder_of(path).string());
    }
    if (std::filesystem::is_directory(path, error)) fail("{}: expected a file name, found a folder", path.string());
}

// Devices and pipes cannot be renamed over: they are written to as they are.
bool is_special(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
}

std::filesystem::path part_beside(const std::filesystem::path& path) {
    return fmt::format("{}.part-{}", path.string(), ::getpid());
}

File opened_to_write(const std::filesystem::path& path, const std::filesystem::path& written) {
    File file(std::fopen(written.c_str(), "wb"));
    if (!file) fail("{}: cannot write: {}", path.string(), std::strerror(errno));
    return file;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::uintmax_t most_bytes) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) fail("{}: no such file", path.string());
    if (std::filesystem::is_directory(status)) fail("{}: expected a file, found a folder", path.string());
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) fail("{}: cannot open: {}", path.string(), std::strerror(errno));
    std::string bytes;
    if (std::filesystem::is_regular_file(status)) {
        const std::uintmax_t size = std::filesystem::file_size(path, error);
        if (!error && size <= most_bytes) bytes.reserve(size);
    }
    char buffer[1 << 16];
    while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, file.get())) {
        bytes.append(buffer, got);
        if (bytes.size() > most_bytes) fail("{}: larger than the {} bytes allowed here", path.string(), most_bytes);
    }
    if (std::ferror(file.get()) != 0) fail("{}: cannot read: {}", path.string(), std::strerror(errno));
    return bytes;
}

PartialFile::PartialFile(std::filesystem::path path) : path_(std::move(path)) {
    check_place(path_);
    written_ = is_special(path_) ? path_ : part_beside(path_);
}

PartialFile::~PartialFile() {
    std::error_code ignored;
    if (written_ != path_) std::filesystem::remove(written_, ignored);
}

void PartialFile::keep() {
    std::error_code error;
    if (written_ != path_) std::filesystem::rename(written_, path_, error);
    if (error) fail("{}: cannot write: {}", path_.string(), error.message());
    written_ = path_;
}

void write_file_whole(const std::filesystem::path& path, std::span<const std::byte> bytes) {
    if (path == "-") return write_standard_output(bytes);
    PartialFile partial(path);
    File file = opened_to_write(path, partial.written());
    const bool written = write_all(file.get(), bytes);
    int reason = errno;
    const bool closed = std::fclose(file.release()) == 0;
    if (written && !closed) reason = errno;
    if (!written || !closed) fail("{}: cannot write: {}", path.string(), std::strerror(reason));
    partial.keep();
}

void write_file_whole(const std::filesystem::path& path, std::string_view text) {
    write_file_whole(path, std::as_bytes(std::span(text)));
}

void check_writable(const std::filesystem::path& path) {
    if (path == "-") return;
    const PartialFile partial(path);
    if (partial.written() != path) opened_to_write(path, partial.written()).reset();
}

}  // namespace croquis
