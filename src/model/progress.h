// How far reading a model has come, told while it goes on; and ending it when nobody wants it any more.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "base/parallel.h"

namespace croquis::model {

/// A stretch of a long piece of work, from one share of the whole to another. One that was made from nothing tells
/// nobody. Stretches are told in their order and on one thread.
class Progress {
public:
    /// Is given the share of the whole that is done. Where it returns false the work ends.
    using Listener = std::function<bool(double)>;

    Progress() = default;
    /// All of the work on what `name` says.
    Progress(std::string name, Listener listener);

    /// A part of this stretch, by shares of it.
    [[nodiscard]] Progress part(double from, double to) const;

    /// So much of this stretch is done. Throws Error, "NAME: cancelled", where the work is to end.
    void reach(double share) const;

private:
    struct Work {
        std::string name;
        Listener listener;
        bool is_cancelled = false;
    };
    std::shared_ptr<Work> work_;
    double from_ = 0, to_ = 1;
};

/// Tells of a loop now and then, at `i` of `count`: a few times a millisecond would be too often.
inline void reach_now_and_then(const Progress& progress, std::size_t i, std::size_t count) {
    constexpr std::size_t between = 1 << 16;
    if (i % between == 0) progress.reach(double(i) / double(count));
}

/// parallel_for in slices; after each of them progress is told on the thread that calls.
template <typename Body>
void parallel_for_in_slices(std::size_t count, std::size_t grain, const Progress& progress, const Body& body) {
    constexpr std::size_t slice = 1 << 18;
    for (std::size_t first = 0; first < count; first += slice) {
        const std::size_t size = std::min(slice, count - first);
        parallel_for(size, grain, [&](std::size_t begin, std::size_t end) { body(first + begin, first + end); });
        progress.reach(double(first + size) / double(count));
    }
}

}  // namespace croquis::model
