#include "framework/resources.h"

#include <algorithm>
#include <array>
#include <set>

#include "base/error.h"
#include "base/files.h"
#include "base/names.h"
#include "framework/sliced_image.h"

namespace croquis::framework {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 5> image_endings{".png", ".jpg", ".jpeg", ".tga", ".bmp"};
constexpr std::uint8_t white_pixel[] = {255, 255, 255, 255};

gpu::ShaderFile find_shader(const DataFolders& folders, const std::string& name) {
    constexpr std::uintmax_t most_bytes = 1 << 20;
    const fs::path path = folders.find("shaders", name, ".glsl");
    if (path.empty()) {
        fail("no shader file \"{}\"{}", name, suggestion(name, folders.names("shaders", ".glsl")));
    }
    return {path.string(), read_file(path, most_bytes)};
}

std::vector<std::string> images_of(const DataFolders& folders, const std::string& directory) {
    std::set<std::string> names;
    for (const char* ending : image_endings) {
        for (std::string& name : folders.names("textures/" + directory, ending)) names.insert(std::move(name));
    }
    return {names.begin(), names.end()};
}

std::vector<std::string> image_directories(const DataFolders& folders) {
    std::vector<std::string> names;
    for (const fs::path& folder : folders.folders()) {
        std::error_code error;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder / "textures", error)) {
            if (entry.is_directory(error)) names.push_back(entry.path().filename().string());
        }
    }
    return names;
}

std::shared_ptr<const gpu::Texture> upload(gpu::Context& context, const image::Image& pixels, const std::string& name,
                                           TextureForm form, gpu::Filter filter) {
    switch (form) {
        case TextureForm::volume:
            return std::make_shared<const gpu::Texture>(context, cut_volume(pixels, name), filter);
        case TextureForm::tonal:
            return std::make_shared<const gpu::Texture>(context, cut_tonal(pixels, name), filter);
        case TextureForm::flat:
            break;
    }
    return std::make_shared<const gpu::Texture>(context, &pixels.pixels().front().x, pixels.width(), pixels.height(),
                                                filter, gpu::Wrap::repeat);
}

}  // namespace

Resources::Resources(gpu::Context& context, DataFolders folders)
    : context_(&context),
      folders_(std::move(folders)),
      triangle_(context),
      white_(context, white_pixel, 1, 1, gpu::Filter::nearest, gpu::Wrap::clamp) {}

std::shared_ptr<const gpu::Program> Resources::program(const std::string& vertex, const std::string& fragment,
                                                       gpu::Output output) {
    std::weak_ptr<const gpu::Program>& known = programs_[{vertex, fragment, output}];
    if (auto program = known.lock()) return program;
    const auto find = [this](const std::string& name) { return find_shader(folders_, name); };
    const auto program = std::make_shared<const gpu::Program>(*context_, gpu::ShaderSource::read(vertex, find),
                                                              gpu::ShaderSource::read(fragment, find), output);
    known = program;
    return program;
}

void Resources::forget_files() {
    programs_.clear();
    images_.clear();
}

fs::path Resources::find_image(const TextureName& name) const {
    std::string image = name.image;
    check_stays_inside(name.directory);
    const std::vector<std::string> names = images_of(folders_, name.directory);
    if (names.empty()) {
        fail("no texture directory \"{}\"{}", name.directory, suggestion(name.directory, image_directories(folders_)));
    }
    if (image == "*") image = names.front();
    for (const fs::path& folder : folders_.folders()) {  // the user's image wins, whatever its ending
        const DataFolders only({folder});
        for (const char* ending : image_endings) {
            fs::path path = only.find("textures/" + name.directory, image, ending);
            if (!path.empty()) return path;
        }
    }
    fail("no image \"{}\" in texture directory \"{}\"{}", image, name.directory, suggestion(image, names));
}

std::vector<std::string> Resources::image_names() const {
    std::set<std::string> names;
    for (const std::string& directory : image_directories(folders_)) {
        for (const std::string& image : images_of(folders_, directory)) {
            names.insert(directory + ":" + image);
        }
    }
    return {names.begin(), names.end()};
}

image::Image Resources::read_image(const TextureName& name) const { return image::read(find_image(name)); }

std::shared_ptr<const gpu::Texture> Resources::image(const TextureName& name, TextureForm form) {
    const fs::path path = find_image(name);
    std::weak_ptr<const gpu::Texture>& known = images_[{path.string(), form, name.is_filtered}];
    if (auto texture = known.lock()) return texture;
    const auto texture = upload(*context_, image::read(path), path.string(), form,
                                name.is_filtered ? gpu::Filter::trilinear : gpu::Filter::nearest);
    known = texture;
    return texture;
}

std::shared_ptr<const gpu::Texture> Resources::image(const std::shared_ptr<const image::Image>& pixels) {
    MaterialImage& known = material_images_[pixels.get()];
    if (known.pixels.lock() == pixels) {
        if (auto texture = known.texture.lock()) return texture;
    }
    const auto texture =
        std::make_shared<const gpu::Texture>(*context_, &pixels->pixels().front().x, pixels->width(), pixels->height(),
                                             gpu::Filter::trilinear, gpu::Wrap::repeat);
    known = {pixels, texture};
    return texture;
}

}  // namespace croquis::framework
