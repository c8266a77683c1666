// Framebuffers: what passes draw to, and reading pictures back.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "gpu/context.h"
#include "gpu/texture.h"

namespace croquis::gpu {

/// Textures to draw to: one colour, or two that one pass fills at once, or none; and depth, or none.
class Framebuffer {
public:
    Framebuffer(Context& context, std::shared_ptr<Texture> color, std::shared_ptr<Texture> depth,
                std::shared_ptr<Texture> second_color = nullptr);
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    [[nodiscard]] const std::shared_ptr<Texture>& color() const { return color_; }
    [[nodiscard]] const std::shared_ptr<Texture>& depth() const { return depth_; }
    [[nodiscard]] int width() const;
    [[nodiscard]] int height() const;

    /// For who draws into it as a caller of the public API does.
    [[nodiscard]] unsigned id() const { return id_; }

    /// Resizes the textures. Contents are lost when the size changes.
    void resize(int width, int height);

    /// Draws go here, over the whole of it, from now on.
    void bind() const;

    void clear_color(const glm::vec4& color) const;
    void clear_second_color(const glm::vec4& color) const;
    /// To the far plane; with it go all marks of the stencil (gpu/state.h).
    void clear_depth() const;
    void clear_line_marks() const;

    /// The colours as 8-bit RGBA, rows from top to bottom. Waits for the picture: counted as a read-back.
    [[nodiscard]] std::vector<std::uint8_t> read_pixels() const { return read(0); }
    [[nodiscard]] std::vector<std::uint8_t> read_second_pixels() const { return read(1); }

    /// One pixel of the colours, from the upper left. Counted as a read-back too.
    [[nodiscard]] glm::u8vec4 read_pixel(int x, int y) const;

    /// Copies the colour or the depth to another framebuffer of the same size and formats.
    enum class Part { color, depth };
    void copy_to(Framebuffer& destination, Part part) const;

private:
    [[nodiscard]] std::vector<std::uint8_t> read(unsigned attachment) const;

    Context* context_;
    std::shared_ptr<Texture> color_;
    std::shared_ptr<Texture> second_color_;
    std::shared_ptr<Texture> depth_;
    unsigned id_ = 0;
};

/// Draws go to the caller's framebuffer object (0: the window) of that size.
void bind_foreign_framebuffer(unsigned id, int width, int height);

}  // namespace croquis::gpu
