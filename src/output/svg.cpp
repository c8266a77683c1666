// We write SVG ourselves, for cairo's has neither groups nor names.
#include "output/svg.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace croquis::output {
namespace {

constexpr const char* head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd\"";
// SVG itself has no layers: those of Inkscape, which other programs know too, are declared in the file.
constexpr const char* layer_declarations =
    " [\n"
    "<!ATTLIST svg xmlns:inkscape CDATA #IMPLIED>\n"
    "<!ATTLIST g inkscape:groupmode CDATA #IMPLIED inkscape:label CDATA #IMPLIED>\n"
    "]";
constexpr const char* layer_namespace = " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"";
constexpr const char* replacement = "\xef\xbf\xbd";

// How many bytes the UTF-8 character at `at` has; 0 for none that XML allows.
std::size_t character_size(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned char>(at + i < text.size() ? text[at + i] : 0);
    };
    const unsigned first = byte(0);
    if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
    const std::size_t size = first >= 0xf0 && first < 0xf5   ? 4
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xc2                 ? 2
                                                             : 0;
    if (size == 0 || first >= 0xf5) return 0;
    unsigned code = first & (0x7fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0u) != 0x80u) return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr unsigned smallest[5] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_allowed = code >= smallest[size] && (code < 0xd800 || code > 0xdfff) && code != 0xfffe &&
                            code != 0xffff && code <= 0x10ffff;
    return is_allowed ? size : 0;
}

std::string color_text(const glm::vec4& color) {
    const auto level = [](float channel) {
        return int(std::lround(std::fmin(std::fmax(channel, 0.0f), 1.0f) * 255.0f));
    };
    const int red = level(color.x), green = level(color.y), blue = level(color.z);
    const bool is_short = red % 17 == 0 && green % 17 == 0 && blue % 17 == 0;
    return is_short ? fmt::format("#{:x}{:x}{:x}", red / 17, green / 17, blue / 17)
                    : fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

/// Writes one subpath: points relative to the one before, which is shortest. They are differences of rounded places, so
/// that no error adds up.
class PathData {
public:
    PathData(std::string& text, const glm::dvec2& start) : text_(text) {
        const Place place = place_of(start);
        begin('M');
        append(place);
        pen_ = place;
    }

    void line_to(const glm::dvec2& point) {
        begin('l');
        append(place_of(point));
        pen_ = place_of(point);
    }

    void curve_to(const glm::dvec2& leaving, const glm::dvec2& arriving, const glm::dvec2& point) {
        begin('c');
        for (const glm::dvec2& control : {leaving, arriving, point}) append(place_of(control));
        pen_ = place_of(point);
    }

    void close() { text_ += 'Z'; }

private:
    using Place = std::array<std::int64_t, 2>;  // thousandths of a millimetre

    static Place place_of(const glm::dvec2& point) { return {thousandths(point.x), thousandths(point.y)}; }

    // A letter that repeats is left out.
    void begin(char letter) {
        needs_gap_ = letter == letter_;
        if (!needs_gap_) text_ += letter;
        letter_ = letter;
    }

    void append(const Place& place) {
        for (std::size_t side = 0; side < 2; ++side) {
            const std::int64_t number = place[side] - pen_[side];
            if (number < 0) {
                text_ += '-';
            } else if (needs_gap_) {
                text_ += ' ';
            }
            append_thousandths(text_, static_cast<std::uint64_t>(std::abs(number)));
            needs_gap_ = true;
        }
    }

    std::string& text_;
    Place pen_{0, 0};
    char letter_ = ' ';
    bool needs_gap_ = false;  // before a number without a sign
};

class Writer {
public:
    explicit Writer(const VectorPage& page) : has_layers_(any_layer(page.groups)) {
        text_ += head;
        if (has_layers_) text_ += layer_declarations;
        text_ += ">\n<svg xmlns=\"http://www.w3.org/2000/svg\"";
        if (has_layers_) text_ += layer_namespace;
        const std::string width = number_text(page.width), height = number_text(page.height);
        text_ +=
            fmt::format(" version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n", width, height);
        text_ += fmt::format("<title>{}</title>\n<desc>{}</desc>\n", xml_text(page.title), xml_text(page.description));
        for (const VectorGroup& group : page.groups) write(group);
        text_ += "</svg>\n";
    }

    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    static bool any_layer(const std::vector<VectorGroup>& groups) {
        for (const VectorGroup& group : groups) {
            if (!group.layer.empty() || any_layer(group.groups)) return true;
        }
        return false;
    }

    void write(const VectorGroup& group) {
        if (group.empty()) return;
        text_ += fmt::format("<g id=\"{}\"", group.id);
        if (!group.layer.empty()) {
            text_ += fmt::format(" inkscape:groupmode=\"layer\" inkscape:label=\"{}\"", xml_text(group.layer));
        }
        if (group.ink) write(*group.ink);
        text_ += ">\n";
        if (!group.title.empty()) text_ += fmt::format("<title>{}</title>\n", xml_text(group.title));
        for (const VectorPath& path : group.paths) write(path);
        for (const VectorText& text : group.texts) write(text);
        for (const VectorGroup& inner : group.groups) write(inner);
        text_ += "</g>\n";
    }

    void write(const Ink& ink) {
        const std::string color = color_text(ink.color);
        const bool is_fill = ink.kind == Ink::Kind::fill;
        if (is_fill) {
            text_ += fmt::format(" fill=\"{}\" stroke=\"none\"", color);
        } else {
            text_ += fmt::format(" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"{}\"", color,
                                 number_text(ink.width), ink.round_ends ? "round" : "butt");
            text_ += " stroke-linejoin=\"round\"";
        }
        if (ink.color.w < 1.0f) {
            text_ += fmt::format(" {}-opacity=\"{}\"", is_fill ? "fill" : "stroke", number_text(double(ink.color.w)));
        }
    }

    void write(const VectorPath& path) {
        text_ += "<path";
        if (path.ink) write(*path.ink);
        text_ += " d=\"";
        for (const Ring& ring : path.rings) write(ring);
        for (const Curve& curve : path.curves) write(curve);
        text_ += "\"/>\n";
    }

    void write(const Ring& ring) {
        PathData data(text_, ring.points.front());
        for (std::size_t i = 1; i < ring.points.size(); ++i) data.line_to(ring.points[i]);
        if (ring.closed) data.close();
    }

    void write(const Curve& curve) {
        PathData data(text_, curve.start);
        for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
            const CurvePiece& piece = curve.pieces[i];
            const bool is_last = i + 1 == curve.pieces.size();
            if (piece.kind == CurvePiece::Kind::cubic) {
                data.curve_to(piece.leaving, piece.arriving, piece.end);
            } else if (!(is_last && curve.closed)) {
                data.line_to(piece.end);
            }
        }
        if (curve.closed) data.close();
    }

    void write(const VectorText& text) {
        text_ +=
            fmt::format("<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\" text-anchor=\"middle\"",
                        number_text(text.place.x), number_text(text.place.y), number_text(text.height));
        text_ += fmt::format(">{}</text>\n", xml_text(text.text));
    }

    bool has_layers_;
    std::string text_;
};

}  // namespace

std::string clean_text(std::string_view text) {
    std::string clean;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = character_size(text, i);
        clean.append(size == 0 ? std::string_view(replacement) : text.substr(i, size));
        i += size == 0 ? 1 : size;
    }
    return clean;
}

std::string xml_text(std::string_view text) {
    std::string escaped;
    for (const char c : clean_text(text)) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string svg_text(const VectorPage& page) { return Writer(page).take(); }

}  // namespace croquis::output
