#include "image/image.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "base/error.h"
#include "base/files.h"

namespace croquis::image {
namespace {

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

Image read(const std::filesystem::path& path) {
    constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 30;
    const std::string bytes = read_file(path, most_bytes);
    return decode(std::as_bytes(std::span(bytes)), path.string());
}

Image decode(std::span<const std::byte> bytes, const std::string& name) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()), &width,
                              &height, &channels, STBI_rgb_alpha));
    if (!pixels)
        fail("{}: expected an image, found {} bytes that are none ({})", name, bytes.size(), stbi_failure_reason());
    Image image(width, height);
    const auto source = reinterpret_cast<const glm::u8vec4*>(pixels.get());
    std::copy_n(source, image.pixels().size(), image.pixels().begin());
    return image;
}

Difference compare(const Image& a, const Image& b) {
    if (a.width() != b.width() || a.height() != b.height()) {
        fail("expected pictures of one size, found {}x{} and {}x{}", a.width(), a.height(), b.width(), b.height());
    }
    Difference difference;
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            const int apart = std::abs(int(a.pixels()[i][c]) - int(b.pixels()[i][c]));
            difference.maximum = std::max(difference.maximum, apart);
            sum += apart;
        }
    }
    if (!a.empty()) difference.mean = sum / (4.0 * double(a.pixels().size()));
    return difference;
}

}  // namespace croquis::image
