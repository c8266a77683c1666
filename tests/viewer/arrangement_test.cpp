// Moving object, camera and light, against projections worked out here.
#include "viewer/arrangement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "api/shapes.h"

namespace croquis::viewer {
namespace {

constexpr FrameSize frame{400, 300};
constexpr double degree = 3.14159265358979323846 / 180;

glm::dvec3 vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

// Where a point of the model at rest appears in the frame, in pixels.
glm::dvec2 place_in_frame(const View& view, const glm::dvec3& point) {
    const glm::dvec3 eye = vector(*view.eye), target = vector(*view.target);
    const glm::dvec3 back = glm::normalize(eye - target);
    const glm::dvec3 right = glm::normalize(glm::cross(vector(view.up), back)), up = glm::cross(back, right);
    const glm::dvec3 from_eye = point - eye;
    const double depth = view.parallel ? glm::length(eye - target) : -glm::dot(from_eye, back);
    const double half_height = depth * std::tan(0.5 * view.field_of_view * degree);
    return {200 + 150 * glm::dot(from_eye, right) / half_height, 150 - 150 * glm::dot(from_eye, up) / half_height};
}

void expect_near(const glm::dvec2& found, const glm::dvec2& expected, double tolerance = 1e-7) {
    EXPECT_LT(glm::length(found - expected), tolerance)
        << found.x << ' ' << found.y << ", expected " << expected.x << ' ' << expected.y;
}

// The model in units and at a place of its own: everything must scale with it.
Arrangement arrangement_of(const test_support::Placement& placement, bool parallel) {
    View view;
    view.parallel = parallel;
    Arrangement arrangement;
    arrangement.take(test_support::cube_file(placement), view, frame);
    return arrangement;
}

struct Case {
    test_support::Placement placement;
    bool parallel;
};
const Case cases[] = {{{1, 0, {}}, false}, {{1, 0, {}}, true}, {{0.001, 5, {}}, false}, {{1000, -300, {}}, true}};

// In parallel projection a point of the object's sphere follows the mouse exactly.
TEST(ArrangementTest, TheGrabbedPointFollowsTheMouse) {
    for (const Case& c : cases) {
        if (!c.parallel) continue;
        Arrangement arrangement = arrangement_of(c.placement, true);
        const glm::dvec3 centre = vector(*arrangement.view().target);
        const double radius = 0.5 * std::sqrt(3.0) * c.placement.scale;
        const glm::dvec3 nearest =
            centre + radius * glm::normalize(vector(*arrangement.view().eye) - centre);  // of the sphere to the eye
        expect_near(place_in_frame(arrangement.view(), nearest), {200, 150});
        const VirtualSphere sphere = arrangement.sphere(frame);
        const glm::dvec2 to(230, 100);
        arrangement.turn(Moves::object, rotation_between(sphere.point_under({200, 150}), sphere.point_under(to)));
        expect_near(place_in_frame(arrangement.view(), nearest), to);
    }
}

// In perspective the sphere's radius is that of the object where the camera looks: r pixels = R / (2 d tan(f/2) / h).
TEST(ArrangementTest, TheSphereHasTheObjectsSize) {
    const Arrangement arrangement = arrangement_of({2, 7, {}}, false);
    const double distance = glm::length(vector(*arrangement.view().eye) - vector(*arrangement.view().target));
    const double expected = std::sqrt(3.0) / (2 * distance * std::tan(20 * degree) / 300);
    EXPECT_NEAR(arrangement.sphere(frame).radius, expected, 1e-9);
    expect_near(arrangement.sphere(frame).centre, {200, 150});
}

TEST(ArrangementTest, CameraAndObjectTurnOppositeWays) {
    Arrangement object = arrangement_of({}, false), camera = object;
    const glm::dquat rotation = glm::angleAxis(0.3, glm::normalize(glm::dvec3(1, 2, 0.5)));
    object.turn(Moves::object, rotation);
    camera.turn(Moves::camera, glm::conjugate(rotation));
    const glm::dvec3 corner(1, 0, 1);
    expect_near(place_in_frame(object.view(), corner), place_in_frame(camera.view(), corner));
}

TEST(ArrangementTest, PanFollowsTheMouse) {
    for (const Case& c : cases) {
        Arrangement arrangement = arrangement_of(c.placement, c.parallel);
        const glm::dvec3 centre = vector(*arrangement.view().target);
        arrangement.pan(Moves::object, {35, -20}, frame);
        expect_near(place_in_frame(arrangement.view(), centre), {235, 130});
        arrangement.turn(Moves::object, glm::angleAxis(1.0, glm::dvec3(0, 1, 0)));
        expect_near(place_in_frame(arrangement.view(), centre), {235, 130});  // it turns about its centre
        expect_near(arrangement.sphere(frame).centre, {235, 130});
    }
}

TEST(ArrangementTest, ZoomKeepsWhatIsUnderTheMouse) {
    for (const Case& c : cases) {
        Arrangement arrangement = arrangement_of(c.placement, c.parallel);
        const View before = arrangement.view();
        const glm::dvec3 target = vector(*before.target), eye = vector(*before.eye);
        const glm::dvec3 right = glm::normalize(glm::cross(vector(before.up), eye - target));
        const glm::dvec3 point = target + 0.3 * c.placement.scale * right + 0.2 * c.placement.scale * vector(before.up);
        const glm::dvec2 mouse = place_in_frame(before, point);
        arrangement.zoom(2.5, mouse, frame);
        expect_near(place_in_frame(arrangement.view(), point), mouse);
        EXPECT_NEAR(glm::length(vector(*arrangement.view().eye) - vector(*arrangement.view().target)),
                    glm::length(eye - target) / 2.5, 1e-9 * glm::length(eye));
    }
}

TEST(ArrangementTest, TheFieldOfViewKeepsTheObjectsSize) {
    Arrangement arrangement = arrangement_of({}, false);
    const glm::dvec3 beside = vector(*arrangement.view().target) + 0.4 * vector(arrangement.view().up);
    const glm::dvec2 before = place_in_frame(arrangement.view(), beside);
    arrangement.set_field_of_view(80);
    expect_near(place_in_frame(arrangement.view(), beside), before);
}

// Towards the light, seen along the camera's right, up and back.
glm::dvec3 light_seen(const Arrangement& arrangement) {
    const Light light = arrangement.light();
    const glm::dvec3 place = vector(light.place);
    if (light.bound == Light::Bound::viewer) return place;
    const View view = arrangement.view();
    const glm::dvec3 back = glm::normalize(vector(*view.eye) - vector(*view.target));
    const glm::dvec3 up = vector(view.up);
    return {glm::dot(place, glm::cross(up, back)), glm::dot(place, up), glm::dot(place, back)};
}

// What the light does, seen from the camera, while something turns by `rotation` in the camera's axes.
TEST(ArrangementTest, TheLightStaysWithWhatItIsBoundTo) {
    const glm::dquat rotation = glm::angleAxis(0.7, glm::normalize(glm::dvec3(0.2, 1, -0.4)));
    const glm::dquat none(1, 0, 0, 0), back = glm::conjugate(rotation);
    struct {
        LightStaysWith bound;
        Moves moves;
        glm::dquat expected;
    } const rules[] = {
        {LightStaysWith::viewer, Moves::object, none},    {LightStaysWith::viewer, Moves::camera, none},
        {LightStaysWith::viewer, Moves::light, rotation}, {LightStaysWith::object, Moves::object, rotation},
        {LightStaysWith::object, Moves::camera, back},    {LightStaysWith::object, Moves::light, rotation},
        {LightStaysWith::world, Moves::object, none},     {LightStaysWith::world, Moves::camera, back},
        {LightStaysWith::world, Moves::light, rotation},
    };
    for (const auto& rule : rules) {
        Arrangement arrangement = arrangement_of({}, false);
        arrangement.turn(Moves::object, glm::angleAxis(0.4, glm::dvec3(1, 0, 0)));
        arrangement.turn(Moves::camera, glm::angleAxis(-0.5, glm::dvec3(0, 1, 0)));
        const glm::dvec3 unbound = light_seen(arrangement);
        arrangement.bind_light(rule.bound);
        EXPECT_LT(glm::length(light_seen(arrangement) - unbound), 1e-9) << "binding changes nothing at once";
        arrangement.turn(rule.moves, rotation);
        EXPECT_LT(glm::length(light_seen(arrangement) - rule.expected * unbound), 1e-9)
            << int(rule.bound) << ' ' << int(rule.moves);
    }
}

}  // namespace
}  // namespace croquis::viewer
