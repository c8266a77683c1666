// Hidden-line removal that keeps whatever the frame holds: surfaces fill the depth alone, then lines, or the strokes on
// the surfaces, are drawn at less or equal depth (seed A, 2.3.2).
#pragma once

#include <memory>

#include "framework/render_context.h"

namespace croquis::components {

class Occluder {
public:
    explicit Occluder(framework::Resources& resources)
        : program_(resources.program("occluder:transform_occluder", "occluder:nothing")) {}

    struct Options {
        float push_back = 0;  ///< gpu::DrawState's
        /// Each mesh is drawn so large about its middle: below 1, lines that were moved off the surface are kept.
        float scale = 1;
        float inset = 0;  ///< scene units by which the surface is drawn in along its normals, for the same
        /// That of the draws to come: another order of vertices rounds to another depth.
        framework::SurfaceKind kind = framework::SurfaceKind::smooth;
    };

    /// Draws the selected surfaces into the depth of the bound frame, and marks them as surfaces.
    void fill_depth(framework::RenderContext& context, const framework::ObjectSelection& selection,
                    const Options& options) const {
        program_->use();
        context.apply(*program_);
        program_->set("occluder_inset", options.inset);
        context.scene.draw_surfaces(
            selection, *program_,
            {.depth_test = gpu::DepthTest::nearer,
             .write_depth = true,
             .write_color = false,
             .push_back = options.push_back,
             .stencil = gpu::Stencil::mark_surface},
            {.eye_is_outside = context.eye_is_outside(), .scale = options.scale, .kind = options.kind});
    }

private:
    std::shared_ptr<const gpu::Program> program_;
};

}  // namespace croquis::components
