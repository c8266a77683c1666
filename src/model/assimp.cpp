// OFF, ASE, STL, glTF and 3DS through Assimp, which only parses: polygons are cut, vertices joined and normals
// computed by our own code, alike for all formats.
#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <cctype>
#include <exception>
#include <memory>

#include "base/error.h"
#include "base/log.h"
#include "base/names.h"
#include "model/assimp_scene.h"
#include "model/readers.h"
#include "model/triangulate.h"
#include "model/vertices.h"

namespace croquis::model {
namespace {

/// Takes away all of Assimp's readers but those of one ending: it would otherwise guess a format by the file's content
/// and hand a damaged file to a reader that nobody asked for.
void keep_readers_of(Assimp::Importer& importer, const std::string& ending) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const std::string endings = importer.GetImporterInfo(i)->mFileExtensions;
        const std::vector<std::string> known = split(endings, " ");
        if (std::find(known.begin(), known.end(), ending) != known.end()) continue;
        const std::unique_ptr<Assimp::BaseImporter> gone(importer.GetImporter(i));
        importer.UnregisterLoader(gone.get());
    }
}

std::string one_line(std::string text) {
    for (char& c : text) {
        if (std::iscntrl(static_cast<unsigned char>(c))) c = ' ';
    }
    while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
    return text.empty() ? "damaged file" : text.substr(0, 300);
}

/// Passes on what Assimp tells, which some of its readers do and none does often. Nobody heeds what `Update` returns:
/// a reader that was cancelled goes on to its end.
class Listening final : public Assimp::ProgressHandler {
public:
    explicit Listening(const Progress& progress) : progress_(progress) {}

    bool Update(float share) override {
        if (!(share > reached_ && share <= 1)) return true;
        reached_ = share;
        try {
            progress_.reach(double(share));
        } catch (const Error&) {  // to be thrown again when Assimp is done
            return false;
        }
        return true;
    }

private:
    Progress progress_;
    float reached_ = 0;
};

const aiScene& read_scene(Assimp::Importer& importer, const std::filesystem::path& path, const std::string& ending,
                          const Progress& progress) {
    importer.SetProgressHandler(new Listening(progress));  // which the importer owns from now on
    const aiScene* scene = nullptr;
    std::string reason;
    try {
        keep_readers_of(importer, ending.substr(1));
        scene = importer.ReadFile(path.string(), 0);
        if (scene == nullptr) reason = importer.GetErrorString();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& exception) {
        reason = exception.what();
    }
    progress.reach(1);
    if (scene == nullptr)
        fail("{}: expected a sound {} file, found: {}", path.string(), ending.substr(1), one_line(reason));
    if (scene->mRootNode == nullptr) fail_without_triangles(path.string(), false);
    return *scene;
}

class SceneReader {
public:
    SceneReader(const aiScene& scene, const std::filesystem::path& path, std::string ending)
        : scene_(scene),
          name_(path.string()),
          ending_(std::move(ending)),
          textures_(path),
          nodes_(nodes_of(scene, name_)) {}

    RawModel read(const Progress& progress) {
        for (std::uint32_t n = 0; n < nodes_.size(); ++n) node_numbers_.try_emplace(nodes_[n].node->mName.C_Str(), n);
        for (std::uint32_t m = 0; m < scene_.mNumMaterials; ++m) {
            raw_.materials.push_back(read_material(*scene_.mMaterials[m], scene_, ending_, name_, textures_));
        }
        const bool moves = scene_.mNumAnimations > 0;
        for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
            const aiNode& node = *nodes_[n].node;
            const Progress adding =
                progress.part(double(n) / double(nodes_.size()), double(n + 1) / double(nodes_.size()));
            for (std::uint32_t i = 0; i < node.mNumMeshes; ++i) {
                if (node.mMeshes[i] < scene_.mNumMeshes)
                    add_mesh({scene_.mMeshes[node.mMeshes[i]], n}, moves,
                             adding.part(double(i) / node.mNumMeshes, double(i + 1) / node.mNumMeshes));
            }
        }
        if (placed_.empty()) fail_without_triangles(name_, found_other_);
        if (moves) read_animations(scene_, nodes_, placed_, raw_);
        return std::move(raw_);
    }

