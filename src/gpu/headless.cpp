// Contexts without a window: EGL devices (a GPU), else EGL's surfaceless platform (Mesa's software renderer).
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "gpu/context.h"

namespace croquis::gpu {
namespace {

struct Display {
    EGLDisplay handle = EGL_NO_DISPLAY;
    std::string name;
};

bool has_client_extension(const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); }

// EGL devices that are not software in disguise.
std::vector<Display> hardware_displays() {
    std::vector<Display> displays;
    if (!has_client_extension("EGL_EXT_device_enumeration") || !has_client_extension("EGL_EXT_platform_device")) {
        return displays;
    }
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count)) return displays;
    for (EGLint i = 0; i < count; ++i) {
        const char* extensions = eglQueryDeviceStringEXT(devices[std::size_t(i)], EGL_EXTENSIONS);
        const bool is_software =
            extensions != nullptr &&
            std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
        if (is_software) continue;
        displays.push_back({eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[std::size_t(i)], nullptr),
                            fmt::format("EGL device {}", i)});
    }
    return displays;
}

std::vector<Display> displays_for(Device device) {
    std::vector<Display> displays;
    if (device != Device::software) displays = hardware_displays();
    if (device != Device::hardware && has_client_extension("EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            {eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), "EGL surfaceless"});
    }
    return displays;
}

EGLContext create_context(EGLDisplay display, Api api) {
    constexpr std::array gl_attributes{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    constexpr std::array gles_attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
    if (!eglBindAPI(api == Api::gl ? EGL_OPENGL_API : EGL_OPENGL_ES_API)) return EGL_NO_CONTEXT;
    return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT,
                            api == Api::gl ? gl_attributes.data() : gles_attributes.data());
}

class HeadlessContext final : public Context {
public:
    HeadlessContext(EGLDisplay display, EGLContext context, std::string platform)
        : Context(std::move(platform)), display_(display), context_(context) {
        HeadlessContext::make_current();
        describe();
    }

    // The display stays initialised: other contexts may share it, and Mesa frees it at exit.
    ~HeadlessContext() override {
        if (eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display_, context_);
    }

    void make_current() override {
        if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            fail("cannot make the {} context current (EGL error {:#x})", platform(), eglGetError());
        }
    }

private:
    EGLDisplay display_;
    EGLContext context_;
};

}  // namespace

std::unique_ptr<Context> Context::headless(const ContextOptions& options) {
    std::string tried;
    for (const Display& display : displays_for(options.device)) {
        tried += (tried.empty() ? "" : ", ") + display.name;
        if (display.handle == EGL_NO_DISPLAY || !eglInitialize(display.handle, nullptr, nullptr)) continue;
        const EGLContext context = create_context(display.handle, options.api);
        if (context == EGL_NO_CONTEXT) continue;
        return std::make_unique<HeadlessContext>(display.handle, context, display.name);
    }
    fail("no {} context to draw with: tried {}", options.api == Api::gl ? "OpenGL 3.3" : "OpenGL ES 3.0",
         tried.empty() ? "no EGL display, for there is none of the kind asked for" : tried);
}

}  // namespace croquis::gpu
