#include "framework/data_folders.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "base/error.h"

namespace croquis::framework {
namespace {

namespace fs = std::filesystem;

bool is_data_folder(const fs::path& folder) {
    std::error_code error;
    return fs::is_directory(folder / "components", error) && fs::is_directory(folder / "techniques", error);
}

// The folder of the shared library that this code is part of, wherever it was moved to; of the program where there is
// none.
fs::path library_folder() {
    static const char in_this_library = 0;
    Dl_info info{};
    if (dladdr(&in_this_library, &info) == 0 || info.dli_fname == nullptr) return {};
    std::error_code error;
    return fs::canonical(info.dli_fname, error).parent_path();
}

std::vector<fs::path> places_of_shipped_data() {
    std::vector<fs::path> places;
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (!error) {
        places.push_back(program.parent_path() / "data");
        places.push_back(program.parent_path().parent_path() / "share" / "croquis");
    }
    if (const fs::path library = library_folder(); !library.empty()) {
        places.push_back((library / CROQUIS_DATA_FROM_LIBRARY).lexically_normal());
    }
    places.emplace_back(CROQUIS_INSTALLED_DATA);
    places.emplace_back(CROQUIS_SOURCE_DATA);
    return places;
}

fs::path shipped_data() {
    if (const char* chosen = std::getenv("CROQUIS_DATA")) {
        if (!is_data_folder(chosen)) {
            fail("expected CROQUIS_DATA to name a folder with components and techniques, found \"{}\"", chosen);
        }
        return chosen;
    }
    const std::vector<fs::path> places = places_of_shipped_data();
    for (const fs::path& place : places) {
        if (is_data_folder(place)) return place;
    }
    std::string looked;
    for (const fs::path& place : places) looked += (looked.empty() ? "" : ", ") + place.string();
    fail("no data folder: looked in {}; set CROQUIS_DATA to where components and techniques are", looked);
}

bool lies_within(const fs::path& file, const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::canonical(file, error);
    if (error) return false;
    const fs::path base = fs::canonical(folder, error);
    if (error) return false;
    return std::mismatch(base.begin(), base.end(), whole.begin(), whole.end()).first == base.end();
}

}  // namespace

void check_stays_inside(const std::string& name) {
    const fs::path path(name);
    const bool climbs = std::any_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
    const bool is_odd = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == '\\'; });
    if (name.empty() || path.is_absolute() || climbs || is_odd) {
        fail("expected a name inside its data folder, found \"{}\"", name);
    }
}

DataFolders::DataFolders(std::vector<fs::path> folders) : folders_(std::move(folders)) {
    for (const fs::path& folder : folders_) {
        std::error_code error;
        if (!fs::is_directory(folder, error)) fail("{}: no such data folder", folder.string());
    }
}

DataFolders DataFolders::find(const std::vector<fs::path>& users_own) {
    std::vector<fs::path> folders = users_own;
    folders.push_back(shipped_data());
    return DataFolders(std::move(folders));
}

fs::path DataFolders::find(const std::string& kind, const std::string& name, const std::string& ending) const {
    check_stays_inside(name);
    for (const fs::path& folder : folders_) {
        const fs::path file = folder / kind / (name + ending);
        std::error_code error;
        if (!fs::is_regular_file(file, error)) continue;
        if (!lies_within(file, folder))
            fail("expected a name inside its data folder, found \"{}\", a link out of it", name);
        return file;
    }
    return {};
}

std::vector<std::string> DataFolders::names(const std::string& kind, const std::string& ending) const {
    std::set<std::string> names;
    for (const fs::path& folder : folders_) {
        std::error_code error;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / kind, error)) {
            if (entry.is_regular_file(error) && entry.path().extension() == ending)
                names.insert(entry.path().stem().string());
        }
    }
    return {names.begin(), names.end()};
}

}  // namespace croquis::framework
