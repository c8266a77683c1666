// Random bytes as an MD2 model: parsed and finished, or refused with an Error; nothing else may happen.
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/error.h"
#include "model/load.h"
#include "model/md2.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        const auto model = croquis::model::finish(
            croquis::model::read_md2(std::as_bytes(std::span(bytes, size)), "fuzz.md2"), "fuzz.md2");
        for (const auto& clip : model->clips) static_cast<void>(croquis::model::pose_at(*model, clip, 0.05));
    } catch (const croquis::Error&) {
        return 0;  // refused, as it should be
    }
    return 0;
}
