// Any model as a smooth surface: Loop's and Catmull and Clark's subdivision (seed D, 5), through OpenSubdiv.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/model.h"

namespace croquis::model {

enum class SubdivisionScheme : std::uint8_t {
    loop,           ///< made for triangles: each becomes four
    catmull_clark,  ///< made for quadrangles. Models hold triangles: the first level cuts each into three quadrangles
};

/// Both names, as the command line writes them: "loop" and "catmull-clark".
[[nodiscard]] std::vector<std::string> subdivision_scheme_names();
/// Throws Error with the nearest name.
[[nodiscard]] SubdivisionScheme subdivision_scheme(std::string_view name);

constexpr int most_subdivision_levels = 5;

/// How many triangles `subdivide` makes of so many. Four times as many a level; with Catmull-Clark six times at the
/// first, since each quadrangle is cut into two triangles in the end.
[[nodiscard]] std::size_t subdivided_triangle_count(std::size_t triangles, SubdivisionScheme scheme, int levels);

/// The model refined so many times, 0 to 5, its vertices moved onto the limit surface and given that surface's normals.
///
/// The control mesh is the welded model: meshes and materials that touch are one smooth surface and keep their faces.
/// - Borders become the cubic B-splines of their points; a corner that one face alone holds stays where it is.
/// - Creases: without `crease_angle` none is sharp. With it, edges that bend the surface by more (radians) become sharp
///   curves, and vertices where three or more of them meet stay sharp (Hoppe's piecewise smooth surfaces).
/// - Edges of three and more faces, and edges whose two faces are wound against each other, are sharp: the sheets that
///   meet there stay together, and each follows the border rule. So is a vertex at which two sheets touch in a point.
/// - Texture coordinates and vertex colours are interpolated linearly within each face of the model, so that seams stay
///   seams. Tagged edges pass on to the edges they are cut into.
/// - The result stands still: clips move the vertices of a mesh, which are no longer there. Level 0 keeps them.
///
/// Throws Error for other levels, for more than 20 million triangles, and for more than 32767 faces at a vertex.
/// Takes some 350 bytes of memory a triangle of the result while it works.
[[nodiscard]] std::shared_ptr<const Model> subdivide(const Model& model, SubdivisionScheme scheme, int levels,
                                                     std::optional<double> crease_angle = std::nullopt);

}  // namespace croquis::model
