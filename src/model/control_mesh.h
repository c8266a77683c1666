// A model as the control mesh of a subdivision surface.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "model/model.h"

namespace croquis::model {

/// A point, as OpenSubdiv mixes them by weights.
struct MixedPoint {
    glm::dvec3 value{0.0};

    void Clear(void* = nullptr) { value = glm::dvec3(0.0); }
    void AddWithWeight(const MixedPoint& source, double weight) { value += weight * source.value; }
};

/// What a render vertex shows beside its place and normal; mixed likewise.
struct MixedLook {
    glm::dvec2 texcoord{0.0};
    glm::dvec4 color{0.0};  ///< 0 to 255

    void Clear(void* = nullptr) { *this = {}; }
    void AddWithWeight(const MixedLook& source, double weight) {
        texcoord += weight * source.texcoord;
        color += weight * source.color;
    }
};

/// The welded model, its vertices and faces numbered as in its topology. Indices are OpenSubdiv's: int.
struct ControlMesh {
    std::vector<MixedPoint> points;
    std::vector<int> corners;            ///< three a face
    std::vector<std::uint32_t> mesh_of;  ///< one a face
    std::vector<int> sharp;              ///< both ends of each sharp edge
    std::vector<int> tagged;             ///< both ends of each tagged edge
    std::vector<MixedLook> looks;        ///< one a render vertex of the model; none where no mesh has a look
    std::vector<int> look_of_corner;     ///< three a face, or none
};

/// Edges that bend the surface by more than `crease_angle` (radians) are sharp.
[[nodiscard]] ControlMesh control_mesh(const Model& model, std::optional<double> crease_angle);

}  // namespace croquis::model
