#include "support/test_source.h"

#include <epoxy/gl.h>

#include <vector>

#include "framework/render_context.h"

namespace croquis::test_support {
namespace {

using framework::Pass;

gpu::TextureFormat format_named(const std::string& word) {
    return word == "depth" ? gpu::TextureFormat::depth : gpu::TextureFormat::rgba8;
}

// Rows from the bottom, as GL has them.
template <typename Pixel>
std::vector<Pixel> flipped(const image::Raster<Pixel>& raster) {
    std::vector<Pixel> pixels;
    for (int y = raster.height() - 1; y >= 0; --y) {
        for (int x = 0; x < raster.width(); ++x) pixels.push_back(raster.at(x, y));
    }
    return pixels;
}

struct Send {
    void operator()(const image::Image& image) const { send(image, GL_RGBA, GL_UNSIGNED_BYTE); }
    void operator()(const DepthValues& depths) const {
        // The 24 bits above those of the stencil.
        DepthValues words = depths;
        for (std::uint32_t& depth : words.pixels()) depth <<= 8;
        send(words, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    }

    template <typename Pixel>
    void send(const image::Raster<Pixel>& raster, GLenum format, GLenum type) const {
        texture.resize(raster.width(), raster.height());
        glBindTexture(GL_TEXTURE_2D, texture.id());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, raster.width(), raster.height(), format, type, flipped(raster).data());
    }

    gpu::Texture& texture;
};

class TestSource final : public framework::Component {
public:
    TestSource(const Pass& pass, const Sources& sources)
        : Component(pass),
          sources_(sources),
          name_(pass.variable<std::string>("texture").value()),
          texture_(pass.generated().declare(name_, format_named(pass.variable<std::string>("format").value()))) {}

protected:
    void render(framework::RenderContext&) override { std::visit(Send{*texture_}, sources_.at(name_)); }

private:
    const Sources& sources_;
    std::string name_;
    std::shared_ptr<gpu::Texture> texture_;
};

}  // namespace

framework::CreateComponent test_source(const Sources& sources) {
    return [&sources](const Pass& pass) { return std::make_unique<TestSource>(pass, sources); };
}

}  // namespace croquis::test_support
