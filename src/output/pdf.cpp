#include "output/pdf.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <memory>

#include "base/error.h"
#include "output/svg.h"

namespace croquis::output {
namespace {

constexpr double points_per_millimetre = 72.0 / 25.4;

struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

// The same bytes at any time: without a date, cairo would write the clock's.
constexpr const char* no_date = "2000-01-01T00:00:00Z";

void apply(cairo_t* cairo, const Ink& ink) {
    cairo_set_source_rgba(cairo, double(ink.color.x), double(ink.color.y), double(ink.color.z), double(ink.color.w));
    cairo_set_line_width(cairo, ink.width);
    cairo_set_line_cap(cairo, ink.round_ends ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
}

void lay(cairo_t* cairo, const Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
        (i == 0 ? cairo_move_to : cairo_line_to)(cairo, ring.points[i].x, ring.points[i].y);
    }
    if (ring.closed) cairo_close_path(cairo);
}

void lay(cairo_t* cairo, const Curve& curve) {
    cairo_move_to(cairo, curve.start.x, curve.start.y);
    for (const CurvePiece& piece : curve.pieces) {
        if (piece.kind == CurvePiece::Kind::straight) {
            cairo_line_to(cairo, piece.end.x, piece.end.y);
        } else {
            cairo_curve_to(cairo, piece.leaving.x, piece.leaving.y, piece.arriving.x, piece.arriving.y, piece.end.x,
                           piece.end.y);
        }
    }
    if (curve.closed) cairo_close_path(cairo);
}

void draw(cairo_t* cairo, const VectorPath& path, const Ink& ink) {
    apply(cairo, ink);
    for (const Ring& ring : path.rings) lay(cairo, ring);
    for (const Curve& curve : path.curves) lay(cairo, curve);
    if (ink.kind == Ink::Kind::fill) {
        cairo_fill(cairo);
    } else {
        cairo_stroke(cairo);
    }
}

void draw(cairo_t* cairo, const VectorText& text) {
    cairo_set_font_size(cairo, text.height);
    const std::string clean = clean_text(text.text);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, clean.c_str(), &extents);
    cairo_move_to(cairo, text.place.x - 0.5 * extents.x_advance, text.place.y);
    cairo_show_text(cairo, clean.c_str());
}

void draw(cairo_t* cairo, const VectorGroup& group, const Ink& outer) {
    const Ink ink = group.ink.value_or(outer);
    for (const VectorPath& path : group.paths) draw(cairo, path, path.ink.value_or(ink));
    apply(cairo, ink);
    for (const VectorText& text : group.texts) draw(cairo, text);
    for (const VectorGroup& inner : group.groups) draw(cairo, inner, ink);
}

}  // namespace

std::string pdf_bytes(const VectorPage& page) {
    std::string bytes;
    const std::unique_ptr<cairo_surface_t, DestroySurface> surface(cairo_pdf_surface_create_for_stream(
        append, &bytes, page.width * points_per_millimetre, page.height * points_per_millimetre));
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, clean_text(page.title).c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_SUBJECT, clean_text(page.description).c_str());
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, no_date);
    {
        const std::unique_ptr<cairo_t, DestroyContext> cairo(cairo_create(surface.get()));
        cairo_scale(cairo.get(), points_per_millimetre, points_per_millimetre);
        cairo_set_line_join(cairo.get(), CAIRO_LINE_JOIN_ROUND);
        cairo_set_fill_rule(cairo.get(), CAIRO_FILL_RULE_WINDING);
        cairo_select_font_face(cairo.get(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
        for (const VectorGroup& group : page.groups) draw(cairo.get(), group, Ink{});
    }
    cairo_surface_finish(surface.get());
    const cairo_status_t status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS) fail("cannot write PDF: {}", cairo_status_to_string(status));
    return bytes;
}

}  // namespace croquis::output
