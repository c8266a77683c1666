// Textures. In this folder alone rows run bottom to top.
#pragma once

#include <cstdint>
#include <span>
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

/// How a shader addresses a texture: by two coordinates (sampler2D; a one-dimensional map is N x 1), by three
/// (sampler3D), or by two and the number of a layer (sampler2DArray).
enum class TextureShape { flat, volume, layers };

/// Slices of one size behind each other, each of 8-bit RGBA pixels whose rows run top to bottom.
struct Slices {
    std::vector<std::uint8_t> pixels;
    int width = 0;
    int height = 0;
    int count = 0;
};

class Texture {
public:
    Texture(Context& context, TextureFormat format, int width, int height);
    /// From 8-bit RGBA pixels whose rows run top to bottom.
    Texture(Context& context, const std::uint8_t* pixels, int width, int height, Filter filter, Wrap wrap);
    /// A volume: repeated across, held at its first and last slice in depth. It has one mip level. Throws Error
    /// for one that is larger than the context's volumes can be.
    Texture(Context& context, const Slices& volume, Filter filter);
    /// Layers whose mip levels are given, each half the size of the one before, down to one pixel; repeated. Throws
    /// Error for more layers, or larger ones, than the context can have.
    Texture(Context& context, std::span<const Slices> levels, Filter filter);
    ~Texture();
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] TextureFormat format() const { return format_; }
    [[nodiscard]] TextureShape shape() const { return shape_; }
    [[nodiscard]] unsigned id() const { return id_; }

    /// Takes another size; the content is lost. Nothing happens when the size is the same.
    void resize(int width, int height);

    void bind(int unit) const;

private:
    void create();
    void allocate();

    Context* context_;
    TextureShape shape_ = TextureShape::flat;
    TextureFormat format_;
    int width_;
    int height_;
    unsigned id_ = 0;
};

}  // namespace croquis::gpu
