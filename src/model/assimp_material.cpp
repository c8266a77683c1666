#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/log.h"
#include "model/assimp_scene.h"
#include "model/readers.h"

namespace croquis::model {
namespace {

glm::vec3 clamped(const aiColor4D& color) {
    const auto channel = [](float value) { return std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f; };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

std::shared_ptr<const image::Image> embedded_image(const aiTexture& texture, const std::string& name) {
    if (texture.mHeight == 0) {  // a whole image file; the width is its size
        const auto bytes = std::as_bytes(std::span(reinterpret_cast<const char*>(texture.pcData), texture.mWidth));
        return std::make_shared<const image::Image>(image::decode(bytes, name));
    }
    if (texture.mWidth > unsigned(image::longest_side) || texture.mHeight > unsigned(image::longest_side))
        return nullptr;
    auto image = std::make_shared<image::Image>(int(texture.mWidth), int(texture.mHeight));
    for (std::size_t i = 0; i < image->pixels().size(); ++i) {
        const aiTexel& texel = texture.pcData[i];
        image->pixels()[i] = {texel.r, texel.g, texel.b, texel.a};
    }
    return image;
}

void attach_texture(const std::string& texture_name, const aiScene& scene, const std::string& name,
                    TextureFinder& textures, Material& material) {
    const aiTexture* const embedded = scene.GetEmbeddedTexture(texture_name.c_str());
    if (embedded == nullptr) return textures.attach(material, texture_name);
    try {
        material.texture_name = name + ":" + texture_name;
        material.texture = embedded_image(*embedded, material.texture_name);
    } catch (const Error& error) {
        warn("{}; drawn without it", error.what());
    }
    if (!material.texture) material.texture_name.clear();
}

void read_gloss(const aiMaterial& given, Material& material) {
    float roughness = 0;
    aiColor4D color;
    if (given.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) == aiReturn_SUCCESS && std::isfinite(roughness)) {
        roughness = std::clamp(roughness, 0.0f, 1.0f);
        material.specular = glm::vec3(0.5f * (1.0f - roughness));
        material.shininess = sensible_shininess(2.0f / std::max(std::pow(roughness, 4.0f), 1e-6f) - 2.0f);
        return;
    }
    material.specular =
        given.Get(AI_MATKEY_COLOR_SPECULAR, color) == aiReturn_SUCCESS ? clamped(color) : glm::vec3(0.0f);
    float strength = 1, shininess = 0;
    if (given.Get(AI_MATKEY_SHININESS_STRENGTH, strength) == aiReturn_SUCCESS && std::isfinite(strength)) {
        material.specular *= std::clamp(strength, 0.0f, 1.0f);
    }
    given.Get(AI_MATKEY_SHININESS, shininess);
    material.shininess = sensible_shininess(std::isfinite(shininess) ? shininess : 0.0f);
}

}  // namespace

Material read_material(const aiMaterial& given, const aiScene& scene, const std::string& ending,
                       const std::string& name, TextureFinder& textures) {
    if (ending == ".stl" || ending == ".off") return plain_material();  // formats without materials: Assimp invents one
    Material material;
    material.name = given.GetName().C_Str();
    aiColor4D color;
    if (given.Get(AI_MATKEY_BASE_COLOR, color) == aiReturn_SUCCESS ||
        given.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS) {
        material.diffuse = clamped(color);
    }
    read_gloss(given, material);
    aiString texture;
    if (given.GetTexture(aiTextureType_BASE_COLOR, 0, &texture) == aiReturn_SUCCESS ||
        given.GetTexture(aiTextureType_DIFFUSE, 0, &texture) == aiReturn_SUCCESS) {
        attach_texture(texture.C_Str(), scene, name, textures, material);
        if (material.texture && material.diffuse == glm::vec3(0.0f)) material.diffuse = glm::vec3(1.0f);
    }
    const bool has_ambient = given.Get(AI_MATKEY_COLOR_AMBIENT, color) == aiReturn_SUCCESS;
    material.ambient =
        has_ambient ? sensible_ambient(clamped(color), material.diffuse) : default_ambient(material.diffuse);
    float opacity = 1;
    if (given.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && std::isfinite(opacity)) {
        material.opacity = std::clamp(opacity, 0.0f, 1.0f);
    }
    return material;
}

}  // namespace croquis::model
