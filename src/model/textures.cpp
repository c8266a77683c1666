#include "model/textures.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"

namespace croquis::model {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// The entry of a folder whose name equals `name` but for letter case; empty when there is none.
fs::path same_but_for_case(const fs::path& folder, const std::string& name) {
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (lower(entry->path().filename().string()) == lower(name)) found.push_back(entry->path());
    }
    return found.empty() ? fs::path() : *std::min_element(found.begin(), found.end());
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

/// `relative` under `folder`, part by part, without regard to letter case.
fs::path find_without_case(fs::path folder, const fs::path& relative) {
    for (const fs::path& part : relative) {
        if (part == "." || part.empty()) continue;
        folder = part == ".." ? folder / part : same_but_for_case(folder, part.string());
        if (folder.empty()) return {};
    }
    return is_file(folder) ? folder : fs::path();
}

bool is_absolute(const std::string& name) {
    return name.starts_with('/') || (name.size() > 1 && name[1] == ':');  // C:/…
}

}  // namespace

image::Image read_texture(const fs::path& path) {
    if (lower(path.extension().string()) != ".pcx") return image::read(path);
    constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 28;
    const std::string bytes = read_file(path, most_bytes);
    return decode_pcx(std::as_bytes(std::span(bytes)), path.string());
}

TextureFinder::TextureFinder(const fs::path& model_file)
    : model_name_(model_file.string()),
      folder_(model_file.has_parent_path() ? model_file.parent_path() : fs::path(".")) {}

fs::path TextureFinder::find(const std::string& name) const {
    std::string slashed = name.substr(0, name.find('\0'));
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    if (slashed.empty() || slashed.size() > 1000) return {};
    if (!is_absolute(slashed)) {
        if (is_file(folder_ / slashed)) return folder_ / slashed;
        if (const fs::path found = find_without_case(folder_, slashed); !found.empty()) return found;
    }
    return find_without_case(folder_, fs::path(slashed).filename());
}

void TextureFinder::attach(Material& material, const std::string& name) {
    const fs::path path = find(name);
    if (path.empty()) return warn("{}: texture {} not found; drawn without it", model_name_, name);
    const auto [entry, is_new] = images_.try_emplace(path);
    if (is_new) {
        try {
            entry->second = std::make_shared<const image::Image>(read_texture(path));
        } catch (const Error& error) {
            warn("{}; drawn without it", error.what());
        }
    }
    if (!entry->second) return;
    material.texture = entry->second;
    material.texture_name = path.string();
}

}  // namespace croquis::model
