#include "truth/solids.h"

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "base/random.h"

namespace croquis::lines::truth {
namespace {

constexpr double pi = 3.14159265358979323846;

void add_triangle(Corners& corners, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    for (const glm::dvec3& corner : {a, b, c}) corners.emplace_back(corner);
}

/// A number that belongs to a place, so that corners at one place stay together.
std::uint64_t place_number(const glm::vec3& place) {
    std::uint64_t number = 0;
    for (int axis = 0; axis < 3; ++axis) {
        number = number * 0x9e3779b97f4a7c15u + std::bit_cast<std::uint32_t>(place[axis] + 0.0f);
    }
    return number;
}

}  // namespace

Corners grid_of(const Grid& grid, const std::function<glm::dvec3(double u, double v)>& at) {
    Corners corners;
    const auto point = [&](int i, int j) {
        const int column = grid.u_closed ? i % grid.u_cells : i, row = grid.v_closed ? j % grid.v_cells : j;
        return at(static_cast<double>(column) / grid.u_cells, static_cast<double>(row) / grid.v_cells);
    };
    for (int i = 0; i < grid.u_cells; ++i) {
        for (int j = 0; j < grid.v_cells; ++j) {
            const glm::dvec3 a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
            add_triangle(corners, a, b, c);
            add_triangle(corners, a, c, d);
        }
    }
    return corners;
}

Corners sphere_corners(int subdivisions) {
    const test_support::ModelPointer model = test_support::icosphere(subdivisions);
    const model::Mesh& mesh = model->meshes[0];
    Corners corners;
    for (const std::uint32_t v : mesh.triangles) corners.push_back(mesh.positions[v]);
    return corners;
}

Corners bumpy_sphere(int subdivisions, double waves, double roughness, std::uint64_t seed) {
    const Random random(seed, "bumps");
    const glm::dvec3 phase(random.unit(0) * 6, random.unit(1) * 6, random.unit(2) * 6);
    Corners corners = sphere_corners(subdivisions);
    for (glm::vec3& corner : corners) {
        const glm::dvec3 p(corner);
        const double wave = std::sin(5 * p.x + phase.x) * std::sin(4 * p.y + phase.y) * std::sin(6 * p.z + phase.z);
        const double noise = random.between(-1, 1, place_number(corner));
        corner = glm::vec3(p * (1 + waves * wave + roughness * noise));
    }
    return corners;
}

Corners torus(double radius, double thickness, int around, int across) {
    return grid_of({around, across, true, true}, [&](double u, double v) {
        const double distance = radius + thickness * std::cos(2 * pi * v);
        return glm::dvec3(distance * std::cos(2 * pi * u), distance * std::sin(2 * pi * u),
                          thickness * std::sin(2 * pi * v));
    });
}

Corners torus_knot(int p, int q, double thickness, int along, int across) {
    const auto spine = [&](double u) {
        const double distance = 2 + std::cos(2 * pi * q * u);
        return glm::dvec3(distance * std::cos(2 * pi * p * u), distance * std::sin(2 * pi * p * u),
                          -std::sin(2 * pi * q * u));
    };
    return grid_of({along, across, true, true}, [&](double u, double v) {
        constexpr double step = 1e-4;
        const glm::dvec3 before = spine(u - step), at = spine(u), after = spine(u + step);
        const glm::dvec3 tangent = glm::normalize(after - before);
        const glm::dvec3 normal = glm::normalize(glm::cross(tangent, glm::cross(after - 2.0 * at + before, tangent)));
        const glm::dvec3 binormal = glm::cross(tangent, normal);
        return at + thickness * (std::cos(2 * pi * v) * normal + std::sin(2 * pi * v) * binormal);
    });
}

Corners wavy_sheet(int cells, double height, std::uint64_t seed) {
    const Random random(seed, "sheet");
    return grid_of({cells, cells}, [&](double u, double v) {
        const double wave = std::sin(9 * u + 6 * random.unit(0)) * std::cos(7 * v + 6 * random.unit(1)) +
                            0.4 * std::sin(17 * u * v + 6 * random.unit(2));
        return glm::dvec3(2 * u - 1, 2 * v - 1, height * wave);
    });
}

Corners gear(int teeth, double height) {
    Corners corners;
    const int points = 4 * teeth;
    const auto rim = [&](int i, double z) {
        const int k = i % points;
        const double radius = k % 4 < 2 ? 1.0 : 0.75;
        const double angle = 2 * pi * (k + (k % 2 == 0 ? 0.15 : -0.15)) / points;
        return glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z);
    };
    const double z = 0.5 * height;
    for (int i = 0; i < points; ++i) {
        add_triangle(corners, rim(i, -z), rim(i + 1, -z), rim(i + 1, z));
        add_triangle(corners, rim(i, -z), rim(i + 1, z), rim(i, z));
        add_triangle(corners, {0, 0, z}, rim(i, z), rim(i + 1, z));
        add_triangle(corners, {0, 0, -z}, rim(i + 1, -z), rim(i, -z));
    }
    return corners;
}

