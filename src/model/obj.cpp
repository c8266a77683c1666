// Wavefront OBJ, our own reader: on the 69 thousand triangles of the bunny Assimp takes 104 ms and 300 bytes a
// triangle. Polygons only; curves and surfaces are skipped. The text is never held as a whole, and points are read in
// double so that a model far from its origin keeps its detail.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/log.h"
#include "model/mtl.h"
#include "model/obj_meshes.h"
#include "model/readers.h"
#include "model/text_lines.h"
#include "model/triangulate.h"

namespace croquis::model {
namespace {

class ObjReader {
public:
    explicit ObjReader(const std::filesystem::path& path) : lines_(path), name_(path.string()), textures_(path) {}

    RawModel read(const Progress& progress) {
        constexpr std::size_t lines_between = 1 << 12;
        const Progress reading = progress.part(0, 0.9);
        std::string_view line;
        for (std::size_t count = 1; lines_.next(line); ++count) {
            read_line(line);
            if (count % lines_between == 0) reading.reach(std::min(lines_.share(), 1.0));
        }
        if (meshes_.empty()) fail_without_triangles(name_, found_other_ || !lists_.points.empty());
        return build(progress.part(0.9, 1));
    }

private:
    void read_line(std::string_view line) {
        const std::string_view keyword = take_word(line);
        if (keyword == "v") return read_point(line);
        if (keyword == "f" || keyword == "fo") return read_face(line);
        if (keyword == "vn") return read_normal(line);
        if (keyword == "vt") return read_texcoord(line);
        if (keyword == "l") read_tagged_edges(line);
        if (keyword == "l" || keyword == "p") found_other_ = true;
        if (keyword == "usemtl") return use_material(std::string(trimmed(line)));
        if (keyword == "mtllib") return read_materials(trimmed(line));
        if (keyword == "s") return read_smoothing(line);
        if (keyword == "o") {
            object_ = trimmed(line);
            group_.clear();
            mesh_ = nullptr;
        } else if (keyword == "g") {
            group_ = trimmed(line);
            mesh_ = nullptr;
        }
    }

    [[noreturn]] void fail_number(std::string_view rest) {
        const std::string_view found = take_word(rest);
        if (found.empty()) fail_at(lines_.where(), "expected a number, found the end of the line");
        fail_at(lines_.where(), "expected a number, found \"{}\"", found.substr(0, 40));
    }

    double number(std::string_view& rest) {
        double value = 0;
        if (!take_number(rest, value)) fail_number(rest);
        return value;
    }

    void read_point(std::string_view rest) {
        const double x = number(rest), y = number(rest), z = number(rest);
        lists_.points.emplace_back(x, y, z);
        if (rest.empty() && lists_.colors.empty()) return;
        double color[3];
        if (take_number(rest, color[0]) && take_number(rest, color[1]) && take_number(rest, color[2])) {
            lists_.colors.resize(lists_.points.size(), glm::u8vec4(255));
            lists_.colors.back() = to_color(color);
        } else if (!lists_.colors.empty()) {
            lists_.colors.resize(lists_.points.size(), glm::u8vec4(255));
        }
    }

    /// Most files hold 0 to 1, a few 0 to 255.
    static glm::u8vec4 to_color(const double (&color)[3]) {
        const double scale = std::max({color[0], color[1], color[2]}) > 1.0 ? 1.0 : 255.0;
        glm::u8vec4 result(255);
        for (int c = 0; c < 3; ++c) {
            const double value = color[c] * scale + 0.5;
            result[c] = value > 0 ? static_cast<std::uint8_t>(std::min(value, 255.0)) : std::uint8_t{0};
        }
        return result;
    }

    void read_normal(std::string_view rest) {
        const double x = number(rest), y = number(rest), z = number(rest);
        lists_.normals.emplace_back(x, y, z);
    }

    void read_texcoord(std::string_view rest) {
        const double u = number(rest);
        double v = 0;
        static_cast<void>(take_number(rest, v));
        lists_.texcoords.emplace_back(u, v);
    }

