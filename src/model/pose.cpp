// Evaluating animation clips: first the skeleton, then each mesh's shapes, then its bones or its node.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "base/error.h"
#include "base/names.h"
#include "base/parallel.h"
#include "model/model.h"

namespace croquis::model {
namespace {

/// Two keys around a moment, and how far it is from the first to the second.
template <typename Value>
struct Between {
    const Value& before;
    const Value& after;
    float share;
};

template <typename Value>
Between<Value> around(const std::vector<Key<Value>>& keys, double time) {
    const auto after =
        std::upper_bound(keys.begin(), keys.end(), time, [](double t, const Key<Value>& key) { return t < key.time; });
    if (after == keys.begin()) return {keys.front().value, keys.front().value, 0};
    if (after == keys.end()) return {keys.back().value, keys.back().value, 0};
    const auto before = after - 1;
    return {before->value, after->value, static_cast<float>((time - before->time) / (after->time - before->time))};
}

glm::vec3 value_at(const std::vector<Key<glm::vec3>>& keys, double time, const glm::vec3& at_rest) {
    if (keys.empty()) return at_rest;
    const auto [before, after, share] = around(keys, time);
    return glm::mix(before, after, share);
}

glm::quat value_at(const std::vector<Key<glm::quat>>& keys, double time, const glm::quat& at_rest) {
    if (keys.empty()) return at_rest;
    const auto [before, after, share] = around(keys, time);
    return glm::normalize(glm::slerp(before, after, share));
}

std::vector<float> value_at(const std::vector<Key<std::vector<float>>>& keys, double time, std::size_t count) {
    std::vector<float> weights(count, 0.0f);
    if (keys.empty()) return weights;
    const auto [before, after, share] = around(keys, time);
    const auto at = [](const std::vector<float>& list, std::size_t i) { return i < list.size() ? list[i] : 0.0f; };
    for (std::size_t i = 0; i < count; ++i) weights[i] = glm::mix(at(before, i), at(after, i), share);
    return weights;
}

/// Every node's transform to the model's space.
std::vector<glm::mat4> node_transforms(const Rig& rig, const AnimationClip& clip, double time) {
    std::vector<const NodeTrack*> track_of(rig.nodes.size(), nullptr);
    for (const NodeTrack& track : clip.nodes) {
        if (track.node < track_of.size()) track_of[track.node] = &track;
    }
    static const NodeTrack at_rest;
    std::vector<glm::mat4> transforms;
    for (std::size_t n = 0; n < rig.nodes.size(); ++n) {
        const Node& node = rig.nodes[n];
        const NodeTrack& track = track_of[n] != nullptr ? *track_of[n] : at_rest;
        const glm::mat4 moved = glm::translate(glm::mat4(1.0f), value_at(track.translations, time, node.translation));
        const glm::mat4 turned = moved * glm::mat4_cast(value_at(track.rotations, time, node.rotation));
        const glm::mat4 local = glm::scale(turned, value_at(track.scales, time, node.scale));
        transforms.push_back(node.parent < 0 ? local : transforms[static_cast<std::size_t>(node.parent)] * local);
    }
    return transforms;
}

void add_shapes(const MeshRig& rig, std::span<const float> weights, MeshPose& pose) {
    for (std::size_t s = 0; s < rig.shapes.size(); ++s) {
        if (weights[s] == 0.0f) continue;
        const Shape& shape = rig.shapes[s];
        for (std::size_t v = 0; v < pose.positions.size(); ++v) {
            pose.positions[v] += weights[s] * (shape.positions[v] - rig.positions[v]);
        }
        for (std::size_t v = 0; v < pose.normals.size() && v < shape.normals.size(); ++v) {
            pose.normals[v] += weights[s] * (shape.normals[v] - rig.normals[v]);
        }
    }
}

/// A shape that holds alone is that shape, to the last bit.
MeshPose shaped(const MeshRig& rig, std::span<const float> weights) {
    const auto is_zero = [](float weight) { return weight == 0.0f; };
    const auto alone = std::find_if_not(weights.begin(), weights.end(), is_zero);
    if (alone != weights.end() && *alone == 1.0f && std::all_of(alone + 1, weights.end(), is_zero)) {
        const Shape& shape = rig.shapes[static_cast<std::size_t>(alone - weights.begin())];
        return {shape.positions, shape.normals.empty() ? rig.normals : shape.normals};
    }
    MeshPose pose{rig.positions, rig.normals};
    add_shapes(rig, weights, pose);
    return pose;
}

void place(MeshPose& pose, std::size_t v, const glm::mat4& transform, const glm::mat3& for_normals) {
    pose.positions[v] = glm::vec3(transform * glm::vec4(pose.positions[v], 1.0f));
    if (v < pose.normals.size()) pose.normals[v] = for_normals * pose.normals[v];
}

void follow_bones(const MeshRig& rig, std::span<const glm::mat4> nodes, MeshPose& pose) {
    std::vector<glm::mat4> bones;
    for (std::size_t b = 0; b < rig.bone_nodes.size(); ++b)
        bones.push_back(nodes[rig.bone_nodes[b]] * rig.bone_offsets[b]);
    parallel_for(pose.positions.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            glm::mat4 blend(0.0f);
            for (std::size_t i = 0; i < 4; ++i) {
                if (rig.weights[v][i] != 0.0f) blend += rig.weights[v][i] * bones[rig.bones[v][i]];
            }
            place(pose, v, blend, glm::inverseTranspose(glm::mat3(blend)));
        }
    });
}

