// VRML 2 (and 1) through Coin, which parses the scene and cuts every shape into triangles.
#include <Inventor/SbColor.h>
#include <Inventor/SbMatrix.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLBox.h>
#include <Inventor/VRMLnodes/SoVRMLCone.h>
#include <Inventor/VRMLnodes/SoVRMLCylinder.h>
#include <Inventor/VRMLnodes/SoVRMLElevationGrid.h>
#include <Inventor/VRMLnodes/SoVRMLExtrusion.h>
#include <Inventor/VRMLnodes/SoVRMLImageTexture.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLShape.h>
#include <Inventor/VRMLnodes/SoVRMLSphere.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

#include <algorithm>
#include <array>
#include <glm/mat3x3.hpp>
#include <map>
#include <mutex>
#include <tuple>

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "model/readers.h"
#include "model/textures.h"
#include "model/vertices.h"
#include "model/vrml_checks.h"

namespace croquis::model {
namespace {

constexpr std::size_t most_visits = 4'000'000;  // nodes; a scene that uses itself doubles without end
constexpr std::size_t most_triangles = 50'000'000;

/// Keeps Coin's messages off the terminal while it reads; the first one is the reason of a failure.
class QuietCoin {
public:
    QuietCoin()
        : before_(SoError::getHandlerCallback()),
          read_before_(SoReadError::getHandlerCallback()),
          debug_before_(SoDebugError::getHandlerCallback()) {
        SoError::setHandlerCallback(note, this);
        SoReadError::setHandlerCallback(note, this);
        SoDebugError::setHandlerCallback(note, this);
    }
    ~QuietCoin() {
        SoError::setHandlerCallback(before_, nullptr);
        SoReadError::setHandlerCallback(read_before_, nullptr);
        SoDebugError::setHandlerCallback(debug_before_, nullptr);
    }
    QuietCoin(const QuietCoin&) = delete;
    QuietCoin& operator=(const QuietCoin&) = delete;

    [[nodiscard]] std::string reason() const {
        std::string line = first_.substr(0, first_.find('\n'));
        while (!line.empty() && (line.back() == '.' || line.back() == ' ')) line.pop_back();
        return line.empty() ? "damaged file" : line.substr(0, 200);
    }

private:
    static void note(const SoError* error, void* self) {
        auto& first = static_cast<QuietCoin*>(self)->first_;
        if (first.empty()) first = error->getDebugString().getString();
    }

    SoErrorCB* before_;
    SoErrorCB* read_before_;
    SoErrorCB* debug_before_;
    std::string first_;
};

/// Releases a scene: Coin counts references.
struct Unreference {
    void operator()(SoNode* node) const { node->unref(); }
};
using Scene = std::unique_ptr<SoNode, Unreference>;

class SceneWalk {
public:
    explicit SceneWalk(const std::filesystem::path& path) : name_(path.string()), textures_(path) {}

    RawModel read(SoNode* scene, const Progress& progress) {
        SoCallbackAction action;
        action.addPreCallback(SoNode::getClassTypeId(), visit<&SceneWalk::count>, this);
        action.addPreCallback(SoVRMLShape::getClassTypeId(), visit<&SceneWalk::begin_appearance>, this);
        action.addPreCallback(SoVRMLImageTexture::getClassTypeId(), visit<&SceneWalk::begin_texture>, this);
        action.addPreCallback(SoShape::getClassTypeId(), visit<&SceneWalk::begin_shape>, this);
        action.addTriangleCallback(SoShape::getClassTypeId(), add_triangle, this);
        action.apply(scene);
        if (visits_ > most_visits) fail("{}: expected fewer than {} nodes, found more", name_, most_visits);
        if (triangles_ > most_triangles)
            fail("{}: expected fewer than {} triangles, found more", name_, most_triangles);
        if (raw_.meshes.empty()) fail_without_triangles(name_, found_other_);
        for (std::size_t m = 0; m < raw_.meshes.size(); ++m) {
            progress.reach(double(m) / double(raw_.meshes.size()));
            complete(raw_.meshes[m].mesh);
        }
        return std::move(raw_);
    }

private:
    using Response = SoCallbackAction::Response;

    template <Response (SceneWalk::*method)(SoCallbackAction*, const SoNode*)>
    static Response visit(void* self, SoCallbackAction* action, const SoNode* node) {
        return (static_cast<SceneWalk*>(self)->*method)(action, node);
    }

