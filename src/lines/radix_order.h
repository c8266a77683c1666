// Sorting numbers by keys in time proportional to how many there are.
#pragma once

#include <cstdint>
#include <vector>

namespace croquis::lines {

/// A number and what to sort it by.
struct KeyedNumber {
    std::uint32_t key = 0;
    std::uint32_t number = 0;
};

/// Sorts by key; equal keys keep their order. Uses all cores; the result does not depend on how many.
void radix_sort(std::vector<KeyedNumber>& items);

}  // namespace croquis::lines
