// Which meshes are closed bodies, wound one way.
#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/topology.h"

namespace croquis::model {

/// Two faces of one mesh that share an edge and are wound alike across it.
using FacesAlike = std::pair<std::uint32_t, std::uint32_t>;

/// Meshes of which no edge was found yet that is open, crowded or wound two ways. Shared between threads.
using SolidMeshes = std::vector<std::atomic<bool>>;

/// Fills `mesh_is_solid`: of the meshes whose edges are all in order, those remain whose connected parts are all wound
/// outside out, or all inside out: no rule about faces that turn away serves both. `on_crowded_edges` are the pairs on
/// edges where several meshes meet.
void fill_solidity(Topology& topology, const SolidMeshes& in_order, std::span<const FacesAlike> on_crowded_edges);

}  // namespace croquis::model
