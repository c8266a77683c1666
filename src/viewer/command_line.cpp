#include "viewer/command_line.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/names.h"

namespace croquis::viewer {
namespace {

std::string text_of(const Vector3& v) { return fmt::format("{},{},{}", v[0], v[1], v[2]); }

std::string text_of(const Light& light) {
    switch (light.bound) {
        case Light::Bound::viewer:
            return "viewer:" + text_of(light.place);
        case Light::Bound::point:
            return "point:" + text_of(light.place);
        case Light::Bound::world:
            break;
    }
    return "world:" + text_of(light.place);
}

std::optional<double> number(const std::string& word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

double read_number(const std::string& option, const std::string& word) {
    if (const auto value = number(word)) return *value;
    fail("{}: expected a number, found \"{}\"", option, word);
}

Vector3 read_vector(const std::string& option, const std::string& word) {
    const std::vector<std::string> words = split(word, ",");
    Vector3 vector{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = words.size() == 3 ? number(words[i]) : std::nullopt;
        if (!value) fail("{}: expected X,Y,Z, found \"{}\"", option, word);
        vector[i] = *value;
    }
    return vector;
}

void read_light(const std::string& option, const std::string& word, Light& light) {
    const std::size_t colon = word.find(':');
    const std::string kind = colon == std::string::npos ? "world" : word.substr(0, colon);
    if (kind != "viewer" && kind != "world" && kind != "point") {
        fail("{}: expected viewer:, world: or point:X,Y,Z, found \"{}\"", option, word);
    }
    light.place = read_vector(option, colon == std::string::npos ? word : word.substr(colon + 1));
    light.bound = kind == "viewer" ? Light::Bound::viewer : kind == "point" ? Light::Bound::point : Light::Bound::world;
}

bool read_option(const std::string& option, const std::string& word, View& view, Light& light) {
    if (option == "--eye") {
        view.eye = read_vector(option, word);
    } else if (option == "--target") {
        view.target = read_vector(option, word);
    } else if (option == "--up") {
        view.up = read_vector(option, word);
    } else if (option == "--fov") {
        view.field_of_view = read_number(option, word);
    } else if (option == "--projection") {
        if (word != "perspective" && word != "parallel") {
            fail("{}: expected perspective or parallel, found \"{}\"", option, word);
        }
        view.parallel = word == "parallel";
    } else if (option == "--light") {
        read_light(option, word, light);
    } else if (option == "--light-color") {
        light.color = read_vector(option, word);
    } else {
        return false;
    }
    return true;
}

glm::dvec3 vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

// What an arrangement can stand on.
void check(const View& view) {
    constexpr double least_field = 1, most_field = 170;
    if (!(view.field_of_view >= least_field && view.field_of_view <= most_field)) {
        fail("--fov: expected {} to {} degrees, found {}", least_field, most_field, view.field_of_view);
    }
    if (!view.eye || !view.target) return;
    const glm::dvec3 sight = vector(*view.target) - vector(*view.eye);
    if (glm::length(sight) == 0) fail("--eye: expected it away from the target, found both at {}", text_of(*view.eye));
    const double across = glm::length(glm::cross(sight, vector(view.up)));
    if (!(across > 1e-9 * glm::length(sight) * glm::length(vector(view.up)))) {
        fail("--up: expected a direction across the line of sight, found {}", text_of(view.up));
    }
}

// A name that begins with a dash would be an option.
std::string path_word(const std::string& path) { return shell_word(path.starts_with('-') ? "./" + path : path); }

}  // namespace

std::string shell_word(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n'\"\\$&|;<>()*?`~#!{}[]") == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string camera_and_light(const View& view, const Light& light) {
    std::string text;
    if (view.eye) text += fmt::format("--eye {} ", text_of(*view.eye));
    if (view.target) text += fmt::format("--target {} ", text_of(*view.target));
    text += fmt::format("--up {} --fov {} --projection {} --light {}", text_of(view.up), view.field_of_view,
                        view.parallel ? "parallel" : "perspective", text_of(light));
    if (light.color != Vector3{1, 1, 1}) text += fmt::format(" --light-color {}", text_of(light.color));
    return text;
}

void read_camera_and_light(const std::string& text, View& view, Light& light) {
    const std::vector<std::string> words = split(text, " \t\r\n");
    View new_view = view;
    Light new_light = light;
    bool is_any = false;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (read_option(words[i], words[i + 1], new_view, new_light)) {
            is_any = true;
            ++i;
        }
    }
    if (!is_any) fail("expected a camera or a light, as --eye X,Y,Z, found none");
    check(new_view);
    const bool has_direction = new_light.bound != Light::Bound::point;
    if (has_direction && glm::length(vector(new_light.place)) == 0)
        fail("--light: expected it away from 0,0,0, found 0,0,0");
    view = new_view;
    light = new_light;
}

std::string render_command(const std::string& model, const std::string& texture, const std::string& technique,
                           const std::map<std::string, std::string>& values, const DrawOptions& options,
                           const std::vector<std::string>& data_folders) {
    std::string command = fmt::format("croquis render {} -t {}", path_word(model), path_word(technique));
    for (const std::string& folder : data_folders) command += " --data " + path_word(folder);
    for (const auto& [variable, value] : values) command += " --set " + shell_word(variable + "=" + value);
    command += fmt::format(" --size {}x{} --samples {} {}", options.width, options.height, options.samples,
                           camera_and_light(options.view, options.light));
    if (!texture.empty()) command += " --texture " + path_word(texture);
    if (!options.animation.empty()) {
        command += fmt::format(" --animation {} --time {}", shell_word(options.animation), options.time);
    }
    if (options.background) {
        const Background& background = *options.background;
        const std::string said = background.transparent       ? "transparent"
                                 : background.texture.empty() ? text_of(background.color)
                                                              : background.texture;
        command += " --background " + shell_word(said);
    }
    return command + " -o drawing.png";
}

}  // namespace croquis::viewer