    /// One index of a corner: from 1, or from the end where negative. `text` loses it.
    std::uint32_t take_index(const char*& at, const char* end, std::size_t size) {
        const bool negative = at < end && *at == '-';
        if (negative || (at < end && *at == '+')) ++at;
        const char* const first = at;
        std::uint64_t value = 0;
        for (; at < end && *at >= '0' && *at <= '9' && value < 0xffffffffull; ++at) {
            value = value * 10 + static_cast<std::uint64_t>(*at - '0');
        }
        if (at == first || value >= 0xffffffffull)
            fail_at(lines_.where(), "expected a vertex index, found something else");
        if (value == 0) return obj_none;  // no index at all: the face is dropped
        if (negative) return value <= size ? static_cast<std::uint32_t>(size - value) : obj_none;
        return static_cast<std::uint32_t>(value - 1);
    }

    void read_corners(std::string_view rest) {
        face_.clear();
        const char* at = rest.data();
        const char* const end = at + rest.size();
        while (true) {
            while (at < end && is_blank(*at)) ++at;
            if (at == end || *at == '#' || *at == '\r') return;
            ObjCorner corner;
            corner.point = take_index(at, end, lists_.points.size());
            if (at < end && *at == '/') {
                ++at;
                const bool has_texcoord = at < end && *at != '/' && !is_blank(*at);
                if (has_texcoord) corner.texcoord = take_index(at, end, lists_.texcoords.size());
                if (at < end && *at == '/' && ++at < end && !is_blank(*at)) {
                    corner.normal = take_index(at, end, lists_.normals.size());
                }
            }
            if (at < end && !is_blank(*at)) {
                fail_at(lines_.where(), "expected corners such as 1/2/3, found \"{}\"", rest.substr(0, 40));
            }
            face_.push_back(corner);
        }
    }

    /// A line along the edges of faces marks them to be drawn always.
    void read_tagged_edges(std::string_view rest) {
        read_corners(rest);
        for (std::size_t i = 1; i < face_.size(); ++i) tagged_.push_back({face_[i - 1].point, face_[i].point});
    }

    [[nodiscard]] std::vector<TaggedEdge> tagged_edges(const glm::dvec3& origin) const {
        std::vector<TaggedEdge> edges;
        for (const auto& [a, b] : tagged_) {
            if (a >= lists_.points.size() || b >= lists_.points.size()) continue;
            edges.push_back({glm::vec3(lists_.points[a] - origin), glm::vec3(lists_.points[b] - origin)});
        }
        return edges;
    }

    void read_face(std::string_view rest) {
        read_corners(rest);
        if (face_.size() < 3) {
            found_other_ = found_other_ || !face_.empty();
            return;
        }
        if (mesh_ == nullptr) mesh_ = &mesh_of_names();
        vertices_.clear();
        for (const ObjCorner& corner : face_) vertices_.push_back(mesh_->vertex(corner));
        if (face_.size() == 3) {
            mesh_->add_triangle(vertices_[0], vertices_[1], vertices_[2]);
        } else {
            cut_polygon();
        }
        if (saw_smoothing_) mesh_->set_smoothing(smoothing_);
    }

    void cut_polygon() {
        polygon_.clear();
        for (const ObjCorner& corner : face_) {
            const bool known = corner.point < lists_.points.size();
            polygon_.push_back(known ? lists_.points[corner.point] : glm::dvec3(0.0));
        }
        cut_.clear();
        triangulate(polygon_, cut_);
        for (std::size_t t = 0; t < cut_.size(); t += 3) {
            mesh_->add_triangle(vertices_[cut_[t]], vertices_[cut_[t + 1]], vertices_[cut_[t + 2]]);
        }
    }

