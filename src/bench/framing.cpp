#include "bench/framing.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/log.h"

namespace croquis::bench {
namespace {

double length(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

View seen_from(const Vector3& target, const Vector3& direction, double distance) {
    View view;
    view.target = target;
    view.eye = target;
    for (std::size_t axis = 0; axis < 3; ++axis) (*view.eye)[axis] += distance / length(direction) * direction[axis];
    return view;
}

}  // namespace

double coverage(Renderer& renderer, const Model& model, const DrawOptions& options) {
    Technique silhouette = renderer.open_technique("base");
    DrawOptions on_glass = options;
    on_glass.background = Background{.color = {}, .transparent = true, .texture = {}};
    const Picture picture = renderer.draw(model, silhouette, on_glass);
    std::size_t covered = 0;
    for (std::size_t alpha = 3; alpha < picture.pixels().size(); alpha += 4) covered += picture.pixels()[alpha] != 0;
    return 100.0 * double(covered) / (double(options.width) * double(options.height));
}

View view_with_coverage(Renderer& renderer, const Model& model, const Protocol& protocol) {
    if (!(length(protocol.direction) > 0)) fail("expected the view to have a direction, found 0,0,0");
    const Vector3 low = model.low_corner(), high = model.high_corner();
    Vector3 centre{}, extent{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        centre[axis] = 0.5 * (low[axis] + high[axis]);
        extent[axis] = high[axis] - low[axis];
    }
    const double radius = 0.5 * length(extent);
    const double nearest = 1.2 * radius, farthest = 1000 * radius;
    DrawOptions options;
    options.width = protocol.width;
    options.height = protocol.height;
    double distance = 3 * radius;
    constexpr int most_steps = 12;
    double found = 0;
    for (int step = 0; step < most_steps; ++step) {
        options.view = seen_from(centre, protocol.direction, distance);
        found = coverage(renderer, model, options);
        if (std::abs(found - protocol.coverage) < 0.01 * protocol.coverage) return options.view;
        // Far away, the covered share falls with the square of the distance.
        const double factor = found > 0 ? std::sqrt(found / protocol.coverage) : 0.5;
        distance = std::clamp(distance * factor, nearest, farthest);
    }
    constexpr double near_enough = 0.05;
    if (std::abs(found - protocol.coverage) > near_enough * protocol.coverage) {
        warn(
            "the model covers {:.1f} percent of the pixels, not {:g}: it cannot be seen otherwise from outside its box",
            found, protocol.coverage);
    }
    return options.view;
}

View turned(const View& view, double degrees) {
    constexpr double radians_per_degree = 3.14159265358979323846 / 180.0;
    const Vector3 target = view.target.value(), eye = view.eye.value();
    const double x = eye[0] - target[0], z = eye[2] - target[2];
    const double cosine = std::cos(degrees * radians_per_degree), sine = std::sin(degrees * radians_per_degree);
    View result = view;
    result.eye = Vector3{target[0] + cosine * x + sine * z, eye[1], target[2] - sine * x + cosine * z};
    return result;
}

}  // namespace croquis::bench
