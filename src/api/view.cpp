#include "croquis/view.h"

#include "model/camera.h"

namespace croquis {

View View::named(const std::string& name) {
    const glm::dvec3 direction = model::named_view(name);
    View view;
    view.direction = {direction.x, direction.y, direction.z};
    return view;
}

}  // namespace croquis