    Response count(SoCallbackAction*, const SoNode*) {
        return ++visits_ > most_visits || triangles_ > most_triangles ? SoCallbackAction::ABORT
                                                                      : SoCallbackAction::CONTINUE;
    }

    Response begin_appearance(SoCallbackAction*, const SoNode*) {
        texture_.clear();
        return SoCallbackAction::CONTINUE;
    }

    Response begin_texture(SoCallbackAction*, const SoNode* node) {
        const auto* const texture = static_cast<const SoVRMLImageTexture*>(node);
        if (texture->url.getNum() > 0) texture_ = texture->url[0].getString();
        return SoCallbackAction::CONTINUE;
    }

    /// Coin computes normals where the file gives none; those are left to our own code, unless the file names a crease
    /// angle: then Coin's follow it.
    Response begin_shape(SoCallbackAction* action, const SoNode* node) {
        keep_normals_ = false;
        if (node->isOfType(SoVRMLIndexedFaceSet::getClassTypeId())) {
            const auto* const faces = static_cast<const SoVRMLIndexedFaceSet*>(node);
            if (!is_sound(*faces)) {
                warn("{}: a face set has indices beyond its lists; left out", name_);
                return SoCallbackAction::PRUNE;
            }
            keep_normals_ = faces->normal.getValue() != nullptr || faces->creaseAngle.getValue() > 0;
        } else if (!is_surface(node)) {
            found_other_ = true;
            return SoCallbackAction::PRUNE;
        }
        shape_name_.clear();
        const SoPath* const path = action->getCurPath();
        for (int i = path->getLength(); i-- > 0 && shape_name_.empty();) {
            shape_name_ = path->getNode(i)->getName().getString();
        }
        return SoCallbackAction::CONTINUE;
    }

    static bool is_surface(const SoNode* node) {
        const SoType types[] = {SoVRMLBox::getClassTypeId(),       SoVRMLCone::getClassTypeId(),
                                SoVRMLCylinder::getClassTypeId(),  SoVRMLElevationGrid::getClassTypeId(),
                                SoVRMLExtrusion::getClassTypeId(), SoVRMLSphere::getClassTypeId()};
        return std::any_of(std::begin(types), std::end(types), [&](const SoType& t) { return node->isOfType(t); });
    }

    struct Surface {
        SbColor ambient, diffuse, specular, emission;
        float shininess = 0, transparency = 0;
    };

    static Surface surface_of(SoCallbackAction* action, int index) {
        Surface s;
        action->getMaterial(s.ambient, s.diffuse, s.specular, s.emission, s.shininess, s.transparency, index);
        return s;
    }

    static glm::vec3 to_glm(const SbVec3f& v) { return {v[0], v[1], v[2]}; }

    std::uint32_t number_of_material(const Surface& s) {
        const auto values = [](const SbColor& c) { return std::array<float, 3>{c[0], c[1], c[2]}; };
        const auto next = static_cast<std::uint32_t>(raw_.materials.size());
        const auto [entry, is_new] = material_numbers_.try_emplace(
            {texture_, values(s.ambient), values(s.diffuse), values(s.specular), s.shininess, s.transparency}, next);
        if (!is_new) return entry->second;
        Material material;
        material.name = fmt::format("material{}", next + 1);
        material.diffuse = glm::clamp(to_glm(s.diffuse), 0.0f, 1.0f);
        material.specular = glm::clamp(to_glm(s.specular), 0.0f, 1.0f);
        material.ambient = sensible_ambient(glm::clamp(to_glm(s.ambient), 0.0f, 1.0f), material.diffuse);
        material.shininess = sensible_shininess(s.shininess * 128.0f);  // 0 to 1 in the file
        material.opacity = std::clamp(1.0f - s.transparency, 0.0f, 1.0f);
        if (!texture_.empty()) textures_.attach(material, texture_);
        raw_.materials.push_back(std::move(material));
        return next;
    }

    /// The mesh of the shape's name and material. Shapes whose vertices differ in colour keep their first material.
    Mesh& mesh_of(SoCallbackAction* action) {
        const std::uint32_t material = number_of_material(surface_of(action, 0));
        const auto next = static_cast<std::uint32_t>(raw_.meshes.size());
        const auto [entry, is_new] = mesh_numbers_.try_emplace({shape_name_, material, keep_normals_}, next);
        if (is_new) {
            raw_.meshes.emplace_back();
            raw_.meshes.back().mesh.name = shape_name_;
            raw_.meshes.back().mesh.material = material;
        }
        return raw_.meshes[entry->second].mesh;
    }

