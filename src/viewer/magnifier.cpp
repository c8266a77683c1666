#include "viewer/magnifier.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "viewer/picture_textures.h"
#include "viewer/sphere_lens.h"

namespace croquis::viewer {
namespace {

constexpr double least_factor = 1.5, most_factor = 16;

// What a lens shows: a square of pixels of the picture, by its middle and half its side.
struct Square {
    glm::dvec2 middle;
    double half;
    FrameSize picture;
    /// The texture coordinates of a place in it, from (-1, -1) in its upper left corner to (1, 1).
    [[nodiscard]] ImVec2 coordinates(const glm::dvec2& place) const {
        const glm::dvec2 pixel = middle + half * place;
        return {float(pixel.x / picture.width), float(1 - pixel.y / picture.height)};
    }
};

// A disc of rings at equal angles of the sphere, each point with the texture coordinates that the sphere has there.
void draw_sphere(ImDrawList& list, ImTextureID texture, const ImVec2& middle, float half, const Square& square) {
    constexpr int rings = 24, sectors = 72;
    list.PushTextureID(texture);
    list.PrimReserve(6 * rings * sectors, (rings + 1) * (sectors + 1));
    const unsigned first = list._VtxCurrentIdx;
    for (int ring = 0; ring <= rings; ++ring) {
        const LensPoint point = sphere_lens(double(ring) / rings);
        for (int sector = 0; sector <= sectors; ++sector) {
            const double angle = 2 * glm::pi<double>() * sector / sectors;
            const glm::dvec2 direction(std::cos(angle), std::sin(angle));
            const float away = half * float(point.radius);
            list.PrimWriteVtx(ImVec2(middle.x + away * float(direction.x), middle.y + away * float(direction.y)),
                              square.coordinates(point.reach * direction), IM_COL32_WHITE);
        }
    }
    for (int ring = 0; ring < rings; ++ring) {
        for (int sector = 0; sector < sectors; ++sector) {
            const auto corner = first + unsigned(ring * (sectors + 1) + sector);
            constexpr unsigned outer = sectors + 1;  // the same corner of the next ring
            for (const unsigned step : {0u, outer, outer + 1, 0u, outer + 1, 1u}) {
                list.PrimWriteIdx(ImDrawIdx(corner + step));
            }
        }
    }
    list.PopTextureID();
}

// The value of the pixel under the mouse, below the lens or where there is no room above it.
void show_value(ImDrawList& list, const Canvas& canvas, int x, int y, float half) {
    const FrameSize size = canvas.size();
    if (x < 0 || y < 0 || x >= size.width || y >= size.height) return;
    const glm::u8vec4 pixel = canvas.pixel(x, y);
    const std::string text = fmt::format("{}, {}   #{:02x}{:02x}{:02x}", x, y, pixel.r, pixel.g, pixel.b);
    const float text_half = 0.5f * ImGui::CalcTextSize(text.c_str()).x;
    const float line = ImGui::GetFontSize(), margin = 0.3f * line, gap = 0.4f * line, height = line + 2 * margin;
    ImVec2 place = ImGui::GetIO().MousePos;
    const bool has_room = place.y + half + gap + height < ImGui::GetIO().DisplaySize.y;
    place.y += has_room ? half + gap : -half - gap - height;
    list.AddRectFilled(ImVec2(place.x - text_half - margin, place.y),
                       ImVec2(place.x + text_half + margin, place.y + height), IM_COL32(20, 22, 26, 230), margin);
    list.AddText(ImVec2(place.x - text_half, place.y + margin), IM_COL32_WHITE, text.c_str());
}

}  // namespace

void Magnifier::zoom(double notches) {
    factor_ = std::clamp(factor_ * std::pow(1.25, notches), least_factor, most_factor);
}

void Magnifier::take_next_shape() { shape_ = shape_ == Shape::sphere ? Shape::round : Shape(int(shape_) + 1); }

void Magnifier::show(const Canvas& canvas, double pixels_a_point) const {
    if (!is_held_ || !ImGui::IsMousePosValid()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    // The middle of the pixel under the mouse lies in the middle of the lens.
    const double x = std::floor(mouse.x * pixels_a_point) + 0.5, y = std::floor(mouse.y * pixels_a_point) + 0.5;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float half = std::min(8 * ImGui::GetFontSize(), 0.35f * std::min(display.x, display.y));
    Square square{{x, y}, double(half) * pixels_a_point / factor_, canvas.size()};
    const ImVec2 corner(mouse.x - half, mouse.y - half), other(mouse.x + half, mouse.y + half);
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float rounding = shape_ == Shape::square ? 0 : half;
    list.AddRectFilled(corner, other, IM_COL32_WHITE, rounding);
    if (shape_ == Shape::sphere) {
        square.half /= middle_reach();
        draw_sphere(list, texture_id(canvas.texture()), mouse, half, square);
    } else {
        list.AddImageRounded(texture_id(canvas.texture()), corner, other, square.coordinates({-1, -1}),
                             square.coordinates({1, 1}), IM_COL32_WHITE, rounding);
    }
    list.AddRect(corner, other, IM_COL32(40, 44, 52, 255), rounding, 0, 0.15f * ImGui::GetFontSize());
    show_value(list, canvas, int(x), int(y), half);
}

}  // namespace croquis::viewer
