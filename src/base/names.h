// Finding names: the nearest one to a typo, and patterns with wildcards.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace croquis {

/// The candidate fewest edits away from `name` (insertions, deletions, substitutions and swaps of neighbours), or
/// nothing when even that one is too far to be a likely typo: more than 1 edit for names of up to 3 letters, 2 for up
/// to 6, a third of the letters for longer ones.
[[nodiscard]] std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// `; did you mean "nearest"?`, or nothing: the tail of an error about an unknown name.
[[nodiscard]] std::string suggestion(std::string_view name, std::span<const std::string> candidates);

/// True when `name` matches `pattern`, in which `*` stands for any letters and `?` for any one. Letter case counts.
[[nodiscard]] bool matches_pattern(std::string_view name, std::string_view pattern);

/// `text` cut at every run of any of `separators`; no empty pieces.
[[nodiscard]] std::vector<std::string> split(std::string_view text, std::string_view separators);

}  // namespace croquis
