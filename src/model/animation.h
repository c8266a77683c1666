// Animation clips: key frames of whole meshes (MD2, morph targets) and moving, skinned skeletons (glTF).
#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace croquis::model {

struct Model;

/// A value at a time, in seconds.
template <typename Value>
struct Key {
    double time = 0;
    Value value{};
};

/// How one node of the skeleton moves: each list sorted by time; an empty one leaves the node at rest.
struct NodeTrack {
    std::uint32_t node = 0;
    std::vector<Key<glm::vec3>> translations;
    std::vector<Key<glm::quat>> rotations;
    std::vector<Key<glm::vec3>> scales;
};

/// How a mesh blends its shapes over time: one weight a shape at each key.
struct ShapeTrack {
    std::uint32_t mesh = 0;
    std::vector<Key<std::vector<float>>> weights;
};

/// A named stretch of movement.
struct AnimationClip {
    std::string name;
    double seconds = 0;
    std::vector<NodeTrack> nodes;
    std::vector<ShapeTrack> shapes;
};

/// A node of the skeleton; parents stand before their children.
struct Node {
    std::string name;
    std::int32_t parent = -1;
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
};

/// A whole shape of a mesh: positions and normals, one a vertex.
struct Shape {
    std::string name;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
};

/// What a clip needs to move one mesh. Positions are in the space of the file's mesh, before any node's transform.
struct MeshRig {
    std::uint32_t node = 0;  ///< carries the mesh where there are no bones
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<Shape> shapes;
    std::vector<std::uint32_t> bone_nodes;
    std::vector<glm::mat4> bone_offsets;              ///< mesh space to bone space, one a bone
    std::vector<std::array<std::uint16_t, 4>> bones;  ///< four bones a vertex, or none
    std::vector<std::array<float, 4>> weights;        ///< their shares, summing to 1
};

/// What clips move: the skeleton and, one a mesh, what the mesh needs to follow. Empty for a still model.
struct Rig {
    std::vector<Node> nodes;
    std::vector<MeshRig> meshes;
};

/// Where one mesh's vertices are at a moment.
struct MeshPose {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
};

/// Where all vertices are at a moment, one entry a mesh, in the model's space.
using Pose = std::vector<MeshPose>;

/// The pose of a clip at a time in seconds; times past the end wrap around. Key frames are blended linearly.
[[nodiscard]] Pose pose_at(const Model& model, const AnimationClip& clip, double seconds);

/// The clip of that name. Throws Error with the nearest name, or for a model without clips.
[[nodiscard]] const AnimationClip& find_clip(const Model& model, std::string_view name);

}  // namespace croquis::model
