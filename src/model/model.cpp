#include "model/model.h"

namespace croquis::model {

std::size_t Model::triangle_count() const {
    std::size_t count = 0;
    for (const Mesh& mesh : meshes) count += mesh.triangle_count();
    return count;
}

std::size_t Model::vertex_count() const {
    std::size_t count = 0;
    for (const Mesh& mesh : meshes) count += mesh.positions.size();
    return count;
}

const Topology& Model::topology() const {
    std::call_once(topology_once_,
                   [this] { topology_ = std::make_unique<const Topology>(weld(meshes, tagged_edges)); });
    return *topology_;
}

}  // namespace croquis::model
