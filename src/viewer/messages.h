// What the viewer has to tell: mistakes that stay until they are mended, and notes that pass.
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace croquis::viewer {

class Messages {
public:
    /// Where a mistake comes from. Each tells one at a time, and none once all is well.
    enum class Source { files, model, drawing, action };

    void tell(Source source, const std::string& mistake);
    void mended(Source source) { mistakes_.erase(source); }
    /// A person has read what can be mended no more: of deeds and of models that cannot be read.
    void close();
    [[nodiscard]] bool has_mistake(Source source) const { return mistakes_.count(source) > 0; }
    [[nodiscard]] std::string mistake(Source source) const;

    /// Shown for some seconds: "wrote a.png".
    void note(const std::string& text);

    /// Shows all of it above the lower edge of the window, between `low` and `high` across.
    void show(float low, float high);
    /// True when a note is shown whose time is over: a frame is due.
    [[nodiscard]] bool has_stale_note() const { return shows_note_ && !has_note(); }

private:
    [[nodiscard]] bool can_be_closed() const;
    struct Mistake {
        std::string text;
        std::string excerpt;
    };
    std::map<Source, Mistake> mistakes_;
    [[nodiscard]] bool has_note() const { return std::chrono::steady_clock::now() < note_ends_; }

    std::string note_;
    std::chrono::steady_clock::time_point note_ends_;
    bool shows_note_ = false;
};

/// The line of the file that a message "FILE:LINE:COLUMN: …" is about, and a caret below the column; empty for a
/// message without place, or a file that cannot be read.
[[nodiscard]] std::string excerpt(const std::string& message);

}  // namespace croquis::viewer
