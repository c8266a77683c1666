// Finding and reading the images that materials name.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "model/model.h"

namespace croquis::model {

/// Reads an image: what image::read knows, and PCX. Throws Error.
[[nodiscard]] image::Image read_texture(const std::filesystem::path& path);

/// Reads PCX with 8 bits a pixel and a palette, or three planes of 8 bits. Throws Error.
[[nodiscard]] image::Image decode_pcx(std::span<const std::byte> bytes, const std::string& name);

/// The textures of one model file: each image is read once. What is missing or damaged warns and leaves none.
class TextureFinder {
public:
    explicit TextureFinder(const std::filesystem::path& model_file);

    /// Gives a material the image of that name.
    ///
    /// A name is looked up beside the model's file; letter case, backslashes and folders that are not there are
    /// forgiven, so that an absolute path of another machine falls back to its last part beside the model.
    void attach(Material& material, const std::string& name);

    /// The file that a name stands for; empty when there is none.
    [[nodiscard]] std::filesystem::path find(const std::string& name) const;

private:
    std::string model_name_;
    std::filesystem::path folder_;
    std::map<std::filesystem::path, std::shared_ptr<const image::Image>> images_;
};

}  // namespace croquis::model
