// MD2: key frames against the file's bytes, read here a second time and otherwise.
#include "model/md2.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include "fixtures.h"

namespace croquis::model::testing {
namespace {

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

template <typename Number>
Number at(const std::string& bytes, std::size_t offset) {
    Number number;
    std::memcpy(&number, bytes.data() + offset, sizeof number);
    return number;
}

/// All points of a frame that triangles use, y up.
std::set<std::array<float, 3>> points_of_frame(const std::string& bytes, std::size_t frame) {
    const std::size_t begin = at<std::uint32_t>(bytes, 56) + frame * at<std::uint32_t>(bytes, 16);
    std::set<std::array<float, 3>> points;
    for (std::uint32_t t = 0; t < at<std::uint32_t>(bytes, 32); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto point = at<std::uint16_t>(bytes, at<std::uint32_t>(bytes, 52) + 12 * t + 2 * k);
            float p[3];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto packed = at<std::uint8_t>(bytes, begin + 40 + 4u * point + axis);
                p[axis] = float(packed) * at<float>(bytes, begin + 4 * axis) + at<float>(bytes, begin + 12 + 4 * axis);
            }
            points.insert({p[0], p[2], -p[1]});
        }
    }
    return points;
}

std::set<std::array<float, 3>> points_of(const MeshPose& pose) {
    std::set<std::array<float, 3>> points;
    for (const glm::vec3& p : pose.positions) points.insert({p.x, p.y, p.z});
    return points;
}

TEST(Md2, PosesAtKeyFramesAreTheFramesOfTheFile) {
    const std::filesystem::path path = sample_folder / "MD2/faerie.md2";
    const std::string bytes = bytes_of(path);
    const auto model = load(path);
    EXPECT_LE(model->triangle_count(), at<std::uint32_t>(bytes, 32));
    std::size_t frame = 0;
    for (const AnimationClip& clip : model->clips) {
        const auto frames = static_cast<std::size_t>(std::lround(clip.seconds * 10));
        for (std::size_t f = 0; f < frames; ++f, ++frame) {
            ASSERT_EQ(points_of(pose_at(*model, clip, double(f) / 10)[0]), points_of_frame(bytes, frame))
                << clip.name << f;
        }
    }
    EXPECT_EQ(frame, 198u);
}

TEST(Md2, MovesBetweenFramesAndWrapsAround) {
    const auto model = load(sample_folder / "MD2/faerie.md2");
    const AnimationClip& run = find_clip(*model, "run");
    EXPECT_DOUBLE_EQ(run.seconds, 0.6);
    const MeshPose first = pose_at(*model, run, 0.0)[0], second = pose_at(*model, run, 0.1)[0];
    const MeshPose between = pose_at(*model, run, 0.025)[0], wrapped = pose_at(*model, run, 0.625)[0];
    EXPECT_NE(first.positions, second.positions);
    for (std::size_t v = 0; v < first.positions.size(); ++v) {
        EXPECT_LT(glm::length(between.positions[v] - glm::mix(first.positions[v], second.positions[v], 0.25f)), 1e-4f);
        EXPECT_LT(glm::length(between.positions[v] - wrapped.positions[v]), 1e-4f);
        EXPECT_NEAR(glm::length(between.normals[v]), 1.0f, 1e-5f);
    }
    EXPECT_EQ(pose_at(*model, run, 0.6)[0].positions, first.positions);
}

TEST(Md2, TheSkinIsFoundBesideTheFile) {
    for (const char* name : {"MD2/faerie.md2", "MD2/sydney.md2"}) {
        const auto model = load(sample_folder / name);
        ASSERT_TRUE(model->materials[0].texture) << name;
        for (const glm::vec2& t : model->meshes[0].texcoords) {
            EXPECT_TRUE(t.x >= 0 && t.x <= 1 && t.y >= 0 && t.y <= 1);
        }
    }
}

TEST(Md2, WindsOutwards) {
    const auto model = load(sample_folder / "MD2/sydney.md2");
    EXPECT_FALSE(model->topology().mesh_is_inverted[0]);
    EXPECT_GT(model->bounds.high.y - model->bounds.low.y, model->bounds.high.z - model->bounds.low.z)
        << "stands upright";
}

TEST(Md2, RefusesDamagedFiles) {
    const std::string whole = bytes_of(sample_folder / "MD2/faerie.md2");
    EXPECT_EQ(error_of("x.md2", ""), "x.md2: file too short, expected at least 68 bytes, found 0");
    EXPECT_EQ(error_of("x.md2", std::string(100, 'x')),
              "x.md2: expected an MD2 file, found one that does not begin with IDP2");
    std::string changed = whole;
    changed[4] = 9;
    EXPECT_EQ(error_of("x.md2", changed), "x.md2: expected MD2 version 8, found 9");
    changed = whole;
    std::memset(changed.data() + 40, 0x7f, 4);
    EXPECT_EQ(error_of("x.md2", changed).substr(0, 43), "x.md2: file too short, expected 2139062143 ");
    const std::size_t end_of_frames = at<std::uint32_t>(whole, 60);  // what follows draws faster, and is not needed
    for (std::size_t size = 0; size < end_of_frames; size += 4999) {
        EXPECT_NE(error_of("x.md2", whole.substr(0, size)), "") << size;
    }
}

TEST(Md2, AnUnknownClipIsNamedWithTheNearest) {
    const auto model = load(sample_folder / "MD2/faerie.md2");
    try {
        static_cast<void>(find_clip(*model, "salut"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(
            std::string(error.what()),
            (sample_folder / "MD2/faerie.md2").string() +
                ": no animation clip \"salut\"; it has stand, run, attack, pain1, pain2, pain3, jump, flip, salute, "
                "taunt, wave, point, crstnd, crwalk, crattak, crpain, crdeath, death1, death2, death3; did you mean "
                "\"salute\"?");
    }
}

}  // namespace
}  // namespace croquis::model::testing
