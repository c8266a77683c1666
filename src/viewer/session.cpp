#include "viewer/session.h"

#include <utility>

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "viewer/command_line.h"

namespace croquis::viewer {
namespace {

// The edges over what is there: its colour and its depth stay.
constexpr const char* wireframe_pass =
    "\npass wireframe wireframe_over_all { keep_color true ; keep_depth true ; } ;\n";

// A value whose variable has gone, or cannot be that any more, is no mistake: files change.
void restore(Technique& technique, const std::map<std::string, std::string>& values) {
    for (const auto& [variable, value] : values) {
        try {
            technique.set(variable, value);
        } catch (const Error& error) {
            note(fmt::format("not kept: {}", error.what()));
        }
    }
}

}  // namespace

void Session::show(Model model, const std::string& path, const std::string& texture) {
    model_ = std::move(model);
    small_copy_.reset();
    model_path_ = path;
    model_texture_ = texture;
    animation_.clear();
    seconds_ = 0;
    touch();
}

void Session::lay_texture(Model model, const std::string& texture) {
    model_ = std::move(model);
    small_copy_.reset();
    model_texture_ = texture;
    touch();
}

Session::Values Session::OpenTechnique::changed() const {
    Values changed;
    for (const PassVariable& variable : technique.variables()) {
        if (variable.value != original.at(variable.full_name())) changed[variable.full_name()] = variable.value;
    }
    return changed;
}

Session::OpenTechnique Session::open(const std::string& name_or_path) {
    OpenTechnique opened{renderer_.open_technique(name_or_path), {}, {}};
    for (const PassVariable& variable : opened.technique.variables()) {
        opened.original[variable.full_name()] = variable.value;
    }
    if (const auto left = left_values_.find(name_or_path); left != left_values_.end()) {
        restore(opened.technique, left->second);
    }
    match_wireframe(opened, has_wireframe_);
    return opened;
}

// Its values are those of the technique: `set` keeps them the same.
void Session::match_wireframe(OpenTechnique& opened, bool has_wireframe) {
    if (!has_wireframe) opened.with_edges.reset();
    if (has_wireframe == opened.with_edges.has_value()) return;
    const Technique& technique = opened.technique;
    opened.with_edges = renderer_.open_technique_text(technique.name(), technique.text() + wireframe_pass);
}

const Technique& Session::drawn_technique() const {
    return current().with_edges ? *current().with_edges : current().technique;
}

Technique& Session::drawn_technique() { return current().with_edges ? *current().with_edges : current().technique; }

void Session::choose_technique(const std::string& name_or_path) {
    const auto found = open_.find(name_or_path);
    if (found == open_.end())
        open_.emplace(name_or_path, open(name_or_path));
    else
        match_wireframe(found->second, has_wireframe_);
    left_values_.try_emplace(name_or_path);
    technique_name_ = name_or_path;
    touch();
}

std::vector<std::string> Session::chosen_techniques() const {
    std::vector<std::string> names;
    for (const auto& [name, values] : left_values_) names.push_back(name);
    return names;
}

std::vector<PassVariable> Session::variables() const {
    return has_technique() ? current().technique.variables() : std::vector<PassVariable>();
}

void Session::set(const std::string& variable, const std::string& value) {
    current().technique.set(variable, value);
    if (current().with_edges) current().with_edges->set(variable, value);
    touch();
}

std::string Session::original_value(const std::string& variable) const { return current().original.at(variable); }

bool Session::is_changed(const PassVariable& variable) const {
    return variable.value != original_value(variable.full_name());
}

void Session::reset_all() {
    if (!has_technique()) return;
    for (const auto& [variable, value] : current().changed()) reset(variable);
}

void Session::save_technique(const std::string& path) const {
    if (!has_technique()) fail("expected a technique to save, found none");
    write_file_whole(path, current().technique.text());
}

// The techniques that are not shown are opened when they are chosen again: their files may be wrong, or slow to
// compile.
void Session::reload() {
    renderer_.reload();
    for (const auto& [name, opened] : open_) left_values_[name] = opened.changed();
    std::erase_if(open_, [&](const auto& opened) { return opened.first != technique_name_; });
    if (!has_technique()) return;
    current() = open(technique_name_);
    touch();
}

void Session::set_wireframe(bool on) {
    if (on == has_wireframe_ || !has_technique()) return;
    match_wireframe(current(), on);
    has_wireframe_ = on;
    touch();
}

void Session::set_samples(int samples) {
    samples_ = samples;
    touch();
}

void Session::set_background(std::optional<Background> background) {
    background_ = std::move(background);
    touch();
}

void Session::set_moment(const std::string& animation, double seconds) {
    animation_ = animation;
    seconds_ = seconds;
    touch();
}

DrawOptions Session::options(FrameSize size) const {
    DrawOptions options;
    options.width = size.width;
    options.height = size.height;
    options.samples = samples_;
    options.view = arrangement_.view();
    options.light = arrangement_.light();
    options.background = background_;
    options.animation = animation_;
    options.time = seconds_;
    return options;
}

DrawOptions Session::options_in(Detail detail, FrameSize size) const {
    DrawOptions options = this->options(size);
    if (detail == Detail::reduced) options.samples = 1;
    return options;
}

bool Session::is_stale(FrameSize size, Detail detail) const {
    if (!model_ || !has_technique()) return false;
    return drawn_.revision != revision_ || drawn_.size != size ||
           (detail == Detail::full && drawn_.detail == Detail::reduced);
}

Painter::Order Session::order(const Painter::Purpose& purpose, const DrawOptions& options) const {
    return {.purpose = purpose,
            .technique = drawn_technique().name(),
            .text = drawn_technique().text(),
            .model = *model_,
            .options = options,
            .revision = revision_};
}

void Session::draw(Canvas& canvas, FrameSize size, Detail detail) {
    note_drawn(size, detail);
    renderer_.draw_into(canvas.begin(size), model_in(detail), drawn_technique(), options_in(detail, size));
    canvas.keep();
}

std::vector<PassTime> Session::time_passes(FrameSize size, Detail detail) {
    if (!model_ || !has_technique()) return {};
    return renderer_.time_passes(model_in(detail), drawn_technique(), options_in(detail, size));
}

DrawOptions Session::picture_options(FrameSize frame, int scale, bool has_background) const {
    if (!model_ || !has_technique()) fail("expected a model and a technique to draw, found none");
    DrawOptions options = this->options({frame.width * scale, frame.height * scale});
    if (!has_background) options.background = Background{.color = {1, 1, 1}, .transparent = true, .texture = {}};
    return options;
}

void Session::save_picture(const std::string& path, const DrawOptions& options) {
    renderer_.draw(*model_, drawn_technique(), options).save(path);
}

std::string Session::command_line(FrameSize frame) const {
    if (!model_ || !has_technique()) fail("expected a model and a technique to draw, found none");
    std::vector<std::string> users_own = renderer_.info().data_folders;
    users_own.pop_back();  // the shipped one
    return render_command(model_path_, model_texture_, technique_name_, current().changed(), options(frame), users_own);
}

}  // namespace croquis::viewer
