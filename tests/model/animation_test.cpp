// Skinned and morphing glTF, moving nodes: poses against what the files' numbers say.
#include <glm/gtc/matrix_transform.hpp>

#include "fixtures.h"

namespace croquis::model::testing {
namespace {

float distance(const Model& model, const Pose& pose) {
    float worst = 0;
    for (std::size_t m = 0; m < pose.size(); ++m) {
        for (std::size_t v = 0; v < pose[m].positions.size(); ++v) {
            worst = std::max(worst, glm::length(pose[m].positions[v] - model.meshes[m].positions[v]));
        }
    }
    return worst;
}

TEST(Animation, MorphingCubeReachesItsTargets) {
    const auto model = load(sample_folder / "glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf");
    const AnimationClip& square = find_clip(*model, "Square");
    EXPECT_LT(distance(*model, pose_at(*model, square, 0)), 1e-6f);
    // At its keys 63 and 190 of the file (2.1 s in steps of a thirtieth) one target after the other holds alone.
    ASSERT_EQ(square.shapes.size(), 1u);
    for (const auto& key : square.shapes[0].weights) {
        const MeshPose pose = pose_at(*model, square, key.time)[0];
        for (std::size_t v = 0; v < pose.positions.size(); ++v) {
            const MeshRig& rig = model->rig.meshes[0];
            glm::vec3 wanted = rig.positions[v];
            for (std::size_t s = 0; s < rig.shapes.size(); ++s) {
                wanted += key.value[s] * (rig.shapes[s].positions[v] - rig.positions[v]);
            }
            // The node turns the cube by a right angle about x and scales it by 100.
            EXPECT_NEAR(glm::length(pose.positions[v]), 100 * glm::length(wanted), 1e-3);
        }
    }
    EXPECT_GT(distance(*model, pose_at(*model, square, square.seconds / 2)), 0.1f);
}

TEST(Animation, SkinnedStripBendsAtItsJoint) {
    // The glTF tutorial's skin: ten points in five rows; the upper joint turns to the left and right about (0, 1).
    const auto model = load(sample_folder / "glTF2/simple_skin/simple_skin.gltf");
    ASSERT_EQ(model->clips.size(), 1u);
    const AnimationClip& clip = model->clips[0];
    EXPECT_LT(distance(*model, pose_at(*model, clip, 0)), 1e-6f);
    const MeshPose bent = pose_at(*model, clip, 1.5)[0];  // a quarter turn: its key says sin and cos of 45 degrees
    for (std::size_t v = 0; v < bent.positions.size(); ++v) {
        const glm::vec3 rest = model->meshes[0].positions[v];
        if (rest.y < 0.25f) {
            EXPECT_LT(glm::length(bent.positions[v] - rest), 1e-5f);
        }
        if (rest.y > 1.75f) {  // these follow the upper joint alone
            const glm::vec3 arm = rest - glm::vec3(0, 1, 0);
            const glm::vec3 moved = bent.positions[v] - glm::vec3(0, 1, 0);
            EXPECT_NEAR(glm::length(moved), glm::length(arm), 1e-4f);
            EXPECT_NEAR(glm::dot(moved, arm), 0.0f, 1e-4f);
        }
    }
}

TEST(Animation, MovingNodesStartAtRest) {
    for (const char* name : {"ASE/RotatingCube.ASE", "3DS/RotatingCube.3DS", "ASE/anim2.ASE"}) {
        const auto model = load(sample_folder / name);
        ASSERT_EQ(model->clips.size(), 1u) << name;
        EXPECT_LT(distance(*model, pose_at(*model, model->clips[0], 0)), 1e-4f * model->bounds.radius()) << name;
        EXPECT_GT(distance(*model, pose_at(*model, model->clips[0], model->clips[0].seconds * 0.3)),
                  0.05f * model->bounds.radius())
            << name;
    }
}

TEST(Animation, AModelWithoutClipsSaysSo) {
    const auto model = load_text("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THROW(static_cast<void>(find_clip(*model, "run")), Error);
}

/// A square that two nodes carry: what pose_at makes of hand-made tracks.
TEST(Animation, NodesMoveWhatTheyCarryThroughTheirParents) {
    RawModel raw;
    raw.meshes.resize(1);
    raw.meshes[0].mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    raw.meshes[0].mesh.triangles = {0, 1, 2};
    raw.rig.nodes = {Node{"root"}, Node{"arm", 0, {2, 0, 0}}};
    raw.rig.meshes.resize(1);
    raw.rig.meshes[0].node = 1;
    AnimationClip clip;
    clip.name = "turn";
    clip.seconds = 2;
    NodeTrack turn{0, {}, {{0.0, glm::quat(1, 0, 0, 0)}, {2.0, glm::angleAxis(1.57079633f, glm::vec3(0, 0, 1))}}, {}};
    NodeTrack reach{1, {{0.0, {2, 0, 0}}, {2.0, {4, 0, 0}}}, {}, {}};
    clip.nodes = {turn, reach};
    raw.clips = {clip};
    const auto model = finish(std::move(raw), "hand-made");
    const MeshPose half = pose_at(*model, model->clips[0], 1.0)[0];
    const float s = std::sqrt(0.5f);  // turned by 45 degrees, the arm reaching 3 far
    EXPECT_LT(glm::length(half.positions[0] - glm::vec3(3 * s, 3 * s, 0)), 1e-5f);
    EXPECT_LT(glm::length(half.positions[1] - glm::vec3(4 * s, 4 * s, 0)), 1e-5f);
    EXPECT_LT(glm::length(half.positions[2] - glm::vec3(2 * s, 4 * s, 0)), 1e-5f);
    EXPECT_LT(glm::length(half.normals[0] - glm::vec3(0, 0, 1)), 1e-5f);
}

}  // namespace
}  // namespace croquis::model::testing
