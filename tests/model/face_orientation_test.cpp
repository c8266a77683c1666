// Ways to tell which faces look at the eye, against the sign of the exact vector in double precision and seed A's
// tables 6 to 9: which of them leave holes, and whose counts are above whose.
#include "model/face_orientation.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <tuple>

#include "fixtures.h"

namespace croquis::model {
namespace {

using Flags = std::vector<std::uint8_t>;
using Method = OrientationMethod;

// A torus with bumps, whose faces and vertices turn every way: u x v quadrangles, two triangles each.
std::shared_ptr<const Model> bumpy_torus(int u_count, int v_count, bool inside_out = false) {
    std::string text;
    constexpr double turn = 6.283185307179586;
    for (int u = 0; u < u_count; ++u) {
        for (int v = 0; v < v_count; ++v) {
            const double a = turn * u / u_count, b = turn * v / v_count;
            const double r = 0.4 + 0.05 * std::sin(3 * a) * std::cos(2 * b), ring = 1.0 + r * std::cos(b);
            text += fmt::format("v {} {} {}\n", ring * std::cos(a), r * std::sin(b), ring * std::sin(a));
        }
    }
    const auto vertex = [&](int u, int v) { return (u % u_count) * v_count + v % v_count + 1; };
    for (int u = 0; u < u_count; ++u) {
        for (int v = 0; v < v_count; ++v) {
            int a = vertex(u, v), b = vertex(u, v + 1), c = vertex(u + 1, v + 1), d = vertex(u + 1, v);
            if (inside_out) std::swap(b, d);
            text += fmt::format("f {} {} {}\nf {} {} {}\n", a, b, c, a, c, d);
        }
    }
    return testing::load_text("torus.obj", text);
}

std::shared_ptr<const Model> cube() {
    return testing::load_text(
        "cube.obj",
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f 5 6 7\nf 5 7 8\nf 2 1 4\nf 2 4 3\nf 6 2 3\nf 6 3 7\nf 1 5 8\nf 1 8 4\nf 8 7 3\nf 8 3 4\n"
        "f 1 2 6\nf 1 6 5\n");
}

std::vector<std::pair<std::string, std::shared_ptr<const Model>>> models() {
    return {{"cube", cube()},
            {"lowest detail", bumpy_torus(9, 6)},
            {"low detail", bumpy_torus(20, 12)},
            {"high detail", bumpy_torus(64, 32)}};
}

// Near and far, all around.
std::vector<Eye> eyes() {
    std::vector<Eye> eyes;
    for (const float distance : {2.2f, 4.0f, 20.0f}) {
        for (int i = 0; i < 40; ++i) {
            const float y = 1.0f - 2.0f * (float(i) + 0.5f) / 40.0f, a = 2.4f * float(i), r = std::sqrt(1 - y * y);
            eyes.push_back({distance * glm::vec3(r * std::cos(a), y, r * std::sin(a)), false});
        }
    }
    return eyes;
}

Flags found_by(Method method, const FaceOrientation& faces, const Eye& eye, std::uint64_t seed = 0) {
    Flags found;
    faces.find(method, eye, seed, found);
    return found;
}

int count(const Flags& flags) { return std::accumulate(flags.begin(), flags.end(), 0); }

// Faces of the first that are missing in the second.
int missing(const Flags& wanted, const Flags& found) {
    int holes = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) holes += wanted[i] > found[i] ? 1 : 0;
    return holes;
}

// Over all eyes: faces found by each method, and holes.
struct Tally {
    std::map<Method, int> found, holes;
};

Tally tally(const Model& model) {
    const FaceOrientation faces(model, nullptr);
    Tally tally;
    for (const Eye& eye : eyes()) {
        const Flags truth = found_by(Method::triangles_exact, faces, eye);
        for (const OrientationName& known : orientation_methods()) {
            const Flags found = found_by(known.method, faces, eye);
            tally.found[known.method] += count(found);
            tally.holes[known.method] += missing(truth, found);
        }
    }
    return tally;
}

// The corners of each triangle in double precision.
std::vector<std::array<glm::dvec3, 3>> triangles_of(const Model& model) {
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (const Mesh& mesh : model.meshes) {
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            std::array<glm::dvec3, 3> corners;
            for (std::size_t c = 0; c < 3; ++c) corners[c] = mesh.positions[mesh.triangles[i + c]];
            triangles.push_back(corners);
        }
    }
    return triangles;
}