    static void add_triangle(void* self, SoCallbackAction* action, const SoPrimitiveVertex* a,
                             const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
        auto& walk = *static_cast<SceneWalk*>(self);
        if (++walk.triangles_ > most_triangles) return;
        const SbMatrix& matrix = action->getModelMatrix();
        const bool mirrored = matrix.det3() < 0;
        const bool clockwise = action->getVertexOrdering() == SoShapeHints::CLOCKWISE;
        if (mirrored != clockwise) std::swap(b, c);
        Mesh& mesh = walk.mesh_of(action);
        for (const SoPrimitiveVertex* vertex : {a, b, c}) walk.add_vertex(action, *vertex, matrix, mesh);
    }

    void add_vertex(SoCallbackAction* action, const SoPrimitiveVertex& vertex, const SbMatrix& matrix, Mesh& mesh) {
        SbVec3f point, normal;
        matrix.multVecMatrix(vertex.getPoint(), point);
        mesh.triangles.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(to_glm(point));
        if (keep_normals_) {
            matrix.inverse().transpose().multDirMatrix(vertex.getNormal(), normal);
            mesh.normals.push_back(to_glm(normal));
        }
        if (!texture_.empty()) {
            const SbVec4f& t = vertex.getTextureCoords();
            mesh.texcoords.emplace_back(t[0], t[1]);
        }
        if (vertex.getMaterialIndex() > 0 || !mesh.colors.empty()) {
            const Surface s = surface_of(action, vertex.getMaterialIndex());
            const glm::vec3 color = glm::clamp(to_glm(s.diffuse), 0.0f, 1.0f) * 255.0f + 0.5f;
            const Surface first = surface_of(action, 0);
            const glm::vec3 before = glm::clamp(to_glm(first.diffuse), 0.0f, 1.0f) * 255.0f + 0.5f;
            mesh.colors.resize(mesh.positions.size() - 1, glm::u8vec4(before, 255));
            mesh.colors.emplace_back(color, 255);
        }
    }

    /// Colours at the vertices replace the material's in VRML, and are multiplied with it in ours.
    void complete(Mesh& mesh) {
        if (!mesh.colors.empty()) {
            Material white = raw_.materials[mesh.material];
            white.diffuse = glm::vec3(1.0f);
            mesh.material = static_cast<std::uint32_t>(raw_.materials.size());
            raw_.materials.push_back(std::move(white));
        }
        join_vertices(mesh);
    }

    using MaterialKey =
        std::tuple<std::string, std::array<float, 3>, std::array<float, 3>, std::array<float, 3>, float, float>;

    std::string name_;
    TextureFinder textures_;
    RawModel raw_;
    std::map<MaterialKey, std::uint32_t> material_numbers_;
    std::map<std::tuple<std::string, std::uint32_t, bool>, std::uint32_t> mesh_numbers_;
    std::string texture_, shape_name_;
    bool keep_normals_ = false, found_other_ = false;
    std::size_t visits_ = 0, triangles_ = 0;
};

Scene read_scene(const std::string& bytes, const std::string& name, const QuietCoin& coin) {
    SoInput input;
    input.setBuffer(bytes.data(), bytes.size());
    SoSeparator* const scene = SoDB::readAll(&input);
    if (scene == nullptr) fail("{}: expected a sound VRML file, found: {}", name, coin.reason());
    scene->ref();
    return Scene(scene);
}

}  // namespace

// Coin parses at one go: only between its stages is there anything to tell.
RawModel read_vrml(const std::filesystem::path& path, const Progress& progress) {
    const std::string name = path.string();
    const std::string bytes = read_file(path, largest_file);
    check_vrml(bytes, name);
    static std::mutex one_at_a_time;  // Coin keeps its state in globals
    const std::lock_guard lock(one_at_a_time);
    static const bool ready = [] {
        SoDB::init();
        return true;
    }();
    static_cast<void>(ready);
    const QuietCoin coin;
    progress.reach(0.1);
    const Scene scene = read_scene(bytes, name, coin);
    progress.reach(0.5);
    return SceneWalk(path).read(scene.get(), progress.part(0.5, 1));
}

}  // namespace croquis::model
