// The readers behind `load`, and what they share. Each returns what its file says; `finish` checks and completes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "model/load.h"

namespace croquis::model {

constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

[[nodiscard]] RawModel read_obj(const std::filesystem::path& path, const Progress& progress);
[[nodiscard]] RawModel read_md2(const std::filesystem::path& path, const Progress& progress);
[[nodiscard]] RawModel read_ply(const std::filesystem::path& path, const Progress& progress);
[[nodiscard]] RawModel read_vrml(const std::filesystem::path& path, const Progress& progress);
[[nodiscard]] RawModel read_through_assimp(const std::filesystem::path& path, const Progress& progress);

/// Where a model's origin should be moved to: its centre where 32-bit positions would lose its detail (more than 16
/// radii away), else zero.
[[nodiscard]] glm::dvec3 suitable_origin(const glm::dvec3& low, const glm::dvec3& high);

/// The material of faces that name none.
[[nodiscard]] Material plain_material();

/// The ambient colour for a material that gives none, or one brighter than its diffuse colour: exporters write 1 1 1
/// where they mean "all of the diffuse colour", which would wash every shade out.
[[nodiscard]] glm::vec3 sensible_ambient(const glm::vec3& ambient, const glm::vec3& diffuse);
[[nodiscard]] glm::vec3 default_ambient(const glm::vec3& diffuse);

/// The exponent a renderer can use: 32 for one below 1, which files write where they mean none.
[[nodiscard]] float sensible_shininess(float shininess);

/// Fails for a text that nests brackets deeper than a recursive parser can follow. Brackets within quotation marks do
/// not count.
void check_nesting(std::string_view text, const std::string& name);

/// Fails for a mesh file of lines and points (`found_other`), or of nothing at all.
[[noreturn]] void fail_without_triangles(const std::string& name, bool found_other);

}  // namespace croquis::model
