// PDF files, through cairo.
#pragma once

#include <string>

#include "output/vector_page.h"

namespace croquis::output {

/// The page as the bytes of a PDF file: one page of its physical size, all of it vectors. Groups' names are left out,
/// for cairo writes no layers. Throws Error.
[[nodiscard]] std::string pdf_bytes(const VectorPage& page);

}  // namespace croquis::output
