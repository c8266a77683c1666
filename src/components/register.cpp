#include "components/register.h"

namespace croquis::components {

// clang-format off

// CORE_COMPONENT(name) registers the class that name.cpp makes in its function make_name.
#define CORE_COMPONENT(name)                                                           \
    {#name, [](const framework::Pass& pass) {                                          \
         std::unique_ptr<framework::Component> make_##name(const framework::Pass&);    \
         return make_##name(pass);                                                     \
     }}

framework::ComponentTable core_components() {
    return {
        CORE_COMPONENT(background),
        CORE_COMPONENT(copy_to_texture),
        CORE_COMPONENT(edge_detect),
        CORE_COMPONENT(generate_texture),
        CORE_COMPONENT(hatch),
        CORE_COMPONENT(lines),
        CORE_COMPONENT(outline),
        CORE_COMPONENT(overlay),
        CORE_COMPONENT(ping_pong),
        CORE_COMPONENT(process_texture),
        CORE_COMPONENT(render_attributes),
        CORE_COMPONENT(simple_render),
        CORE_COMPONENT(wireframe),
    };
}

#undef CORE_COMPONENT

// clang-format on

}  // namespace croquis::components
