#include "gpu/state.h"

#include <epoxy/gl.h>

namespace croquis::gpu {
namespace {

void enable(GLenum capability, bool on) { on ? glEnable(capability) : glDisable(capability); }

void apply_blend(Blend blend) {
    enable(GL_BLEND, blend != Blend::off);
    switch (blend) {
        case Blend::off: break;
        case Blend::multiplied: glBlendFuncSeparate(GL_SRC_ALPHA, GL_ZERO, GL_ONE, GL_ZERO); break;
        case Blend::over:
            glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            break;
        case Blend::over_premultiplied: glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
        case Blend::multiply: glBlendFuncSeparate(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE); break;
        case Blend::screen: glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_COLOR, GL_ZERO, GL_ONE); break;
        case Blend::add: glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE); break;
    }
}

}  // namespace

void apply(const DrawState& state) {
    enable(GL_DEPTH_TEST, state.depth_test != DepthTest::off || state.write_depth);
    switch (state.depth_test) {
        case DepthTest::off: glDepthFunc(GL_ALWAYS); break;
        case DepthTest::nearer: glDepthFunc(GL_LESS); break;
        case DepthTest::nearer_or_equal: glDepthFunc(GL_LEQUAL); break;
    }
    glDepthMask(state.write_depth ? GL_TRUE : GL_FALSE);
    const GLboolean color = state.write_color ? GL_TRUE : GL_FALSE;
    glColorMask(color, color, color, color);
    apply_blend(state.blend);
    enable(GL_CULL_FACE, state.cull != Cull::none);
    if (state.cull != Cull::none) glCullFace(state.cull == Cull::back ? GL_BACK : GL_FRONT);
    glFrontFace(GL_CCW);
    enable(GL_POLYGON_OFFSET_FILL, state.push_back != 0);
    if (state.push_back != 0) glPolygonOffset(state.push_back, state.push_back);
    enable(GL_SCISSOR_TEST, state.within.has_value());
    if (state.within) glScissor(state.within->x, state.within->y, state.within->width, state.within->height);
}

SavedState::SavedState() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_framebuffer_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_framebuffer_);
    glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depth_mask_);
    glGetBooleanv(GL_COLOR_WRITEMASK, color_mask_);
    depth_test_ = glIsEnabled(GL_DEPTH_TEST) == GL_TRUE;
    blend_ = glIsEnabled(GL_BLEND) == GL_TRUE;
    cull_ = glIsEnabled(GL_CULL_FACE) == GL_TRUE;
    scissor_ = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
    polygon_offset_ = glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE;
    glDisable(GL_SCISSOR_TEST);
}

SavedState::~SavedState() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(draw_framebuffer_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(read_framebuffer_));
    glUseProgram(GLuint(program_));
    glBindVertexArray(GLuint(vertex_array_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    glDepthMask(depth_mask_);
    glColorMask(color_mask_[0], color_mask_[1], color_mask_[2], color_mask_[3]);
    enable(GL_DEPTH_TEST, depth_test_);
    enable(GL_BLEND, blend_);
    enable(GL_CULL_FACE, cull_);
    enable(GL_SCISSOR_TEST, scissor_);
    enable(GL_POLYGON_OFFSET_FILL, polygon_offset_);
}

}  // namespace croquis::gpu
