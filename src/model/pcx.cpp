// PCX, the image format of MD2's skins (ZSoft's technical reference manual, 1991): runs of equal bytes, a palette of
// 256 colours at the end.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/error.h"
#include "model/textures.h"

namespace croquis::model {
namespace {

constexpr std::size_t header_size = 128;
constexpr std::size_t palette_size = 768;

class Bytes {
public:
    explicit Bytes(std::span<const std::byte> bytes) : bytes_(bytes) {}
    [[nodiscard]] int byte(std::size_t at) const { return std::to_integer<int>(bytes_[at]); }
    [[nodiscard]] int word(std::size_t at) const { return byte(at) | byte(at + 1) << 8; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }

private:
    std::span<const std::byte> bytes_;
};

/// Unpacks `wanted` bytes; those that the file lacks stay 0.
std::vector<std::uint8_t> unpack(const Bytes& bytes, std::size_t wanted) {
    std::vector<std::uint8_t> unpacked;
    unpacked.reserve(wanted);
    for (std::size_t at = header_size; at < bytes.size() && unpacked.size() < wanted; ++at) {
        int value = bytes.byte(at), count = 1;
        if (value >= 0xc0 && at + 1 < bytes.size()) {
            count = value & 0x3f;
            value = bytes.byte(++at);
        }
        const auto fitting = std::min(std::size_t(count), wanted - unpacked.size());
        unpacked.insert(unpacked.end(), fitting, static_cast<std::uint8_t>(value));
    }
    unpacked.resize(wanted);
    return unpacked;
}

}  // namespace

image::Image decode_pcx(std::span<const std::byte> data, const std::string& name) {
    const Bytes bytes(data);
    if (bytes.size() < header_size || bytes.byte(0) != 10) fail("{}: expected a PCX image, found something else", name);
    const int width = bytes.word(8) - bytes.word(4) + 1, height = bytes.word(10) - bytes.word(6) + 1;
    const int planes = bytes.byte(65), row = bytes.word(66);
    const bool with_palette = planes == 1;
    if (bytes.byte(3) != 8 || (planes != 1 && planes != 3)) {
        fail("{}: expected a PCX image of 1 or 3 planes of 8 bits, found {} of {}", name, planes, bytes.byte(3));
    }
    if (width < 1 || height < 1 || row < width || width > image::longest_side || height > image::longest_side) {
        fail("{}: expected a PCX image of a sensible size, found {}x{} in rows of {}", name, width, height, row);
    }
    const auto wanted = std::size_t(row) * std::size_t(planes) * std::size_t(height);
    constexpr std::size_t most_packed = 64;  // a run of two bytes gives at most 63
    if (wanted > bytes.size() * most_packed || (with_palette && bytes.size() < header_size + palette_size)) {
        fail("{}: expected a whole PCX image, found {} bytes of it", name, bytes.size());
    }
    const std::vector<std::uint8_t> unpacked = unpack(bytes, wanted);
    image::Image image(width, height);
    for (int y = 0; y < height; ++y) {
        const std::uint8_t* const line = &unpacked[std::size_t(row) * std::size_t(planes) * std::size_t(y)];
        for (int x = 0; x < width; ++x) {
            const auto color = [&](int c) -> std::uint8_t {
                if (!with_palette) return line[c * row + x];
                return static_cast<std::uint8_t>(
                    bytes.byte(bytes.size() - palette_size + std::size_t(line[x]) * 3 + std::size_t(c)));
            };
            image.at(x, y) = {color(0), color(1), color(2), 255};
        }
    }
    return image;
}

}  // namespace croquis::model
