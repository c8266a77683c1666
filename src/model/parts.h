// Which faces hang together.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.h"

namespace croquis::model {

/// The connected parts of surfaces: faces joined at their edges. Union-find that several threads may share: a part is
/// named by its first face whatever the order of joins, since roots only ever give way to smaller ones.
class Parts {
public:
    explicit Parts(std::size_t face_count) : parent_(face_count) {
        parallel_for(face_count, 8192, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f)
                parent_[f].store(static_cast<std::uint32_t>(f), std::memory_order_relaxed);
        });
    }

    void join(std::uint32_t a, std::uint32_t b) {
        if (parent_[a].load(std::memory_order_relaxed) == parent_[b].load(std::memory_order_relaxed)) return;
        for (;;) {
            a = first_face(a);
            b = first_face(b);
            if (a == b) return;
            std::uint32_t larger = std::max(a, b);
            if (parent_[larger].compare_exchange_strong(larger, std::min(a, b), std::memory_order_relaxed)) return;
        }
    }

    /// The first face of the part that holds `face`: what names the part.
    [[nodiscard]] std::uint32_t first_face(std::uint32_t face) {
        std::uint32_t parent = parent_[face].load(std::memory_order_relaxed);
        while (parent != face) {
            const std::uint32_t next = parent_[parent].load(std::memory_order_relaxed);
            if (next != parent) parent_[face].store(next, std::memory_order_relaxed);  // halves the path
            face = next;
            parent = parent_[face].load(std::memory_order_relaxed);
        }
        return face;
    }

private:
    std::vector<std::atomic<std::uint32_t>> parent_;
};

}  // namespace croquis::model
