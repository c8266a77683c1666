// Data folders: the user's own first, and no name leads out of them.
#include "framework/data_folders.h"

#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/temporary_folder.h"

namespace croquis::framework {
namespace {

using test_support::error_of;
using test_support::TemporaryFolder;

TEST(DataFoldersTest, AMissingFolderIsAnError) {
    const TemporaryFolder folder;
    const std::string missing = folder.path() / "missing";
    EXPECT_EQ(error_of([&] { (void)DataFolders({missing}); }), missing + ": no such data folder");
}

TEST(DataFoldersTest, TheFirstFolderWins) {
    const TemporaryFolder own, shipped;
    (void)own.write("shaders/a.glsl", "own");
    (void)shipped.write("shaders/a.glsl", "shipped");
    (void)shipped.write("shaders/b.glsl", "shipped");
    const DataFolders folders({own.path(), shipped.path()});
    EXPECT_EQ(folders.find("shaders", "a", ".glsl"), own.path() / "shaders/a.glsl");
    EXPECT_EQ(folders.find("shaders", "b", ".glsl"), shipped.path() / "shaders/b.glsl");
    EXPECT_TRUE(folders.find("shaders", "c", ".glsl").empty());
    EXPECT_EQ(folders.names("shaders", ".glsl"), (std::vector<std::string>{"a", "b"}));
}

TEST(DataFoldersTest, NamesMayHaveFoldersOfTheirOwn) {
    const TemporaryFolder folder;
    (void)folder.write("shaders/include/light.glsl", "x");
    EXPECT_EQ(DataFolders({folder.path()}).find("shaders", "include/light", ".glsl"),
              folder.path() / "shaders/include/light.glsl");
}

TEST(DataFoldersTest, NoNameLeadsOut) {
    const TemporaryFolder outside, folder;
    (void)outside.write("secret.glsl", "x");
    (void)folder.write("shaders/a.glsl", "x");
    const DataFolders folders({folder.path()});
    const std::string absolute = outside.path() / "secret";
    for (const std::string& name : {std::string("../secret"), std::string("a/../../secret"), absolute, std::string(),
                                    std::string("a\\b"), std::string("a\nb"), std::string("..")}) {
        EXPECT_EQ(error_of([&] { (void)folders.find("shaders", name, ".glsl"); }),
                  "expected a name inside its data folder, found \"" + name + "\"");
    }
}

TEST(DataFoldersTest, NoLinkLeadsOut) {
    const TemporaryFolder outside, folder;
    (void)outside.write("secret.glsl", "x");
    (void)folder.write("shaders/a.glsl", "x");
    std::filesystem::create_symlink(outside.path() / "secret.glsl", folder.path() / "shaders/link.glsl");
    std::filesystem::create_directory_symlink(outside.path(), folder.path() / "shaders/there");
    std::filesystem::create_symlink("a.glsl", folder.path() / "shaders/inside.glsl");
    const DataFolders folders({folder.path()});
    EXPECT_EQ(error_of([&] { (void)folders.find("shaders", "link", ".glsl"); }),
              "expected a name inside its data folder, found \"link\", a link out of it");
    EXPECT_EQ(error_of([&] { (void)folders.find("shaders", "there/secret", ".glsl"); }),
              "expected a name inside its data folder, found \"there/secret\", a link out of it");
    EXPECT_FALSE(folders.find("shaders", "inside", ".glsl").empty()) << "a link that stays inside is allowed";
}

}  // namespace
}  // namespace croquis::framework
