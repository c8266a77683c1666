#include "lines/stroke_styles.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "lines/stroke_text.h"

namespace croquis::lines {
namespace fs = std::filesystem;

StrokeStyles::StrokeStyles(std::vector<fs::path> folders) : folders_(std::move(folders)) {}

std::vector<std::string> StrokeStyles::names() const { return names_ending(".stroke"); }

std::vector<std::string> StrokeStyles::names_ending(const std::string& ending) const {
    std::vector<std::string> names;
    for (const fs::path& folder : folders_) {
        std::error_code error;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
            if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

// Only names that a folder lists are found, so that none leads out of it.
fs::path StrokeStyles::find(const std::string& kind, const std::string& name, const std::string& ending) const {
    const std::vector<std::string> names = names_ending(ending);
    if (std::binary_search(names.begin(), names.end(), name)) {
        for (const fs::path& folder : folders_) {
            if (const fs::path path = folder / (name + ending); fs::is_regular_file(path)) return path;
        }
    }
    fail("there is no {} {}{}", kind, in_quotes(name), suggestion(name, names));
}

StrokeStyle StrokeStyles::style(const std::string& name) const {
    const fs::path path = find("stroke style", name, ".stroke");
    StrokeStyle style = read_stroke_style(read_file(path, SettingReader::most_bytes), path.string());
    if (style.offsets.empty()) return style;
    try {
        const fs::path pattern = find("offset file", style.offsets, ".offsets");
        style.pattern = std::make_shared<const OffsetPattern>(
            read_offsets(read_file(pattern, SettingReader::most_bytes), pattern.string()));
    } catch (const Error& error) {
        fail("stroke style \"{}\": {}", name, error.what());
    }
    return style;
}

StyleSet StrokeStyles::set(const std::string& name) const {
    const StrokeStyle main = style(name);
    StyleSet set(main);
    for (std::size_t i = 0; i < line_class_count; ++i) {
        if (!main.class_styles[i].empty()) set.visible[i] = style(main.class_styles[i]);
    }
    for (std::size_t i = 0; i < set.hidden.size(); ++i) {
        if (!main.hidden_styles[i].empty()) {
            set.hidden[i] = style(main.hidden_styles[i]);
        } else if (i > 0) {
            set.hidden[i] = set.hidden[i - 1];
        }
    }
    return set;
}

}  // namespace croquis::lines
