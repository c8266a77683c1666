#include "model/vertices.h"

#include <bit>
#include <cstring>
#include <vector>

namespace croquis::model {
namespace {

constexpr std::uint32_t unused = 0xffffffffu;

/// Calls `visit` with each list of one entry a vertex.
template <typename Visit>
void visit_vertex_lists(Mesh& mesh, MeshRig* rig, const Visit& visit) {
    visit(mesh.positions);
    visit(mesh.normals);
    visit(mesh.texcoords);
    visit(mesh.colors);
    if (rig == nullptr) return;
    visit(rig->positions);
    visit(rig->normals);
    visit(rig->bones);
    visit(rig->weights);
    for (Shape& shape : rig->shapes) {
        visit(shape.positions);
        visit(shape.normals);
    }
}

/// Keeps the vertices `kept`, which rise, and renumbers the triangles by `number_of`.
void keep_vertices(Mesh& mesh, MeshRig* rig, std::span<const std::uint32_t> kept,
                   std::span<const std::uint32_t> number_of) {
    visit_vertex_lists(mesh, rig, [&](auto& list) {
        if (list.empty()) return;
        for (std::size_t n = 0; n < kept.size(); ++n) list[n] = list[kept[n]];
        list.resize(kept.size());
        list.shrink_to_fit();
    });
    for (std::uint32_t& corner : mesh.triangles) corner = number_of[corner];
}

std::uint64_t hash_of_vertex(const Mesh& mesh, std::uint32_t v) {
    std::uint64_t hash = 0;
    const auto mix = [&](const auto& list) {
        if (list.empty()) return;
        std::uint32_t words[sizeof(list[v]) / 4];
        std::memcpy(words, &list[v], sizeof words);
        for (const std::uint32_t word : words) {
            hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
            hash ^= hash >> 32;
        }
    };
    mix(mesh.positions);
    mix(mesh.normals);
    mix(mesh.texcoords);
    mix(mesh.colors);
    return hash;
}

bool same_vertex(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
    const auto same = [&](const auto& list) {
        return list.empty() || std::memcmp(&list[a], &list[b], sizeof list[a]) == 0;
    };
    return same(mesh.positions) && same(mesh.normals) && same(mesh.texcoords) && same(mesh.colors);
}

}  // namespace

void append_copies(Mesh& mesh, MeshRig* rig, std::span<const std::uint32_t> sources) {
    if (sources.empty()) return;
    visit_vertex_lists(mesh, rig, [&](auto& list) {
        if (list.empty()) return;
        list.reserve(list.size() + sources.size());
        for (const std::uint32_t source : sources) list.push_back(list[source]);
    });
}

void drop_unused_vertices(Mesh& mesh, MeshRig* rig) {
    std::vector<std::uint32_t> number_of(mesh.positions.size(), unused);
    for (const std::uint32_t corner : mesh.triangles) number_of[corner] = 0;
    std::vector<std::uint32_t> kept;
    for (std::uint32_t v = 0; v < number_of.size(); ++v) {
        if (number_of[v] == unused) continue;
        number_of[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(v);
    }
    if (kept.size() < mesh.positions.size()) keep_vertices(mesh, rig, kept, number_of);
}

void join_vertices(Mesh& mesh, MeshRig* rig, const Progress& progress) {
    if (rig != nullptr && (!rig->bones.empty() || !rig->shapes.empty())) return;
    for (const std::uint32_t corner : mesh.triangles) {
        if (corner >= mesh.positions.size()) return;  // `finish` sorts that out
    }
    const auto count = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<std::uint32_t> slots(std::bit_ceil(std::size_t{count} + count / 2 + 2), unused);
    std::vector<std::uint32_t> number_of(count), kept;
    for (std::uint32_t v = 0; v < count; ++v) {
        reach_now_and_then(progress, v, count);
        std::size_t slot = hash_of_vertex(mesh, v) & (slots.size() - 1);
        while (slots[slot] != unused && !same_vertex(mesh, kept[slots[slot]], v))
            slot = (slot + 1) & (slots.size() - 1);
        if (slots[slot] == unused) {
            slots[slot] = static_cast<std::uint32_t>(kept.size());
            kept.push_back(v);
        }
        number_of[v] = slots[slot];
    }
    if (kept.size() < count) keep_vertices(mesh, rig, kept, number_of);
}

}  // namespace croquis::model