Corners soup(std::size_t triangles, double size, std::uint64_t seed) {
    const Random random(seed, "soup");
    Corners corners;
    corners.reserve(3 * triangles);
    const auto vector = [&](std::uint64_t index, double reach) {
        return reach * glm::dvec3(random.between(-1, 1, 3 * index), random.between(-1, 1, 3 * index + 1),
                                  random.between(-1, 1, 3 * index + 2));
    };
    for (std::size_t t = 0; t < triangles; ++t) {
        const glm::dvec3 middle = vector(4 * t, 1);
        for (std::size_t k = 1; k < 4; ++k) corners.emplace_back(middle + vector(4 * t + k, size));
    }
    return corners;
}

Corners cut(const Corners& corners, const std::function<bool(const glm::dvec3& middle)>& keep) {
    Corners kept;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const glm::dvec3 middle =
            (glm::dvec3(corners[i]) + glm::dvec3(corners[i + 1]) + glm::dvec3(corners[i + 2])) / 3.0;
        if (keep(middle)) kept.insert(kept.end(), {corners[i], corners[i + 1], corners[i + 2]});
    }
    return kept;
}

Corners shaped(const Corners& corners, const Shape& shape) {
    Corners result;
    for (const glm::vec3& corner : corners) result.emplace_back(shape(glm::dvec3(corner)));
    return result;
}

Corners moved(const Corners& corners, const glm::dvec3& offset, double scale) {
    return shaped(corners, [&](const glm::dvec3& p) { return p * scale + offset; });
}

Corners turned(const Corners& corners, const glm::dvec3& axis, double angle) {
    const glm::dmat3 matrix = rotation(axis, angle);
    return shaped(corners, [&](const glm::dvec3& p) { return matrix * p; });
}

Corners inside_out(const Corners& corners) {
    Corners result = corners;
    for (std::size_t i = 0; i + 2 < result.size(); i += 3) std::swap(result[i + 1], result[i + 2]);
    return result;
}

Corners joined(const std::vector<Corners>& parts) {
    Corners all;
    for (const Corners& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

// Rodrigues: v cos + (k × v) sin + k (k · v) (1 - cos), column by column.
glm::dmat3 rotation(const glm::dvec3& axis, double angle) {
    const glm::dvec3 k = glm::normalize(axis);
    glm::dmat3 matrix(1.0);
    for (int column = 0; column < 3; ++column) {
        glm::dvec3 v(0.0);
        v[column] = 1;
        matrix[column] =
            v * std::cos(angle) + glm::cross(k, v) * std::sin(angle) + k * (glm::dot(k, v) * (1 - std::cos(angle)));
    }
    return matrix;
}

}  // namespace croquis::lines::truth
