// A page of vectors: what a drawing in lines comes to on paper, before it is written as SVG or PDF.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "output/curves.h"

namespace croquis::output {

/// How paths are inked. All corners of strokes are round.
struct Ink {
    enum class Kind : std::uint8_t {
        stroke,
        fill,  ///< whatever the rings wind around, and so nothing where two rings of opposite turn cancel out
    };
    Kind kind = Kind::stroke;
    double width = 0.35;                      ///< of a stroke, millimetres
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};  ///< red, green, blue, opacity; not multiplied
    bool round_ends = true;                   ///< of strokes; else they end square, at their last point

    bool operator==(const Ink&) const = default;
};

/// A chain of points in millimetres from the page's upper left corner; y points down.
struct Ring {
    std::vector<glm::dvec2> points;
    bool closed = false;  ///< the last point is joined to the first, which is not repeated
};

/// Rings and curves that are inked as one.
struct VectorPath {
    std::vector<Ring> rings;
    std::vector<Curve> curves;
    std::optional<Ink> ink;  ///< where it is not the group's
};

/// A line of text, centred on a point.
struct VectorText {
    glm::dvec2 place{0.0};  ///< the middle of its foot, millimetres
    double height = 3.5;    ///< of the letters with their room, millimetres
    std::string text;
};

/// A named group of paths and groups; what it does not say of its ink it takes from the group around it.
struct VectorGroup {
    std::string id;     ///< a valid XML name, unique in the page: see NameGiver
    std::string title;  ///< what people see in place of the id, where that is not the same
    std::string layer;  ///< where not empty, the group is a layer of this name in programs that know layers
    std::optional<Ink> ink;
    std::vector<VectorPath> paths;
    std::vector<VectorText> texts;
    std::vector<VectorGroup> groups;

    [[nodiscard]] bool empty() const;
};

/// A whole page.
struct VectorPage {
    double width = 210;  ///< millimetres
    double height = 297;
    std::string title;
    std::string description;
    std::vector<VectorGroup> groups;
};

/// Makes names that are valid in XML and unique from whatever meshes are called.
class NameGiver {
public:
    /// `start` must begin with a letter; what XML does not allow in a name becomes an underscore.
    [[nodiscard]] std::string name(const std::string& start, const std::string& rest = {});

private:
    std::vector<std::string> given_;  // sorted
};

/// A number with at most three decimals, as short as it goes: "0.35", "12", "-3.5".
void append_number(std::string& text, double number);
[[nodiscard]] std::string number_text(double number);

/// A number as whole thousandths, and the shortest text of as many: "12", "3.5", ".35".
[[nodiscard]] std::int64_t thousandths(double number);
void append_thousandths(std::string& text, std::uint64_t number);

}  // namespace croquis::output
