#include "gpu/state.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>

namespace croquis::gpu {
namespace {

void enable(GLenum capability, bool on) { on ? glEnable(capability) : glDisable(capability); }

void apply_blend(Blend blend) {
    enable(GL_BLEND, blend != Blend::off);
    switch (blend) {
        case Blend::off:
            break;
        case Blend::multiplied:
            glBlendFuncSeparate(GL_SRC_ALPHA, GL_ZERO, GL_ONE, GL_ZERO);
            break;
        case Blend::over:
            glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            break;
        case Blend::over_premultiplied:
            glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
            break;
        case Blend::multiply:
            glBlendFuncSeparate(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
            break;
        case Blend::screen:
            glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_COLOR, GL_ZERO, GL_ONE);
            break;
        case Blend::add:
            glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
            break;
    }
}

// Of a draw: which marks let it pass, which it may change, and what becomes of them where it is drawn.
struct StencilRule {
    GLenum function;
    unsigned mark;
    unsigned changes;
    GLenum where_drawn;
};

StencilRule stencil_rule(Stencil stencil) {
    switch (stencil) {
        case Stencil::off:
            break;
        case Stencil::mark_surface:
            return {GL_ALWAYS, surface_mark, surface_mark, GL_REPLACE};
        case Stencil::outside_surfaces:
            return {GL_NOTEQUAL, surface_mark, 0, GL_KEEP};
        case Stencil::mark_line:
            return {GL_ALWAYS, line_mark, line_mark, GL_REPLACE};
        case Stencil::take_line_mark:
            return {GL_EQUAL, line_mark, line_mark, GL_ZERO};
    }
    return {GL_ALWAYS, 0, 0, GL_KEEP};
}

void apply_stencil(Stencil stencil) {
    enable(GL_STENCIL_TEST, stencil != Stencil::off);
    if (stencil == Stencil::off) return;
    const StencilRule rule = stencil_rule(stencil);
    glStencilFunc(rule.function, GLint(rule.mark), rule.mark);
    glStencilMask(rule.changes);
    glStencilOp(GL_KEEP, GL_KEEP, rule.where_drawn);
}

// The groups of a SavedState: each reads its part when it is made and puts it back at its end.

// An enumerator or the name of an object.
GLuint word(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return GLuint(value);
}

float number(GLenum name) {
    GLfloat value = 0;
    glGetFloatv(name, &value);
    return value;
}

struct SavedCapabilities {
    static constexpr std::array<GLenum, 6> names{GL_DEPTH_TEST,   GL_BLEND,        GL_CULL_FACE,
                                                 GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL};
    std::array<bool, names.size()> on{};

    SavedCapabilities() {
        std::transform(names.begin(), names.end(), on.begin(),
                       [](GLenum name) { return glIsEnabled(name) == GL_TRUE; });
    }
    ~SavedCapabilities() {
        for (std::size_t i = 0; i < names.size(); ++i) enable(names[i], on[i]);
    }
};

struct SavedAreas {
    std::array<GLint, 4> viewport{};
    std::array<GLint, 4> scissor{};

    SavedAreas() {
        glGetIntegerv(GL_VIEWPORT, viewport.data());
        glGetIntegerv(GL_SCISSOR_BOX, scissor.data());
    }
    ~SavedAreas() {
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        glScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
    }
};

struct SavedMasks {
    GLboolean depth = GL_TRUE;
    std::array<GLboolean, 4> color{};

    SavedMasks() {
        glGetBooleanv(GL_DEPTH_WRITEMASK, &depth);
        glGetBooleanv(GL_COLOR_WRITEMASK, color.data());
    }
    ~SavedMasks() {
        glDepthMask(depth);
        glColorMask(color[0], color[1], color[2], color[3]);
    }
};

struct SavedFunctions {
    GLenum depth = word(GL_DEPTH_FUNC);
    GLenum source = word(GL_BLEND_SRC_RGB);
    GLenum destination = word(GL_BLEND_DST_RGB);
    GLenum source_alpha = word(GL_BLEND_SRC_ALPHA);
    GLenum destination_alpha = word(GL_BLEND_DST_ALPHA);

