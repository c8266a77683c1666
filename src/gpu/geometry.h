// Vertex data on the GPU, uploaded once and drawn many times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/context.h"

namespace croquis::gpu {

/// One attribute of a vertex, or of an instance: where its numbers stand in its buffer.
struct Attribute {
    enum class Kind { floats, bytes_to_unit };
    unsigned location = 0;  ///< as in the shader's layout
    int count = 0;          ///< numbers, 1 to 4
    Kind kind = Kind::floats;
    std::size_t offset = 0;
};

/// A buffer of vertices or instances and what stands in it.
struct VertexBuffer {
    std::span<const std::byte> bytes;
    std::size_t stride = 0;
    std::vector<Attribute> attributes;
    enum class Step { vertex, instance };
    Step step = Step::vertex;
};

/// Triangles of indexed vertices, or instances of a strip built in the vertex shader.
class Geometry {
public:
    /// Triangles: three indices each.
    Geometry(Context& context, std::span<const VertexBuffer> buffers, std::span<const std::uint32_t> triangles);
    /// Instances without indices, each `strip_vertices` vertices of a triangle strip told apart by gl_VertexID.
    Geometry(Context& context, std::span<const VertexBuffer> buffers, int strip_vertices, int instances);
    ~Geometry();
    Geometry(const Geometry&) = delete;
    Geometry& operator=(const Geometry&) = delete;

    /// Replaces the bytes of one buffer with as many others (a new pose of the same mesh).
    void update(std::size_t buffer, std::span<const std::byte> bytes);

    void draw() const;
    /// Draws a stretch of the triangles alone: `count` indices from `first` on.
    void draw(std::size_t first, std::size_t count) const;
    /// Uploads other triangles of the same vertices and draws these alone: slow, for what changes with each frame.
    void draw(std::span<const std::uint32_t> triangles);

private:
    void upload(std::span<const VertexBuffer> buffers);

    Context* context_;
    unsigned array_ = 0;
    std::vector<unsigned> buffers_;
    unsigned indices_ = 0;
    unsigned passing_indices_ = 0;  // made when first needed
    int index_count_ = 0;
    int strip_vertices_ = 0;
    int instances_ = 0;
};

/// A triangle that covers the whole target: the one way to draw a full-screen pass. The vertex shader makes it from
/// gl_VertexID.
class FullScreenTriangle {
public:
    explicit FullScreenTriangle(Context& context);
    ~FullScreenTriangle();
    FullScreenTriangle(const FullScreenTriangle&) = delete;
    FullScreenTriangle& operator=(const FullScreenTriangle&) = delete;
    void draw() const;

private:
    Context* context_;
    unsigned array_ = 0;
};

}  // namespace croquis::gpu
