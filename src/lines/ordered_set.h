// A set of numbers that go in in any order and come out in ascending order.
#pragma once

#include <cstdint>
#include <vector>

namespace croquis::lines {

/// Holds numbers below a bound, a bit each. Taking them out costs what is in the set, and hardly anything of the bound.
class OrderedSet {
public:
    explicit OrderedSet(std::size_t bound) : words_((bound >> 6) + 1), summary_((bound >> 12) + 1) {}

    void add(std::uint32_t number) {
        words_[number >> 6] |= std::uint64_t{1} << (number & 63);
        summary_[number >> 12] |= std::uint64_t{1} << (number >> 6 & 63);
    }
    [[nodiscard]] bool has(std::uint32_t number) const { return (words_[number >> 6] >> (number & 63) & 1) != 0; }

    /// Moves all numbers to `numbers`, in place of what stands there.
    void take(std::vector<std::uint32_t>& numbers);

    void clear();

private:
    std::vector<std::uint64_t> words_;    // a bit a number
    std::vector<std::uint64_t> summary_;  // a bit a word that is not zero
};

}  // namespace croquis::lines