    ~SavedFunctions() {
        glDepthFunc(depth);
        glBlendFuncSeparate(source, destination, source_alpha, destination_alpha);
    }
};

// Of one side of surfaces, for a caller may have set each on its own.
struct SavedStencilSide {
    struct Names {
        GLenum side, function, reference, read_mask, write_mask, fail, depth_fail, depth_pass;
    };
    Names names;
    GLenum function = word(names.function), fail = word(names.fail), depth_fail = word(names.depth_fail),
           depth_pass = word(names.depth_pass);
    GLuint reference = word(names.reference), read_mask = word(names.read_mask), write_mask = word(names.write_mask);

    ~SavedStencilSide() {
        glStencilFuncSeparate(names.side, function, GLint(reference), read_mask);
        glStencilMaskSeparate(names.side, write_mask);
        glStencilOpSeparate(names.side, fail, depth_fail, depth_pass);
    }
};

struct SavedStencil {
    SavedStencilSide front{{GL_FRONT, GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_WRITEMASK,
                            GL_STENCIL_FAIL, GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS}};
    SavedStencilSide back{{GL_BACK, GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF, GL_STENCIL_BACK_VALUE_MASK,
                           GL_STENCIL_BACK_WRITEMASK, GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                           GL_STENCIL_BACK_PASS_DEPTH_PASS}};
};

struct SavedFaces {
    GLenum culled = word(GL_CULL_FACE_MODE);
    GLenum front = word(GL_FRONT_FACE);
    float offset_factor = number(GL_POLYGON_OFFSET_FACTOR);
    float offset_units = number(GL_POLYGON_OFFSET_UNITS);

    ~SavedFaces() {
        glCullFace(culled);
        glFrontFace(front);
        glPolygonOffset(offset_factor, offset_units);
    }
};

struct SavedTextures {
    struct Target {
        GLenum target;
        GLenum binding;
    };
    static constexpr std::array<Target, 3> targets{{{GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
                                                    {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
                                                    {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY}}};
    static constexpr std::size_t units = 8;  // those that passes may use
    GLenum active = word(GL_ACTIVE_TEXTURE);
    std::array<std::array<GLuint, targets.size()>, units> bound{};

    SavedTextures() {
        for_each([](const Target& target, GLuint& texture) { texture = word(target.binding); });
    }
    ~SavedTextures() {
        for_each([](const Target& target, GLuint& texture) { glBindTexture(target.target, texture); });
    }

private:
    template <typename Visit>
    void for_each(const Visit& visit) {
        for (std::size_t unit = 0; unit < units; ++unit) {
            glActiveTexture(GLenum(GL_TEXTURE0 + unit));
            for (std::size_t i = 0; i < targets.size(); ++i) visit(targets[i], bound[unit][i]);
        }
        glActiveTexture(active);
    }
};

struct SavedBindings {
    GLuint draw_framebuffer = word(GL_DRAW_FRAMEBUFFER_BINDING);
    GLuint read_framebuffer = word(GL_READ_FRAMEBUFFER_BINDING);
    GLuint program = word(GL_CURRENT_PROGRAM);
    GLuint vertex_array = word(GL_VERTEX_ARRAY_BINDING);
    GLuint array_buffer = word(GL_ARRAY_BUFFER_BINDING);

    ~SavedBindings() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw_framebuffer);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, read_framebuffer);
        glUseProgram(program);
        glBindVertexArray(vertex_array);
        glBindBuffer(GL_ARRAY_BUFFER, array_buffer);
    }
};

}  // namespace

void apply(const DrawState& state) {
    enable(GL_DEPTH_TEST, state.depth_test != DepthTest::off || state.write_depth);
    switch (state.depth_test) {
        case DepthTest::off:
            glDepthFunc(GL_ALWAYS);
            break;
        case DepthTest::nearer:
            glDepthFunc(GL_LESS);
            break;
        case DepthTest::nearer_or_equal:
            glDepthFunc(GL_LEQUAL);
            break;
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
    apply_stencil(state.stencil);
    enable(GL_SCISSOR_TEST, state.within.has_value());
    if (state.within) glScissor(state.within->x, state.within->y, state.within->width, state.within->height);
}

struct SavedState::Groups {
    SavedCapabilities capabilities;
    SavedAreas areas;
    SavedMasks masks;
    SavedFunctions functions;
    SavedStencil stencil;
    SavedFaces faces;
    SavedTextures textures;
    SavedBindings bindings;
};

SavedState::SavedState() : groups_(std::make_unique<Groups>()) { glDisable(GL_SCISSOR_TEST); }
SavedState::~SavedState() = default;

}  // namespace croquis::gpu
