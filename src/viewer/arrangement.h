// How object, camera and light stand to each other, and how a person moves them (seed E, 10.2: the choice whether the
// object or the camera moves, and where the light belongs, changes what a drawing shows of a shape).
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "croquis/model.h"
#include "croquis/view.h"
#include "viewer/trackball.h"

namespace croquis::viewer {

/// What follows the mouse.
enum class Moves { object, camera, light };

/// What the light stays with while the rest moves. A light that stays with the object shades it the same from all
/// sides; one that stays with the viewer is that of an object turned in the hand.
enum class LightStaysWith { viewer, object, world };

/// The size of the picture, in pixels.
struct FrameSize {
    int width = 1;
    int height = 1;
    [[nodiscard]] double aspect() const { return double(width) / double(height); }
    bool operator==(const FrameSize&) const = default;
};

/// The object can be turned and moved in the world; so can the camera, and the light about the object. The drawing
/// functions know a model at rest alone: `view` and `light` say the same as seen from the object.
class Arrangement {
public:
    Arrangement() = default;

    /// Takes another object, which is at rest then, and looks at it from the direction of `view`. Lengths scale with
    /// the object, so that the same drag moves a tooth and a town alike.
    void take(const Model& model, const View& view, FrameSize frame);

    /// The object at rest, the camera where a view says, which names its eye and its target.
    void place(const View& view);

    [[nodiscard]] View view() const;
    [[nodiscard]] Light light() const;

    /// The object's sphere as the camera sees it, not smaller than a fifth of the frame and not larger than twice the
    /// frame: what is dragged.
    [[nodiscard]] VirtualSphere sphere(FrameSize frame) const;

    /// Turns what moves by a rotation in the camera's axes: the object about its centre, the camera about what it looks
    /// at, the light about the object.
    void turn(Moves moves, const glm::dquat& rotation);
    /// Turns about the line of sight, counter-clockwise.
    void roll(Moves moves, double radians) { turn(moves, glm::angleAxis(radians, glm::dvec3(0, 0, 1))); }
    /// Moves object or camera across the line of sight by so many pixels, x to the right and y down. A light has a
    /// direction and no place: the object moves in its stead.
    void pan(Moves moves, const glm::dvec2& pixels, FrameSize frame);
    /// Brings the camera to 1 / `factor` of its distance. What lies under the mouse, in the depth of what is looked
    /// at, stays under it.
    void zoom(double factor, const glm::dvec2& mouse, FrameSize frame);

    [[nodiscard]] LightStaysWith light_stays_with() const { return light_stays_with_; }
    /// Binds the light to something else; it shines as before until that moves.
    void bind_light(LightStaysWith what);
    void set_light(const Light& light);

    [[nodiscard]] bool is_parallel() const { return is_parallel_; }
    /// Perspective and parallel pictures are of the same size where the camera looks at.
    void set_parallel(bool on) { is_parallel_ = on; }
    [[nodiscard]] double field_of_view() const { return field_of_view_; }
    /// The object keeps its size in the picture: the camera comes nearer as the field widens.
    void set_field_of_view(double degrees);

private:
    /// What a pixel is worth where the camera looks at.
    [[nodiscard]] double length_of_pixel(FrameSize frame) const;
    [[nodiscard]] glm::dvec3 to_object(const glm::dvec3& point_of_world) const;
    /// Which rotation of the world the light's direction goes through to be one in the camera's axes.
    [[nodiscard]] glm::dquat camera_from_light() const;

    // The object: its sphere in the file's coordinates, and where it is in the world.
    glm::dvec3 centre_{0.0};
    double radius_ = 1.0;
    glm::dquat object_turn_{1, 0, 0, 0};
    glm::dvec3 object_offset_{0.0};
    // The camera, in the world. Its orientation turns the camera's axes, right, up, back, to where they point.
    glm::dvec3 target_{0.0};
    glm::dquat orientation_{1, 0, 0, 0};
    double distance_ = 3.0;
    double field_of_view_ = 40.0;  // degrees
    bool is_parallel_ = false;
    // The light: towards it, in the axes of what it stays with.
    LightStaysWith light_stays_with_ = LightStaysWith::viewer;
    glm::dvec3 to_light_{-0.5, 0.7, 1.0};
    Vector3 light_color_{1, 1, 1};
};

}  // namespace croquis::viewer
