// A finished drawing as pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace croquis {

/// 8-bit RGBA pixels, rows from top to bottom, alpha not multiplied in, values display-referred (sRGB as stored).
class Picture {
public:
    Picture(int width, int height, std::vector<std::uint8_t> pixels)
        : width_(width), height_(height), pixels_(std::move(pixels)) {}

    /// Reads PNG, JPEG, TGA, BMP, GIF, PSD or PNM. Throws Error.
    [[nodiscard]] static Picture read(const std::string& path);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

    /// width × height × 4 bytes.
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return pixels_; }

    /// Writes a PNG, whole or not at all; "-" is standard output. Throws Error.
    void save(const std::string& path) const;

    /// How far two pictures lie apart, in levels of 0 to 255 over all four channels.
    struct Difference {
        double mean = 0;
        int maximum = 0;
    };

    /// Throws Error when the sizes differ.
    [[nodiscard]] Difference difference_from(const Picture& other) const;

private:
    int width_;
    int height_;
    std::vector<std::uint8_t> pixels_;
};

}  // namespace croquis
