#include "gpu/framebuffer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "base/error.h"
#include "gpu/state.h"

namespace croquis::gpu {
namespace {

// Rows from the bottom, as GL gives them, to rows from the top.
template <typename Word>
void flip_rows(std::vector<Word>& words, std::size_t row, int height) {
    for (std::size_t low = 0, high = std::size_t(height) - 1; low < high; ++low, --high) {
        std::swap_ranges(words.begin() + std::ptrdiff_t(low * row), words.begin() + std::ptrdiff_t((low + 1) * row),
                         words.begin() + std::ptrdiff_t(high * row));
    }
}

void attach(GLenum point, const std::shared_ptr<Texture>& texture) {
    if (texture) glFramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture->id(), 0);
}

}  // namespace

Framebuffer::Framebuffer(Context& context, std::shared_ptr<Texture> color, std::shared_ptr<Texture> depth,
                         std::shared_ptr<Texture> second_color)
    : context_(&context), color_(std::move(color)), second_color_(std::move(second_color)), depth_(std::move(depth)) {
    assert(color_ || depth_);
    glGenFramebuffers(1, &id_);
    ++context_->counters().live_framebuffers;
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    attach(GL_COLOR_ATTACHMENT0, color_);
    attach(GL_COLOR_ATTACHMENT1, second_color_);
    attach(GL_DEPTH_STENCIL_ATTACHMENT, depth_);
    const std::array<GLenum, 2> buffers{GLenum(color_ ? GL_COLOR_ATTACHMENT0 : GL_NONE), GL_COLOR_ATTACHMENT1};
    glDrawBuffers(second_color_ ? 2 : 1, buffers.data());
    glReadBuffer(buffers.front());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        glDeleteFramebuffers(1, &id_);
        --context_->counters().live_framebuffers;
        fail("the renderer {} cannot draw to this kind of texture (status {:#x})", context_->renderer(), status);
    }
}

Framebuffer::~Framebuffer() {
    glDeleteFramebuffers(1, &id_);
    --context_->counters().live_framebuffers;
}

int Framebuffer::width() const { return color_ ? color_->width() : depth_->width(); }
int Framebuffer::height() const { return color_ ? color_->height() : depth_->height(); }

void Framebuffer::resize(int width, int height) {
    if (color_) color_->resize(width, height);
    if (second_color_) second_color_->resize(width, height);
    if (depth_) depth_->resize(width, height);
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, width(), height());
}

void Framebuffer::clear_color(const glm::vec4& color) const {
    bind();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, &color.x);
}

void Framebuffer::clear_second_color(const glm::vec4& color) const {
    bind();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearBufferfv(GL_COLOR, 1, &color.x);
}

void Framebuffer::clear_depth() const {
    bind();
    glDepthMask(GL_TRUE);
    glStencilMask(0xff);
    glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

void Framebuffer::clear_line_marks() const {
    bind();
    const GLint none = 0;
    glStencilMask(line_mark);
    glClearBufferiv(GL_STENCIL, 0, &none);
}

std::vector<std::uint8_t> Framebuffer::read(unsigned attachment) const {
    bind();
    glReadBuffer(GL_COLOR_ATTACHMENT0 + attachment);
    ++context_->counters().read_backs;
    const std::size_t row = std::size_t(width()) * 4;
    std::vector<std::uint8_t> pixels(row * std::size_t(height()));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    glReadBuffer(color_ ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    flip_rows(pixels, row, height());
    return pixels;
}

glm::u8vec4 Framebuffer::read_pixel(int x, int y) const {
    bind();
    ++context_->counters().read_backs;
    glm::u8vec4 pixel{0};
    glReadPixels(x, height() - 1 - y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel.x);
    return pixel;
}

void Framebuffer::copy_to(Framebuffer& destination, Part part) const {
    assert(width() == destination.width() && height() == destination.height());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, destination.id_);
    const GLbitfield mask = part == Part::color ? GL_COLOR_BUFFER_BIT : GL_DEPTH_BUFFER_BIT;
    glBlitFramebuffer(0, 0, width(), height(), 0, 0, width(), height(), mask, GL_NEAREST);
}

void bind_foreign_framebuffer(unsigned id, int width, int height) {
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    glViewport(0, 0, width, height);
}

}  // namespace croquis::gpu
