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
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) sum += signature_of(entry->path());
    }
    return sum;
}

std::uint64_t signature_of_place(const fs::path& place) {
    std::error_code error;
    return fs::is_directory(place, error) ? signature_of_folder(place) : signature_of(place);
}

}  // namespace

void FileWatch::watch(const std::vector<fs::path>& places) {
    std::map<fs::path, std::uint64_t> signatures;
    for (const fs::path& place : places) {
        const auto known = last_.find(place);
        signatures[place] = known != last_.end() ? known->second : signature_of_place(place);
    }
    last_ = std::move(signatures);
}

bool FileWatch::has_changed() {
    bool has_changed = false;
    for (auto& [place, last] : last_) {
        const std::uint64_t now = signature_of_place(place);
        has_changed = std::exchange(last, now) != now || has_changed;
    }
    return has_changed;
}

}  // namespace croquis::viewer
