// OpenGL contexts by named factories, and what is counted in them. No type of OpenGL leaves this folder.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace croquis::gpu {

/// Which of the two APIs a context speaks: OpenGL 3.3 core, or the portable subset alone.
enum class Api { gl, gles };

/// Where to draw: on a GPU when there is one, else in software; or one of the two by force.
enum class Device { automatic, hardware, software };

struct ContextOptions {
    Api api = Api::gl;
    Device device = Device::automatic;

    /// The choice in the environment: CROQUIS_GL is "gl" or "gles", CROQUIS_DEVICE "auto", "hardware" or "software".
    /// Throws Error for any other word.
    [[nodiscard]] static ContextOptions from_environment();
};

[[nodiscard]] Api api_named(const std::string& word);
[[nodiscard]] Device device_named(const std::string& word);

/// What is alive and what was done in a context. Tests assert on these: no read-back in a frame, nothing alive at exit,
/// no program linked twice.
struct Counters {
    int live_programs = 0;
    int live_textures = 0;
    int live_framebuffers = 0;
    int live_geometries = 0;
    std::int64_t draws = 0;
    std::int64_t read_backs = 0;
    std::int64_t programs_linked = 0;
    std::int64_t texture_uploads = 0;
    std::int64_t geometry_uploads = 0;

    [[nodiscard]] int live_objects() const {
        return live_programs + live_textures + live_framebuffers + live_geometries;
    }
};

/// One OpenGL context. All objects made in it must go before it does, and all are used on the thread it is current on.
class Context {
public:
    /// A context without a window or display: an EGL device where there is a GPU, else Mesa's surfaceless platform.
    /// It is current on return. Throws Error saying what was tried.
    [[nodiscard]] static std::unique_ptr<Context> headless(const ContextOptions& options);

    /// The context that the caller made current, which stays the caller's.
    [[nodiscard]] static std::unique_ptr<Context> current();

    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    virtual void make_current() = 0;

    [[nodiscard]] Api api() const { return api_; }
    [[nodiscard]] const std::string& renderer() const { return renderer_; }
    [[nodiscard]] const std::string& version() const { return version_; }
    /// How the context came to be: "EGL device 0", "EGL surfaceless", "the caller's".
    [[nodiscard]] const std::string& platform() const { return platform_; }
    [[nodiscard]] bool is_software() const;
    /// The longest side of a texture or target.
    [[nodiscard]] int longest_side() const { return longest_side_; }
    /// The longest side of a volume.
    [[nodiscard]] int longest_volume_side() const { return longest_volume_side_; }
    /// The most layers of a texture of layers.
    [[nodiscard]] int most_layers() const { return most_layers_; }

    [[nodiscard]] Counters& counters() { return counters_; }

    /// Waits until everything asked for so far is drawn.
    void finish();

protected:
    explicit Context(std::string platform) : platform_(std::move(platform)) {}
    /// Reads what the current context says of itself. Throws Error when it is too old.
    void describe();

private:
    Api api_ = Api::gl;
    std::string renderer_;
    std::string version_;
    std::string platform_;
    int longest_side_ = 0;
    int longest_volume_side_ = 0;
    int most_layers_ = 0;
    Counters counters_;
};

}  // namespace croquis::gpu
