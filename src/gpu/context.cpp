#include "gpu/context.h"

#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/names.h"

namespace croquis::gpu {
namespace {

template <typename Choice, std::size_t n>
Choice choice_named(const std::string& word, const std::array<std::pair<const char*, Choice>, n>& choices,
                    const char* what) {
    std::vector<std::string> names;
    for (const auto& [name, choice] : choices) {
        if (word == name) return choice;
        names.emplace_back(name);
    }
    fail("expected {} to be {}, found \"{}\"{}", what, fmt::join(names, ", "), word, suggestion(word, names));
}

class CurrentContext final : public Context {
public:
    CurrentContext() : Context("the caller's") { describe(); }
    void make_current() override {}
};

std::string text_of(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text != nullptr ? text : "unknown";
}

}  // namespace

Api api_named(const std::string& word) {
    return choice_named<Api, 2>(word, {{{"gl", Api::gl}, {"gles", Api::gles}}}, "the API");
}

Device device_named(const std::string& word) {
    return choice_named<Device, 3>(
        word, {{{"auto", Device::automatic}, {"hardware", Device::hardware}, {"software", Device::software}}},
        "the device");
}

ContextOptions ContextOptions::from_environment() {
    ContextOptions options;
    if (const char* api = std::getenv("CROQUIS_GL")) options.api = api_named(api);
    if (const char* device = std::getenv("CROQUIS_DEVICE")) options.device = device_named(device);
    return options;
}

std::unique_ptr<Context> Context::current() { return std::make_unique<CurrentContext>(); }

void Context::describe() {
    const int version = epoxy_gl_version();
    if (version == 0) fail("expected a current OpenGL context, found none");
    api_ = epoxy_is_desktop_gl() ? Api::gl : Api::gles;
    const int least = api_ == Api::gl ? 33 : 30;
    if (version < least) {
        fail("expected {} {}.{} or later, found {}.{}", api_ == Api::gl ? "OpenGL" : "OpenGL ES", least / 10,
             least % 10, version / 10, version % 10);
    }
    renderer_ = text_of(GL_RENDERER);
    version_ = text_of(GL_VERSION);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest_side_);
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longest_volume_side_);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most_layers_);
}

bool Context::is_software() const {
    for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "swrast"}) {
        if (renderer_.find(name) != std::string::npos) return true;
    }
    return false;
}

void Context::finish() { glFinish(); }

}  // namespace croquis::gpu
