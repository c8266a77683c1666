#include "viewer/file_watch.h"

#include <functional>
#include <string>
#include <system_error>
#include <utility>

namespace croquis::viewer {
namespace {

namespace fs = std::filesystem;

// Sums do not depend on the order in which a folder lists its files.
std::uint64_t signature_of(const fs::path& file) {
    std::error_code error;
    const auto time = fs::last_write_time(file, error).time_since_epoch().count();
    if (error) return 0;
    const std::uintmax_t size = fs::file_size(file, error);
    return std::hash<std::string>()(file.string() + '|' + std::to_string(time) + '|' + std::to_string(size));
}

std::uint64_t signature_of_folder(const fs::path& folder) {
    std::uint64_t sum = 0;
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) sum += signature_of(entry->path());
    }
    return sum;
}

}  // namespace

void FileWatch::watch(std::vector<fs::path> places) {
    places_ = std::move(places);
    last_ = signature();
}

std::uint64_t FileWatch::signature() const {
    std::uint64_t sum = 0;
    for (const fs::path& place : places_) {
        std::error_code error;
        sum += fs::is_directory(place, error) ? signature_of_folder(place) : signature_of(place);
    }
    return sum;
}

bool FileWatch::has_changed() {
    const std::uint64_t now = signature();
    return std::exchange(last_, now) != now;
}

}  // namespace croquis::viewer
