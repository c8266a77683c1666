#include "croquis/picture.h"

#include <algorithm>

#include "image/image.h"
#include "output/png.h"

namespace croquis {
namespace {

image::Image as_image(const Picture& picture) {
    image::Image image(picture.width(), picture.height());
    std::copy(picture.pixels().begin(), picture.pixels().end(), reinterpret_cast<std::uint8_t*>(image.pixels().data()));
    return image;
}

}  // namespace

Picture Picture::read(const std::string& path) {
    const image::Image image = image::read(path);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(image.pixels().data());
    return Picture(image.width(), image.height(), std::vector<std::uint8_t>(bytes, bytes + image.pixels().size() * 4));
}

void Picture::save(const std::string& path) const { output::write_png(path, width_, height_, pixels_); }

Picture::Difference Picture::difference_from(const Picture& other) const {
    const image::Difference difference = image::compare(as_image(*this), as_image(other));
    return {difference.mean, difference.maximum};
}

}  // namespace croquis
