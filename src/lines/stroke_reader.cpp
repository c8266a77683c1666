// The text of stroke styles: one function a setting.
#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/names.h"
#include "lines/stroke_style.h"
#include "lines/stroke_text.h"

namespace croquis::lines {
namespace {

constexpr double longest = 10000;  // any length, in its unit
constexpr double widest_factor = 100;
constexpr double finest_noise = 2;  // the smallest wiggle, in its unit
constexpr std::uint32_t most_passes = 16;
constexpr std::size_t most_wobbles = 4;
constexpr std::size_t most_dashes = 16;

// Reads a setting's values into the style.
using ReadSetting = void (*)(SettingReader&, StrokeStyle&);

struct Setting {
    const char* name;
    ReadSetting read;
    bool repeats = false;  // may stand more than once
};

bool yes_or_no(SettingReader& reader) {
    static const std::vector<std::string> words{"yes", "no"};
    return reader.choice(words) == 0;
}

void read_color(SettingReader& reader, StrokeStyle& style) {
    for (int i = 0; i < 3; ++i) style.color[i] = static_cast<float>(reader.number(0, 1));
}

void read_ends(SettingReader& reader, StrokeStyle& style) {
    static const std::vector<std::string> words{"round", "butt"};
    style.ends = static_cast<StrokeEnds>(reader.choice(words));
}

void read_taper(SettingReader& reader, StrokeStyle& style) {
    style.taper_start = style.taper_end = reader.length(0, longest);
    if (reader.has_more()) style.taper_end = reader.length(0, longest);
}

void read_overshoot(SettingReader& reader, StrokeStyle& style) {
    style.overshoot = reader.length(0, longest);
    if (reader.has_more()) style.overshoot_variation = reader.number(0, 1);
}

WidthRange width_range(SettingReader& reader) {
    const double from = reader.number(0, widest_factor);
    return {from, reader.number(0, widest_factor)};
}

// How large noise's wiggles are. A share or a multiple of widths would make them differ from line to line.
Length wiggle_size(SettingReader& reader) {
    const Length size = reader.length(finest_noise, longest);
    if (size.unit != Length::Unit::pixels && size.unit != Length::Unit::millimetres) {
        fail_at(reader.where(), "expected the size of wiggles in px or mm");
    }
    return size;
}

Variation variation(SettingReader& reader) {
    const double amount = reader.number(0, 1);
    return {amount, wiggle_size(reader)};
}

void read_wobble(SettingReader& reader, StrokeStyle& style) {
    if (style.wobbles.size() == most_wobbles) {
        fail_at(reader.where(), "expected \"wobble\" at most {} times", most_wobbles);
    }
    Wobble wobble;
    wobble.across = reader.length(0, longest);
    wobble.along = reader.length(0, longest);
    wobble.every = wiggle_size(reader);
    style.wobbles.push_back(wobble);
}

void read_passes(SettingReader& reader, StrokeStyle& style) {
    const double passes = reader.number(1, most_passes);
    style.passes = static_cast<std::uint32_t>(passes);
    if (style.passes != passes) fail_at(reader.where(), "expected a whole number, found {}", passes);
}

void read_corner_angle(SettingReader& reader, StrokeStyle& style) {
    style.corner_angle = reader.number(1, 180) * std::numbers::pi / 180;
}

void read_dash(SettingReader& reader, StrokeStyle& style) {
    double sum = 0;
    do {
        const Length length = reader.length(0, longest);
        if (style.dash.size() == most_dashes) {
            fail_at(reader.where(), "expected at most {} lengths of dashes and gaps", most_dashes);
        }
        style.dash.push_back(length);
        sum += style.dash.back().value;
    } while (reader.has_more());
    if (style.dash.size() % 2 != 0) {
        fail_at(reader.where(), "expected a gap after each dash, found an odd number of lengths");
    }
    if (sum <= 0) fail_at(reader.where(), "expected a dash or a gap longer than 0");
}

void read_offset_run(SettingReader& reader, StrokeStyle& style) {
    static const std::vector<std::string> words{"repeat", "fit", "once"};
    style.offset_run = static_cast<OffsetRun>(reader.choice(words));
}

void read_hidden(SettingReader& reader, StrokeStyle& style) {
    const auto layers = static_cast<std::size_t>(reader.number(1, 3));
    style.hidden_styles[layers - 1] = reader.file_word("the name of a style");
}

void read_class(SettingReader& reader, StrokeStyle& style) {
    std::vector<std::string> classes;
    for (const LineClassInfo& info : line_class_infos()) classes.emplace_back(info.name);
    const std::size_t line_class = reader.choice(classes);
    style.class_styles[line_class] = reader.file_word("the name of a style");
}

const std::vector<Setting>& settings() {
    using Reader = SettingReader;
    using Style = StrokeStyle;
    static const std::vector<Setting> all{
        {"help", [](Reader& r, Style& s) { s.help = r.text(); }},
        {"width", [](Reader& r, Style& s) { s.width = r.length(0, longest); }},
        {"full_width_from", [](Reader& r, Style& s) { s.full_width_from = r.length(0, longest); }},
        {"color", read_color},
        {"opacity", [](Reader& r, Style& s) { s.opacity = static_cast<float>(r.number(0, 1)); }},
        {"ends", read_ends},
        {"texture", [](Reader& r, Style& s) { s.texture = r.file_word("the name of an image"); }},
        {"taper", read_taper},
        {"taper_to", [](Reader& r, Style& s) { s.taper_to = r.number(0, 1); }},
        {"overshoot", read_overshoot},
        {"width_by_light", [](Reader& r, Style& s) { s.width_by_light = width_range(r); }},
        {"width_by_depth", [](Reader& r, Style& s) { s.width_by_depth = width_range(r); }},
        {"vary_width", [](Reader& r, Style& s) { s.vary_width = variation(r); }},
        {"vary_opacity", [](Reader& r, Style& s) { s.vary_opacity = variation(r); }},
        {"vary_color", [](Reader& r, Style& s) { s.vary_color = variation(r); }},
        {"wobble", read_wobble, true},
        {"passes", read_passes},
        {"corner_angle", read_corner_angle},
        {"dash", read_dash},
        {"dash_fit", [](Reader& r, Style& s) { s.dash_fit = yes_or_no(r); }},
        {"offsets", [](Reader& r, Style& s) { s.offsets = r.file_word("the name of an offset file"); }},
        {"offset_scale", [](Reader& r, Style& s) { s.offset_scale = r.number(0.1, widest_factor); }},
        {"offset_run", read_offset_run},
        {"hidden", read_hidden, true},
        {"class", read_class, true},
    };
    return all;
}

const Setting& setting_named(const SettingReader& reader) {
    std::vector<std::string> names;
    for (const Setting& setting : settings()) {
        if (reader.name() == setting.name) return setting;
        names.emplace_back(setting.name);
    }
    fail_at(reader.where(), "expected a setting, found {}{}", in_quotes(reader.name()),
            suggestion(reader.name(), names));
}

}  // namespace

StrokeStyle read_stroke_style(std::string_view text, const std::string& file_name) {
    SettingReader reader(text, file_name);
    StrokeStyle style;
    std::vector<std::size_t> set_in_line(settings().size(), 0);
    while (reader.next()) {
        const Setting& setting = setting_named(reader);
        std::size_t& line = set_in_line[static_cast<std::size_t>(&setting - settings().data())];
        if (line != 0 && !setting.repeats) {
            fail_at(reader.where(), "expected \"{}\" only once, found it in line {} already", setting.name, line);
        }
        line = reader.line_number();
        setting.read(reader, style);
        reader.expect_end();
    }
    if (!style.dash.empty() && !style.offsets.empty()) {
        fail("{}: expected either \"dash\" or \"offsets\", found both: breaks of an offset file make dashes too",
             file_name);
    }
    return style;
}

}  // namespace croquis::lines
