#include "support/models.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace croquis::test_support {
namespace {

// The regular icosahedron: 12 corners on three golden rectangles.
std::vector<glm::dvec3> icosahedron_corners() {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    const std::array<glm::dvec3, 12> v{{{-1, g, 0},
                                        {1, g, 0},
                                        {-1, -g, 0},
                                        {1, -g, 0},
                                        {0, -1, g},
                                        {0, 1, g},
                                        {0, -1, -g},
                                        {0, 1, -g},
                                        {g, 0, -1},
                                        {g, 0, 1},
                                        {-g, 0, -1},
                                        {-g, 0, 1}}};
    constexpr std::array<int, 60> faces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                        4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                        6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    std::vector<glm::dvec3> corners;
    for (const int corner : faces) corners.push_back(glm::normalize(v[std::size_t(corner)]));
    return corners;
}

// Each triangle cut into four, the new corners brought onto the sphere.
std::vector<glm::dvec3> subdivided(const std::vector<glm::dvec3>& corners) {
    std::vector<glm::dvec3> finer;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
        const glm::dvec3 &a = corners[i], &b = corners[i + 1], &c = corners[i + 2];
        const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c), ca = glm::normalize(c + a);
        for (const glm::dvec3& corner : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) finer.push_back(corner);
    }
    return finer;
}

}  // namespace

model::Material plain(const std::string& name, const glm::vec3& diffuse) {
    model::Material material;
    material.name = name;
    material.ambient = glm::vec3(0.0f);
    material.diffuse = diffuse;
    material.specular = glm::vec3(0.0f);
    return material;
}

model::Material glossy() {
    model::Material material;
    material.name = "glossy";
    material.ambient = {0.10f, 0.05f, 0.15f};
    material.diffuse = {0.50f, 0.60f, 0.40f};
    material.specular = {0.30f, 0.20f, 0.35f};
    material.shininess = 12.0f;
    return material;
}

ModelPointer model_of(const std::vector<Piece>& pieces, std::vector<model::Material> materials) {
    model::RawModel raw;
    raw.materials = std::move(materials);
    for (const Piece& piece : pieces) {
        model::RawMesh mesh;
        mesh.mesh.name = piece.name;
        mesh.mesh.material = piece.material;
        mesh.mesh.positions = piece.corners;
        for (std::uint32_t i = 0; i < piece.corners.size(); ++i) mesh.mesh.triangles.push_back(i);
        raw.meshes.push_back(std::move(mesh));
    }
    return model::finish(std::move(raw), "test");
}

std::vector<glm::vec3> quad_corners(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
    return {a, b, c, a, c, d};
}

std::vector<glm::vec3> box_corners(const glm::vec3& low, const glm::vec3& high) {
    std::vector<glm::vec3> corners;
    const auto at = [&](int x, int y, int z) {
        return glm::vec3(x ? high.x : low.x, y ? high.y : low.y, z ? high.z : low.z);
    };
    const auto side = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
        for (const glm::vec3& corner : quad_corners(a, b, c, d)) corners.push_back(corner);
    };
    side(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
    side(at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0));
    side(at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1));
    side(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
    side(at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0));
    side(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
    return corners;
}

ModelPointer cube() { return model_of({{"cube", box_corners(glm::vec3(-1.0f), glm::vec3(1.0f))}}); }

ModelPointer icosphere(int subdivisions, model::Material material) {
    std::vector<glm::dvec3> corners = icosahedron_corners();
    for (int i = 0; i < subdivisions; ++i) corners = subdivided(corners);
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.name = "sphere";
    for (const glm::dvec3& corner : corners) {
        mesh.mesh.triangles.push_back(std::uint32_t(mesh.mesh.positions.size()));
        mesh.mesh.positions.emplace_back(corner);
        mesh.mesh.normals.emplace_back(corner);
    }
    raw.materials.push_back(std::move(material));
    return model::finish(std::move(raw), "sphere");
}

ModelPointer parallel_squares() {
    return model_of({{"far", quad_corners({-2, -2, -1}, {2, -2, -1}, {2, 2, -1}, {-2, 2, -1})},
                     {"near", quad_corners({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1})}});
}

ModelPointer crossing_boards() {
    return model_of(
        {{"left_board", quad_corners({-1, -0.8f, 0.6f}, {1, -0.8f, -0.6f}, {1, 0.8f, -0.6f}, {-1, 0.8f, 0.6f}), 0},
         {"right_board", quad_corners({-1, -0.6f, -0.6f}, {1, -0.6f, 0.6f}, {1, 0.6f, 0.6f}, {-1, 0.6f, -0.6f}), 1}},
        {plain("red", {1, 0, 0}), plain("blue", {0, 0, 1})});
}

ModelPointer two_material_board() {
    return model_of({{"board", quad_corners({-1, -0.7f, 0}, {0, -0.7f, 0}, {0, 0.7f, 0}, {-1, 0.7f, 0}), 0},
                     {"board", quad_corners({0, -0.7f, 0}, {1, -0.7f, 0}, {1, 0.7f, 0}, {0, 0.7f, 0}), 1}},
                    {plain("oak", {0.6f, 0.4f, 0.2f}), plain("ash", {0.7f, 0.6f, 0.5f})});
}

}  // namespace croquis::test_support
