// The classes of lines that a technical drawing tells apart (seed D, section 2; seed E, 10.3; SPEC row L1).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace croquis::lines {

/// What a line is. Where an edge is several things at once, the first in this order names it.
enum class LineClass : std::uint8_t {
    contour,       ///< a silhouette or border with nothing of the model behind it: the drawing's outline
    silhouette,    ///< between a face that is turned to the eye and one that is turned away
    border,        ///< an edge of one face only
    tagged,        ///< marked by the model's author
    crease,        ///< where the surface bends by more than the crease angle
    intersection,  ///< where two faces pass through each other
    material,      ///< between two meshes or materials
};

constexpr std::size_t line_class_count = 7;

/// A set of classes.
class LineClasses {
public:
    constexpr LineClasses() = default;
    constexpr LineClasses(std::initializer_list<LineClass> classes) {
        for (const LineClass one : classes) add(one);
    }
    [[nodiscard]] static constexpr LineClasses all() {
        LineClasses classes;
        classes.bits_ = (1u << line_class_count) - 1;
        return classes;
    }
    constexpr void add(LineClass one) { bits_ |= 1u << static_cast<unsigned>(one); }
    constexpr void remove(LineClass one) { bits_ &= ~(1u << static_cast<unsigned>(one)); }
    [[nodiscard]] constexpr bool has(LineClass one) const { return (bits_ >> static_cast<unsigned>(one) & 1u) != 0; }
    constexpr bool operator==(const LineClasses&) const = default;

private:
    std::uint32_t bits_ = 0;
};

/// How a class is named in files and on the command line, and how wide it is drawn unless someone says otherwise.
struct LineClassInfo {
    LineClass line_class;
    std::string_view name;
    double width_mm;  ///< after the series of ISO 128-20: 0.13 0.18 0.25 0.35 0.5 0.7
    std::string_view help;
};

/// One entry a class, in the order of the enumeration.
[[nodiscard]] const std::array<LineClassInfo, line_class_count>& line_class_infos();
[[nodiscard]] const LineClassInfo& info_of(LineClass line_class);

/// The class of a name. Throws Error with the nearest name.
[[nodiscard]] LineClass line_class_named(std::string_view name);

/// The width of a hidden line, in millimetres.
constexpr double hidden_width_mm = 0.18;

}  // namespace croquis::lines
