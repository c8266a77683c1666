#include "gpu/texture.h"

#include <epoxy/gl.h>

#include <cassert>
#include <cstring>
#include <string>

#include "base/error.h"

namespace croquis::gpu {
namespace {

struct GlFormat {
    GLint internal;
    GLenum format;
    GLenum type;
};

GlFormat gl_format(TextureFormat format) {
    switch (format) {
        case TextureFormat::rgba8:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case TextureFormat::rgba16f:
            return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
        case TextureFormat::depth:
            return {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
    }
    return {};
}

GLenum target_of(TextureShape shape) {
    switch (shape) {
        case TextureShape::flat:
            return GL_TEXTURE_2D;
        case TextureShape::volume:
            return GL_TEXTURE_3D;
        case TextureShape::layers:
            return GL_TEXTURE_2D_ARRAY;
    }
    return GL_TEXTURE_2D;
}

// Of the texture that is bound to the target.
void set_sampling(GLenum target, GLint minify, GLint magnify, GLint wrap) {
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
}

std::string bottom_row_first(const std::uint8_t* pixels, int width, int height) {
    const std::size_t row = std::size_t(width) * 4;
    std::string flipped(row * std::size_t(height), '\0');
    for (int y = 0; y < height; ++y) {
        std::memcpy(flipped.data() + row * std::size_t(height - 1 - y), pixels + row * std::size_t(y), row);
    }
    return flipped;
}

// The same of each slice.
std::string bottom_row_first(const Slices& slices) {
    const std::size_t bytes = std::size_t(slices.width) * std::size_t(slices.height) * 4;
    assert(slices.pixels.size() == bytes * std::size_t(slices.count));
    std::string flipped;
    flipped.reserve(slices.pixels.size());
    for (std::size_t i = 0; i < slices.pixels.size(); i += bytes) {
        flipped += bottom_row_first(slices.pixels.data() + i, slices.width, slices.height);
    }
    return flipped;
}

void upload(GLenum target, int level, const Slices& slices) {
    const std::string rows = bottom_row_first(slices);
    glTexImage3D(target, level, GL_RGBA8, slices.width, slices.height, slices.count, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 rows.data());
}

// OpenGL draws black with a texture that is too large, and says nothing.
void expect_to_fit(const char* what, const Slices& slices, int longest_side, int most_slices) {
    if (slices.width <= longest_side && slices.height <= longest_side && slices.count <= most_slices) return;
    fail("expected {} of at most {} x {} x {} pixels, found {} x {} x {}", what, longest_side, longest_side,
         most_slices, slices.width, slices.height, slices.count);
}

}  // namespace

Texture::Texture(Context& context, TextureFormat format, int width, int height)
    : context_(&context), format_(format), width_(width), height_(height) {
    create();
    set_sampling(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    allocate();
}

Texture::Texture(Context& context, const std::uint8_t* pixels, int width, int height, Filter filter, Wrap wrap)
    : context_(&context), format_(TextureFormat::rgba8), width_(width), height_(height) {
    create();
    ++context_->counters().texture_uploads;
    const GLint gl_wrap = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    const std::string rows = bottom_row_first(pixels, width, height);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    if (filter == Filter::trilinear) {
        set_sampling(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, gl_wrap);
        glGenerateMipmap(GL_TEXTURE_2D);
    } else {
        set_sampling(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST, gl_wrap);
    }
}

Texture::Texture(Context& context, const Slices& volume, Filter filter)
    : context_(&context),
      shape_(TextureShape::volume),
      format_(TextureFormat::rgba8),
      width_(volume.width),
      height_(volume.height) {
    expect_to_fit("a volume", volume, context.longest_volume_side(), context.longest_volume_side());
    create();
    ++context_->counters().texture_uploads;
    upload(GL_TEXTURE_3D, 0, volume);
    const GLint within_level = filter == Filter::trilinear ? GL_LINEAR : GL_NEAREST;
    set_sampling(GL_TEXTURE_3D, within_level, within_level, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
}

Texture::Texture(Context& context, std::span<const Slices> levels, Filter filter)
    : context_(&context),
      shape_(TextureShape::layers),
      format_(TextureFormat::rgba8),
      width_(levels.front().width),
      height_(levels.front().height) {
    expect_to_fit("layers", levels.front(), context.longest_side(), context.most_layers());
    create();
    ++context_->counters().texture_uploads;
    for (std::size_t level = 0; level < levels.size(); ++level) upload(GL_TEXTURE_2D_ARRAY, int(level), levels[level]);
    const bool is_smooth = filter == Filter::trilinear;
    set_sampling(GL_TEXTURE_2D_ARRAY, is_smooth ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST,
                 is_smooth ? GL_LINEAR : GL_NEAREST, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, GLint(levels.size()) - 1);
}

Texture::~Texture() {
    glDeleteTextures(1, &id_);
    --context_->counters().live_textures;
}

void Texture::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    glBindTexture(GL_TEXTURE_2D, id_);
    allocate();
}

// Makes the object and leaves it bound.
void Texture::create() {
    glGenTextures(1, &id_);
    ++context_->counters().live_textures;
    glBindTexture(target_of(shape_), id_);
}

void Texture::allocate() {
    assert(shape_ == TextureShape::flat && width_ > 0 && height_ > 0);
    const GlFormat gl = gl_format(format_);
    glTexImage2D(GL_TEXTURE_2D, 0, gl.internal, width_, height_, 0, gl.format, gl.type, nullptr);
}

void Texture::bind(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(target_of(shape_), id_);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace croquis::gpu
