// Reading model files: one table of formats, one way in.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/progress.h"

namespace croquis::model {

struct LoadOptions {
    /// Faces whose normals lie within this angle of each other share a smooth vertex, where the file says nothing of
    /// normals or smoothing groups. Radians.
    float crease_angle = 0.8727f;  // 50 degrees
    /// An image in place of every material's own texture (an MD2's skin, for one); none when empty.
    std::filesystem::path texture;
    Progress progress;
};

/// Reads OBJ (+MTL), MD2, OFF, ASE, PLY, STL, glTF 2 (.gltf, .glb), 3DS and VRML 2 (.wrl), by the file's ending, and
/// finishes it. Throws Error for a file that is missing, damaged, larger than the bound or without triangles: lines
/// and points alone are no surface to draw.
[[nodiscard]] std::shared_ptr<const Model> load(const std::filesystem::path& path, const LoadOptions& options = {});

/// The endings that `load` reads, lower case, each with its dot.
[[nodiscard]] std::vector<std::string> readable_endings();

/// What a reader of one format hands over, before it is checked and completed.
struct RawMesh {
    Mesh mesh;                                    ///< normals may be missing, or not of unit length
    std::vector<std::uint32_t> smoothing_groups;  ///< one bit set a triangle (0: flat), or none
};
struct RawModel {
    std::vector<RawMesh> meshes;
    std::vector<Material> materials;
    std::vector<AnimationClip> clips;
    Rig rig;
    std::vector<TaggedEdge> tagged_edges;
    glm::dvec3 origin{0.0};
};

/// Checks and completes what a reader found: drops faces with indices out of range, points that are not finite and
/// faces of no area, computes missing normals (angle-weighted, honouring smoothing groups or the crease angle), turns
/// faces to agree with given normals, gives regions their ids. Throws Error, naming `name`, when nothing is left.
[[nodiscard]] std::shared_ptr<const Model> finish(RawModel raw, const std::string& name,
                                                  const LoadOptions& options = {});

}  // namespace croquis::model
