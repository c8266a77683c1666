#include "model/vrml_checks.h"

#include <Inventor/VRMLnodes/SoVRMLColor.h>
#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLNormal.h>
#include <Inventor/VRMLnodes/SoVRMLTextureCoordinate.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "model/readers.h"

namespace croquis::model {
namespace {

/// Words, braces and brackets of a VRML text; strings and comments are skipped.
class Tokens {
public:
    explicit Tokens(std::string_view text) : text_(text) {}

    /// The next one; empty at the end.
    std::string_view next() {
        skip_blanks();
        if (at_ >= text_.size()) return {};
        const std::size_t begin = at_++;
        if (is_bracket(text_[begin])) return text_.substr(begin, 1);
        while (at_ < text_.size() && !is_separator(text_[at_]) && !is_bracket(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }

private:
    static bool is_bracket(char c) { return c == '{' || c == '}' || c == '[' || c == ']'; }
    static bool is_separator(char c) {
        return static_cast<unsigned char>(c) <= ' ' || c == ',' || c == '"' || c == '#';
    }

    void skip_blanks() {
        while (at_ < text_.size() && is_separator(text_[at_])) {
            const char c = text_[at_++];
            if (c == '#') {
                while (at_ < text_.size() && text_[at_] != '\n') ++at_;
            } else if (c == '"') {
                while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
                ++at_;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

/// A DEF or PROTO whose body is not yet closed.
struct Open {
    std::string_view name;
    int depth;
};

/// Fails where a node stands within itself.
void check_cycles(std::string_view text, const std::string& name) {
    Tokens tokens(text);
    std::vector<Open> nodes, prototypes;
    int depth = 0;
    const auto is_open = [](const std::vector<Open>& open, std::string_view wanted) {
        return std::any_of(open.begin(), open.end(), [&](const Open& one) { return one.name == wanted; });
    };
    for (std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
        if (token == "{" || token == "[") ++depth;
        if (token == "}") {
            --depth;
            while (!nodes.empty() && nodes.back().depth >= depth) nodes.pop_back();
            while (!prototypes.empty() && prototypes.back().depth >= depth) prototypes.pop_back();
        }
        if (token == "]") --depth;
        if (token == "DEF") nodes.push_back({tokens.next(), depth});
        if (token == "PROTO") {
            prototypes.push_back({tokens.next(), depth});
        } else if (is_open(prototypes, token)) {
            fail("{}: expected nodes that do not use themselves, found {}", name, token);
        }
        if (token == "USE" && is_open(nodes, token = tokens.next())) {
            fail("{}: expected nodes that do not use themselves, found {}", name, token);
        }
        if (token == "Inline" || token == "EXTERNPROTO") {
            fail("{}: expected a scene in one file, found {} of another", name, token);
        }
    }
}

bool all_below(const SoMFInt32& indices, int count) {
    const int32_t* const first = indices.getValues(0);
    return std::all_of(first, first + indices.getNum(), [&](int32_t index) { return index >= -1 && index < count; });
}

/// A list beside the points: by its own indices, or without them by the points' or by the number of the face.
bool fits(int count, const SoMFInt32& own, const SoMFInt32& points, bool per_vertex) {
    const int32_t* const first = points.getValues(0);
    const auto faces = 1 + std::count(first, first + points.getNum(), -1);
    if (own.getNum() == 0) return per_vertex ? all_below(points, count) : faces <= count + 1;
    return all_below(own, count) && (per_vertex ? own.getNum() >= points.getNum() : own.getNum() + 1 >= faces);
}

}  // namespace

void check_vrml(std::string_view text, const std::string& name) {
    if (!text.starts_with("#VRML ")) fail("{}: expected a VRML file, found one that does not begin with #VRML", name);
    if (!text.starts_with("#VRML V2.0")) {
        fail("{}: expected VRML V2.0, found {}", name, text.substr(6, text.substr(6, 20).find_first_of(" \r\n")));
    }
    check_nesting(text, name);
    check_cycles(text, name);
}

bool is_sound(const SoVRMLIndexedFaceSet& faces) {
    const auto* const points = static_cast<const SoVRMLCoordinate*>(faces.coord.getValue());
    const auto* const colors = static_cast<const SoVRMLColor*>(faces.color.getValue());
    const auto* const normals = static_cast<const SoVRMLNormal*>(faces.normal.getValue());
    const auto* const texcoords = static_cast<const SoVRMLTextureCoordinate*>(faces.texCoord.getValue());
    const SoMFInt32& corners = faces.coordIndex;
    if (points == nullptr || !all_below(corners, points->point.getNum())) return false;
    if (colors != nullptr &&
        !fits(colors->color.getNum(), faces.colorIndex, corners, faces.colorPerVertex.getValue())) {
        return false;
    }
    if (normals != nullptr &&
        !fits(normals->vector.getNum(), faces.normalIndex, corners, faces.normalPerVertex.getValue())) {
        return false;
    }
    return texcoords == nullptr || fits(texcoords->point.getNum(), faces.texCoordIndex, corners, true);
}

}  // namespace croquis::model
