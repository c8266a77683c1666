// Bones, shapes and key frames of Assimp's scenes.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <utility>

#include "model/assimp_scene.h"

namespace croquis::model {
namespace {

void copy(const aiVector3D* from, std::size_t count, std::vector<glm::vec3>& to) {
    if (from == nullptr) return;
    to.reserve(count);
    for (std::size_t i = 0; i < count; ++i) to.push_back(to_glm(from[i]));
}

/// Gives a vertex to a bone, in place of its weakest where it has four.
void add_weight(MeshRig& rig, std::size_t vertex, std::uint16_t bone, float weight) {
    if (!std::isfinite(weight) || !(weight > 0)) return;
    auto& weights = rig.weights[vertex];
    const auto weakest = static_cast<std::size_t>(std::min_element(weights.begin(), weights.end()) - weights.begin());
    if (weights[weakest] >= weight) return;
    weights[weakest] = weight;
    rig.bones[vertex][weakest] = bone;
}

/// Shares that sum to 1; vertices of no bone follow the mesh's node, as one bone more.
void complete_weights(MeshRig& rig) {
    const auto own = static_cast<std::uint16_t>(rig.bone_nodes.size());
    rig.bone_nodes.push_back(rig.node);
    rig.bone_offsets.emplace_back(1.0f);
    for (std::size_t v = 0; v < rig.weights.size(); ++v) {
        auto& weights = rig.weights[v];
        const float sum = weights[0] + weights[1] + weights[2] + weights[3];
        if (sum > 1e-6f) {
            for (float& weight : weights) weight /= sum;
        } else {
            weights = {1.0f, 0.0f, 0.0f, 0.0f};
            rig.bones[v][0] = own;
        }
    }
}

void read_bones(const aiMesh& mesh, const std::unordered_map<std::string, std::uint32_t>& node_numbers, MeshRig& rig) {
    constexpr std::uint32_t most_bones = 65534;
    if (mesh.mNumBones == 0) return;
    rig.bones.assign(mesh.mNumVertices, {});
    rig.weights.assign(mesh.mNumVertices, {});
    for (std::uint32_t b = 0; b < std::min(mesh.mNumBones, most_bones); ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const auto node = node_numbers.find(bone.mName.C_Str());
        if (node == node_numbers.end()) continue;
        const auto number = static_cast<std::uint16_t>(rig.bone_nodes.size());
        rig.bone_nodes.push_back(node->second);
        rig.bone_offsets.push_back(to_glm(bone.mOffsetMatrix));
        for (std::uint32_t w = 0; w < bone.mNumWeights; ++w) {
            const aiVertexWeight& weight = bone.mWeights[w];
            if (weight.mVertexId < mesh.mNumVertices) add_weight(rig, weight.mVertexId, number, weight.mWeight);
        }
    }
    complete_weights(rig);
}

/// The weights of a mesh's shapes at rest.
std::vector<float> rest_weights(const aiMesh& mesh) {
    std::vector<float> weights;
    for (std::uint32_t s = 0; s < mesh.mNumAnimMeshes; ++s) {
        const float weight = mesh.mAnimMeshes[s]->mWeight;
        weights.push_back(std::isfinite(weight) ? weight : 0.0f);
    }
    return weights;
}

template <typename Keys>
void sort_keys(Keys& keys) {
    std::erase_if(keys, [](const auto& key) { return !std::isfinite(key.time); });
    std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
}

template <typename Given, typename Value>
void read_keys(const Given* given, std::uint32_t count, double ticks, std::vector<Key<Value>>& keys) {
    for (std::uint32_t k = 0; given != nullptr && k < count; ++k) {
        keys.push_back({given[k].mTime / ticks, to_glm(given[k].mValue)});
    }
    sort_keys(keys);
}

class AnimationReader {
public:
    AnimationReader(const aiScene& scene, const std::vector<SceneNode>& nodes, const std::vector<PlacedMesh>& placed)
        : scene_(scene), nodes_(nodes), placed_(placed) {
        for (std::uint32_t n = 0; n < nodes.size(); ++n) numbers_.try_emplace(nodes[n].node->mName.C_Str(), n);
    }

    void read(RawModel& raw) const {
        for (const SceneNode& one : nodes_) raw.rig.nodes.push_back(node_at_rest(one));
        for (std::uint32_t a = 0; a < scene_.mNumAnimations; ++a) {
            AnimationClip clip = clip_of(*scene_.mAnimations[a]);
            if (clip.name.empty()) clip.name = "animation" + std::to_string(a + 1);
            if (!clip.nodes.empty() || !clip.shapes.empty()) raw.clips.push_back(std::move(clip));
        }
    }

private:
    static Node node_at_rest(const SceneNode& one) {
        Node node;
        node.name = one.node->mName.C_Str();
        node.parent = one.parent;
        aiVector3D scale, translation;
        aiQuaternion rotation;
        one.node->mTransformation.Decompose(scale, rotation, translation);
        node.translation = to_glm(translation);
        node.rotation = to_glm(rotation);
        node.scale = to_glm(scale);
        return node;
    }

