#include "support/studio.h"

#include <utility>

#include "base/files.h"
#include "components/register.h"

namespace croquis::test_support {
namespace {

std::shared_ptr<gpu::Texture> target(Studio& studio, gpu::TextureFormat format, int width, int height) {
    return std::make_shared<gpu::Texture>(studio.context(), format, width, height);
}

std::shared_ptr<gpu::Texture> generated(const framework::Technique& technique, const std::string& name) {
    const framework::Pass& any = technique.pass(technique.pass_names().front());
    return std::const_pointer_cast<gpu::Texture>(any.generated().at(name));
}

image::Image as_image(int width, int height, const std::vector<std::uint8_t>& bytes) {
    image::Image image(width, height);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        image.pixels()[i] = {bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2], bytes[4 * i + 3]};
    }
    return image;
}

}  // namespace

Studio::Studio() : context_(gpu::Context::headless(gpu::ContextOptions::from_environment())) {
    const framework::DataFolders folders = framework::DataFolders::find({CROQUIS_TEST_DATA});
    library_ = std::make_shared<const framework::Library>(folders);
    resources_ = std::make_unique<framework::Resources>(*context_, folders);
    components_ = components::core_components();
    components_.emplace("test_source", test_source(sources_));
}

std::unique_ptr<framework::Technique> Studio::open(const std::string& text) {
    const auto find = [&](const std::string& name) {
        const std::filesystem::path path = library_->folders().find("techniques", name, ".technique");
        if (path.empty()) fail("no technique {}", name);
        return framework::Descriptors::Source{name + ".technique", read_file(path, 1 << 20)};
    };
    const framework::TechniqueDefinition definition =
        framework::read_technique("test", {"test.technique", text}, library_->descriptors(), find);
    return std::make_unique<framework::Technique>(library_, definition, *resources_, components_);
}

std::unique_ptr<framework::Technique> Studio::open_named(const std::string& name) {
    return std::make_unique<framework::Technique>(library_, library_->technique(name), *resources_, components_);
}

Stage::Stage(Studio& studio, Shot shot)
    : studio_(studio),
      shot_(std::move(shot)),
      scene_(studio.resources(), shot_.model),
      frame_(studio.context(), target(studio, gpu::TextureFormat::rgba8, 1, 1),
             target(studio, gpu::TextureFormat::depth, 1, 1)) {
    resize(shot_.width, shot_.height);
}

void Stage::resize(int width, int height) {
    shot_.width = width;
    shot_.height = height;
    frame_.resize(width * shot_.pixel_scale, height * shot_.pixel_scale);
    camera_ = model::place_camera(*shot_.model, nullptr, shot_.view, double(width) / double(height));
}

void Stage::draw(framework::Technique& technique) {
    framework::RenderContext context{.resources = studio_.resources(),
                                     .scene = scene_,
                                     .camera = camera_,
                                     .light = shot_.light,
                                     .frame = frame_,
                                     .background = shot_.background,
                                     .pixel_scale = shot_.pixel_scale,
                                     .seed = shot_.seed};
    context.clear_frame(glm::vec3(1.0f));
    frame_.clear_depth();
    technique.draw(context);
}

image::Image Stage::picture() const { return as_image(frame_.width(), frame_.height(), frame_.read_pixels()); }

image::Image Stage::picture(framework::Technique& technique) {
    draw(technique);
    return picture();
}

image::Image Stage::picture(const std::string& text) { return picture(*studio_.open(text)); }

image::Image read_colors(Studio& studio, const framework::Technique& technique, const std::string& name) {
    const gpu::Framebuffer source(studio.context(), generated(technique, name), nullptr);
    return as_image(source.width(), source.height(), source.read_pixels());
}

image::Raster<double> read_depths(Studio& studio, const framework::Technique& technique, const std::string& name) {
    const std::shared_ptr<gpu::Texture> depth = generated(technique, name);
    const gpu::Framebuffer bytes(studio.context(),
                                 target(studio, gpu::TextureFormat::rgba8, depth->width(), depth->height()), nullptr);
    const auto program = studio.resources().program("image:full_screen", "test_image:depth_bytes");
    bytes.bind();
    program->use();
    gpu::apply({});
    depth->bind(0);
    program->set("texture_sampler", 0);
    studio.resources().draw_full_screen();
    const image::Image read = as_image(bytes.width(), bytes.height(), bytes.read_pixels());
    image::Raster<double> depths(read.width(), read.height());
    for (std::size_t i = 0; i < read.pixels().size(); ++i) {
        const glm::u8vec4& pixel = read.pixels()[i];
        depths.pixels()[i] = double(pixel.x << 16 | pixel.y << 8 | pixel.z) / double(largest_depth);
    }
    return depths;
}

}  // namespace croquis::test_support
