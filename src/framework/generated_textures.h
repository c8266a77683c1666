// The textures that a technique's passes make and read: the directory `<generated>`.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gpu/texture.h"

namespace croquis::framework {

/// One technique's generated textures. A component declares what it makes when it is constructed; whoever reads it
/// finds it under its name, in whatever order they run.
class GeneratedTextures {
public:
    explicit GeneratedTextures(gpu::Context& context) : context_(&context) {}

    /// The texture of that name, made now if this is the first to declare it; one pixel large until its maker sizes it.
    /// Throws Error when it was declared with another format.
    std::shared_ptr<gpu::Texture> declare(const std::string& name, gpu::TextureFormat format);

    /// Throws Error with the nearest name.
    [[nodiscard]] std::shared_ptr<const gpu::Texture> at(const std::string& name) const;

private:
    gpu::Context* context_;
    std::map<std::string, std::shared_ptr<gpu::Texture>> textures_;
};

}  // namespace croquis::framework
