// Names of textures in technique files: `directory:image:filter` and `<generated>:name` (seed C, 2.2.2).
#pragma once

#include <string>
#include <string_view>

namespace croquis::framework {

struct TextureName {
    bool is_generated = false;
    std::string directory;    ///< in data/textures; empty for generated textures
    std::string image;        ///< without ending; "*" for the first of the directory; the name of a generated texture
    bool is_filtered = true;  ///< trilinear rather than nearest; generated textures are always nearest

    /// Throws Error saying which form was expected and what was found.
    [[nodiscard]] static TextureName parse(std::string_view text);

    [[nodiscard]] std::string to_string() const;
};

}  // namespace croquis::framework
