#include "lines/ordered_set.h"

namespace croquis::lines {
namespace {

/// Calls `visit` with the place of each bit that is set, counted from `first`.
template <typename Visit>
void for_each_bit(std::uint64_t bits, std::size_t first, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(first + static_cast<std::size_t>(__builtin_ctzll(bits)));
}

}  // namespace

void OrderedSet::take(std::vector<std::uint32_t>& numbers) {
    numbers.clear();
    for (std::size_t s = 0; s < summary_.size(); ++s) {
        for_each_bit(summary_[s], s << 6, [&](std::size_t w) {
            for_each_bit(words_[w], w << 6,
                         [&](std::size_t number) { numbers.push_back(static_cast<std::uint32_t>(number)); });
        });
    }
    clear();
}

void OrderedSet::clear() {
    for (std::size_t s = 0; s < summary_.size(); ++s) {
        for_each_bit(summary_[s], s << 6, [&](std::size_t w) { words_[w] = 0; });
        summary_[s] = 0;
    }
}

}  // namespace croquis::lines
