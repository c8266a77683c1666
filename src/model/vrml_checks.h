// What Coin would follow into a crash, found before it meets the file or the shape.
#pragma once

#include <string>
#include <string_view>

class SoVRMLIndexedFaceSet;

namespace croquis::model {

/// Fails for a file that is not VRML 2, that nests brackets too deep, whose nodes or prototypes use themselves, or that
/// draws other files in.
void check_vrml(std::string_view text, const std::string& name);

/// Whether all indices of a face set stand within their lists.
[[nodiscard]] bool is_sound(const SoVRMLIndexedFaceSet& faces);

}  // namespace croquis::model
