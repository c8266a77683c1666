// Welding by a hash table with open addressing: one probe for most points, four bytes a slot.
#include "model/welding.h"

#include <bit>
#include <cstring>

#include "base/error.h"

namespace croquis::model {
namespace {

constexpr std::uint32_t empty_slot = 0xffffffffu;

std::uint64_t hash_of(const glm::vec3& point) {
    std::uint32_t words[3];
    std::memcpy(words, &point, sizeof words);
    std::uint64_t hash = (std::uint64_t{words[0]} << 32 | words[1]) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
    hash = (hash + words[2]) * 0xbf58476d1ce4e5b9ull;
    return hash ^ hash >> 32;
}

bool same_bits(const glm::vec3& a, const glm::vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

WeldedPoints weld_points(std::span<const std::span<const glm::vec3>> lists) {
    std::size_t total = 0;
    for (const auto list : lists) total += list.size();
    if (total >= empty_slot) fail("expected fewer than {} vertices, found {}", empty_slot, total);
    std::vector<std::uint32_t> slots(std::bit_ceil(total + total / 2 + 2), empty_slot);
    const std::size_t mask = slots.size() - 1;
    WeldedPoints welded;
    welded.ids.reserve(total);
    for (const auto list : lists) {
        welded.first_of_list.push_back(welded.ids.size());
        for (const glm::vec3& given : list) {
            const glm::vec3 point = given + 0.0f;  // turns -0 into 0
            std::size_t slot = hash_of(point) & mask;
            while (slots[slot] != empty_slot && !same_bits(welded.positions[slots[slot]], point)) {
                slot = (slot + 1) & mask;
            }
            if (slots[slot] == empty_slot) {
                slots[slot] = static_cast<std::uint32_t>(welded.positions.size());
                welded.positions.push_back(point);
            }
            welded.ids.push_back(slots[slot]);
        }
    }
    return welded;
}

}  // namespace croquis::model
