#include "gpu/texture.h"

#include <epoxy/gl.h>

#include <cassert>
#include <cstring>
#include <string>

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

void set_sampling(GLint minify, GLint magnify, GLint wrap) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

std::string bottom_row_first(const std::uint8_t* pixels, int width, int height) {
    const std::size_t row = std::size_t(width) * 4;
    std::string flipped(row * std::size_t(height), '\0');
    for (int y = 0; y < height; ++y) {
        std::memcpy(flipped.data() + row * std::size_t(height - 1 - y), pixels + row * std::size_t(y), row);
    }
    return flipped;
}

}  // namespace

Texture::Texture(Context& context, TextureFormat format, int width, int height)
    : context_(&context), format_(format), width_(width), height_(height) {
    glGenTextures(1, &id_);
    ++context_->counters().live_textures;
    glBindTexture(GL_TEXTURE_2D, id_);
    set_sampling(GL_NEAREST, GL_NEAREST, GL_CLAMP_TO_EDGE);
    allocate();
}

Texture::Texture(Context& context, const std::uint8_t* pixels, int width, int height, Filter filter, Wrap wrap)
    : context_(&context), format_(TextureFormat::rgba8), width_(width), height_(height) {
    glGenTextures(1, &id_);
    ++context_->counters().live_textures;
    ++context_->counters().texture_uploads;
    glBindTexture(GL_TEXTURE_2D, id_);
    const GLint gl_wrap = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    const std::string rows = bottom_row_first(pixels, width, height);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    if (filter == Filter::trilinear) {
        set_sampling(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, gl_wrap);
        glGenerateMipmap(GL_TEXTURE_2D);
    } else {
        set_sampling(GL_NEAREST, GL_NEAREST, gl_wrap);
    }
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

void Texture::allocate() {
    assert(width_ > 0 && height_ > 0);
    const GlFormat gl = gl_format(format_);
    glTexImage2D(GL_TEXTURE_2D, 0, gl.internal, width_, height_, 0, gl.format, gl.type, nullptr);
}

void Texture::bind(int unit) const {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, id_);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace croquis::gpu
