// A studio for tests of the framework and its components: a context with techniques, and stages to draw models on.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "framework/technique.h"
#include "support/models.h"
#include "support/test_source.h"

namespace croquis::test_support {

/// One context with all that techniques share: the shipped data, and the tests' own before it.
class Studio {
public:
    Studio();

    [[nodiscard]] gpu::Context& context() { return *context_; }
    [[nodiscard]] gpu::Counters& counters() { return context_->counters(); }
    [[nodiscard]] framework::Resources& resources() { return *resources_; }
    [[nodiscard]] const framework::Library& library() const { return *library_; }
    /// What passes of component test_source hand on.
    [[nodiscard]] Sources& sources() { return sources_; }

    /// A technique from its text; messages call it test.technique.
    [[nodiscard]] std::unique_ptr<framework::Technique> open(const std::string& text);
    /// A technique of the data folders.
    [[nodiscard]] std::unique_ptr<framework::Technique> open_named(const std::string& name);

    /// Lets go of what is shared, so that only leaks are left alive.
    void close() { resources_.reset(); }

private:
    std::unique_ptr<gpu::Context> context_;
    std::shared_ptr<const framework::Library> library_;
    std::unique_ptr<framework::Resources> resources_;
    framework::ComponentTable components_;
    Sources sources_;
};

/// The model as a whole, seen from a direction.
[[nodiscard]] inline model::ViewRequest seen_from(const glm::dvec3& direction,
                                                  model::Projection projection = model::Projection::perspective) {
    model::ViewRequest view;
    view.direction = direction;
    view.projection = projection;
    return view;
}

/// What is drawn, and how.
struct Shot {
    ModelPointer model = cube();
    model::ViewRequest view{};
    framework::Light light{};
    int width = 64;  ///< pixels of the picture
    int height = 48;
    int pixel_scale = 1;
    std::optional<framework::Background> background = std::nullopt;
    std::uint64_t seed = 0;
};

/// A model set up before the camera, and the frame that it is drawn to.
class Stage {
public:
    Stage(Studio& studio, Shot shot);

    [[nodiscard]] const model::Model& model() const { return *shot_.model; }
    [[nodiscard]] const model::Camera& camera() const { return camera_; }
    [[nodiscard]] framework::Scene& scene() { return scene_; }
    [[nodiscard]] int width() const { return shot_.width; }
    [[nodiscard]] int height() const { return shot_.height; }

    void set_seed(std::uint64_t seed) { shot_.seed = seed; }
    void resize(int width, int height);

    /// Draws a frame as the renderer does, over white.
    void draw(framework::Technique& technique);
    /// The frame: the picture, or its samples where the pixel scale is above 1.
    [[nodiscard]] image::Image picture() const;
    /// Draws and reads.
    [[nodiscard]] image::Image picture(framework::Technique& technique);
    /// Draws a technique's text, whose life ends with it, and reads.
    [[nodiscard]] image::Image picture(const std::string& text);

private:
    Studio& studio_;
    Shot shot_;
    framework::Scene scene_;
    model::Camera camera_;
    gpu::Framebuffer frame_;
};

/// What a generated texture of a technique holds.
[[nodiscard]] image::Image read_colors(Studio& studio, const framework::Technique& technique, const std::string& name);
/// The same of a depth texture, in window space.
[[nodiscard]] image::Raster<double> read_depths(Studio& studio, const framework::Technique& technique,
                                                const std::string& name);

/// Tests with a studio, one for each test suite; none of its GPU objects may outlive the suite.
class StudioTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() { studio_ = std::make_unique<Studio>(); }
    static void TearDownTestSuite() {
        studio_->close();
        EXPECT_EQ(studio_->counters().live_objects(), 0) << "objects of the GPU outlived the tests";
        studio_.reset();
    }
    [[nodiscard]] static Studio& studio() { return *studio_; }

private:
    static inline std::unique_ptr<Studio> studio_;
};

}  // namespace croquis::test_support
