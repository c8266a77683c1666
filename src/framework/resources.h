// What the techniques of one context share: programs and images, each made once and freed with its last user.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "framework/data_folders.h"
#include "framework/texture_form.h"
#include "framework/texture_name.h"
#include "gpu/geometry.h"
#include "gpu/program.h"
#include "gpu/texture.h"
#include "image/image.h"

namespace croquis::framework {

class Resources {
public:
    Resources(gpu::Context& context, DataFolders folders);

    [[nodiscard]] gpu::Context& gpu() { return *context_; }
    [[nodiscard]] const DataFolders& folders() const { return folders_; }

    /// The program of two shader functions, `file:function` each. Throws Error when either is missing or wrong.
    [[nodiscard]] std::shared_ptr<const gpu::Program> program(const std::string& vertex, const std::string& fragment,
                                                              gpu::Output output = gpu::Output::one);

    /// An image of data/textures. Throws Error with the nearest directory or image, or saying why the image does not
    /// have the form.
    [[nodiscard]] std::shared_ptr<const gpu::Texture> image(const TextureName& name,
                                                            TextureForm form = TextureForm::flat);

    /// All images of data/textures, `directory:image`, sorted.
    [[nodiscard]] std::vector<std::string> image_names() const;

    /// The pixels of an image of data/textures. Throws Error as `image` does.
    [[nodiscard]] image::Image read_image(const TextureName& name) const;

    /// A material's image.
    [[nodiscard]] std::shared_ptr<const gpu::Texture> image(const std::shared_ptr<const image::Image>& pixels);

    /// One white pixel, for surfaces without a texture.
    [[nodiscard]] const gpu::Texture& white() const { return white_; }

    /// Reads programs and images anew when they are next asked for. Those in use stay as they are.
    void forget_files();

    /// Draws the bound program over the whole bound target: the one way to draw a full-screen pass.
    void draw_full_screen() const { triangle_.draw(); }

private:
    [[nodiscard]] std::filesystem::path find_image(const TextureName& name) const;

    gpu::Context* context_;
    DataFolders folders_;
    gpu::FullScreenTriangle triangle_;
    gpu::Texture white_;
    std::map<std::tuple<std::string, std::string, gpu::Output>, std::weak_ptr<const gpu::Program>> programs_;
    // By path, form and filter.
    std::map<std::tuple<std::string, TextureForm, bool>, std::weak_ptr<const gpu::Texture>> images_;
    struct MaterialImage {
        std::weak_ptr<const image::Image> pixels;  // an address may be used again: the image must be the same
        std::weak_ptr<const gpu::Texture> texture;
    };
    std::map<const image::Image*, MaterialImage> material_images_;
};

}  // namespace croquis::framework
