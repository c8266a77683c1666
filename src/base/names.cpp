#include "base/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace croquis {
namespace {

// Optimal string alignment distance, in three rows.
std::size_t edits_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), current(b.size() + 1);
    std::iota(previous.begin(), previous.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substitution = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({previous[j] + 1, current[j - 1] + 1, substitution});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
        }
        std::swap(before, previous);
        std::swap(previous, current);
    }
    return previous[b.size()];
}

std::size_t most_edits(std::size_t letters) { return letters <= 3 ? 1 : letters <= 6 ? 2 : letters / 3; }

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
    constexpr std::size_t longest_considered = 200;
    if (name.size() > longest_considered) return {};
    std::string nearest;
    std::size_t fewest = most_edits(name.size()) + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > longest_considered) continue;
        const std::size_t edits = edits_between(name, candidate);
        const bool nothing_in_common = edits >= std::max(name.size(), candidate.size());
        if (edits < fewest && !nothing_in_common) {
            fewest = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
    const std::string nearest = nearest_name(name, candidates);
    return nearest.empty() ? std::string{} : fmt::format("; did you mean \"{}\"?", nearest);
}

bool matches_pattern(std::string_view name, std::string_view pattern) {
    std::size_t n = 0, p = 0;
    std::size_t star = std::string_view::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::string> split(std::string_view text, std::string_view separators) {
    std::vector<std::string> pieces;
    std::size_t begin = text.find_first_not_of(separators);
    while (begin != std::string_view::npos) {
        const std::size_t end = text.find_first_of(separators, begin);
        pieces.emplace_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(separators, end);
    }
    return pieces;
}

}  // namespace croquis