void follow_node(const glm::mat4& transform, MeshPose& pose) {
    if (transform == glm::mat4(1.0f)) return;
    const glm::mat3 for_normals = glm::inverseTranspose(glm::mat3(transform));
    for (std::size_t v = 0; v < pose.positions.size(); ++v) place(pose, v, transform, for_normals);
}

void normalize(MeshPose& pose) {
    for (glm::vec3& normal : pose.normals) {
        const float length = glm::length(normal);
        normal = std::isfinite(length) && length > 1e-12f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

MeshPose mesh_pose(const Model& model, std::size_t mesh, const AnimationClip& clip, double time,
                   std::span<const glm::mat4> nodes) {
    const MeshRig& rig = model.rig.meshes[mesh];
    const auto track =
        std::find_if(clip.shapes.begin(), clip.shapes.end(), [&](const ShapeTrack& one) { return one.mesh == mesh; });
    const auto weights = track == clip.shapes.end() ? std::vector<float>(rig.shapes.size(), 0.0f)
                                                    : value_at(track->weights, time, rig.shapes.size());
    MeshPose pose = shaped(rig, weights);
    if (!rig.bones.empty()) {
        follow_bones(rig, nodes, pose);
    } else if (rig.node < nodes.size()) {
        follow_node(nodes[rig.node], pose);
    }
    if (model.origin != glm::dvec3(0.0)) {
        for (glm::vec3& p : pose.positions) p = glm::vec3(glm::dvec3(p) - model.origin);
    }
    normalize(pose);
    return pose;
}

double wrapped(double seconds, double length) {
    if (!(length > 0) || !std::isfinite(seconds)) return 0;
    const double time = std::fmod(seconds, length);
    return time < 0 ? time + length : time;
}

}  // namespace

Pose pose_at(const Model& model, const AnimationClip& clip, double seconds) {
    const double time = seconds == clip.seconds ? seconds : wrapped(seconds, clip.seconds);
    const std::vector<glm::mat4> nodes = node_transforms(model.rig, clip, time);
    Pose pose;
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        if (m < model.rig.meshes.size()) {
            pose.push_back(mesh_pose(model, m, clip, time, nodes));
        } else {
            pose.push_back({model.meshes[m].positions, model.meshes[m].normals});
        }
    }
    return pose;
}

const AnimationClip& find_clip(const Model& model, std::string_view name) {
    std::vector<std::string> names;
    for (const AnimationClip& clip : model.clips) {
        if (clip.name == name) return clip;
        names.push_back(clip.name);
    }
    if (names.empty()) fail("{}: expected animation clip \"{}\", found a model without clips", model.name, name);
    fail("{}: no animation clip \"{}\"; it has {}{}", model.name, name, fmt::join(names, ", "),
         suggestion(name, names));
}

}  // namespace croquis::model
