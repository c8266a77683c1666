#include "framework/texture_name.h"

#include "base/error.h"

namespace croquis::framework {
namespace {

constexpr std::string_view generated_directory = "<generated>";

[[noreturn]] void refuse(std::string_view text) {
    fail(
        "expected a texture as directory:image, directory:image:0, directory:image:1 or <generated>:name, found \"{}\"",
        text);
}

}  // namespace

TextureName TextureName::parse(std::string_view text) {
    const std::size_t first = text.find(':');
    if (first == std::string_view::npos || first == 0) refuse(text);
    TextureName name;
    name.directory = text.substr(0, first);
    const std::string_view rest = text.substr(first + 1);
    const std::size_t second = rest.find(':');
    name.image = rest.substr(0, second);
    if (name.image.empty()) refuse(text);
    if (second != std::string_view::npos) {
        const std::string_view filter = rest.substr(second + 1);
        if (filter != "0" && filter != "1") refuse(text);
        name.is_filtered = filter == "1";
    }
    if (name.directory == generated_directory) {
        name.is_generated = true;
        name.directory.clear();
        name.is_filtered = false;
    }
    return name;
}

std::string TextureName::to_string() const {
    if (is_generated) return fmt::format("{}:{}", generated_directory, image);
    return fmt::format("{}:{}:{}", directory, image, is_filtered ? 1 : 0);
}

}  // namespace croquis::framework
