// Files are read within a bound, and written whole or not at all.
#include "base/files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/errors.h"
#include "support/temporary_folder.h"

namespace croquis {
namespace {

using test_support::error_of;
using test_support::TemporaryFolder;

std::size_t file_count(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

TEST(WriteFileWhole, ReplacesAFileAndLeavesNothingElse) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "picture.svg";
    write_file_whole(path, "first and longer");
    write_file_whole(path, "second");
    EXPECT_EQ(read_file(path, 100), "second");
    EXPECT_EQ(file_count(folder.path()), 1u);
}

TEST(WriteFileWhole, WritesNothingToo) {
    const TemporaryFolder folder;
    write_file_whole(folder.path() / "empty", "");
    EXPECT_EQ(read_file(folder.path() / "empty", 0), "");
}

TEST(WriteFileWhole, NamesAMissingFolder) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "missing" / "picture.svg";
    EXPECT_EQ(error_of([&] { write_file_whole(path, "x"); }),
              path.string() + ": folder " + path.parent_path().string() + " does not exist");
    EXPECT_EQ(file_count(folder.path()), 0u);
}

TEST(WriteFileWhole, RefusesAFolder) {
    const TemporaryFolder folder;
    EXPECT_EQ(error_of([&] { write_file_whole(folder.path(), "x"); }),
              folder.path().string() + ": expected a file name, found a folder");
}

TEST(WriteFileWhole, TellsThatTheDiskIsFull) {
    EXPECT_EQ(error_of([] { write_file_whole("/dev/full", "x"); }), "/dev/full: cannot write: No space left on device");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(WriteFileWhole, LeavesNothingBehindWhenItCannotReplace) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "kept";
    write_file_whole(path, "old");
    // A name so long that the file beside it cannot be made.
    const auto longest = folder.path() / std::string(255, 'n');
    EXPECT_EQ(error_of([&] { write_file_whole(longest, "x"); }),
              longest.string() + ": cannot write: File name too long");
    EXPECT_EQ(read_file(path, 100), "old");
    EXPECT_EQ(file_count(folder.path()), 1u);
}

TEST(WriteFileWhole, WritesThroughToDevices) { EXPECT_NO_THROW(write_file_whole("/dev/null", "x")); }

TEST(PartialFile, TakesItsPlaceWhenItIsKeptAndNotBefore) {
    const TemporaryFolder folder;
    const auto path = folder.write("kept", "old");
    {
        const PartialFile abandoned(path);
        std::ofstream(abandoned.written()) << "half";
        EXPECT_EQ(file_count(folder.path()), 2u);
    }
    EXPECT_EQ(file_count(folder.path()), 1u);
    EXPECT_EQ(read_file(path, 100), "old");
    PartialFile complete(path);
    std::ofstream(complete.written()) << "new";
    complete.keep();
    EXPECT_EQ(read_file(path, 100), "new");
    EXPECT_EQ(file_count(folder.path()), 1u);
}

TEST(CheckWritable, RefusesWhatCannotBeWrittenAndWritesNothing) {
    const TemporaryFolder folder;
    const auto kept = folder.write("kept", "old");
    const auto longest = folder.path() / std::string(255, 'n');
    for (const auto& path : {folder.path(), folder.path() / "missing" / "file", longest}) {
        EXPECT_EQ(error_of([&] { check_writable(path); }), error_of([&] { write_file_whole(path, "x"); }));
        EXPECT_NE(error_of([&] { check_writable(path); }), "no error");
    }
    for (const std::filesystem::path& path :
         {kept, folder.path() / "new", std::filesystem::path("/dev/null"), std::filesystem::path("-")}) {
        EXPECT_NO_THROW(check_writable(path));
    }
    EXPECT_EQ(read_file(kept, 100), "old");
    EXPECT_EQ(file_count(folder.path()), 1u);
}

TEST(ReadFile, TellsWhatIsWrong) {
    const TemporaryFolder folder;
    const auto missing = folder.path() / "missing";
    const auto large = folder.write("large", "123456");
    EXPECT_EQ(error_of([&] { (void)read_file(missing, 10); }), missing.string() + ": no such file");
    EXPECT_EQ(error_of([&] { (void)read_file(folder.path(), 10); }),
              folder.path().string() + ": expected a file, found a folder");
    EXPECT_EQ(error_of([&] { (void)read_file(large, 5); }), large.string() + ": larger than the 5 bytes allowed here");
    EXPECT_EQ(read_file(large, 6), "123456");
}

TEST(ReadFile, IsBoundedForFilesWithoutEnd) {
    EXPECT_EQ(error_of([] { (void)read_file("/dev/zero", 1000); }),
              "/dev/zero: larger than the 1000 bytes allowed here");
}

}  // namespace
}  // namespace croquis
