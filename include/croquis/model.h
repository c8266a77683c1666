// Models, read from files.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace croquis {

namespace model {
struct Model;
}

struct View;
class LineDrawing;
struct LineOptions;
struct FaceOrientationOptions;
struct FaceOrientationResult;

/// A stretch of movement that a model brings along.
struct Animation {
    std::string name;
    double seconds = 0;
};

/// Called while a model is read, now and then and on the thread that reads, with the share that is done: from 0 to 1,
/// never less than before. Where it returns false, reading ends soon, with an Error that says "cancelled". Formats that
/// other libraries parse (all but OBJ, PLY and MD2) tell little and end late: a parser cannot be stopped in its middle.
using LoadProgress = std::function<bool(double share)>;

/// A model: meshes, materials, textures, animations. It does not change; copies share it.
class Model {
public:
    /// Reads OBJ (+MTL), MD2, OFF, ASE, PLY, STL, glTF 2 (.gltf, .glb), 3DS or VRML 2 (.wrl), by the file's ending.
    ///
    /// `texture` is an image for all surfaces in place of the materials' own, the skin of an MD2 for one. Throws Error
    /// for a file that is missing, damaged or without surfaces.
    [[nodiscard]] static Model load(const std::string& path, const std::string& texture = {},
                                    const LoadProgress& progress = {});

    /// The endings that `load` reads, each with its dot, in lower case.
    [[nodiscard]] static std::vector<std::string> readable_endings();

    [[nodiscard]] std::size_t triangle_count() const;
    [[nodiscard]] std::size_t mesh_count() const;
    [[nodiscard]] std::vector<Animation> animations() const;

    /// Two opposite corners of the bounding box, in the file's coordinates.
    [[nodiscard]] std::array<double, 3> low_corner() const;
    [[nodiscard]] std::array<double, 3> high_corner() const;

    /// The model as a smooth surface: its faces cut into four so many times, 0 to 5, its points moved to the limit.
    /// `scheme` is loop or catmull-clark. The result stands still. Throws Error.
    [[nodiscard]] Model subdivided(const std::string& scheme, int levels) const;

    /// The model in so many triangles, give or take 3 %: a level of detail. Its outline, materials, seams and
    /// animations are kept; a model of no more triangles comes back as it is. Throws Error where the model cannot do
    /// with so few.
    [[nodiscard]] Model simplified(std::size_t triangles) const;

    /// A rough copy of about so many triangles in a hundredth of the time: vertices in a cell of a grid become one. For
    /// previews of very large models; neither closedness nor seams are kept. Throws Error where nothing would be left.
    [[nodiscard]] Model clustered(std::size_t triangles) const;

private:
    friend class Renderer;
    friend struct View;
    friend LineDrawing draw_lines(const Model& model, const LineOptions& options);
    friend std::vector<FaceOrientationResult> compare_face_orientations(const Model& model,
                                                                        const FaceOrientationOptions& options);
    explicit Model(std::shared_ptr<const model::Model> model) : model_(std::move(model)) {}
    std::shared_ptr<const model::Model> model_;
};

}  // namespace croquis
