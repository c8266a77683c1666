// Welding by a hash table with open addressing. On a large model every look into the table misses the cache, so that
// slots are asked for some points ahead, and a slot tells by 32 bits of the hash whether a look at its point is due.
#include "model/welding.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "base/error.h"

namespace croquis::model {
namespace {

constexpr std::uint32_t no_point = 0xffffffffu;

std::uint64_t hash_of(const glm::vec3& point) {
    std::uint32_t words[3];
    std::memcpy(words, &point, sizeof words);
    std::uint64_t hash = (std::uint64_t{words[0]} << 32 | words[1]) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
    hash = (hash + words[2]) * 0xbf58476d1ce4e5b9ull;
    return hash ^ hash >> 32;
}

bool same_bits(const glm::vec3& a, const glm::vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// The points seen so far, by their hash.
class Table {
public:
    explicit Table(std::size_t point_count) : slots_(std::bit_ceil(point_count + point_count / 2 + 2)) {}

    void fetch(std::uint64_t hash) const { __builtin_prefetch(&slots_[first_slot(hash)]); }

    /// The number of a point; a new one is added to `positions`.
    [[nodiscard]] std::uint32_t number_of(const glm::vec3& point, std::uint64_t hash,
                                          std::vector<glm::vec3>& positions) {
        const auto tag = static_cast<std::uint32_t>(hash >> 32);
        std::size_t s = first_slot(hash);
        for (; slots_[s].point != no_point; s = (s + 1) & (slots_.size() - 1)) {
            if (slots_[s].tag == tag && same_bits(positions[slots_[s].point], point)) return slots_[s].point;
        }
        slots_[s] = {tag, static_cast<std::uint32_t>(positions.size())};
        positions.push_back(point);
        return slots_[s].point;
    }

private:
    struct Slot {
        std::uint32_t tag = 0;
        std::uint32_t point = no_point;
    };

    [[nodiscard]] std::size_t first_slot(std::uint64_t hash) const { return hash & (slots_.size() - 1); }

    std::vector<Slot> slots_;
};

void add_list(std::span<const glm::vec3> list, Table& table, WeldedPoints& welded, const Progress& progress) {
    constexpr std::size_t ahead = 32;
    std::array<std::uint64_t, ahead> hashes;
    for (std::size_t begin = 0; begin < list.size(); begin += ahead) {
        reach_now_and_then(progress, begin, list.size());
        const auto batch = list.subspan(begin, std::min(ahead, list.size() - begin));
        for (std::size_t i = 0; i < batch.size(); ++i) {
            hashes[i] = hash_of(batch[i] + 0.0f);  // turns -0 into 0
            table.fetch(hashes[i]);
        }
        for (std::size_t i = 0; i < batch.size(); ++i) {
            welded.ids.push_back(table.number_of(batch[i] + 0.0f, hashes[i], welded.positions));
        }
    }
}

}  // namespace

WeldedPoints weld_points(std::span<const std::span<const glm::vec3>> lists, const Progress& progress) {
    std::size_t total = 0;
    for (const auto list : lists) total += list.size();
    if (total >= no_point) fail("expected fewer than {} vertices, found {}", no_point, total);
    WeldedPoints welded;
    welded.ids.reserve(total);
    welded.positions.reserve(total);
    Table table(total);
    for (const auto list : lists) {
        const double done = double(welded.ids.size()) / double(total);
        welded.first_of_list.push_back(welded.ids.size());
        add_list(list, table, welded, progress.part(done, done + double(list.size()) / double(total)));
    }
    if (welded.positions.size() < total / 8 * 7) welded.positions.shrink_to_fit();
    return welded;
}

}  // namespace croquis::model
