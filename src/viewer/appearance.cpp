#include "viewer/appearance.h"

#include <filesystem>
#include <system_error>

namespace croquis::viewer {
namespace {

constexpr const char* text_font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* fixed_font = "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf";
constexpr float font_pixels = 15;

// ImGui's own letters where the font is not installed.
void add_font(const char* file, float pixels) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    std::error_code error;
    if (std::filesystem::exists(file, error)) {
        // Latin letters, and from general punctuation and mathematics what help texts use: – — “ ” … → ° ².
        static constexpr ImWchar ranges[] = {0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2044, 0x2080,
                                             0x2089, 0x2190, 0x21ff, 0x2200, 0x22ff, 0};
        fonts.AddFontFromFileTTF(file, pixels, nullptr, ranges);
        return;
    }
    ImFontConfig config;
    config.SizePixels = pixels;
    fonts.AddFontDefault(&config);
}

}  // namespace

void set_appearance(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    add_font(text_font, font_pixels * scale);
    add_font(fixed_font, font_pixels * scale);
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    style.FrameRounding = style.PopupRounding = 4;
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.11f, 0.12f, 0.14f, 1.0f);
    style.Colors[ImGuiCol_TextDisabled] = ImVec4(0.64f, 0.66f, 0.7f, 1.0f);
    style.Colors[ImGuiCol_Border] = ImVec4(0.4f, 0.45f, 0.55f, 1.0f);
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

ImFont* fixed_width_font() { return ImGui::GetIO().Fonts->Fonts[1]; }

}  // namespace croquis::viewer
