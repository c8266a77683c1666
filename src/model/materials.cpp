// Defaults and checks that the readers share.
#include <algorithm>
#include <cstddef>

#include "base/error.h"
#include "model/readers.h"

namespace croquis::model {

glm::dvec3 suitable_origin(const glm::dvec3& low, const glm::dvec3& high) {
    constexpr double farthest = 16.0;  // radii
    const glm::dvec3 centre = 0.5 * (low + high);
    const double radius = 0.5 * glm::length(high - low);
    return glm::length(centre) > farthest * radius ? centre : glm::dvec3(0.0);
}

glm::vec3 default_ambient(const glm::vec3& diffuse) { return 0.15f * diffuse; }

glm::vec3 sensible_ambient(const glm::vec3& ambient, const glm::vec3& diffuse) {
    const bool brighter = ambient.x + ambient.y + ambient.z > diffuse.x + diffuse.y + diffuse.z;
    return brighter ? default_ambient(diffuse) : ambient;
}

float sensible_shininess(float shininess) { return shininess >= 1.0f ? std::min(shininess, 1000.0f) : 32.0f; }

Material plain_material() {
    Material material;
    material.name = "default";
    material.ambient = default_ambient(material.diffuse);
    return material;
}

void check_nesting(std::string_view text, const std::string& name) {
    constexpr int deepest = 200;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\') ++i;
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        if (c == '{' || c == '[') ++depth;
        if (c == '}' || c == ']') --depth;
        if (depth > deepest) fail("{}: expected brackets nested at most {} deep, found more", name, deepest);
    }
}

void fail_without_triangles(const std::string& name, bool found_other) {
    if (found_other) fail("{}: expected triangles, found only lines and points", name);
    fail("{}: expected triangles, found none", name);
}

}  // namespace croquis::model
