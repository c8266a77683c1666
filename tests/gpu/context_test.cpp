// Contexts by their factories, what they say of themselves, and adopting the caller's.
#include "gpu/context.h"

#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/studio.h"

namespace croquis::gpu {
namespace {

using test_support::error_of;

class ContextTest : public test_support::StudioTest {};

TEST_F(ContextTest, SpeaksTheApiAskedFor) {
    EXPECT_EQ(studio().context().api(), ContextOptions::from_environment().api);
    EXPECT_FALSE(studio().context().renderer().empty());
    EXPECT_GE(studio().context().longest_side(), 2048);
}

TEST_F(ContextTest, CurrentAdoptsTheCallersAndLeavesIt) {
    const EGLContext before = eglGetCurrentContext();
    {
        const std::unique_ptr<Context> adopted = Context::current();
        EXPECT_EQ(adopted->api(), studio().context().api());
        EXPECT_EQ(adopted->renderer(), studio().context().renderer());
        EXPECT_EQ(adopted->platform(), "the caller's");
        EXPECT_EQ(adopted->counters().live_objects(), 0);
    }
    EXPECT_EQ(eglGetCurrentContext(), before);
}

void adopt_nothing() {
    eglMakeCurrent(eglGetCurrentDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    const bool is_told = error_of([] { (void)Context::current(); }) == "expected a current OpenGL context, found none";
    std::_Exit(is_told ? 0 : 3);
}

// In a process of its own: libepoxy ends the process when it is asked anything without a context.
TEST_F(ContextTest, AdoptingNothingIsAnError) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(adopt_nothing(), ::testing::ExitedWithCode(0), "");
}

TEST_F(ContextTest, TwoContextsLiveSideBySide) {
    const std::unique_ptr<Context> other = Context::headless(ContextOptions::from_environment());
    EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT);
    studio().context().make_current();
    const Texture texture(studio().context(), TextureFormat::rgba8, 2, 2);
    EXPECT_EQ(other->counters().live_textures, 0);
}

TEST(ContextWords, AreCheckedWithTheNearest) {
    EXPECT_EQ(api_named("gles"), Api::gles);
    EXPECT_EQ(device_named("software"), Device::software);
    EXPECT_EQ(error_of([] { (void)api_named("glse"); }),
              "expected the API to be gl, gles, found \"glse\"; did you mean \"gles\"?");
    EXPECT_EQ(error_of([] { (void)device_named("gpu"); }),
              "expected the device to be auto, hardware, software, found \"gpu\"");
}

}  // namespace
}  // namespace croquis::gpu
