// What stands behind the public handles.
#pragma once

#include <utility>

#include "croquis/renderer.h"
#include "framework/technique.h"
#include "gpu/context.h"

namespace croquis {

struct Technique::Opened {
    template <typename... Parts>
    explicit Opened(gpu::Context& made_in, Parts&&... parts)
        : context(made_in), technique(std::forward<Parts>(parts)...) {}
    ~Opened() { context.make_current(); }  // what the technique frees is this context's
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    gpu::Context& context;
    framework::Technique technique;
};

}  // namespace croquis
