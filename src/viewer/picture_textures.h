// Pictures for the user interface: small drawings in the list of techniques, previews of textures.
#pragma once

#include <imgui.h>

#include <map>
#include <memory>
#include <string>

#include "croquis/picture.h"
#include "gpu/texture.h"

namespace croquis::viewer {

class PictureTextures {
public:
    /// Kept in the context that is current, which must stay so.
    PictureTextures() : context_(gpu::Context::current()) {}

    void put(const std::string& name, const Picture& picture);
    void clear() { textures_.clear(); }

    /// Puts the picture of that name into the window at the cursor, as large as asked for, or leaves the place empty
    /// where there is none.
    void show(const std::string& name, const ImVec2& size) const;

private:
    std::unique_ptr<gpu::Context> context_;
    std::map<std::string, std::unique_ptr<const gpu::Texture>> textures_;
};

/// What ImGui calls a texture.
[[nodiscard]] ImTextureID texture_id(unsigned texture);

}  // namespace croquis::viewer
