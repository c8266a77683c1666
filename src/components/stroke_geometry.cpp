#include "components/stroke_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

namespace croquis::components {
namespace {

using glm::vec2;

// Where data/shaders/strokes.glsl expects a corner's numbers.
constexpr unsigned position_location = 0, place_location = 1, color_location = 2;

// Points of a spine nearer to each other are one: nobody sees the difference.
constexpr float smallest_step = 0.05f;

// Tangent of half the turn from which the outer side is a wedge of its own: 90 degrees. Beyond, a bisector's corner
// would lie far outside the round one.
constexpr float widest_mitre = 1.0f;

// Radians. The larger the angle that a wedge's corner spans, the more empty pixels it draws.
constexpr float widest_wedge_corner = 1.7f;

struct SpinePoint {
    vec2 position;
    float reach = 0;
    glm::u8vec4 color{};
};

struct Segment {
    vec2 direction{1.0f, 0.0f};
    float length = 0;

    [[nodiscard]] vec2 right() const { return {-direction.y, direction.x}; }
};

// How two segments meet at a point, or how the first or last one ends.
struct Joint {
    enum class Kind {
        round,  ///< an end with half a disc
        butt,   ///< a square end
        mitre,  ///< both sides end on the bisector
        fold,   ///< the inner side ends on the bisector, the outer one in a wedge
        tight,  ///< the inner sides overlap
    };
    Kind kind = Kind::round;
    float slope = 0;       ///< tangent of half the turn; positive when the spine turns right
    vec2 right{}, left{};  ///< the bisector's corners

    [[nodiscard]] bool turns_right() const { return slope > 0; }
};

// `room` is how much of either segment the bisector may take on the inner side.
Joint joint_of(const Segment& before, const Segment& after, const SpinePoint& at, float room) {
    const float cosine = glm::dot(before.direction, after.direction);
    const float sine = before.direction.x * after.direction.y - before.direction.y * after.direction.x;
    constexpr float straight_back = 1e4f;
    Joint joint;
    joint.slope = std::clamp(sine / std::max(1.0f + cosine, 1e-6f), -straight_back, straight_back);
    if (cosine < 0 && std::abs(joint.slope) < widest_mitre) joint.slope = straight_back;
    if (at.reach * std::abs(joint.slope) > room) {
        joint.kind = Joint::Kind::tight;
        return joint;
    }
    joint.kind = std::abs(joint.slope) <= widest_mitre ? Joint::Kind::mitre : Joint::Kind::fold;
    const vec2 bisector = (before.right() + after.right()) * (at.reach / (1.0f + cosine));
    joint.right = at.position + bisector;
    joint.left = at.position - bisector;
    return joint;
}

vec2 beside(const SpinePoint& point, const Segment& segment, float y) { return point.position + segment.right() * y; }

glm::u8vec4 as_bytes(const glm::vec4& color) { return glm::u8vec4(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f)); }

// Builds the triangles of one even stroke after the other. The arrays are kept from stroke to stroke.
class EvenStrokes {
public:
    EvenStrokes(StrokeTriangles& triangles, float pixel_scale) : triangles_(triangles), pixel_scale_(pixel_scale) {}