    AnimationClip clip_of(const aiAnimation& given) const {
        AnimationClip clip;
        clip.name = given.mName.C_Str();
        const double ticks = given.mTicksPerSecond > 0 ? given.mTicksPerSecond : 25.0;
        for (std::uint32_t c = 0; c < given.mNumChannels; ++c) {
            const aiNodeAnim& channel = *given.mChannels[c];
            const auto node = numbers_.find(channel.mNodeName.C_Str());
            if (node == numbers_.end()) continue;
            NodeTrack track;
            track.node = node->second;
            read_keys(channel.mPositionKeys, channel.mNumPositionKeys, ticks, track.translations);
            read_keys(channel.mRotationKeys, channel.mNumRotationKeys, ticks, track.rotations);
            read_keys(channel.mScalingKeys, channel.mNumScalingKeys, ticks, track.scales);
            clip.nodes.push_back(std::move(track));
        }
        for (std::uint32_t m = 0; m < placed_.size(); ++m) add_shapes(given, m, ticks, clip);
        clip.seconds = given.mDuration / ticks;
        if (!std::isfinite(clip.seconds) || clip.seconds < 0) clip.seconds = 0;
        return clip;
    }

    void add_shapes(const aiAnimation& given, std::uint32_t mesh, double ticks, AnimationClip& clip) const {
        if (placed_[mesh].mesh->mNumAnimMeshes == 0) return;
        ShapeTrack track;
        track.mesh = mesh;
        const aiString& node_name = nodes_[placed_[mesh].node].node->mName;
        for (std::uint32_t c = 0; c < given.mNumMorphMeshChannels; ++c) {
            const aiMeshMorphAnim& channel = *given.mMorphMeshChannels[c];
            if (channel.mName == node_name) read_weights(channel, placed_[mesh].mesh->mNumAnimMeshes, ticks, track);
        }
        if (track.weights.empty()) track.weights.push_back({0.0, rest_weights(*placed_[mesh].mesh)});
        clip.shapes.push_back(std::move(track));
    }

    static void read_weights(const aiMeshMorphAnim& channel, std::uint32_t shapes, double ticks, ShapeTrack& track) {
        for (std::uint32_t k = 0; k < channel.mNumKeys; ++k) {
            const aiMeshMorphKey& key = channel.mKeys[k];
            std::vector<float> weights(shapes, 0.0f);
            for (std::uint32_t w = 0; w < key.mNumValuesAndWeights; ++w) {
                if (key.mValues[w] < shapes) weights[key.mValues[w]] = static_cast<float>(key.mWeights[w]);
            }
            track.weights.push_back({key.mTime / ticks, std::move(weights)});
        }
        sort_keys(track.weights);
    }

    const aiScene& scene_;
    const std::vector<SceneNode>& nodes_;
    const std::vector<PlacedMesh>& placed_;
    std::unordered_map<std::string, std::uint32_t> numbers_;
};

}  // namespace

MeshRig rig_of(const PlacedMesh& placed, const std::unordered_map<std::string, std::uint32_t>& node_numbers) {
    const aiMesh& mesh = *placed.mesh;
    MeshRig rig;
    rig.node = placed.node;
    copy(mesh.mVertices, mesh.mNumVertices, rig.positions);
    copy(mesh.mNormals, mesh.mNumVertices, rig.normals);
    read_bones(mesh, node_numbers, rig);
    for (std::uint32_t s = 0; s < mesh.mNumAnimMeshes; ++s) {
        const aiAnimMesh& given = *mesh.mAnimMeshes[s];
        Shape shape;
        shape.name = given.mName.C_Str();
        const bool fits = given.mNumVertices == mesh.mNumVertices && given.mVertices != nullptr;
        if (fits) {
            copy(given.mVertices, given.mNumVertices, shape.positions);
            copy(given.mNormals, given.mNumVertices, shape.normals);
        } else {
            shape.positions = rig.positions;  // keeps the weights' numbering
            shape.normals = rig.normals;
        }
        rig.shapes.push_back(std::move(shape));
    }
    return rig;
}

void place_at_rest(const PlacedMesh& placed, const MeshRig& rig, const std::vector<SceneNode>& nodes, Mesh& mesh) {
    mesh.positions = rig.positions;
    mesh.normals = rig.normals;
    const std::vector<float> weights = rest_weights(*placed.mesh);
    for (std::size_t s = 0; s < weights.size(); ++s) {
        if (weights[s] == 0.0f) continue;
        const Shape& shape = rig.shapes[s];
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            mesh.positions[v] += weights[s] * (shape.positions[v] - rig.positions[v]);
        }
        for (std::size_t v = 0; v < mesh.normals.size() && v < shape.normals.size(); ++v) {
            mesh.normals[v] += weights[s] * (shape.normals[v] - rig.normals[v]);
        }
    }
    const glm::mat4& by_node = nodes[rig.node].to_model;
    if (rig.bones.empty() && by_node == glm::mat4(1.0f)) return;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::mat4 blend = by_node;
        if (!rig.bones.empty()) {
            blend = glm::mat4(0.0f);
            for (std::size_t i = 0; i < 4; ++i) {
                const std::uint16_t bone = rig.bones[v][i];
                if (rig.weights[v][i] == 0.0f) continue;
                blend += rig.weights[v][i] * (nodes[rig.bone_nodes[bone]].to_model * rig.bone_offsets[bone]);
            }
        }
        mesh.positions[v] = glm::vec3(blend * glm::vec4(mesh.positions[v], 1.0f));
        if (!mesh.normals.empty()) mesh.normals[v] = glm::inverseTranspose(glm::mat3(blend)) * mesh.normals[v];
    }
    if (rig.bones.empty() && glm::determinant(glm::mat3(by_node)) < 0) {  // a mirror turns all faces inside out
        for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
            std::swap(mesh.triangles[t + 1], mesh.triangles[t + 2]);
    }
}

void read_animations(const aiScene& scene, const std::vector<SceneNode>& nodes, const std::vector<PlacedMesh>& placed,
                     RawModel& raw) {
    AnimationReader(scene, nodes, placed).read(raw);
}

}  // namespace croquis::model
