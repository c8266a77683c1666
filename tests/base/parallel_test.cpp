// The parallel loop covers each item once, whatever the grain.
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace croquis {
namespace {

TEST(ParallelFor, CoversEachItemOnce) {
    for (const std::size_t count : {0u, 1u, 2u, 7u, 64u, 1000u, 100000u}) {
        for (const std::size_t grain : {1u, 3u, 64u, 1000000u}) {
            std::vector<std::atomic<int>> visits(count);
            parallel_for(count, grain, [&](std::size_t begin, std::size_t end) {
                EXPECT_LT(begin, end);
                for (std::size_t i = begin; i < end; ++i) ++visits[i];
            });
            for (std::size_t i = 0; i < count; ++i)
                ASSERT_EQ(visits[i], 1) << i << " of " << count << ", grain " << grain;
        }
    }
}

TEST(ParallelFor, HandsOnWhatTheBodyThrows) {
    EXPECT_THROW(parallel_for(1000, 1,
                              [](std::size_t begin, std::size_t) {
                                  if (begin > 10) throw 1;
                              }),
                 int);
}

}  // namespace
}  // namespace croquis