    void add(std::span<const lines::StrokePoint> points, bool closed, lines::StrokeEnds ends) {
        take_points(points, closed);
        if (spine_.empty()) return;
        closed_ = closed && spine_.size() > 2;
        make_segments();
        make_joints(ends);
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            add_segment(i);
            if (joints_[i].kind == Joint::Kind::butt) add_fading_end(i, -1.0f);
            if (joints_[i + 1].kind == Joint::Kind::butt) add_fading_end(i, 1.0f);
            add_wedge(i);
        }
    }

private:
    void take_points(std::span<const lines::StrokePoint> points, bool closed) {
        const auto apart = [&](const vec2& position, const SpinePoint& other) {
            const vec2 step = position - other.position;
            return glm::dot(step, step) >= smallest_step * smallest_step;
        };
        spine_.clear();
        for (const lines::StrokePoint& point : points) {
            const vec2 position = vec2(point.position) * pixel_scale_;
            if (!spine_.empty() && !apart(position, spine_.back())) continue;
            spine_.push_back({position, 0.5f * point.width * pixel_scale_ + 0.5f, as_bytes(point.color)});
        }
        while (closed && spine_.size() > 1 && !apart(spine_.back().position, spine_.front())) spine_.pop_back();
    }

    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < segments_.size() ? i + 1 : 0; }
    [[nodiscard]] const SpinePoint& start_of(std::size_t segment) const { return spine_[segment]; }
    [[nodiscard]] const SpinePoint& end_of(std::size_t segment) const {
        return spine_[segment + 1 < spine_.size() ? segment + 1 : 0];
    }

    // A stroke of one point is a dot: a segment without length.
    void make_segments() {
        segments_.resize(std::max<std::size_t>(closed_ ? spine_.size() : spine_.size() - 1, 1));
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const vec2 step = end_of(i).position - start_of(i).position;
            const float length = glm::length(step);
            segments_[i] = length > 0 ? Segment{step / length, length} : Segment{};
        }
    }

    // Joint i is at the start of segment i; the last one ends the last segment.
    void make_joints(lines::StrokeEnds ends) {
        Joint end;
        end.kind = ends == lines::StrokeEnds::butt ? Joint::Kind::butt : Joint::Kind::round;
        joints_.assign(segments_.size() + 1, end);
        for (std::size_t i = 1; i < segments_.size(); ++i) {
            joints_[i] = joint_of(segments_[i - 1], segments_[i], spine_[i], std::min(room(i - 1), room(i)));
        }
        if (!closed_) return;
        const float room_at_seam = std::min(room(segments_.size() - 1), room(0));
        joints_.front() = joint_of(segments_.back(), segments_.front(), spine_.front(), room_at_seam);
        joints_.back() = joints_.front();
    }

    // Half of a segment is for the joint at its other end, where there is one.
    [[nodiscard]] float room(std::size_t i) const {
        const bool ends_here = !closed_ && (i == 0 || i + 1 == segments_.size());
        return segments_[i].length * (ends_here ? 1.0f : 0.5f);
    }

    // A corner of segment i at (x, y): along its direction from its start, and to its right.
    [[nodiscard]] StrokeCorner corner(std::size_t i, float x, float y, const vec2& position) const {
        const SpinePoint &start = start_of(i), &end = end_of(i);
        const float length = segments_[i].length;
        const float share = length > 0 ? std::clamp(x / length, 0.0f, 1.0f) : 0.0f;
        glm::u8vec4 color = start.color;
        if (end.color != start.color) {
            color = glm::u8vec4(glm::round(glm::mix(glm::vec4(start.color), glm::vec4(end.color), share)));
        }
        return {position, {-x, x - length, y, glm::mix(start.reach, end.reach, share)}, color};
    }
    [[nodiscard]] StrokeCorner corner(std::size_t i, float x, float y) const {
        return corner(i, x, y, start_of(i).position + segments_[i].direction * x + segments_[i].right() * y);
    }

    // A convex polygon, corner by corner.
    void begin_polygon() { first_ = std::uint32_t(triangles_.corners.size()); }
    void put(const StrokeCorner& corner) { triangles_.corners.push_back(corner); }
    void end_polygon() {
        const auto count = std::uint32_t(triangles_.corners.size()) - first_;
        for (std::uint32_t i = 2; i < count; ++i) {
            triangles_.indices.insert(triangles_.indices.end(), {first_, first_ + i - 1, first_ + i});
        }
    }

    void add_segment(std::size_t i) {
        begin_polygon();
        add_end(i, joints_[i], -1.0f);
        add_end(i, joints_[i + 1], 1.0f);
        end_polygon();
    }

    // How far before a square end its border of one pixel begins to fade.
    [[nodiscard]] float fade(std::size_t i) const { return 0.5f * std::min(segments_[i].length, 1.0f); }

    // The corners of one end of a segment, `outwards` being -1 at its start and 1 at its end: from right to left at the
    // start and from left to right at the end, so that both together go around.
    void add_end(std::size_t i, const Joint& joint, float outwards) {
        const SpinePoint& at = outwards < 0 ? start_of(i) : end_of(i);
        const float x = outwards < 0 ? 0.0f : segments_[i].length;
        const float first = -outwards;
        for (const float side : {first, -first}) {
            const float y = side * at.reach;
            const bool is_inner = joint.turns_right() == (side > 0);
            if (joint.kind == Joint::Kind::round) {
                put(corner(i, x + outwards * at.reach, y));
            } else if (joint.kind == Joint::Kind::butt) {
                put(corner(i, x - outwards * fade(i), y));
            } else if (joint.kind == Joint::Kind::mitre || (joint.kind == Joint::Kind::fold && is_inner)) {
                // To the right of a spine that turns right, a segment is shorter.
                put(corner(i, x - outwards * side * joint.slope * at.reach, y, side > 0 ? joint.right : joint.left));
            } else {
                put(corner(i, x, y, beside(at, segments_[i], y)));
            }
            if (joint.kind == Joint::Kind::fold && side == first) put(corner(i, x, 0.0f, at.position));
        }
    }

    // The border of a square end: opaque half a pixel within, transparent half a pixel without.
    void add_fading_end(std::size_t i, float outwards) {
        const float x = outwards < 0 ? 0.0f : segments_[i].length;
        const float reach = (outwards < 0 ? start_of(i) : end_of(i)).reach;
        const auto put_pair = [&](float at, float side, bool transparent) {
            for (const float y : {side * reach, -side * reach}) {
                StrokeCorner one = corner(i, x + outwards * at, y);
                one.place.x = one.place.y = -1.0f;  // not rounded
                if (transparent) one.color.a = 0;
                put(one);
            }
        };
        begin_polygon();
        put_pair(-fade(i), 1.0f, false);
        put_pair(0.5f, -1.0f, true);
        end_polygon();
    }

    // The outer side of a sharp turn at the end of segment i, in that segment's directions: from its own last crossbar
    // to the next one's first, around corners outside the circle of the reach.
    void add_wedge(std::size_t i) {
        const Joint& joint = joints_[i + 1];
        if (joint.kind != Joint::Kind::fold && joint.kind != Joint::Kind::tight) return;
        const SpinePoint& at = end_of(i);
        const float turn = 2.0f * std::atan(std::abs(joint.slope));
        const float x = segments_[i].length, y = joint.turns_right() ? -at.reach : at.reach;
        begin_polygon();
        put(corner(i, x, 0.0f, at.position));
        put(corner(i, x, y, beside(at, segments_[i], y)));
        const int corners = int(turn / widest_wedge_corner) + 1;
        const float step = turn / float(corners), outside = 1.0f / std::cos(0.5f * step);
        for (int k = 0; k < corners; ++k) {
            const float angle = (float(k) + 0.5f) * step;
            put(corner(i, x + outside * at.reach * std::sin(angle), outside * y * std::cos(angle)));
        }
        put(corner(i, x + at.reach * std::sin(turn), y * std::cos(turn), beside(at, segments_[after(i)], y)));
        end_polygon();
    }

    StrokeTriangles& triangles_;
    float pixel_scale_;
    bool closed_ = false;
    std::uint32_t first_ = 0;
    std::vector<SpinePoint> spine_;
    std::vector<Segment> segments_;
    std::vector<Joint> joints_;
};

