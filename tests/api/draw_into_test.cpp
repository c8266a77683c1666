// Drawing into the caller's framebuffer gives the same pixels as drawing to a picture, and leaves his state alone.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <map>

#include "api/shapes.h"
#include "gpu/context.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::small;
using test_support::torus_file;

class DrawInto : public ::testing::Test {
protected:
    DrawInto() : context_(gpu::Context::headless(gpu::ContextOptions::from_environment())) {
        glGenTextures(1, &texture_);
        glBindTexture(GL_TEXTURE_2D, texture_);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
        clear(0.0f, 0.0f, 0.0f, 0.0f);
    }
    void clear(float r, float g, float b, float a) const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glClearColor(r, g, b, a);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    // Rows from the top.
    [[nodiscard]] std::vector<std::uint8_t> pixels() const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        std::vector<std::uint8_t> rows(std::size_t(width) * height * 4), flipped;
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
        for (int y = height - 1; y >= 0; --y)
            flipped.insert(flipped.end(), rows.begin() + y * width * 4, rows.begin() + (y + 1) * width * 4);
        return flipped;
    }

    static constexpr int width = 120, height = 90;
    std::unique_ptr<gpu::Context> context_;
    unsigned texture_ = 0, framebuffer_ = 0;
};

TEST_F(DrawInto, GivesThePixelsOfDraw) {
    Renderer renderer = Renderer::in_current_context();
    const Model model = torus_file();
    for (const char* name : {"phong", "edges", "wireframe"}) {
        Technique technique = renderer.open_technique(name);
        for (const int samples : {1, 4}) {
            DrawOptions options = small(width, height);
            options.samples = samples;
            const Picture picture = renderer.draw(model, technique, options);
            clear(1, 0, 1, 1);
            renderer.draw_into(framebuffer_, model, technique, options);
            const Picture seen(width, height, pixels());
            EXPECT_LE(seen.difference_from(picture).maximum, 0) << name << ", samples " << samples;
        }
    }
}

TEST_F(DrawInto, LeavesTheRestOfALargerFramebuffer) {
    Renderer renderer = Renderer::in_current_context();
    Technique technique = renderer.open_technique("phong");
    clear(1, 0, 1, 1);
    renderer.draw_into(framebuffer_, cube_file(), technique, small(40, 30));
    const std::vector<std::uint8_t> seen = pixels();
    EXPECT_EQ(seen[1], 0) << "the upper left is untouched";
    EXPECT_NE(seen[(std::size_t(height - 1) * width) * 4 + 1], 0) << "the lower left is drawn";
}

TEST_F(DrawInto, ReadsNothingBack) {
    Renderer renderer = Renderer::in_current_context();
    Technique technique = renderer.open_technique("edges");
    renderer.draw_into(framebuffer_, cube_file(), technique, small(width, height));
    EXPECT_EQ(renderer.counts().read_backs, 0);
}

TEST_F(DrawInto, ATransparentBackgroundKeepsWhatIsThere) {
    Renderer renderer = Renderer::in_current_context();
    Technique technique = renderer.open_technique("phong");
    DrawOptions options = small(width, height);
    options.background = Background{.color = {1, 1, 1}, .transparent = true, .texture = {}};
    clear(1, 0, 1, 1);
    renderer.draw_into(framebuffer_, cube_file(), technique, options);
    const std::vector<std::uint8_t> seen = pixels();
    EXPECT_EQ(std::vector<std::uint8_t>(seen.begin(), seen.begin() + 4), (std::vector<std::uint8_t>{255, 0, 255, 255}));
}

