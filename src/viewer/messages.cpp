#include "viewer/messages.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "base/error.h"
#include "base/files.h"
#include "viewer/appearance.h"

namespace croquis::viewer {
namespace {

constexpr std::uintmax_t most_bytes = 1 << 20;

// ":12" at `at` as a number, past which `at` moves; 0 where there is none.
std::size_t take_number(const std::string& text, std::size_t& at) {
    if (at + 1 >= text.size() || text[at] != ':' || std::isdigit(static_cast<unsigned char>(text[at + 1])) == 0)
        return 0;
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data() + at + 1, text.data() + text.size(), number);
    if (error != std::errc{}) return 0;
    at = std::size_t(end - text.data());
    return number;
}

// The place that a message begins with. A file's name may hold colons itself: the place ends at the first ":number".
TextPosition place_of(const std::string& message) {
    for (std::size_t at = message.find(':'); at != std::string::npos; at = message.find(':', at + 1)) {
        std::size_t after = at;
        const std::size_t line = take_number(message, after);
        if (line > 0) return {message.substr(0, at), line, take_number(message, after)};
    }
    return {};
}

std::string line_of(const std::string& text, std::size_t number) {
    std::size_t begin = 0;
    for (std::size_t line = 1; line < number; ++line) {
        begin = text.find('\n', begin);
        if (begin == std::string::npos) return {};
        ++begin;
    }
    return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

std::string excerpt(const std::string& message) {
    const TextPosition place = place_of(message);
    if (place.line == 0) return {};
    try {
        const std::string line = line_of(read_file(place.file, most_bytes), place.line);
        if (line.empty() || place.column == 0) return line;
        return line + '\n' + std::string(std::min(place.column - 1, line.size()), ' ') + '^';
    } catch (const Error&) {
        return {};  // it is about something that is no file
    }
}

void Messages::tell(Source source, const std::string& mistake) {
    const auto known = mistakes_.find(source);
    if (known != mistakes_.end() && known->second.text == mistake) return;
    mistakes_[source] = {mistake, excerpt(mistake)};
}

std::string Messages::mistake(Source source) const {
    const auto found = mistakes_.find(source);
    return found == mistakes_.end() ? "" : found->second.text;
}

void Messages::note(const std::string& text) {
    note_ = text;
    note_ends_ = std::chrono::steady_clock::now() + std::chrono::seconds(4);
}

bool Messages::can_be_closed() const {
    return mistakes_.count(Source::action) > 0 || mistakes_.count(Source::model) > 0;
}

void Messages::close() {
    mended(Source::action);
    mended(Source::model);
}

void Messages::show(float low, float high) {
    shows_note_ = has_note();
    if (mistakes_.empty() && !shows_note_) return;
    const float line = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(low + line, ImGui::GetIO().DisplaySize.y - line), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowSize(ImVec2(std::max(high - low - 2 * line, line), 0));
    ImGui::Begin("messages", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoMove);
    for (const auto& [source, mistake] : mistakes_) {
        ImGui::PushStyleColor(ImGuiCol_Text, mistake_color);
        ImGui::TextWrapped("%s", mistake.text.c_str());
        ImGui::PopStyleColor();
        if (mistake.excerpt.empty()) continue;
        ImGui::PushFont(fixed_width_font());
        ImGui::TextUnformatted(mistake.excerpt.c_str());
        ImGui::PopFont();
    }
    if (can_be_closed() && ImGui::SmallButton("close")) close();
    if (shows_note_) ImGui::TextWrapped("%s", note_.c_str());
    ImGui::End();
}

}  // namespace croquis::viewer
