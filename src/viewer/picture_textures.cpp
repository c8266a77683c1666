#include "viewer/picture_textures.h"

#include <cstdint>

namespace croquis::viewer {

ImTextureID texture_id(unsigned texture) { return reinterpret_cast<ImTextureID>(std::uintptr_t(texture)); }

void PictureTextures::put(const std::string& name, const Picture& picture) {
    textures_[name] = std::make_unique<const gpu::Texture>(*context_, picture.pixels().data(), picture.width(),
                                                           picture.height(), gpu::Filter::trilinear, gpu::Wrap::clamp);
}

void PictureTextures::show(const std::string& name, const ImVec2& size) const {
    const auto found = textures_.find(name);
    if (found == textures_.end()) {
        ImGui::Dummy(size);
        return;
    }
    // The first row of a texture is its lowest.
    ImGui::Image(texture_id(found->second->id()), size, ImVec2(0, 1), ImVec2(1, 0));
}

}  // namespace croquis::viewer
