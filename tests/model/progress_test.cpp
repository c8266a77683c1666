// How far reading has come, for every format, and ending it in its middle.
#include "model/progress.h"

#include <chrono>
#include <vector>

#include "fixtures.h"

namespace croquis::model::testing {
namespace {

// The shares that are told while a file is read.
std::vector<double> shares_of(const std::filesystem::path& path) {
    std::vector<double> shares;
    LoadOptions options;
    options.progress = Progress(path.string(), [&](double share) {
        shares.push_back(share);
        return true;
    });
    static_cast<void>(load(path, options));
    return shares;
}

// What reading says that is ended once it has come so far; nothing where it is not ended.
std::string end_at(const std::filesystem::path& path, double share) {
    LoadOptions options;
    bool has_ended = false;
    options.progress = Progress(path.string(), [&](double now) {
        EXPECT_FALSE(has_ended) << "nobody is asked again";
        has_ended = now >= share;
        return !has_ended;
    });
    try {
        static_cast<void>(load(path, options));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

// One of each format; those that our own readers read tell more than the beginning and the end.
struct Sample {
    const char* file;
    std::size_t least_told;
};
constexpr Sample samples[] = {
    {"OBJ/spider.obj", 10}, {"MD2/faerie.md2", 100}, {"PLY/Wuson.ply", 6},
    {"OFF/Wuson.off", 4},   {"STL/Wuson.stl", 4},    {"ASE/ThreeCubesGreen.ASE", 4},
    {"3DS/fels.3ds", 4},    {"WRL/Wuson.wrl", 4},    {"glTF2/BoxTextured-glTF/BoxTextured.gltf", 4}};

TEST(Progress, RisesFromNothingToAllInEveryFormat) {
    for (const Sample& sample : samples) {
        const std::vector<double> shares = shares_of(sample_folder / sample.file);
        SCOPED_TRACE(sample.file);
        ASSERT_GE(shares.size(), sample.least_told);
        EXPECT_EQ(shares.front(), 0);
        EXPECT_EQ(shares.back(), 1);
        EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    }
}

TEST(Progress, EndsAnywhereInEveryFormat) {
    for (const Sample& sample : samples) {
        for (const double share : {0.0, 0.3, 0.6, 1.0}) {
            const std::filesystem::path path = sample_folder / sample.file;
            EXPECT_EQ(end_at(path, share), path.string() + ": cancelled") << share;
        }
    }
}

// A sphere of 360,000 triangles in text: no two calls are farther apart than a fraction of the whole, so that it ends
// soon wherever it is ended, and no stretch of the shares is left out.
TEST(Progress, ALargeFileIsToldEvenly) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.write("ball.obj", sphere(300, 600, 1));
    const auto begun = std::chrono::steady_clock::now();
    std::chrono::steady_clock::duration longest{0};
    auto last = begun;
    double last_share = 0, widest = 0;
    LoadOptions options;
    options.progress = Progress("ball", [&](double share) {
        const auto now = std::chrono::steady_clock::now();
        longest = std::max(longest, now - last);
        widest = std::max(widest, share - last_share);
        last = now;
        last_share = share;
        return true;
    });
    static_cast<void>(load(path, options));
    EXPECT_LT(longest, (std::chrono::steady_clock::now() - begun) / 4);
    EXPECT_LT(widest, 0.15);
}

TEST(Progress, PartsOfPartsAreSharesOfTheWhole) {
    double told = -1;
    const Progress all("all", [&](double share) {
        told = share;
        return true;
    });
    all.part(0.5, 1).part(0.25, 0.75).reach(0.5);
    EXPECT_DOUBLE_EQ(told, 0.75);
    Progress().part(0, 1).reach(0.5);  // tells nobody
}

}  // namespace
}  // namespace croquis::model::testing
