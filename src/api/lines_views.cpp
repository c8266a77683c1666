// Sheets of several views: parallel projections of one scale, side by side in the first or third angle (ISO 128-30).
#include "api/lines_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "api/view_request.h"
#include "base/error.h"

namespace croquis {
namespace {

// Where a view stands from the front view: columns to the right, rows down, in the third angle.
struct Place {
    const char* name;
    int column;
    int row;
};
constexpr std::array<Place, 7> places{{{"front", 0, 0},
                                       {"right", 1, 0},
                                       {"left", -1, 0},
                                       {"back", 2, 0},
                                       {"top", 0, -1},
                                       {"bottom", 0, 1},
                                       {"iso", 1, -1}}};

Place place_of(const std::string& name, LineOptions::Arrangement arrangement) {
    (void)model::named_view(name);  // throws where there is none of the name
    Place place = *std::find_if(places.begin(), places.end(), [&](const Place& one) { return one.name == name; });
    if (arrangement == LineOptions::Arrangement::third_angle) return place;
    // In the first angle views stand on the other side; "back" stays at the end of the row, "iso" in a free corner.
    if (name == "right" || name == "left") place.column = -place.column;
    place.row = -place.row;
    return place;
}

struct Cell {
    std::string name;
    Place place;
    lines::Viewpoint viewpoint;
    glm::dvec2 size{0.0};  // of the model in this view, scene units
};

// The viewpoint's axes alone; its frame and scale are set when all sizes are known.
Cell cell_of(const lines::Surface& surface, const model::Pose* pose, const std::string& name,
             LineOptions::Arrangement arrangement) {
    Cell cell;
    cell.name = name;
    cell.place = place_of(name, arrangement);
    model::ViewRequest request;
    request.direction = model::named_view(name);
    request.projection = model::Projection::parallel;
    cell.viewpoint = lines::Viewpoint::of(model::place_camera(surface.model(), pose, request, 1.0), 1.0, 1.0);
    for (std::uint32_t v = 0; v < surface.vertex_count(); ++v) {
        const glm::dvec3 point = surface.point(v);
        const glm::dvec2 extent(std::abs(glm::dot(point, cell.viewpoint.right)),
                                std::abs(glm::dot(point, cell.viewpoint.up)));
        cell.size = glm::max(cell.size, 2.0 * extent);
    }
    return cell;
}

// Columns or rows in their order, each as wide as its widest view.
using Tracks = std::map<int, double>;

double sum_of(const Tracks& tracks) {
    double sum = 0;
    for (const auto& [number, size] : tracks) sum += size;
    return sum;
}

// Pixels from the sheet's edge to the middle of a track.
double middle_of(const Tracks& tracks, int number, double scale, double room, double total) {
    double at = 0.5 * (total - (sum_of(tracks) * scale + room * double(tracks.size())));
    for (const auto& [other, size] : tracks) {
        if (other == number) return at + 0.5 * size * scale + 0.5 * room;
        at += size * scale + room;
    }
    return at;
}

std::vector<PlacedView> arrange(std::vector<Cell> cells, double width, double height) {
    Tracks columns, rows;
    for (const Cell& cell : cells) {
        columns[cell.place.column] = std::max(columns[cell.place.column], cell.size.x);
        rows[cell.place.row] = std::max(rows[cell.place.row], cell.size.y);
    }
    const double shorter = std::min(width, height);
    const double gap = 0.08 * shorter, label = std::min(13.0, 0.03 * shorter);
    const double scale = std::min((width - gap * double(columns.size())) / std::max(sum_of(columns), 1e-9),
                                  (height - gap * double(rows.size())) / std::max(sum_of(rows), 1e-9));
    std::vector<PlacedView> views;
    for (Cell& cell : cells) {
        PlacedView view;
        view.name = cell.name;
        view.viewpoint = cell.viewpoint;
        view.viewpoint.scale = scale;
        view.viewpoint.width = cell.size.x * scale + 0.5 * gap;
        view.viewpoint.height = cell.size.y * scale + 0.5 * gap;
        const glm::dvec2 middle(middle_of(columns, cell.place.column, scale, gap, width),
                                middle_of(rows, cell.place.row, scale, gap, height));
        view.corner = middle - 0.5 * glm::dvec2(view.viewpoint.width, view.viewpoint.height);
        view.label_height = label;
        view.label_place = middle + glm::dvec2(0.0, 0.5 * cell.size.y * scale + 0.3 * gap + 0.3 * label);
        views.push_back(std::move(view));
    }
    return views;
}

}  // namespace

std::vector<PlacedView> place_views(const lines::Surface& surface, const model::Pose* pose,
                                    const LineOptions& options) {
    const double width = options.width, height = options.height;
    if (options.views.empty()) {
        const model::Camera camera =
            model::place_camera(surface.model(), pose, view_request(options.view), width / height);
        return {{"", lines::Viewpoint::of(camera, width, height), glm::dvec2(0.0), glm::dvec2(0.0), 0}};
    }
    std::set<std::string> named;
    std::vector<Cell> cells;
    for (const std::string& name : options.views) {
        cells.push_back(cell_of(surface, pose, name, options.arrangement));
        if (!named.insert(name).second) fail("expected each view once on a sheet, found \"{}\" twice", name);
    }
    return arrange(std::move(cells), width, height);
}

}  // namespace croquis
