#include "model/mtl.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/log.h"
#include "model/readers.h"
#include "model/text_lines.h"

namespace croquis::model {
namespace {

/// The file name at the end of a map line, after options such as `-s 1 1 1` or `-clamp on`.
std::string_view map_file(std::string_view rest) {
    while (true) {
        rest = trimmed(rest);
        if (!rest.starts_with('-')) return rest;
        std::string_view after = rest;
        const std::string_view option = take_word(after);
        double number = 0;
        if (option == "-o" || option == "-s" || option == "-t") {
            for (int i = 0; i < 3 && take_number(after, number); ++i) continue;
        } else if (option == "-mm") {
            for (int i = 0; i < 2; ++i) static_cast<void>(take_word(after));
        } else if (option == "-blendu" || option == "-blendv" || option == "-bm" || option == "-boost" ||
                   option == "-cc" || option == "-clamp" || option == "-imfchan" || option == "-texres" ||
                   option == "-type") {
            static_cast<void>(take_word(after));
        } else {
            return rest;  // a file name that begins with a hyphen
        }
        rest = after;
    }
}

class MtlReader {
public:
    MtlReader(const std::filesystem::path& path, TextureFinder& textures, std::vector<Material>& materials)
        : lines_(path), textures_(textures), materials_(materials) {}

    void read() {
        std::string_view line;
        while (lines_.next(line)) {
            const std::string_view keyword = take_word(line);
            if (keyword == "newmtl") {
                close();
                current_ = Material{};
                current_->name = std::string(trimmed(line));
                current_->specular = glm::vec3(0.0f);
            } else if (current_) {
                read_value(keyword, line);
            }
        }
        close();
    }

private:
    void read_value(std::string_view keyword, std::string_view rest) {
        if (keyword == "Kd") color(rest, current_->diffuse);
        if (keyword == "Ks") color(rest, current_->specular);
        if (keyword == "Ka" && color(rest, current_->ambient)) has_ambient_ = true;
        if (keyword == "Ns") number(rest, current_->shininess);
        if (keyword == "d" && rest.find("-halo") == std::string_view::npos) {
            has_opacity_ = number(rest, current_->opacity);
        }
        if (keyword == "Tr" && !has_opacity_) {
            float transparency = 0;
            if (number(rest, transparency)) current_->opacity = 1 - transparency;
        }
        if (keyword == "map_Kd") diffuse_map_ = std::string(map_file(rest));
        if (keyword == "map_Ka") ambient_map_ = std::string(map_file(rest));
    }

    /// One grey or three values; anything else, a spectrum for one, is left alone.
    bool color(std::string_view rest, glm::vec3& value) {
        double red = 0, green = 0, blue = 0;
        if (!take_number(rest, red) || !std::isfinite(red)) return warn_of_number(), false;
        if (!take_number(rest, green) || !take_number(rest, blue)) green = blue = red;
        if (!std::isfinite(green) || !std::isfinite(blue)) return warn_of_number(), false;
        value = glm::clamp(glm::vec3(red, green, blue), 0.0f, 1.0f);
        return true;
    }

    bool number(std::string_view rest, float& value) {
        double given = 0;
        if (!take_number(rest, given) || !std::isfinite(given)) return warn_of_number(), false;
        value = static_cast<float>(given);
        return true;
    }

    void warn_of_number() { warn("{}: expected numbers, found none; line skipped", lines_.where().to_string()); }

    void close() {
        if (!current_) return;
        Material& material = *current_;
        material.shininess = sensible_shininess(material.shininess);
        material.opacity = std::clamp(material.opacity, 0.0f, 1.0f);
        const auto same = [&](const Material& other) { return other.name == material.name; };
        if (std::none_of(materials_.begin(), materials_.end(), same)) {
            const std::string& map = diffuse_map_.empty() ? ambient_map_ : diffuse_map_;
            if (!map.empty()) textures_.attach(material, map);
            // A black Kd under an image is an exporter's way to say "the image alone".
            if (material.texture && material.diffuse == glm::vec3(0.0f)) material.diffuse = glm::vec3(1.0f);
            material.ambient =
                has_ambient_ ? sensible_ambient(material.ambient, material.diffuse) : default_ambient(material.diffuse);
            materials_.push_back(std::move(material));
        }
        current_.reset();
        has_ambient_ = has_opacity_ = false;
        diffuse_map_.clear();
        ambient_map_.clear();
    }

    TextLines lines_;
    TextureFinder& textures_;
    std::vector<Material>& materials_;
    std::optional<Material> current_;
    bool has_ambient_ = false, has_opacity_ = false;
    std::string diffuse_map_, ambient_map_;
};

}  // namespace

void read_mtl(const std::filesystem::path& path, TextureFinder& textures, std::vector<Material>& materials) {
    MtlReader(path, textures, materials).read();
}

}  // namespace croquis::model
