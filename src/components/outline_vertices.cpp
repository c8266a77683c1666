#include "components/outline_vertices.h"

#include <algorithm>
#include <glm/common.hpp>

#include "base/parallel.h"
#include "base/random.h"
#include "model/camera.h"
#include "model/posed_shape.h"

namespace croquis::components {
namespace {

// The texel at a texture coordinate; (0, 0) is the image's lower left, and the image is repeated.
glm::vec3 texel(const image::Image& image, const glm::vec2& at) {
    const glm::vec2 place = glm::fract(at) * glm::vec2(image.width(), image.height());
    const int x = std::clamp(int(place.x), 0, image.width() - 1);
    const int y = std::clamp(image.height() - 1 - int(place.y), 0, image.height() - 1);
    return glm::vec3(image.at(x, y)) / 255.0f;
}

// What a vertex shows without light, as data/shaders/default.glsl has it in base().
glm::vec3 surface_color(const model::Mesh& mesh, const model::Material& material, std::size_t vertex) {
    glm::vec3 color = material.diffuse;
    if (!mesh.colors.empty()) color *= glm::vec3(mesh.colors[vertex]) / 255.0f;
    if (material.texture && !mesh.texcoords.empty()) color *= texel(*material.texture, mesh.texcoords[vertex]);
    return color;
}

// A random vector of a lattice point, components between -1 and 1.
glm::vec3 lattice_vector(const Random& random, const glm::ivec3& at) {
    const auto bits = [](int i) { return std::uint64_t(std::uint32_t(i)); };
    const std::uint64_t column = random.bits((bits(at.x) << 32) | bits(at.y));
    const auto component = [&](std::uint64_t c) { return float(random.between(-1, 1, column + 3 * bits(at.z) + c)); };
    return {component(0), component(1), component(2)};
}

// Between the eight lattice points around a place, without a kink where cells meet.
glm::vec3 smooth_noise(const Random& random, const glm::vec3& at) {
    const glm::vec3 cell = glm::floor(at), inside = at - cell;
    const glm::vec3 share = inside * inside * (3.0f - 2.0f * inside);
    glm::vec3 sum(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::vec3 weight = glm::mix(1.0f - share, share, glm::vec3(step));
        sum += weight.x * weight.y * weight.z * lattice_vector(random, glm::ivec3(cell) + step);
    }
    return sum;
}

}  // namespace

std::vector<glm::u8vec4> own_line_colors(const model::Model& model, float darkening) {
    std::vector<glm::u8vec4> colors(model.topology().positions.size());
    const std::vector<std::uint32_t> vertices = model::topology_vertices(model);
    auto vertex = vertices.begin();
    for (const model::Mesh& mesh : model.meshes) {
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const glm::vec3 color = surface_color(mesh, model.materials[mesh.material], v) * (1.0f - darkening);
            colors[*vertex++] = glm::u8vec4(glm::clamp(color, 0.0f, 1.0f) * 255.0f + 0.5f, 255);
        }
    }
    return colors;
}

std::vector<glm::vec3> ink_offsets(const model::Model& model, float amount, float grain, std::uint64_t seed) {
    const Random random(seed, "ink offsets");
    const model::SceneSpace space = model::SceneSpace::of(model);
    const std::vector<glm::vec3>& positions = model.topology().positions;
    std::vector<glm::vec3> offsets(positions.size());
    parallel_for(offsets.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            if (grain > 0) {
                const glm::vec3 place(space.from_file(glm::dvec3(positions[v]) + model.origin));
                offsets[v] = amount * smooth_noise(random, place / grain);
            } else {
                for (int c = 0; c < 3; ++c)
                    offsets[v][c] = amount * float(random.between(-1, 1, 3 * v + std::size_t(c)));
            }
        }
    });
    return offsets;
}

}  // namespace croquis::components
