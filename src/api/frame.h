// The picture that a renderer draws: the techniques' framebuffer, larger than the picture when it is oversampled.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "framework/resources.h"
#include "gpu/framebuffer.h"

namespace croquis {

class Frame {
public:
    explicit Frame(framework::Resources& resources);

    void resize(int width, int height, int pixel_scale);

    /// What techniques draw to: width · scale × height · scale pixels, colours multiplied by alpha.
    [[nodiscard]] gpu::Framebuffer& target() { return samples_; }

    /// Draws what is still missing of the picture: the mean of its samples. What it returns holds the picture.
    gpu::Framebuffer& resolve();

    /// The picture: samples averaged, colours not multiplied by alpha, rows from top to bottom.
    [[nodiscard]] std::vector<std::uint8_t> read();

    /// The picture into the lower left of the caller's framebuffer, over what it holds.
    void present(unsigned framebuffer);

private:
    void draw_mean() const;

    framework::Resources* resources_;
    gpu::Framebuffer samples_;
    gpu::Framebuffer picture_;  // used when oversampled
    std::shared_ptr<const gpu::Program> mean_;
    int width_ = 1;
    int height_ = 1;
    int pixel_scale_ = 1;
};

}  // namespace croquis