// Strokes that follow each other and are of one kind: even ones, or textured with one image.
struct Run {
    std::size_t first = 0;
    std::size_t end = 0;
};

Run next_run(const lines::Strokes& strokes, std::size_t first) {
    const auto texture_of = [&](std::size_t i) -> const std::string& {
        return strokes.brushes[strokes.strokes[i].brush].texture;
    };
    std::size_t end = first + 1;
    while (end < strokes.strokes.size() && texture_of(end) == texture_of(first)) ++end;
    return {first, end};
}

void add_textured(StrokeTriangles& triangles, const lines::Strokes& strokes, const Run& run, float pixel_scale,
                  const lines::TextureAspect& aspect) {
    lines::Strokes some;
    some.brushes = strokes.brushes;
    some.strokes.assign(strokes.strokes.begin() + std::ptrdiff_t(run.first),
                        strokes.strokes.begin() + std::ptrdiff_t(run.end));
    some.points = strokes.points;
    const lines::StrokeMesh mesh = lines::make_stroke_mesh(some, aspect);
    const auto first = std::uint32_t(triangles.corners.size());
    for (const lines::StrokeVertex& vertex : mesh.vertices) {
        triangles.corners.push_back(
            {vertex.position * pixel_scale, {vertex.texture, 0.0f, 0.0f}, as_bytes(vertex.color)});
    }
    for (const std::uint32_t index : mesh.indices) triangles.indices.push_back(first + index);
}

}  // namespace

StrokeTriangles triangles_of(const lines::Strokes& strokes, float pixel_scale, const lines::TextureAspect& aspect) {
    StrokeTriangles triangles;
    triangles.corners.reserve(strokes.points.size() * 4);
    triangles.indices.reserve(strokes.points.size() * 6);
    EvenStrokes even(triangles, pixel_scale);
    for (Run run; run.end < strokes.strokes.size();) {
        run = next_run(strokes, run.end);
        const std::string& texture = strokes.brushes[strokes.strokes[run.first].brush].texture;
        const std::size_t first_index = triangles.indices.size();
        if (!texture.empty()) add_textured(triangles, strokes, run, pixel_scale, aspect);
        for (std::size_t i = run.first; i < run.end && texture.empty(); ++i) {
            const lines::Stroke& stroke = strokes.strokes[i];
            even.add(strokes.points_of(stroke), stroke.closed, strokes.brushes[stroke.brush].ends);
        }
        triangles.parts.push_back({texture, first_index, triangles.indices.size() - first_index});
    }
    return triangles;
}

std::unique_ptr<gpu::Geometry> upload(gpu::Context& context, const StrokeTriangles& triangles) {
    using Kind = gpu::Attribute::Kind;
    const gpu::VertexBuffer corners{std::as_bytes(std::span(triangles.corners)),
                                    sizeof(StrokeCorner),
                                    {{position_location, 2, Kind::floats, offsetof(StrokeCorner, position)},
                                     {place_location, 4, Kind::floats, offsetof(StrokeCorner, place)},
                                     {color_location, 4, Kind::bytes_to_unit, offsetof(StrokeCorner, color)}}};
    return std::make_unique<gpu::Geometry>(context, std::span(&corners, 1), triangles.indices);
}

}  // namespace croquis::components
