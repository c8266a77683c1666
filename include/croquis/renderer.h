// Drawing: a renderer owns what techniques share; a technique draws models.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "croquis/model.h"
#include "croquis/pass_variable.h"
#include "croquis/picture.h"
#include "croquis/view.h"

namespace croquis {

/// A technique that was opened and can draw. It belongs to its renderer and must go before that does, or before another
/// renderer takes its place: declare the renderer first.
class Technique {
public:
    Technique(Technique&&) noexcept;
    Technique& operator=(Technique&&) noexcept;
    ~Technique();

    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] const std::string& help() const;
    [[nodiscard]] std::vector<std::string> pass_names() const;

    /// All variables of all passes, in order, as their descriptors declare them, with their values of now.
    [[nodiscard]] std::vector<PassVariable> variables() const;

    /// The text of a `.technique` file that draws the same: what it included stands in it, with the values of now.
    [[nodiscard]] std::string text() const;

    /// Changes a variable of a pass: `set("edges.normal_threshold", "0.5")`. Values are written as in technique files,
    /// text without its quotes. A value out of range warns and is clamped. Throws Error with the nearest name, changing
    /// nothing, for a pass or variable that does not exist, or one that cannot change while the technique runs.
    void set(const std::string& variable, const std::string& value);

    /// A variable's value, as a technique file would have it.
    [[nodiscard]] std::string get(const std::string& variable) const;

private:
    friend class Renderer;
    struct Opened;
    explicit Technique(std::unique_ptr<Opened> opened);
    std::unique_ptr<Opened> opened_;
};

/// How long a pass took, and how many lines it drew that were found on the model.
struct PassTime {
    std::string pass;
    double milliseconds = 0;
    std::size_t lines = 0;
};

/// What a renderer draws with.
struct RendererInfo {
    std::string api;       ///< "OpenGL 3.3" or "OpenGL ES 3.0": what it asked for
    std::string version;   ///< what the driver gave
    std::string renderer;  ///< the driver's name of the device
    std::string platform;  ///< how the context came to be
    bool is_software = false;
    std::vector<std::string> data_folders;  ///< in order of precedence
};

/// Draws models. Not to be shared between threads.
class Renderer {
public:
    /// How to choose a context. Empty words leave the choice to the environment (CROQUIS_GL, CROQUIS_DEVICE), and where
    /// that says nothing either, to the machine.
    struct Choice {
        std::string api;     ///< "gl" or "gles"
        std::string device;  ///< "auto", "hardware" or "software"
        /// Folders with the user's own components, techniques, shaders and textures, searched before the shipped one.
        std::vector<std::string> data_folders;
    };

    /// A renderer with a context of its own: a GPU where there is one, else software; no window or display needed.
    /// Throws Error.
    [[nodiscard]] static Renderer headless(const Choice& choice);
    [[nodiscard]] static Renderer headless() { return headless(Choice()); }

    /// A renderer in the OpenGL context that is current now, which stays the caller's and must be current at each call.
    [[nodiscard]] static Renderer in_current_context(const std::vector<std::string>& data_folders = {});

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    [[nodiscard]] RendererInfo info() const;

    [[nodiscard]] std::vector<std::string> technique_names() const;

    /// The images that texture variables may name, `directory:image` each.
    [[nodiscard]] std::vector<std::string> texture_names() const;

    /// One of them. Throws Error with the nearest name.
    [[nodiscard]] Picture texture(const std::string& name) const;

    /// Opens a technique by name, or by the path of a file that ends in ".technique". `settings` are values from the
    /// start, `pass.variable=value` each. Throws Error at the place of a mistake in its file.
    [[nodiscard]] Technique open_technique(const std::string& name_or_path,
                                           const std::vector<std::string>& settings = {});

    /// Opens a technique from the text of a `.technique` file. Messages call that file `name`.technique.
    [[nodiscard]] Technique open_technique_text(const std::string& name, const std::string& text);

    /// Takes notice of changed files: techniques opened from now on are made of descriptors, shaders and textures as
    /// they are on disk now. Those opened before go on with what they have, so that a mistake in a file need not cost
    /// the picture. Throws Error, changing nothing, when the descriptors are wrong.
    void reload();

    /// Draws, and reads the picture back. Throws Error for options that make no sense.
    [[nodiscard]] Picture draw(const Model& model, Technique& technique, const DrawOptions& options = {});

    /// Draws into the caller's own framebuffer object (0: the window), over its lower left width × height pixels.
    /// Bindings and fixed state that it changes are put back; samples and options are as for `draw`.
    void draw_into(unsigned framebuffer, const Model& model, Technique& technique, const DrawOptions& options = {});

    /// Draws one frame and tells how long each pass took: by GPU timer queries, or by the clock around each finished
    /// pass on a software renderer.
    [[nodiscard]] std::vector<PassTime> time_passes(const Model& model, Technique& technique,
                                                    const DrawOptions& options = {});

    /// Draws frames one after another, waits until the last is finished, and tells how many milliseconds one took.
    /// Reads nothing back. The first frames of a technique compile and upload: draw some before. Throws Error for no
    /// frames.
    [[nodiscard]] double time_frames(const Model& model, Technique& technique, const std::vector<DrawOptions>& frames);

    /// How many OpenGL objects are alive, what was drawn, read back, linked and uploaded since the start.
    struct Counts {
        int live_objects = 0;
        long long draws = 0;
        long long read_backs = 0;
        long long programs_linked = 0;
        long long texture_uploads = 0;
        long long geometry_uploads = 0;
    };
    [[nodiscard]] Counts counts() const;

private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace croquis
