#include "viewer/settings.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"

namespace croquis::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<Moves, const char*>, 3> names_of_moves{
    {{Moves::object, "object"}, {Moves::camera, "camera"}, {Moves::light, "light"}}};
constexpr std::array<std::pair<LightStaysWith, const char*>, 3> names_of_companions{
    {{LightStaysWith::viewer, "viewer"}, {LightStaysWith::object, "object"}, {LightStaysWith::world, "world"}}};

template <typename Choice, std::size_t n>
const char* name_of(Choice choice, const std::array<std::pair<Choice, const char*>, n>& names) {
    return std::find_if(names.begin(), names.end(), [&](const auto& pair) { return pair.first == choice; })->second;
}

/// Takes values from a table, each only where it has the right type and makes sense.
class TableReader {
public:
    TableReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

    template <typename T>
    void read(const char* key, T& value, double least = 0, double most = 1) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return;
        if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>) {
            if (const auto found = node->value_exact<T>())
                value = *found;
            else
                refuse(key, *node);
        } else {
            const auto found = node->value<double>();
            if (found && *found >= least && *found <= most)
                value = T(*found);
            else
                refuse(key, *node);
        }
    }

    template <typename Choice, std::size_t n>
    void read(const char* key, Choice& value, const std::array<std::pair<Choice, const char*>, n>& names) {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return;
        const std::string word = node->value_or(std::string());
        for (const auto& [choice, name] : names) {
            if (word == name) {
                value = choice;
                return;
            }
        }
        refuse(key, *node);
    }

    void read(const char* key, std::vector<std::string>& values) {
        const toml::array* array = table_[key].as_array();
        if (array == nullptr) return;
        for (const toml::node& node : *array) {
            if (const auto text = node.value<std::string>()) values.push_back(*text);
        }
    }

private:
    void refuse(const char* key, const toml::node& node) {
        warn("{}:{}:{}: {} cannot be that; using what it is without", file_, node.source().begin.line,
             node.source().begin.column, key);
    }

    const toml::table& table_;
    std::string file_;
};

}  // namespace

void Settings::remember_model(const std::string& path) {
    std::erase(recent_models, path);
    recent_models.insert(recent_models.begin(), path);
    if (recent_models.size() > most_recent) recent_models.resize(most_recent);
}

fs::path Settings::default_path() {
    const auto folder = [](const char* variable) -> fs::path {
        const char* value = std::getenv(variable);
        return value != nullptr ? value : "";
    };
    if (const fs::path configuration = folder("XDG_CONFIG_HOME"); !configuration.empty()) {
        return configuration / "croquis" / "viewer.toml";
    }
    const fs::path home = folder("HOME");
    return home.empty() ? fs::path() : home / ".config" / "croquis" / "viewer.toml";
}

Settings Settings::load(const fs::path& path) {
    Settings settings;
    std::error_code error;
    if (path.empty() || !fs::exists(path, error)) return settings;
    try {
        constexpr std::uintmax_t most_bytes = 1 << 20;
        const toml::table table = toml::parse(read_file(path, most_bytes), path.string());
        TableReader reader(table, path.string());
        reader.read("recent_models", settings.recent_models);
        reader.read("technique", settings.technique);
        reader.read("window_width", settings.window_width, 1, 32768);
        reader.read("window_height", settings.window_height, 1, 32768);
        reader.read("ui_scale", settings.ui_scale, 0, 4);
        reader.read("samples", settings.samples, 1, 16);
        reader.read("least_frame_rate", settings.least_frame_rate, 0, 1000);
        reader.read("shows_panels", settings.shows_panels);
        reader.read("shows_overlay", settings.shows_overlay);
        reader.read("has_inertia", settings.has_inertia);
        reader.read("video", settings.video);
        reader.read("moves", settings.moves, names_of_moves);
        reader.read("light_stays_with", settings.light_stays_with, names_of_companions);
    } catch (const toml::parse_error& mistake) {
        warn("{}:{}:{}: {}", path.string(), mistake.source().begin.line, mistake.source().begin.column,
             mistake.description());
    } catch (const Error& mistake) {
        warn(mistake.what());
    }
    return settings;
}

void Settings::save(const fs::path& path) const {
    toml::array recent;
    for (const std::string& model : recent_models) recent.push_back(model);
    const toml::table table{{"recent_models", recent},
                            {"technique", technique},
                            {"window_width", window_width},
                            {"window_height", window_height},
                            {"ui_scale", ui_scale},
                            {"samples", samples},
                            {"least_frame_rate", least_frame_rate},
                            {"shows_panels", shows_panels},
                            {"shows_overlay", shows_overlay},
                            {"has_inertia", has_inertia},
                            {"video", video},
                            {"moves", name_of(moves, names_of_moves)},
                            {"light_stays_with", name_of(light_stays_with, names_of_companions)}};
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    std::ostringstream text;
    text << table << '\n';
    write_file_whole(path, text.str());
}

}  // namespace croquis::viewer
