#include "output/png.h"

#include <png.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/files.h"

namespace croquis::output {
namespace {

bool is_opaque(std::span<const std::uint8_t> pixels) {
    for (std::size_t alpha = 3; alpha < pixels.size(); alpha += 4) {
        if (pixels[alpha] != 255) return false;
    }
    return true;
}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

[[noreturn]] void refuse(png_structp, png_const_charp message) { fail("cannot write PNG: {}", message); }

class Writer {
public:
    Writer() : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, nullptr)) {
        if (png_ == nullptr) fail("cannot write PNG: out of memory");
        info_ = png_create_info_struct(png_);
        png_set_write_fn(png_, &bytes_, append, nullptr);
    }
    ~Writer() { png_destroy_write_struct(&png_, &info_); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    // Level 1 with the SUB filter: five times faster than the default, files a little larger.
    std::string write(int width, int height, std::span<const std::uint8_t> pixels) {
        const bool opaque = is_opaque(pixels);
        png_set_compression_level(png_, 1);
        png_set_filter(png_, 0, PNG_FILTER_SUB);
        png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), 8,
                     opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png_, info_);
        if (opaque) png_set_filler(png_, 0, PNG_FILLER_AFTER);
        const std::size_t row = std::size_t(width) * 4;
        for (int y = 0; y < height; ++y) png_write_row(png_, pixels.data() + row * std::size_t(y));
        png_write_end(png_, info_);
        return std::move(bytes_);
    }

private:
    png_structp png_;
    png_infop info_ = nullptr;
    std::string bytes_;
};

}  // namespace

void write_png(const std::filesystem::path& path, int width, int height, std::span<const std::uint8_t> pixels) {
    write_file_whole(path, Writer().write(width, height, pixels));
}

}  // namespace croquis::output
