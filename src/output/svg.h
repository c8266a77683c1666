// SVG files: SVG 1.1, in millimetres, every group named.
#pragma once

#include <string>

#include "output/vector_page.h"

namespace croquis::output {

/// The page as the text of an SVG 1.1 file, valid against its DTD (docs/lines-format.md has its structure).
[[nodiscard]] std::string svg_text(const VectorPage& page);

/// `text` as UTF-8 that every reader takes: what is none, or no character that XML allows, is replaced by U+FFFD.
[[nodiscard]] std::string clean_text(std::string_view text);

/// The same as the content of an XML element or attribute: markup escaped.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace croquis::output
