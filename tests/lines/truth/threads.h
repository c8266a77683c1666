// Work on a number of threads of one's choice, so that it can be shown that the number does not matter.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace croquis::lines::truth {

/// Calls `act` where parallel loops are cut as for so many threads, also for more than the machine has.
template <typename Act>
auto on_threads(int threads, const Act& act) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    return arena.execute(act);
}

}  // namespace croquis::lines::truth
