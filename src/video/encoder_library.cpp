// The library with FFmpeg in it is loaded when a video is made, and not with the program: it brings more than a hundred
// others along, with which every command would take four times as long to start (75 ms in place of 18).
#include <dlfcn.h>

#include <array>
#include <filesystem>

#include "base/error.h"
#include "video/encoder.h"

namespace croquis::video {
namespace {

namespace fs = std::filesystem;

fs::path library_path() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const std::array<fs::path, 3> places{program.parent_path() / CROQUIS_VIDEO_FROM_PROGRAM, CROQUIS_INSTALLED_VIDEO,
                                         CROQUIS_BUILT_VIDEO};
    for (const fs::path& place : places) {
        if (fs::is_regular_file(place, error)) return place;
    }
    fail("no library for videos: looked for {}, {} and {}", places[0].lexically_normal().string(), places[1].string(),
         places[2].string());
}

// It stays: what threads of its libraries may still hold must not be pulled from under them.
MakeEncoder& loaded() {
    const fs::path path = library_path();
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    void* const function = library != nullptr ? ::dlsym(library, "croquis_make_encoder") : nullptr;
    if (function == nullptr) fail("{}: cannot load it for videos: {}", path.string(), ::dlerror());
    return *reinterpret_cast<MakeEncoder*>(function);
}

}  // namespace

MakeEncoder& encoder_maker() {
    static MakeEncoder& maker = loaded();
    return maker;
}

}  // namespace croquis::video
