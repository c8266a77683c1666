#include "lines/stroke_offsets.h"

#include <array>

#include "base/names.h"
#include "lines/stroke_text.h"

namespace croquis::lines {
namespace {

constexpr double farthest = 10000;  // of an offset, in pixels

const std::array<std::string, 4> statements{"help", "length", "point", "break"};

OffsetPoint read_point(SettingReader& reader, double length) {
    OffsetPoint point;
    point.along = reader.number(0, length);
    point.tangent = reader.number(-farthest, farthest);
    point.normal = reader.number(-farthest, farthest);
    return point;
}

}  // namespace

OffsetPattern read_offsets(std::string_view text, const std::string& file_name) {
    SettingReader reader(text, file_name);
    OffsetPattern pattern;
    bool joined = true;
    while (reader.next()) {
        if (reader.name() == statements[0]) {
            pattern.help = reader.text();
        } else if (reader.name() == statements[1]) {
            if (pattern.length > 0) fail_at(reader.where(), "expected \"length\" only once");
            pattern.length = reader.number(1, farthest);
        } else if (reader.name() == statements[2]) {
            if (pattern.length <= 0) fail_at(reader.where(), "expected \"length\" before the first point");
            if (pattern.points.size() == most_offset_points) {
                fail_at(reader.where(), "expected at most {} points", most_offset_points);
            }
            pattern.points.push_back(read_point(reader, pattern.length));
            pattern.points.back().joined = joined;
            joined = true;
        } else if (reader.name() == statements[3]) {
            joined = false;
        } else {
            fail_at(reader.where(), "expected \"length\", \"point\", \"break\" or \"help\", found {}{}",
                    in_quotes(reader.name()), suggestion(reader.name(), statements));
        }
        reader.expect_end();
    }
    if (pattern.points.empty()) fail("{}: expected at least one point, found none", file_name);
    if (!joined) pattern.points.front().joined = false;  // a break at the end is one before the next pattern
    return pattern;
}

}  // namespace croquis::lines
