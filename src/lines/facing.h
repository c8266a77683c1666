// Which faces are turned to the eye, decided fast: in single precision where that is safe, else by the surface.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "lines/surface.h"
#include "lines/viewpoint.h"

namespace croquis::lines {

/// A viewpoint as a linear function of planes: its product with a face's plane is the height of the eye over the face,
/// in units of how far the eye is away at most. In a parallel projection it is the height of the direction to the eye.
class EyeFunction {
public:
    explicit EyeFunction(const Viewpoint& view) {
        if (view.projection == model::Projection::perspective) {
            const double reach = 1.0 + std::abs(view.eye.x) + std::abs(view.eye.y) + std::abs(view.eye.z);
            factors_ = glm::vec4(glm::dvec4(view.eye, 1.0) / reach);
        } else {
            factors_ = glm::vec4(view.back, 0.0);
        }
    }

    [[nodiscard]] const glm::vec4& factors() const { return factors_; }

    [[nodiscard]] float operator()(const glm::vec4& plane) const {
        return plane.x * factors_.x + plane.y * factors_.y + plane.z * factors_.z + plane.w * factors_.w;
    }

    /// Heights beyond this have the sign of the exact ones: the doubt of Surface::front_facing in the same units, and
    /// as much again as single precision loses here.
    static constexpr float doubt = 6e-6f;

private:
    glm::vec4 factors_;
};

/// Surface::front_facing of one view, for face after face.
class Facing {
public:
    /// Both must live as long.
    Facing(const Surface& surface, const Viewpoint& view)
        : surface_(surface), view_(view), planes_(surface.planes()), height_(view) {}

    [[nodiscard]] const EyeFunction& height() const { return height_; }

    [[nodiscard]] bool front(std::uint32_t face) const {
        const float height = height_(planes_[face]);
        return height > EyeFunction::doubt || (height >= -EyeFunction::doubt && surface_.front_facing(face, view_));
    }

    /// True when one face is turned to the eye and the other away.
    [[nodiscard]] bool differ(const FacePair& pair) const {
        return differ(pair, height_(planes_[pair.first]), height_(planes_[pair.second]));
    }

    /// Appends those of some edges to `found` that lie between a face that is turned to the eye and one that is turned
    /// away.
    void append_silhouettes(std::span<const std::uint32_t> edges, std::vector<std::uint32_t>& found) const;

private:
    /// Given the heights of both faces. No branch depends on a sign, which could not be predicted.
    [[nodiscard]] bool differ(const FacePair& pair, float first, float second) const {
        if (std::abs(first) > EyeFunction::doubt && std::abs(second) > EyeFunction::doubt) {
            return (first > 0) != (second > 0);
        }
        return front(pair.first) != front(pair.second);
    }

    const Surface& surface_;
    const Viewpoint& view_;
    std::span<const glm::vec4> planes_;
    EyeFunction height_;
};

}  // namespace croquis::lines