glm::dvec3 normal_of(const std::array<glm::dvec3, 3>& t) {
    return glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
}

TEST(FaceOrientation, ExactIsTheSignOfTheVectorToEachFace) {
    const auto model = bumpy_torus(20, 12);
    const FaceOrientation faces(*model, nullptr);
    const auto triangles = triangles_of(*model);
    ASSERT_EQ(faces.face_count(), triangles.size());
    for (const Eye& eye : eyes()) {
        const Flags found = found_by(Method::triangles_exact, faces, eye);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            // Any corner will do: all lie in one plane.
            const double side = glm::dot(normal_of(triangles[i]), triangles[i][0] - glm::dvec3(eye.place));
            if (std::abs(side) < 1e-5) continue;
            EXPECT_EQ(found[i] != 0, side < 0) << "face " << i;
        }
    }
}

// Seed A, 3.5.2 and 3.5.2.1, word by word and by brute force.
TEST(FaceOrientation, VerticesFollowTheirAveragedNormals) {
    const auto model = bumpy_torus(9, 6);
    const FaceOrientation faces(*model, nullptr);
    const auto triangles = triangles_of(*model);
    glm::dvec3 low(1e9), high(-1e9);
    for (const auto& triangle : triangles) {
        for (const glm::dvec3& corner : triangle) low = glm::min(low, corner), high = glm::max(high, corner);
    }
    const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    const auto averaged = [&](const glm::dvec3& place) {
        glm::dvec3 sum(0.0);
        for (const auto& triangle : triangles) {
            for (const glm::dvec3& corner : triangle) {
                if (corner == place) sum += normal_of(triangle);
            }
        }
        return glm::normalize(sum);
    };
    for (const Eye& eye : {eyes()[3], eyes()[50], eyes()[99]}) {
        const glm::dvec3 view = 0.5 * (low + high) - glm::dvec3(eye.place);
        const double sine = side / glm::length(view);
        std::array<Flags, 4> by_number;  // at least so many of a face's vertices look at the eye
        for (int fewest : {1, 2, 3}) {
            const Method method =
                std::array{Method::vertices_one, Method::vertices_two, Method::vertices_all}[std::size_t(fewest - 1)];
            by_number[std::size_t(fewest)] = found_by(method, faces, eye);
        }
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            int front = 0, undecided = 0;
            for (const glm::dvec3& corner : triangles[i]) {
                const double above = glm::dot(averaged(corner), glm::normalize(view)) - sine;
                front += above < 0;
                undecided += std::abs(above) < 1e-5;
            }
            if (undecided > 0) continue;
            for (int fewest : {1, 2, 3}) EXPECT_EQ(by_number[std::size_t(fewest)][i] != 0, front >= fewest);
        }
    }
}

// Tables 6 and 7: "Perfect".
TEST(FaceOrientation, ThePerfectOnesLeaveNoHoles) {
    for (const auto& [name, model] : models()) {
        Tally found = tally(*model);
        for (const Method method : {Method::triangles_corrected, Method::vertices_one, Method::marked_all}) {
            EXPECT_EQ(found.holes[method], 0) << name << ", " << orientation_methods()[std::size_t(method)].name;
        }
    }
}

// Table 6: one view vector without correction leaves holes near the model, random marks many.
TEST(FaceOrientation, TheBadOnesLeaveHoles) {
    Tally found = tally(*bumpy_torus(20, 12));
    EXPECT_GT(found.holes[Method::triangles_constant], 0);
    EXPECT_GT(found.holes[Method::marked_some], 0);
}

