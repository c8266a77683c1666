// How far reading has come, for every format, and ending it in its middle.
#include "model/progress.h"

#include <algorithm>
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

// However large a file is, it is told in small steps: reading, joining and finishing.
TEST(Progress, ALargeFileIsToldInSmallSteps) {
    const TemporaryFolder folder;
    const std::vector<double> shares = shares_of(folder.write("ball.obj", sphere(300, 600, 1)));
    EXPECT_GT(shares.size(), 100u);
    for (std::size_t i = 1; i < shares.size(); ++i) EXPECT_LT(shares[i] - shares[i - 1], 0.1) << shares[i];
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
