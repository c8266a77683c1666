#include "parse.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/error.h"
#include "base/names.h"

namespace croquis::app {
namespace {

// A finite number that is the whole text.
bool parse_number(const std::string& text, double& number) {
    if (text.empty()) return false;
    char* end = nullptr;
    number = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size() && std::isfinite(number);
}

bool parse_numbers(const std::string& text, Vector3& numbers) {
    const std::vector<std::string> words = split(text, ", ");
    if (words.size() != 3) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!parse_number(words[i], numbers[i])) return false;
    }
    return true;
}

bool parse_side(const std::string& text, int& side) {
    double number = 0;
    if (!parse_number(text, number) || number < 1 || number > 1e9 || number != std::floor(number)) return false;
    side = int(number);
    return true;
}

bool parse_hexadecimal(const std::string& text, Vector3& color) {
    if (text.front() != '#' || (text.size() != 4 && text.size() != 7)) return false;
    if (text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) return false;
    const std::size_t digits = text.size() == 4 ? 1 : 2;
    for (std::size_t i = 0; i < 3; ++i) {
        std::string channel = text.substr(1 + i * digits, digits);
        if (digits == 1) channel += channel;
        color[i] = double(std::strtol(channel.c_str(), nullptr, 16)) / 255.0;
    }
    return true;
}

struct NamedColor {
    const char* name;
    Vector3 color;
};
constexpr std::array<NamedColor, 8> named_colors{{{"white", {1, 1, 1}},
                                                  {"black", {0, 0, 0}},
                                                  {"grey", {0.5, 0.5, 0.5}},
                                                  {"gray", {0.5, 0.5, 0.5}},
                                                  {"red", {1, 0, 0}},
                                                  {"green", {0, 0.6, 0}},
                                                  {"blue", {0, 0, 1}},
                                                  {"yellow", {1, 1, 0}}}};

}  // namespace

Vector3 parse_vector(const std::string& text, const std::string& what) {
    Vector3 numbers{};
    if (!parse_numbers(text, numbers)) fail("{}: expected three numbers as X,Y,Z, found \"{}\"", what, text);
    return numbers;
}

Size parse_size(const std::string& text, const std::string& what) {
    const std::vector<std::string> words = split(text, "xX");
    Size size;
    if (words.size() != 2 || !parse_side(words[0], size.width) || !parse_side(words[1], size.height)) {
        fail("{}: expected a size in pixels as WIDTHxHEIGHT, found \"{}\"", what, text);
    }
    return size;
}

Vector3 parse_color(const std::string& text, const std::string& what) {
    Vector3 color{};
    std::vector<std::string> names;
    for (const NamedColor& named : named_colors) {
        if (text == named.name) return named.color;
        names.emplace_back(named.name);
    }
    if (text.empty() || !(parse_hexadecimal(text, color) || parse_numbers(text, color))) {
        fail("{}: expected a colour as R,G,B from 0 to 1, #RRGGBB or a name, found \"{}\"{}", what, text,
             suggestion(text, names));
    }
    for (const double channel : color) {
        if (channel < 0 || channel > 1) fail("{}: expected R,G,B from 0 to 1, found \"{}\"", what, text);
    }
    return color;
}

Vector3 parse_view(const std::string& text) {
    Vector3 direction{};
    if (parse_numbers(text, direction)) return direction;
    const bool is_number_like = text.find(',') != std::string::npos;
    if (is_number_like) fail("--view: expected a name or a direction as X,Y,Z, found \"{}\"", text);
    return View::named(text).direction;
}

Light parse_light(const std::string& text) {
    Light light;
    light.bound = Light::Bound::world;
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) {
        const std::string bound = text.substr(0, colon);
        const std::vector<std::string> bounds{"viewer", "world", "point"};
        if (bound == "viewer") {
            light.bound = Light::Bound::viewer;
        } else if (bound == "point") {
            light.bound = Light::Bound::point;
        } else if (bound != "world") {
            fail("--light: expected viewer:, world: or point: before X,Y,Z, found \"{}\"{}", text,
                 suggestion(bound, bounds));
        }
    }
    light.place = parse_vector(colon == std::string::npos ? text : text.substr(colon + 1), "--light");
    return light;
}

Background parse_background(const std::string& text) {
    Background background;
    if (text == "transparent") {
        background.transparent = true;
        background.color = {0, 0, 0};
    } else if (text.find(':') != std::string::npos) {
        background.texture = text;
    } else {
        background.color = parse_color(text, "--background");
    }
    return background;
}

Picture::Difference parse_threshold(const std::string& text) {
    const std::vector<std::string> words = split(text, ",");
    double mean = 0, maximum = 255;
    const bool is_good = (words.size() == 1 || words.size() == 2) && parse_number(words[0], mean) && mean >= 0 &&
                         (words.size() == 1 || (parse_number(words[1], maximum) && maximum >= 0));
    if (!is_good) fail("--threshold: expected MEAN or MEAN,MAXIMUM from 0 to 255, found \"{}\"", text);
    return {mean, int(maximum)};
}

std::string check_number(const std::string& text) {
    double number = 0;
    return parse_number(text, number) ? "" : fmt::format("expected a number, found \"{}\"", text);
}

std::string check_whole_number(const std::string& text) {
    constexpr std::size_t most_digits = 18;
    const bool is_good =
        !text.empty() && text.size() <= most_digits && text.find_first_not_of("0123456789") == std::string::npos;
    return is_good ? "" : fmt::format("expected a whole number, found \"{}\"", text);
}

}  // namespace croquis::app
