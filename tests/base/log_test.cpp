// Messages for people: printed once, on one line, whatever a file put into them.
#include "base/log.h"

#include <gtest/gtest.h>

namespace croquis {
namespace {

TEST(Printable, ShowsControlCharactersAsNumbers) {
    EXPECT_EQ(printable("a\x1b[31mb\nc\t\x7f"), "a\\x1b[31mb\\x0ac\\x09\\x7f");
    EXPECT_EQ(printable("Gr\u00fc\u00dfe, 1 2"), "Gr\u00fc\u00dfe, 1 2");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
    EXPECT_EQ(printable(""), "");
}

TEST(Warn, PrintsAMessageOnceAndOnOneLine) {
    ::testing::internal::CaptureStderr();
    for (int i = 0; i < 3; ++i) warn("material {} is missing", "\x1b[2J\n");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "croquis: warning: material \\x1b[2J\\x0a is missing\n");
}

}  // namespace
}  // namespace croquis