// Tables 8 and 9: exact < constant < corrected and all three < two < one, whose faces marking finds too.
TEST(FaceOrientation, CountsAreInTheOrderOfTheTables) {
    for (const auto& [name, model] : models()) {
        SCOPED_TRACE(name);
        Tally found = tally(*model);
        EXPECT_LE(found.found[Method::triangles_exact], found.found[Method::triangles_constant]);
        EXPECT_LT(found.found[Method::triangles_constant], found.found[Method::triangles_corrected]);
        EXPECT_LT(found.found[Method::vertices_all], found.found[Method::vertices_two]);
        EXPECT_LT(found.found[Method::vertices_two], found.found[Method::vertices_one]);
        EXPECT_EQ(found.found[Method::vertices_one], found.found[Method::marked_all]);
        EXPECT_LT(found.found[Method::marked_some], found.found[Method::marked_all]);
        EXPECT_LE(found.found[Method::triangles_corrected], found.found[Method::vertices_one]);
    }
}

TEST(FaceOrientation, MarkingAllIsOneVertexTheOtherWayRound) {
    const auto model = bumpy_torus(20, 12);
    const FaceOrientation faces(*model, nullptr);
    for (const Eye& eye : eyes()) {
        const Flags all = found_by(Method::marked_all, faces, eye), some = found_by(Method::marked_some, faces, eye, 5);
        EXPECT_EQ(all, found_by(Method::vertices_one, faces, eye));
        EXPECT_EQ(missing(some, all), 0);
    }
}

TEST(FaceOrientation, RandomMarksFollowTheSeed) {
    const auto model = bumpy_torus(20, 12);
    const FaceOrientation faces(*model, nullptr);
    const Eye eye = eyes()[7];
    EXPECT_EQ(found_by(Method::marked_some, faces, eye, 1), found_by(Method::marked_some, faces, eye, 1));
    EXPECT_NE(found_by(Method::marked_some, faces, eye, 1), found_by(Method::marked_some, faces, eye, 2));
}

TEST(FaceOrientation, FromFarAwayOneVectorIsExact) {
    const auto model = bumpy_torus(20, 12);
    const FaceOrientation faces(*model, nullptr);
    for (Eye eye : eyes()) {
        eye.is_far = true;
        eye.place = glm::normalize(eye.place);
        const Flags exact = found_by(Method::triangles_exact, faces, eye);
        EXPECT_EQ(found_by(Method::triangles_constant, faces, eye), exact);
        EXPECT_EQ(found_by(Method::triangles_corrected, faces, eye), exact);
    }
}

TEST(FaceOrientation, AMeshWoundInsideOutLooksTheOtherWay) {
    const auto model = bumpy_torus(20, 12), inverted = bumpy_torus(20, 12, true);
    const auto triangles = triangles_of(*inverted);
    const FaceOrientation faces(*inverted, nullptr);
    const Eye eye = eyes()[60];
    const Flags found = found_by(Method::triangles_exact, faces, eye);
    EXPECT_NEAR(count(found), count(found_by(Method::triangles_exact, FaceOrientation(*model, nullptr), eye)), 60);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const double side = glm::dot(normal_of(triangles[i]), triangles[i][0] - glm::dvec3(eye.place));
        if (std::abs(side) < 1e-5) continue;
        EXPECT_EQ(found[i] != 0, side > 0);
    }
}

// A pose that moves and enlarges the model is the model seen by an eye that moved and went away.
TEST(FaceOrientation, APoseIsSeenAsItStands) {
    const auto model = bumpy_torus(20, 12);
    const auto moved = [](const glm::vec3& p) { return 2.0f * p + glm::vec3(8.0f, -4.0f, 16.0f); };
    Pose pose;
    for (const Mesh& mesh : model->meshes) {
        pose.push_back({mesh.positions, mesh.normals});
        for (glm::vec3& position : pose.back().positions) position = moved(position);
    }
    const FaceOrientation at_rest(*model, nullptr), posed(*model, &pose);
    for (const Eye& eye : eyes()) {
        for (const OrientationName& known : orientation_methods()) {
            const Flags found = found_by(known.method, posed, {moved(eye.place), false});
            // Rounding decides for a face now and then.
            EXPECT_NEAR(count(found), count(found_by(known.method, at_rest, eye)), 1) << known.name;
        }
    }
}

TEST(FaceOrientation, AWrongNameIsToldWithTheNearest) {
    try {
        static_cast<void>(orientation_method("vertices_tow"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "no face orientation \"vertices_tow\"; did you mean \"vertices_two\"?");
    }
}

}  // namespace
}  // namespace croquis::model
