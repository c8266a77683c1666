// We write SVG ourselves, for cairo's has neither groups nor names.
#include "output/svg.h"

#include <fmt/format.h>

#include <cmath>

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
        text_ += "\"/>\n";
    }

    void write(const Ring& ring) {
        for (std::size_t i = 0; i < ring.points.size(); ++i) {
            text_ += i == 0 ? 'M' : i == 1 ? 'L' : ' ';
            append_number(text_, ring.points[i].x);
            text_ += ' ';
            append_number(text_, ring.points[i].y);
        }
        if (ring.closed) text_ += 'Z';
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
