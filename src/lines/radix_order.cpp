#include "lines/radix_order.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/parallel.h"

namespace croquis::lines {
namespace {

constexpr int digit_bits = 11;
constexpr std::uint32_t digit_count = 1u << digit_bits;
constexpr std::size_t most_pieces = 16;
constexpr std::size_t items_a_piece = 65536;

using Counts = std::array<std::uint32_t, digit_count>;

}  // namespace

// Least significant digit first. Each piece of the input counts its digits, and then knows where its items go.
void radix_sort(std::vector<KeyedNumber>& items) {
    const std::size_t pieces = std::clamp<std::size_t>(items.size() / items_a_piece, 1, most_pieces);
    const auto start_of = [&](std::size_t piece) { return items.size() * piece / pieces; };
    std::vector<KeyedNumber> sorted(items.size());
    std::vector<Counts> places(pieces);
    for (int shift = 0; shift < 32; shift += digit_bits) {
        const auto digit = [shift](const KeyedNumber& item) { return item.key >> shift & (digit_count - 1); };
        parallel_for(pieces, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end; ++piece) {
                places[piece].fill(0);
                for (std::size_t i = start_of(piece); i < start_of(piece + 1); ++i) ++places[piece][digit(items[i])];
            }
        });
        std::uint32_t next = 0;
        for (std::uint32_t d = 0; d < digit_count; ++d) {
            for (Counts& counts : places) next += std::exchange(counts[d], next);
        }
        parallel_for(pieces, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end; ++piece) {
                for (std::size_t i = start_of(piece); i < start_of(piece + 1); ++i) {
                    sorted[places[piece][digit(items[i])]++] = items[i];
                }
            }
        });
        items.swap(sorted);
    }
}

}  // namespace croquis::lines
