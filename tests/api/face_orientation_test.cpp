// Ways to tell which faces look at the eye, compared through the API.
#include <gtest/gtest.h>

#include <map>

#include "api/shapes.h"
#include "support/errors.h"

namespace croquis {
namespace {

using test_support::cube_file;
using test_support::error_of;

// Three faces of a cube are seen from its corner, two triangles each, and no way misses one.
TEST(FaceOrientationTable, KnowsACube) {
    FaceOrientationOptions options;
    options.view.direction = {1, 1, 1};
    options.views = 1;
    std::map<std::string, FaceOrientationResult> results;
    for (const FaceOrientationResult& result : compare_face_orientations(cube_file(), options)) {
        results[result.method] = result;
    }
    ASSERT_EQ(results.size(), 8u);
    EXPECT_EQ(results["triangles_exact"].found, 6);
    EXPECT_EQ(results["triangles_constant"].found, 6);
    EXPECT_GE(results["vertices_one"].found, 6);
    for (const auto& [method, result] : results) {
        EXPECT_GE(result.microseconds, 0) << method;
        if (method != "marked_some") {
            EXPECT_EQ(result.holes, 0) << method;
        }
    }
}

TEST(FaceOrientationTable, WantsAView) {
    FaceOrientationOptions options;
    options.views = 0;
    EXPECT_EQ(error_of([&] { static_cast<void>(compare_face_orientations(cube_file(), options)); }),
              "expected 1 view or more, found 0");
}

}  // namespace
}  // namespace croquis
