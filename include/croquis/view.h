// How a model is looked at and lit, and what stands behind it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace croquis {

class Model;

/// Three numbers: a point or a direction, x, y, z; y points up.
using Vector3 = std::array<double, 3>;

/// Where the eye stands. Points are in the model file's coordinates.
struct View {
    Vector3 direction{1.0, 0.7, 1.0};  ///< from the centre of the bounding box to the eye
    /// The eye stands at the nearest distance at which every vertex lies within this share of the frame.
    double fit = 0.9;
    std::optional<Vector3> eye;     ///< in place of direction and fit
    std::optional<Vector3> target;  ///< what is looked at; the centre of the bounding box where not given
    Vector3 up{0.0, 1.0, 0.0};
    double field_of_view = 40.0;  ///< of the frame's height, in degrees
    bool parallel = false;        ///< parallel projection in place of perspective

    /// front, back, left, right, top, bottom or iso. Throws Error with the nearest name.
    [[nodiscard]] static View named(const std::string& name);

    /// The same view with its eye and target said, where direction and fit put them for the model at rest in a frame of
    /// `aspect` = width / height: what an interactive camera starts from. Throws Error for a view that makes no sense.
    [[nodiscard]] View placed(const Model& model, double aspect) const;
};

/// The one light.
struct Light {
    /// Where the light belongs: it goes with the viewer, stays in the world, or stands at a point of the world.
    enum class Bound { viewer, world, point };
    Bound bound = Bound::viewer;
    /// viewer: towards the light, along the camera's right, up and back. world: towards the light. point: its position
    /// in the file's coordinates.
    Vector3 place{-0.5, 0.7, 1.0};
    Vector3 color{1.0, 1.0, 1.0};
};

/// What stands behind the drawing in place of the technique's own colour.
struct Background {
    Vector3 color{1.0, 1.0, 1.0};  ///< red, green, blue, 0 to 1
    bool transparent = false;
    std::string texture;  ///< an image of the data folder, `directory:image`, tiled; none when empty
};

/// Everything of a drawing that is not the model and the technique.
struct DrawOptions {
    int width = 1024;
    int height = 768;
    /// Samples a pixel: 1, 4, 9 or 16. With more than one the whole technique is drawn larger, its lines as wide as
    /// before, and averaged.
    int samples = 1;
    View view{};
    Light light{};
    std::optional<Background> background{};
    std::string animation{};  ///< name of the model's animation; at rest when empty
    double time = 0;          ///< seconds into the animation
    std::uint64_t seed = 0;   ///< of everything random
};

}  // namespace croquis
