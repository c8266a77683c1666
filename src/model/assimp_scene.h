// From Assimp's scene to ours: what the files assimp*.cpp share. No other file sees Assimp.
#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/load.h"
#include "model/textures.h"

namespace croquis::model {

[[nodiscard]] inline glm::vec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline glm::quat to_glm(const aiQuaternion& q) { return {q.w, q.x, q.y, q.z}; }
[[nodiscard]] glm::mat4 to_glm(const aiMatrix4x4& m);

/// A node of the scene, parents before children.
struct SceneNode {
    const aiNode* node = nullptr;
    std::int32_t parent = -1;
    glm::mat4 to_model{1.0f};
};

/// The scene's nodes in one list. Throws Error, naming `name`, for more of them than a file can mean.
[[nodiscard]] std::vector<SceneNode> nodes_of(const aiScene& scene, const std::string& name);

/// A mesh as one node carries it.
struct PlacedMesh {
    const aiMesh* mesh = nullptr;
    std::uint32_t node = 0;
};

/// What bones, shapes and nodes make of one mesh; its positions are in the file's mesh space.
[[nodiscard]] MeshRig rig_of(const PlacedMesh& placed,
                             const std::unordered_map<std::string, std::uint32_t>& node_numbers);

/// Positions and normals at rest, in the model's space.
void place_at_rest(const PlacedMesh& placed, const MeshRig& rig, const std::vector<SceneNode>& nodes, Mesh& mesh);

/// The skeleton and the clips of a scene whose meshes are `placed`.
void read_animations(const aiScene& scene, const std::vector<SceneNode>& nodes, const std::vector<PlacedMesh>& placed,
                     RawModel& raw);

/// A material in Phong's terms. `ending` is the file's, lower case.
///
/// glTF's metallic and roughness become a grey specular colour of half of (1 - roughness) and the exponent
/// 2 / roughness^4 - 2, which gives highlights of the same width.
[[nodiscard]] Material read_material(const aiMaterial& given, const aiScene& scene, const std::string& ending,
                                     const std::string& name, TextureFinder& textures);

/// Fails for files on which Assimp would crash, hang or take memory that the file does not account for.
void check_before_assimp(const std::filesystem::path& path, const std::string& ending);

/// The same for glTF: a tree of nodes without cycles, accessors within their buffers.
void check_gltf(const std::string& bytes, const std::filesystem::path& path);

}  // namespace croquis::model