// Everything fixed or bound that drawing may touch.
std::map<std::string, std::vector<int>> state() {
    std::map<std::string, std::vector<int>> state;
    const auto integers = [&](const char* name, GLenum what, std::size_t count) {
        std::vector<int>& values = state[name];
        values.resize(count);
        glGetIntegerv(what, values.data());
    };
    integers("draw framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 1);
    integers("read framebuffer", GL_READ_FRAMEBUFFER_BINDING, 1);
    integers("program", GL_CURRENT_PROGRAM, 1);
    integers("vertex array", GL_VERTEX_ARRAY_BINDING, 1);
    integers("array buffer", GL_ARRAY_BUFFER_BINDING, 1);
    integers("active texture", GL_ACTIVE_TEXTURE, 1);
    integers("viewport", GL_VIEWPORT, 4);
    integers("scissor box", GL_SCISSOR_BOX, 4);
    integers("depth mask", GL_DEPTH_WRITEMASK, 1);
    integers("colour mask", GL_COLOR_WRITEMASK, 4);
    integers("depth function", GL_DEPTH_FUNC, 1);
    integers("blend source", GL_BLEND_SRC_RGB, 1);
    integers("blend destination", GL_BLEND_DST_RGB, 1);
    integers("blend source alpha", GL_BLEND_SRC_ALPHA, 1);
    integers("blend destination alpha", GL_BLEND_DST_ALPHA, 1);
    integers("culled face", GL_CULL_FACE_MODE, 1);
    integers("front face", GL_FRONT_FACE, 1);
    integers("pack alignment", GL_PACK_ALIGNMENT, 1);
    integers("stencil function", GL_STENCIL_FUNC, 1);
    integers("stencil reference", GL_STENCIL_REF, 1);
    integers("stencil read mask", GL_STENCIL_VALUE_MASK, 1);
    integers("stencil write mask", GL_STENCIL_WRITEMASK, 1);
    integers("stencil operation", GL_STENCIL_PASS_DEPTH_PASS, 1);
    integers("stencil function behind", GL_STENCIL_BACK_FUNC, 1);
    integers("stencil write mask behind", GL_STENCIL_BACK_WRITEMASK, 1);
    integers("stencil operation behind", GL_STENCIL_BACK_FAIL, 1);
    integers("clear colour", GL_COLOR_CLEAR_VALUE, 4);
    for (const auto& [name, what] : {std::pair("depth test", GL_DEPTH_TEST),
                                     {"blend", GL_BLEND},
                                     {"cull", GL_CULL_FACE},
                                     {"scissor", GL_SCISSOR_TEST},
                                     {"stencil", GL_STENCIL_TEST},
                                     {"polygon offset", GL_POLYGON_OFFSET_FILL}}) {
        state[name] = {glIsEnabled(GLenum(what))};
    }
    for (int unit = 0; unit < 3; ++unit) {
        int before = 0;
        glGetIntegerv(GL_ACTIVE_TEXTURE, &before);
        glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        integers(unit == 0 ? "texture 0" : unit == 1 ? "texture 1" : "texture 2", GL_TEXTURE_BINDING_2D, 1);
        integers(unit == 0 ? "volume 0" : unit == 1 ? "volume 1" : "volume 2", GL_TEXTURE_BINDING_3D, 1);
        integers(unit == 0 ? "layers 0" : unit == 1 ? "layers 1" : "layers 2", GL_TEXTURE_BINDING_2D_ARRAY, 1);
        glActiveTexture(GLenum(before));
    }
    float offsets[2] = {};
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &offsets[0]);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &offsets[1]);
    state["polygon offset values"] = {int(offsets[0]), int(offsets[1])};
    return state;
}

TEST_F(DrawInto, PutsTheCallersStateBack) {
    Renderer renderer = Renderer::in_current_context();
    const Model model = cube_file();
    unsigned buffer = 0, array = 0, textures[3] = {}, volumes[3] = {}, layers[3] = {};
    glGenBuffers(1, &buffer);
    glGenVertexArrays(1, &array);
    glGenTextures(3, textures);
    glGenTextures(3, volumes);
    glGenTextures(3, layers);
    for (const char* name :
         {"phong", "cartoon_per_vertex", "wireframe", "edges", "outline_lines", "hatching_simple", "hatching_3d"}) {
        Technique technique = renderer.open_technique(name);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        glBindVertexArray(array);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        for (unsigned unit = 0; unit < 3; ++unit) {
            glActiveTexture(GL_TEXTURE0 + unit);
            glBindTexture(GL_TEXTURE_2D, textures[unit]);
            glBindTexture(GL_TEXTURE_3D, volumes[unit]);
            glBindTexture(GL_TEXTURE_2D_ARRAY, layers[unit]);
        }
        glActiveTexture(GL_TEXTURE2);
        glUseProgram(0);
        glViewport(3, 4, 50, 60);
        glDepthMask(GL_FALSE);
        glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
        glDepthFunc(GL_GREATER);
        glBlendFuncSeparate(GL_ONE, GL_ZERO, GL_DST_ALPHA, GL_ONE);
        glCullFace(GL_FRONT_AND_BACK);
        glFrontFace(GL_CW);
        glEnable(GL_SCISSOR_TEST);
        glScissor(1, 2, 3, 4);
        glEnable(GL_CULL_FACE);
        glEnable(GL_STENCIL_TEST);
        glStencilFuncSeparate(GL_FRONT, GL_LESS, 5, 0x3f);
        glStencilFuncSeparate(GL_BACK, GL_GEQUAL, 5, 0x3f);
        glStencilMaskSeparate(GL_FRONT, 0x0f);
        glStencilMaskSeparate(GL_BACK, 0x33);
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR);
        glStencilOpSeparate(GL_BACK, GL_INVERT, GL_KEEP, GL_KEEP);
        glPolygonOffset(7, 9);
        const auto before = state();
        renderer.draw_into(framebuffer_, model, technique, small(width, height));
        const auto after = state();
        for (const auto& [what, values] : before) EXPECT_EQ(after.at(what), values) << what << ", technique " << name;
        glDisable(GL_SCISSOR_TEST);
        glDisable(GL_STENCIL_TEST);
        glDisable(GL_CULL_FACE);
    }
}

}  // namespace
}  // namespace croquis
