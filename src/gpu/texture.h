// Textures. In this folder alone rows run bottom to top.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/context.h"

namespace croquis::gpu {

enum class TextureFormat {
    rgba8,    ///< colours
    rgba16f,  ///< where the context can draw to it
    depth,    ///< 24 bits of window-space depth, and 8 of stencil that samplers do not see
};

enum class Filter { nearest, trilinear };
enum class Wrap { repeat, clamp };

/// A two-dimensional texture. A one-dimensional map is N x 1.
class Texture {
public:
    Texture(Context& context, TextureFormat format, int width, int height);
    /// From 8-bit RGBA pixels whose rows run top to bottom.
    Texture(Context& context, const std::uint8_t* pixels, int width, int height, Filter filter, Wrap wrap);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] TextureFormat format() const { return format_; }
    [[nodiscard]] unsigned id() const { return id_; }

    /// Takes another size; the content is lost. Nothing happens when the size is the same.
    void resize(int width, int height);

    void bind(int unit) const;

private:
    void allocate();

    Context* context_;
    TextureFormat format_;
    int width_;
    int height_;
    unsigned id_ = 0;
};

}  // namespace croquis::gpu
