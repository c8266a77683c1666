// What a person works on: a model, a technique with its values, how both are looked at. No window, no panels.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "croquis/renderer.h"
#include "viewer/arrangement.h"
#include "viewer/canvas.h"
#include "viewer/painter.h"

namespace croquis::viewer {

/// How fine a picture is: fewer samples and triangles while something moves, so that it keeps up (seed A, 7.1.1).
enum class Detail { full, reduced };

class Session {
public:
    explicit Session(Renderer& renderer) : renderer_(renderer) {}

    // ---- The model

    /// Shows another model, at rest. Where it is seen from is for the arrangement to say.
    void show(Model model, const std::string& path, const std::string& texture);
    /// The model that is shown, with another texture: it stays where it is, and at its moment.
    void lay_texture(Model model, const std::string& texture);
    /// A copy of fewer triangles of the model that is shown, for Detail::reduced and for small pictures.
    void take_small_copy(Model copy) { small_copy_ = std::move(copy); }
    [[nodiscard]] const Model* model() const { return model_ ? &*model_ : nullptr; }
    [[nodiscard]] const Model* small_model() const { return small_copy_ ? &*small_copy_ : model(); }
    [[nodiscard]] const std::string& model_path() const { return model_path_; }
    [[nodiscard]] const std::string& model_texture() const { return model_texture_; }

    // ---- The technique

    /// Switches to a technique by name or path; its values are as they were left. Throws Error, changing nothing.
    void choose_technique(const std::string& name_or_path);
    /// All that were chosen so far.
    [[nodiscard]] std::vector<std::string> chosen_techniques() const;
    /// As it was asked for: a name or a path.
    [[nodiscard]] const std::string& technique_name() const { return technique_name_; }
    [[nodiscard]] bool has_technique() const { return !technique_name_.empty(); }
    [[nodiscard]] std::string technique_help() const { return has_technique() ? current().technique.help() : ""; }
    [[nodiscard]] std::vector<PassVariable> variables() const;

    /// Changes a variable, `pass.variable`. Throws Error, changing nothing.
    void set(const std::string& variable, const std::string& value);
    /// What the technique came with.
    [[nodiscard]] std::string original_value(const std::string& variable) const;
    [[nodiscard]] bool is_changed(const PassVariable& variable) const;
    void reset(const std::string& variable) { set(variable, original_value(variable)); }
    /// All variables as the technique came.
    void reset_all();

    /// Writes the technique with its values of now as a `.technique` file. Throws Error.
    void save_technique(const std::string& path) const;
    /// Makes the techniques anew from the files as they are now; values that were changed, in any of them, stay changed
    /// where they still can. Throws Error where a file of the one that is shown is wrong: then the old one goes on.
    void reload();

    /// Every edge over whatever a technique draws. It belongs to the drawing and to no technique: variables, what is
    /// saved and the command know nothing of it. Throws Error, changing nothing.
    void set_wireframe(bool on);
    [[nodiscard]] bool has_wireframe() const { return has_wireframe_; }

    // ---- Looking

    /// For changes; the next picture shows them.
    [[nodiscard]] Arrangement& arrangement() {
        touch();
        return arrangement_;
    }
    [[nodiscard]] const Arrangement& arrangement() const { return arrangement_; }
    void set_samples(int samples);
    [[nodiscard]] int samples() const { return samples_; }
    void set_background(std::optional<Background> background);
    [[nodiscard]] const std::optional<Background>& background() const { return background_; }
    void set_moment(const std::string& animation, double seconds);
    [[nodiscard]] const std::string& animation() const { return animation_; }
    [[nodiscard]] double seconds() const { return seconds_; }

    // ---- Pictures

    [[nodiscard]] DrawOptions options(FrameSize size) const;
    /// Grows with everything that shows in the picture.
    [[nodiscard]] long long revision() const { return revision_; }
    /// True when a drawing of this size would not be the one that was made last. A full one serves for a reduced one.
    [[nodiscard]] bool is_stale(FrameSize size, Detail detail) const;
    /// What a painter needs to draw the model and the technique as they are now.
    [[nodiscard]] Painter::Order order(const Painter::Purpose& purpose, const DrawOptions& options) const;
    /// A picture of now was drawn elsewhere, or could not be.
    void note_drawn(FrameSize size, Detail detail) { drawn_ = {revision_, size, detail}; }
    /// Draws a picture of that size on the canvas. Throws Error; the canvas keeps its last picture then, and it is not
    /// tried again until something changes.
    void draw(Canvas& canvas, FrameSize size, Detail detail);
    /// What each pass of such a frame takes.
    [[nodiscard]] std::vector<PassTime> time_passes(FrameSize size, Detail detail);
    /// For a picture `scale` times as large as the frame, that is to be kept. Throws Error where there is nothing to
    /// draw.
    [[nodiscard]] DrawOptions picture_options(FrameSize frame, int scale, bool has_background) const;
    /// Draws a picture and writes it as PNG. Throws Error.
    void save_picture(const std::string& path, const DrawOptions& options);
    /// The command that draws the same picture to a file.
    [[nodiscard]] std::string command_line(FrameSize frame) const;

private:
    using Values = std::map<std::string, std::string>;  // by full name
    struct OpenTechnique {
        Technique technique;
        Values original;
        std::optional<Technique> with_edges;  // the same and every edge over it, while that is what is drawn
        [[nodiscard]] Values changed() const;
    };
    [[nodiscard]] OpenTechnique open(const std::string& name_or_path);
    void match_wireframe(OpenTechnique& opened, bool has_wireframe);
    [[nodiscard]] OpenTechnique& current() { return open_.at(technique_name_); }
    [[nodiscard]] const OpenTechnique& current() const { return open_.at(technique_name_); }
    [[nodiscard]] Technique& drawn_technique();
    [[nodiscard]] const Technique& drawn_technique() const;
    [[nodiscard]] DrawOptions options_in(Detail detail, FrameSize size) const;
    [[nodiscard]] const Model& model_in(Detail detail) const {
        return detail == Detail::full ? *model_ : *small_model();
    }
    void touch() { ++revision_; }

    Renderer& renderer_;
    std::optional<Model> model_, small_copy_;
    std::string model_path_, model_texture_;
    std::map<std::string, OpenTechnique> open_;  // all that were chosen since a reload: switching back is at once
    std::map<std::string, Values> left_values_;  // of all that were ever chosen: what was changed before that reload
    std::string technique_name_;
    bool has_wireframe_ = false;
    Arrangement arrangement_;
    int samples_ = 4;
    std::optional<Background> background_;
    std::string animation_;
    double seconds_ = 0;

    long long revision_ = 0;
    struct Drawn {
        long long revision = -1;
        FrameSize size{0, 0};
        Detail detail = Detail::full;
    } drawn_;
};

}  // namespace croquis::viewer
