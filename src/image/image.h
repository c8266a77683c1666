// Pixel buffers: rows run top to bottom, values are display-referred (sRGB as stored).
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <vector>

namespace croquis::image {

/// A rectangle of pixels, row 0 at the top.
template <typename Pixel>
class Raster {
public:
    Raster() = default;
    Raster(int width, int height, Pixel fill = Pixel{})
        : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height), fill) {
        assert(width >= 0 && height >= 0);
    }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool empty() const { return pixels_.empty(); }

    [[nodiscard]] Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
    [[nodiscard]] const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }

    [[nodiscard]] std::span<Pixel> pixels() { return pixels_; }
    [[nodiscard]] std::span<const Pixel> pixels() const { return pixels_; }

    bool operator==(const Raster&) const = default;

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        assert(x >= 0 && x < width_ && y >= 0 && y < height_);
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }

    int width_ = 0;
    int height_ = 0;
    std::vector<Pixel> pixels_;
};

/// 8 bits a channel, alpha not multiplied in.
using Image = Raster<glm::u8vec4>;

/// The longest side of an image that is read or written.
constexpr int longest_side = 32768;

/// Reads PNG, JPEG, TGA, BMP, GIF (first frame), PSD or PNM, whatever the file's name says. A missing alpha is 255.
/// Throws Error for a file that is missing, damaged or of more than `longest_side` pixels a side.
[[nodiscard]] Image read(const std::filesystem::path& path);

/// The same from bytes in memory; `name` stands in errors.
[[nodiscard]] Image decode(std::span<const std::byte> bytes, const std::string& name);

/// How far two pictures lie apart, in levels of 0 to 255 over all four channels.
struct Difference {
    double mean = 0;
    int maximum = 0;
};

/// Throws Error when the sizes differ.
[[nodiscard]] Difference compare(const Image& a, const Image& b);

}  // namespace croquis::image
