// Where the eye is and what it sees, in scene space: the model's box centred on the origin, half its diagonal long
// as 1.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/animation.h"
#include "model/model.h"

namespace croquis::model {

enum class Projection { perspective, parallel };

/// Maps the file's coordinates to scene space, in which every model has the same size: thresholds, near planes and
/// light positions need not know how large a model is or how far from its origin.
struct SceneSpace {
    glm::dvec3 centre{0.0};  ///< in the file's coordinates
    double radius = 1.0;     ///< half the diagonal of the bounding box

    [[nodiscard]] static SceneSpace of(const Model& model);
    [[nodiscard]] glm::dvec3 from_file(const glm::dvec3& point) const { return (point - centre) / radius; }
};

/// What a person asks of the camera. Points are in the file's coordinates.
struct ViewRequest {
    glm::dvec3 direction{1.0, 0.7, 1.0};  ///< from the centre of the bounding box to the eye
    double fit = 0.9;                     ///< share of the frame that the model may fill, 0 to 1
    std::optional<glm::dvec3> eye;        ///< in place of direction and fit
    std::optional<glm::dvec3> target;     ///< the box's centre where not given
    glm::dvec3 up{0.0, 1.0, 0.0};
    double field_of_view = 0.6981317;  ///< of the frame's height, radians; 40 degrees
    Projection projection = Projection::perspective;
};

/// The direction of a named view: front, back, left, right, top, bottom or iso. Throws Error with the nearest name.
[[nodiscard]] glm::dvec3 named_view(std::string_view name);
[[nodiscard]] std::vector<std::string> view_names();

/// A camera in scene space, its planes fitted to the model.
struct Camera {
    glm::dvec3 eye{0.0, 0.0, 3.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 back{0.0, 0.0, 1.0};  ///< from what is looked at towards the eye
    Projection projection = Projection::perspective;
    double tangent = 0.36397;  ///< of half the field of view, over the frame's height
    double half_height = 1.0;  ///< of a parallel projection's frame
    double near_plane = 0.1;   ///< eye distance, in scene units
    double far_plane = 10.0;
    /// The part of the frame that the model covers, -1 to 1 from left to right and from bottom to top.
    glm::dvec2 covered_low{-1.0}, covered_high{1.0};

    [[nodiscard]] glm::mat4 eye_from_scene() const;
    [[nodiscard]] glm::mat4 clip_from_eye(double aspect) const;
};

/// Places the camera for a model, or one pose of it: without an eye, at the nearest distance at which every vertex lies
/// within the asked share of the frame, looking at the centre of the bounding box. Near and far planes enclose the
/// vertices. Throws Error for a request that cannot be met: no direction, an eye at the target, angles out of range.
[[nodiscard]] Camera place_camera(const Model& model, const Pose* pose, const ViewRequest& request, double aspect);

}  // namespace croquis::model
