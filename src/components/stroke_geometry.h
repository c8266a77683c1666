// Strokes as triangles for the GPU: each pixel of a stroke is covered once, so that a translucent one stays even.
#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gpu/geometry.h"
#include "lines/stroke.h"
#include "lines/stroke_mesh.h"

namespace croquis::components {

/// A corner of a stroke's triangles, as data/shaders/strokes.glsl reads it.
struct StrokeCorner {
    glm::vec2 position;  ///< pixels of the frame, from its upper left corner; y points down
    /// Of an even stroke, in pixels of the frame: how far past its segment's start and past its end, along the spine;
    /// how far beside the spine; and how far from it ink can be, half the width and half a pixel that fades. Of a
    /// textured one: the texture's coordinates, and nothing.
    glm::vec4 place;
    glm::u8vec4 color;  ///< not multiplied by opacity
};

/// Strokes of one brush that follow each other.
struct StrokePart {
    std::string texture;  ///< of the brush; empty: even ink
    std::size_t first_index = 0;
    std::size_t index_count = 0;
};

struct StrokeTriangles {
    std::vector<StrokeCorner> corners;
    std::vector<std::uint32_t> indices;  ///< three a triangle
    std::vector<StrokePart> parts;       ///< in painting order
};

/// The triangles of strokes in a frame of `pixel_scale` pixels along one of the strokes'.
///
/// Each segment of an even stroke becomes a quadrangle that ends on the bisectors of its joints, so that none covers
/// another; the distance of a pixel from the spine, which the fragment shader computes, rounds corners and ends and
/// fades the border. Where the spine turns sharply, a wedge fills the outer side. Where it turns within less than half
/// the stroke's width, quadrangles overlap on the inner side. Textured strokes are ribbons (lines/stroke_mesh.h).
[[nodiscard]] StrokeTriangles triangles_of(const lines::Strokes& strokes, float pixel_scale,
                                           const lines::TextureAspect& aspect = {});

/// The triangles on the GPU, for the vertex function strokes:stroke_corner.
[[nodiscard]] std::unique_ptr<gpu::Geometry> upload(gpu::Context& context, const StrokeTriangles& triangles);

}  // namespace croquis::components
