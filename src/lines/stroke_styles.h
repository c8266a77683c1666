// Finding stroke styles by name: NAME.stroke and NAME.offsets in a list of folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lines/stroke_style.h"

namespace croquis::lines {

/// The stroke styles of some folders; a style in an earlier folder takes the place of a later one's.
class StrokeStyles {
public:
    /// Folders that do not exist are passed over.
    explicit StrokeStyles(std::vector<std::filesystem::path> folders);

    /// The names of all styles, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

    /// One style, with its offset pattern. Throws Error with the nearest name.
    [[nodiscard]] StrokeStyle style(const std::string& name) const;

    /// A style with those that it names for hidden lines and for classes. Where it names none for hidden lines, they
    /// are dashed; what the named styles name in their turn does not count.
    [[nodiscard]] StyleSet set(const std::string& name) const;

private:
    [[nodiscard]] std::vector<std::string> names_ending(const std::string& ending) const;
    [[nodiscard]] std::filesystem::path find(const std::string& kind, const std::string& name,
                                             const std::string& ending) const;

    std::vector<std::filesystem::path> folders_;
};

}  // namespace croquis::lines
