// Where a pass draws: the frame, or a generated texture that later passes read (seed C, 2.1).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "framework/pass.h"
#include "framework/render_context.h"
#include "gpu/framebuffer.h"

namespace croquis::framework {

/// The variables render_target, render_target_width and render_target_height of a pass. A target named `x` makes the
/// textures `<generated>:x_color` and `<generated>:x_depth`. A width or height of 0 is the frame's, a positive one is
/// pixels, and -n is the frame's divided by n.
class RenderTarget {
public:
    explicit RenderTarget(const Pass& pass);

    [[nodiscard]] bool is_frame() const { return !framebuffer_; }

    /// The framebuffer to draw to, of the right size for this frame; not bound, not cleared.
    [[nodiscard]] gpu::Framebuffer& prepare(RenderContext& context);

    /// Clears what the pass's variables keep_color and keep_depth do not keep. On the frame, the asked background takes
    /// the place of `color`.
    void clear(RenderContext& context, const glm::vec3& color);

private:
    Variable<std::int32_t> width_;
    Variable<std::int32_t> height_;
    Variable<bool> keep_color_;
    Variable<bool> keep_depth_;
    std::unique_ptr<gpu::Framebuffer> framebuffer_;
};

}  // namespace croquis::framework
