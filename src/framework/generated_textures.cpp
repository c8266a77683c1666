#include "framework/generated_textures.h"

#include "base/error.h"
#include "base/names.h"

namespace croquis::framework {

std::shared_ptr<gpu::Texture> GeneratedTextures::declare(const std::string& name, gpu::TextureFormat format) {
    std::shared_ptr<gpu::Texture>& texture = textures_[name];
    if (!texture) texture = std::make_shared<gpu::Texture>(*context_, format, 1, 1);
    if (texture->format() != format) fail("<generated>:{} is made by two passes in two formats", name);
    return texture;
}

std::shared_ptr<const gpu::Texture> GeneratedTextures::at(const std::string& name) const {
    const auto found = textures_.find(name);
    if (found != textures_.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, texture] : textures_) names.push_back(known);
    fail("no pass generates the texture \"{}\"{}", name, suggestion(name, names));
}

}  // namespace croquis::framework
