// A model on the GPU: its meshes uploaded once, its materials' textures, its edges when someone draws them.
#pragma once

#include <array>
#include <functional>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/resources.h"
#include "framework/scene_geometry.h"
#include "gpu/geometry.h"
#include "gpu/state.h"
#include "model/camera.h"
#include "model/model.h"

namespace croquis::framework {

/// Which objects a pass draws: the words of the variable `objects`. Each is a pattern with `*` and `?` that a mesh's or
/// a material's name matches, or `#3` for region 3; with a `-` before it, what matches is left out. No words: all.
class ObjectSelection {
public:
    explicit ObjectSelection(const std::string& words);
    [[nodiscard]] bool includes(const model::Model& model, const model::Mesh& mesh) const;

private:
    struct Word {
        std::string pattern;
        bool excludes = false;
    };
    std::vector<Word> words_;
};

class Scene {
public:
    /// Uploads the model.
    Scene(Resources& resources, std::shared_ptr<const model::Model> model);

    [[nodiscard]] const model::Model& model() const { return *model_; }
    [[nodiscard]] const model::Pose* pose() const { return pose_.get(); }
    /// The same to keep: whoever holds both knows whether the surface is still the one that it was. No pose: at rest.
    [[nodiscard]] const std::shared_ptr<const model::Model>& shared_model() const { return model_; }
    [[nodiscard]] const std::shared_ptr<const model::Pose>& shared_pose() const { return pose_; }
    [[nodiscard]] const glm::mat4& scene_from_model() const { return scene_from_model_; }

    /// The box of the vertices as they stand now, in scene space.
    [[nodiscard]] const model::Bounds& bounds() const { return bounds_; }

    /// Moves the vertices to a pose of the model. Nothing else is uploaded again.
    void set_pose(model::Pose pose);
    /// Back to the model at rest.
    void clear_pose();

    struct SurfaceOptions {
        /// Faces that turn away are then left out where the mesh is closed, for nobody can see them.
        bool eye_is_outside = false;
        const gpu::Texture* texture_for_all = nullptr;  ///< in place of each material's own
        float scale = 1;                                ///< of each mesh, about the middle of its box
        SurfaceKind kind = SurfaceKind::smooth;         ///< what the program reads at the vertices
        int texture_colors = 0;  ///< each material's own texture brought to so many colours; 0: as it is
        /// One list a mesh of the triangles to draw in place of all, front and back, uploaded with each draw.
        const std::vector<std::vector<std::uint32_t>>* triangles = nullptr;
    };

    /// Draws the surfaces of the selected meshes with the program in use, giving it each one's material. Texture unit 0
    /// is taken.
    void draw_surfaces(const ObjectSelection& selection, const gpu::Program& program, gpu::DrawState state,
                       const SurfaceOptions& options);

    enum class Edges { all, tagged };

    [[nodiscard]] bool has_tagged_edges() const { return !model_->topology().tagged_edges.empty(); }

    /// Draws the selected meshes' edges with the bound program: one instance an edge, of four strip vertices, with both
    /// end points and both face normals as attributes.
    void draw_edges(const ObjectSelection& selection, Edges which);

private:
    struct Part {
        std::array<std::unique_ptr<MeshGeometry>, 4> surfaces;  // by kind; but for smooth ones made when first drawn
        std::shared_ptr<const gpu::Texture> texture;
        gpu::Cull cull = gpu::Cull::none;
        glm::vec3 middle{0.0f};                               // of its box, as the vertices stand now
        std::array<std::unique_ptr<gpu::Geometry>, 2> edges;  // all and tagged, made when first drawn
        std::optional<float> texcoord_scale;                  // found when a program first asks
    };

    struct ReducedTexture {
        int colors = 0;
        std::shared_ptr<const gpu::Texture> texture;
    };

    void move_vertices();
    [[nodiscard]] MeshGeometry& surface(std::size_t mesh, SurfaceKind kind);
    [[nodiscard]] std::span<const glm::vec3> positions(std::size_t mesh) const;
    [[nodiscard]] std::span<const glm::vec3> normals(std::size_t mesh) const;
    [[nodiscard]] float texcoord_scale(std::size_t mesh);
    void find_bounds();
    [[nodiscard]] glm::mat4 scaled(const Part& part, float scale) const;
    [[nodiscard]] const gpu::Texture& surface_texture(std::size_t mesh, const SurfaceOptions& options);
    [[nodiscard]] const gpu::Texture& reduced_texture(const std::shared_ptr<const image::Image>& image, int colors);
    [[nodiscard]] std::unique_ptr<gpu::Geometry> make_edges(std::size_t mesh, Edges which) const;

    Resources* resources_;
    std::shared_ptr<const model::Model> model_;
    std::shared_ptr<const model::Pose> pose_;
    glm::mat4 scene_from_model_;
    model::Bounds bounds_;
    std::vector<Part> parts_;  // one a mesh
    // Textures in fewer colours, each made when first drawn; of each image the last few, for the number is a slider.
    std::map<const image::Image*, std::vector<ReducedTexture>> reduced_textures_;
};

}  // namespace croquis::framework
