// What a camera sees, by ray casting in double precision: the truth that pictures are compared with.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "model/camera.h"

namespace croquis::test_support {

struct Hit {
    double eye_distance = 0;  ///< along the camera's axis, in scene space
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};  ///< the vertices' normals interpolated, unit, on the side that is seen
    glm::dvec3 to_eye{0.0};  ///< unit
    std::uint32_t mesh = 0;
    std::uint32_t triangle = 0;  ///< of all meshes
    glm::dvec3 weights{0.0};     ///< of the triangle's corners
};

class RayCaster {
public:
    RayCaster(const model::Model& model, const model::Camera& camera, int width, int height);

    /// What is seen at a point of the picture, in pixels from its upper left corner.
    [[nodiscard]] std::optional<Hit> at(double x, double y) const;
    /// What is seen at a pixel's centre.
    [[nodiscard]] std::optional<Hit> pixel(int x, int y) const { return at(x + 0.5, y + 0.5); }

    /// False where a surface ends so near to the pixel's centre that the rasteriser's rounding decides.
    [[nodiscard]] bool is_certain(int x, int y) const;

    /// The corners of a hit's triangle, in scene space.
    struct Triangle {
        glm::dvec3 corners[3];
        glm::dvec3 normals[3];
        std::uint32_t mesh = 0;
    };
    [[nodiscard]] const Triangle& triangle(const Hit& hit) const { return triangles_[hit.triangle]; }

private:
    struct Box {
        double left, right, top, bottom;
    };
    [[nodiscard]] Box box_of(const Triangle& triangle) const;

    model::Camera camera_;
    int width_;
    int height_;
    std::vector<Triangle> triangles_;
    std::vector<Box> boxes_;  // one a triangle
};

}  // namespace croquis::test_support