private:
    void add_mesh(const PlacedMesh& placed, bool moves, const Progress& progress) {
        const aiMesh& given = *placed.mesh;
        RawMesh raw;
        Mesh& mesh = raw.mesh;
        read_triangles(given, mesh);
        if (mesh.triangles.empty()) {
            found_other_ = found_other_ || given.mNumFaces > 0 || given.mNumVertices > 0;
            return;
        }
        constexpr std::size_t most_vertices = std::size_t{1} << 30;  // of all copies that nodes make of meshes
        vertices_ += given.mNumVertices;
        if (vertices_ > most_vertices) fail("{}: expected fewer than {} vertices, found more", name_, most_vertices);
        const std::string node_name = nodes_[placed.node].node->mName.C_Str();
        mesh.name = node_name.empty() ? given.mName.C_Str() : node_name;
        mesh.material = given.mMaterialIndex;
        MeshRig rig = rig_of(placed, node_numbers_);
        if (ending_ == ".stl") rig.normals.clear();  // one a face there: that is what the winding says already
        place_at_rest(placed, rig, nodes_, mesh);
        read_colors(given, mesh);
        join_vertices(mesh, &rig, progress);
        if (moves) raw_.rig.meshes.push_back(std::move(rig));
        raw_.meshes.push_back(std::move(raw));
        placed_.push_back(placed);
    }

    void read_triangles(const aiMesh& given, Mesh& mesh) const {
        std::vector<glm::dvec3> polygon;
        std::vector<std::uint32_t> cut;
        for (std::uint32_t f = 0; f < given.mNumFaces; ++f) {
            const aiFace& face = given.mFaces[f];
            const std::uint32_t* const corners = face.mIndices;
            if (face.mNumIndices < 3) continue;
            if (face.mNumIndices == 3) {
                mesh.triangles.insert(mesh.triangles.end(), corners, corners + 3);
                continue;
            }
            polygon.clear();
            cut.clear();
            for (std::uint32_t i = 0; i < face.mNumIndices; ++i) {
                const bool known = corners[i] < given.mNumVertices;
                polygon.emplace_back(known ? to_glm(given.mVertices[corners[i]]) : glm::vec3(0.0f));
            }
            triangulate(polygon, cut);
            for (const std::uint32_t corner : cut) mesh.triangles.push_back(corners[corner]);
        }
    }

    static void read_colors(const aiMesh& given, Mesh& mesh) {
        for (std::uint32_t v = 0; given.HasTextureCoords(0) && v < given.mNumVertices; ++v) {
            mesh.texcoords.emplace_back(given.mTextureCoords[0][v].x, given.mTextureCoords[0][v].y);
        }
        if (!given.HasVertexColors(0)) return;
        const auto channel = [](float value) {
            return static_cast<std::uint8_t>(value > 0 ? std::min(value, 1.0f) * 255.0f + 0.5f : 0.0f);
        };
        for (std::uint32_t v = 0; v < given.mNumVertices; ++v) {
            const aiColor4D& c = given.mColors[0][v];
            mesh.colors.emplace_back(channel(c.r), channel(c.g), channel(c.b), channel(c.a));
        }
    }

    const aiScene& scene_;
    std::string name_, ending_;
    TextureFinder textures_;
    std::vector<SceneNode> nodes_;
    std::unordered_map<std::string, std::uint32_t> node_numbers_;
    std::vector<PlacedMesh> placed_;
    RawModel raw_;
    std::size_t vertices_ = 0;
    bool found_other_ = false;
};

}  // namespace

glm::mat4 to_glm(const aiMatrix4x4& m) {
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

std::vector<SceneNode> nodes_of(const aiScene& scene, const std::string& name) {
    constexpr std::size_t most_nodes = 1 << 22;
    std::vector<SceneNode> nodes;
    nodes.push_back({scene.mRootNode, -1, to_glm(scene.mRootNode->mTransformation)});
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const SceneNode parent = nodes[n];
        if (nodes.size() + parent.node->mNumChildren > most_nodes)
            fail("{}: expected fewer than {} nodes", name, most_nodes);
        for (std::uint32_t c = 0; c < parent.node->mNumChildren; ++c) {
            const aiNode* const child = parent.node->mChildren[c];
            nodes.push_back({child, static_cast<std::int32_t>(n), parent.to_model * to_glm(child->mTransformation)});
        }
    }
    return nodes;
}

RawModel read_through_assimp(const std::filesystem::path& path, const Progress& progress) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    check_before_assimp(path, ending);
    Assimp::Importer importer;
    const aiScene& scene = read_scene(importer, path, ending, progress.part(0, 0.7));
    return SceneReader(scene, path, ending).read(progress.part(0.7, 1));
}

}  // namespace croquis::model
