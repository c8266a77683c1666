#include "line_models.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "model/load.h"

namespace croquis::bench {

using lines::Viewpoint;

std::shared_ptr<const model::Model> sphere(int n, double noise) {
    const Random random(1, "noise");
    model::RawModel raw;
    model::RawMesh& mesh = raw.meshes.emplace_back();
    mesh.mesh.name = "sphere";
    const auto corner = [&](int x, int y, int z) {
        const glm::dvec3 sines = glm::sin(glm::dvec3(x, y, z) * (1.570796327 / n));
        const auto index = (std::uint64_t(x + n) * 4096 + std::uint64_t(y + n)) * 4096 + std::uint64_t(z + n);
        mesh.mesh.triangles.push_back(static_cast<std::uint32_t>(mesh.mesh.positions.size()));
        mesh.mesh.positions.emplace_back(glm::normalize(sines) * (1.0 + noise * random.unit(index) / n));
    };
    for (int octant = 0; octant < 8; ++octant) {
        const int sx = (octant & 1) != 0 ? -1 : 1, sy = (octant & 2) != 0 ? -1 : 1, sz = (octant & 4) != 0 ? -1 : 1;
        const bool mirrored = sx * sy * sz < 0;
        const auto triangle = [&](const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c) {
            for (const glm::ivec2& p : {a, mirrored ? c : b, mirrored ? b : c}) {
                corner(sx * p.x, sy * p.y, sz * (n - p.x - p.y));
            }
        };
        for (int i = 0; i < n; ++i) {
            for (int k = 0; k < n - i; ++k) {
                triangle({i, k}, {i + 1, k}, {i, k + 1});
                if (i + k < n - 1) triangle({i + 1, k}, {i + 1, k + 1}, {i, k + 1});
            }
        }
    }
    return model::finish(std::move(raw), "sphere");
}

Viewpoint turned(int degrees, model::Projection projection) {
    const double turn = 0.01745329 * degrees;
    Viewpoint view;
    view.projection = projection;
    view.back = glm::normalize(glm::dvec3(std::cos(turn), 0.5, std::sin(turn)));
    view.eye = 2.6 * view.back;
    return view;
}

}  // namespace croquis::bench
