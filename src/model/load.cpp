// The table of formats.
#include "model/load.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/names.h"
#include "model/readers.h"

namespace croquis::model {
namespace {

struct Format {
    const char* ending;
    RawModel (*read)(const std::filesystem::path& path, const Progress& progress);
};

constexpr Format formats[] = {
    {".obj", read_obj},
    {".md2", read_md2},
    {".wrl", read_vrml},
    {".off", read_through_assimp},
    {".ase", read_through_assimp},
    {".ply", read_ply},
    {".stl", read_through_assimp},
    {".gltf", read_through_assimp},
    {".glb", read_through_assimp},
    {".3ds", read_through_assimp},
};

/// How much of the time reading takes; the rest is for finishing.
constexpr double reading_share = 0.6;

std::string lower_ending(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

void check_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) fail("{}: no such file", path.string());
    if (std::filesystem::is_directory(path, error)) fail("{}: expected a file, found a folder", path.string());
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (!error && size > largest_file) fail("{}: larger than the {} bytes allowed here", path.string(), largest_file);
}

[[noreturn]] void fail_ending(const std::filesystem::path& path, const std::string& ending) {
    const std::vector<std::string> endings = readable_endings();
    fail("{}: expected a model file ({}), found {}{}", path.string(), fmt::join(endings, " "),
         ending.empty() ? "no ending" : "ending " + ending, ending.empty() ? "" : suggestion(ending, endings));
}

}  // namespace

std::shared_ptr<const Model> load(const std::filesystem::path& path, const LoadOptions& options) {
    const std::string ending = lower_ending(path);
    for (const Format& format : formats) {
        if (ending != format.ending) continue;
        check_file(path);
        const Progress& progress = options.progress;
        progress.reach(0);
        LoadOptions rest = options;
        rest.progress = progress.part(reading_share, 1);
        auto model = finish(format.read(path, progress.part(0, reading_share)), path.string(), rest);
        progress.reach(1);
        return model;
    }
    fail_ending(path, ending);
}

std::vector<std::string> readable_endings() {
    std::vector<std::string> endings;
    for (const Format& format : formats) endings.emplace_back(format.ending);
    return endings;
}

}  // namespace croquis::model