    ObjMesh& mesh_of_names() {
        std::string name = object_.empty() || group_.empty() ? object_ + group_ : object_ + "/" + group_;
        const auto next = static_cast<std::uint32_t>(meshes_.size());
        const auto [entry, is_new] = mesh_numbers_.try_emplace({name, material_}, next);
        if (is_new) meshes_.emplace_back(std::move(name), number_of_material());
        return meshes_[entry->second];
    }

    std::uint32_t number_of_material() {
        const auto next = static_cast<std::uint32_t>(used_materials_.size());
        const auto [entry, is_new] = material_numbers_.try_emplace(material_, next);
        if (is_new) used_materials_.push_back(material_);
        return entry->second;
    }

    void use_material(std::string name) {
        material_ = std::move(name);
        mesh_ = nullptr;
    }

    /// `s off`, `s 0` or a group from 1. Groups past 32 share bits: neighbours of equal bits are rare.
    void read_smoothing(std::string_view rest) {
        saw_smoothing_ = true;
        double group = 0;
        if (!take_number(rest, group) || !(group >= 1)) {
            smoothing_ = 0;
        } else {
            smoothing_ = 1u << ((static_cast<std::uint64_t>(std::min(group, 1e9)) - 1) % 32);
        }
    }

    /// One file whose name may hold blanks or, as the format's text allows, several.
    void read_materials(std::string_view names) {
        if (!textures_.find(std::string(names)).empty()) return read_material_file(names);
        while (!names.empty()) {
            read_material_file(take_word(names));
            names = trimmed(names);
        }
    }

    void read_material_file(std::string_view file) {
        if (file.empty() || !material_files_.insert(std::string(file)).second) return;
        const std::filesystem::path path = textures_.find(std::string(file));
        if (path.empty()) return warn("{}: material file {} not found; drawn without it", name_, file);
        try {
            read_mtl(path, textures_, materials_);
        } catch (const Error& error) {
            warn("{}; drawn without it", error.what());
        }
    }

    RawModel build(const Progress& progress) {
        RawModel raw;
        glm::dvec3 low(1e300), high(-1e300);
        for (const glm::dvec3& p : lists_.points) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        if (!lists_.points.empty() && glm::length(high - low) < 1e18) raw.origin = suitable_origin(low, high);
        raw.tagged_edges = tagged_edges(raw.origin);
        for (ObjMesh& mesh : meshes_) {
            progress.reach(double(raw.meshes.size()) / double(meshes_.size()));
            raw.meshes.push_back(mesh.build(lists_, raw.origin));
        }
        for (const std::string& used : used_materials_) {
            const auto found = std::find_if(materials_.begin(), materials_.end(),
                                            [&](const Material& material) { return material.name == used; });
            raw.materials.push_back(found != materials_.end() ? *found : plain_material());
            raw.materials.back().name = used;
            if (found == materials_.end() && !used.empty() && !materials_.empty()) {
                warn("{}: material \"{}\" is in no material file; drawn plain", name_, used);
            }
        }
        return raw;
    }

    TextLines lines_;
    std::string name_;
    TextureFinder textures_;
    ObjLists lists_;
    std::vector<Material> materials_;
    std::set<std::string> material_files_;

    std::vector<ObjMesh> meshes_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> mesh_numbers_;  // of (name, material)
    std::map<std::string, std::uint32_t> material_numbers_;
    std::vector<std::string> used_materials_;
    ObjMesh* mesh_ = nullptr;  // of the names that hold now; null when they changed
    std::string object_, group_, material_;
    std::uint32_t smoothing_ = 0;
    bool saw_smoothing_ = false, found_other_ = false;

    std::vector<std::array<std::uint32_t, 2>> tagged_;  // pairs of points

    std::vector<ObjCorner> face_;  // kept to save allocations
    std::vector<std::uint32_t> vertices_, cut_;
    std::vector<glm::dvec3> polygon_;
};

}  // namespace

RawModel read_obj(const std::filesystem::path& path, const Progress& progress) {
    return ObjReader(path).read(progress);
}

}  // namespace croquis::model
