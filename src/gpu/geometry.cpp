#include "gpu/geometry.h"

#include <epoxy/gl.h>

#include <cassert>

namespace croquis::gpu {
namespace {

const void* as_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void point_at(const VertexBuffer& buffer) {
    for (const Attribute& attribute : buffer.attributes) {
        const bool is_float = attribute.kind == Attribute::Kind::floats;
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.count, is_float ? GL_FLOAT : GL_UNSIGNED_BYTE,
                              is_float ? GL_FALSE : GL_TRUE, GLsizei(buffer.stride), as_offset(attribute.offset));
        glVertexAttribDivisor(attribute.location, buffer.step == VertexBuffer::Step::instance ? 1 : 0);
    }
}

}  // namespace

Geometry::Geometry(Context& context, std::span<const VertexBuffer> buffers, std::span<const std::uint32_t> triangles)
    : context_(&context), index_count_(int(triangles.size())) {
    upload(buffers);
    glGenBuffers(1, &indices_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(triangles.size_bytes()), triangles.data(), GL_STATIC_DRAW);
    glBindVertexArray(0);
}

Geometry::Geometry(Context& context, std::span<const VertexBuffer> buffers, int strip_vertices, int instances)
    : context_(&context), strip_vertices_(strip_vertices), instances_(instances) {
    upload(buffers);
    glBindVertexArray(0);
}

void Geometry::upload(std::span<const VertexBuffer> buffers) {
    ++context_->counters().live_geometries;
    ++context_->counters().geometry_uploads;
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    buffers_.resize(buffers.size());
    glGenBuffers(GLsizei(buffers_.size()), buffers_.data());
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[i]);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(buffers[i].bytes.size()), buffers[i].bytes.data(), GL_STATIC_DRAW);
        point_at(buffers[i]);
    }
}

Geometry::~Geometry() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(GLsizei(buffers_.size()), buffers_.data());
    if (indices_ != 0) glDeleteBuffers(1, &indices_);
    if (passing_indices_ != 0) glDeleteBuffers(1, &passing_indices_);
    --context_->counters().live_geometries;
}

void Geometry::update(std::size_t buffer, std::span<const std::byte> bytes) {
    assert(buffer < buffers_.size());
    ++context_->counters().geometry_uploads;
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes.size()), bytes.data(), GL_DYNAMIC_DRAW);
}

void Geometry::draw() const {
    ++context_->counters().draws;
    glBindVertexArray(array_);
    if (indices_ != 0) {
        glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    } else {
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, strip_vertices_, instances_);
    }
    glBindVertexArray(0);
}

void Geometry::draw(std::size_t first, std::size_t count) const {
    assert(indices_ != 0);
    ++context_->counters().draws;
    glBindVertexArray(array_);
    glDrawElements(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_INT, as_offset(first * sizeof(std::uint32_t)));
    glBindVertexArray(0);
}

void Geometry::draw(std::span<const std::uint32_t> triangles) {
    assert(indices_ != 0);
    ++context_->counters().draws;
    ++context_->counters().geometry_uploads;
    if (passing_indices_ == 0) glGenBuffers(1, &passing_indices_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, passing_indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(triangles.size_bytes()), triangles.data(), GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, GLsizei(triangles.size()), GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBindVertexArray(0);
}

FullScreenTriangle::FullScreenTriangle(Context& context) : context_(&context) {
    ++context_->counters().live_geometries;
    glGenVertexArrays(1, &array_);
}

FullScreenTriangle::~FullScreenTriangle() {
    glDeleteVertexArrays(1, &array_);
    --context_->counters().live_geometries;
}

void FullScreenTriangle::draw() const {
    ++context_->counters().draws;
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace croquis::gpu
