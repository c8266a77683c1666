#include "viewer/magnifier.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "viewer/picture_textures.h"

namespace croquis::viewer {
namespace {

constexpr double least_factor = 1.5, most_factor = 16;

// The value of the pixel under the mouse, below the lens.
void show_value(ImDrawList& list, const Canvas& canvas, int x, int y, const ImVec2& place) {
    const FrameSize size = canvas.size();
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) return;
    const glm::u8vec4 pixel = canvas.pixel(x, y);
    const std::string text = fmt::format("{}, {}   #{:02x}{:02x}{:02x}", x, y, pixel.r, pixel.g, pixel.b);
    const ImVec2 half(0.5f * ImGui::CalcTextSize(text.c_str()).x, 0);
    const float margin = 0.3f * ImGui::GetFontSize();
    list.AddRectFilled(ImVec2(place.x - half.x - margin, place.y),
                       ImVec2(place.x + half.x + margin, place.y + ImGui::GetFontSize() + 2 * margin),
                       IM_COL32(20, 22, 26, 230), margin);
    list.AddText(ImVec2(place.x - half.x, place.y + margin), IM_COL32_WHITE, text.c_str());
}

}  // namespace

void Magnifier::zoom(double notches) {
    factor_ = std::clamp(factor_ * std::pow(1.25, notches), least_factor, most_factor);
}

void Magnifier::show(const Canvas& canvas, double pixels_a_point) const {
    if (!is_held_ || !ImGui::IsMousePosValid()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const FrameSize size = canvas.size();
    // The middle of the pixel under the mouse lies in the middle of the lens.
    const double x = std::floor(mouse.x * pixels_a_point) + 0.5, y = std::floor(mouse.y * pixels_a_point) + 0.5;
    const float half = 8 * ImGui::GetFontSize();
    const double covered = half * pixels_a_point / factor_;  // pixels on each side
    const ImVec2 low(float((x - covered) / size.width), float(1 - (y - covered) / size.height));
    const ImVec2 high(float((x + covered) / size.width), float(1 - (y + covered) / size.height));
    const ImVec2 corner(mouse.x - half, mouse.y - half), other(mouse.x + half, mouse.y + half);
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float rounding = shape_ == Shape::round ? half : 0;
    list.AddRectFilled(corner, other, IM_COL32_WHITE, rounding);
    list.AddImageRounded(texture_id(canvas.texture()), corner, other, low, high, IM_COL32_WHITE, rounding);
    list.AddRect(corner, other, IM_COL32(40, 44, 52, 255), rounding, 0, 0.15f * ImGui::GetFontSize());
    show_value(list, canvas, int(x), int(y), ImVec2(mouse.x, other.y + 0.4f * ImGui::GetFontSize()));
}

}  // namespace croquis::viewer
