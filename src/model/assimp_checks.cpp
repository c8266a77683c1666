// What is wrong with a file is found here, before Assimp meets it: it believes counts, and recurses without a bound.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <map>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "model/assimp_scene.h"
#include "model/readers.h"
#include "model/text_lines.h"

namespace croquis::model {
namespace {

/// A declared count: digits up to the next blank. Anything else counts as 0 and is left to Assimp.
std::uint64_t count_of(std::string_view word) {
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error == std::errc::result_out_of_range) return ~std::uint64_t{0};
    return error == std::errc() ? count : 0;
}

void check_count(std::uint64_t count, const char* what, std::size_t bytes_each, std::size_t size,
                 const std::string& name) {
    if (count <= size / bytes_each) return;
    fail("{}: expected room for {} {}, found a file of {} bytes", name, count, what, size);
}

std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

void check_off(std::string_view text, std::size_t size, const std::string& name) {
    const std::string_view magic = text.substr(0, std::min<std::size_t>(text.size(), 8));
    if (magic.find("OFF") == std::string_view::npos) {
        fail("{}: expected an OFF file, found one that does not begin with OFF", name);
    }
    static_cast<void>(take_line(text));
    std::string_view line;
    while (!text.empty() && (line.empty() || line.starts_with('#'))) line = trimmed(take_line(text));
    const std::uint64_t vertices = count_of(take_word(line)), faces = count_of(take_word(line));
    check_count(vertices, "vertices", 2, size, name);
    check_count(faces, "faces", 2, size, name);
}

void check_stl(std::string_view text, const std::string& name) {
    if (text.size() < 15) fail("{}: file too short, expected at least 15 bytes, found {}", name, text.size());
    constexpr std::size_t head = 84, facet = 50;
    const std::string_view start = trimmed(text.substr(0, 80));
    std::string word(start.substr(0, 5));
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (word == "solid") return;
    if (text.size() < head) fail("{}: file too short, expected at least {} bytes, found {}", name, head, text.size());
    std::uint32_t count = 0;
    std::memcpy(&count, text.data() + 80, 4);
    check_count(count, "triangles", facet, text.size() - head, name);
}

/// The lists of an ASE mesh whose counts Assimp believes, and the faces that point into them.
struct AseList {
    const char* count_keyword;
    const char* face_keyword;
    std::uint64_t count;
};

/// Assimp takes memory for every count at once, follows every index unseen, and recurses at braces.
class AseCheck {
public:
    AseCheck(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    void check() {
        for (std::size_t at = text_.find("*MESH_"); at != std::string_view::npos; at = text_.find("*MESH_", at + 1)) {
            std::string_view line = text_.substr(at + 1, std::min<std::size_t>(200, text_.size() - at - 1));
            line = line.substr(0, line.find_first_of("\r\n*"));
            check_line(take_word(line), line);
        }
    }

private:
    void check_line(std::string_view keyword, std::string_view line) {
        if (keyword.starts_with("MESH_NUM")) {
            std::string_view rest = line;
            check_count(count_of(take_word(rest)), "mesh elements", 4, text_.size(), name_);
        }
        for (AseList& list : lists_) {
            if (keyword == list.count_keyword) list.count = count_of(take_word(line));
            if (keyword == list.face_keyword) check_face(list, line);
        }
    }

    /// `12: A: 0 B: 1 C: 2 …` or `12 0 1 2`: the number of the face, then three indices. Letters and colons are blanks
    /// here, but none may stand within a number: Assimp would then read an index from nowhere.
    void check_face(const AseList& list, std::string_view line) const {
        std::size_t at = 0;
        for (int n = 0; n < 4; ++n) {
            while (at < line.size() && (is_blank(line[at]) || (line[at] >= 'A' && line[at] <= 'C') || line[at] == ':'))
                ++at;
            const std::size_t begin = at;
            while (at < line.size() && line[at] >= '0' && line[at] <= '9') ++at;
            const bool ends_well = at == line.size() || is_blank(line[at]) || (n == 0 && line[at] == ':');
            if (at == begin || !ends_well)
                fail("{}: expected four numbers in {}, found fewer", name_, list.face_keyword);
            const std::uint64_t index = count_of(line.substr(begin, at - begin));
            if (n > 0 && index >= list.count) {
                fail("{}: expected indices below {} in {}, found {}", name_, list.count, list.face_keyword, index);
            }
        }
    }

    std::string_view text_;
    const std::string& name_;
    AseList lists_[3] = {
        {"MESH_NUMVERTEX", "MESH_FACE", 0}, {"MESH_NUMTVERTEX", "MESH_TFACE", 0}, {"MESH_NUMCVERTEX", "MESH_CFACE", 0}};
};

void check_ase(std::string_view text, const std::string& name) {
    if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe")) {
        fail("{}: expected UTF-8 text, found UTF-16", name);
    }
    check_nesting(text, name);
    AseCheck(text, name).check();
}

}  // namespace

void check_before_assimp(const std::filesystem::path& path, const std::string& ending) {
    const std::string name = path.string();
    const std::string bytes = read_file(path, largest_file);
    if (bytes.empty()) fail("{}: expected a model, found an empty file", name);
    if (ending == ".off") check_off(bytes, bytes.size(), name);
    if (ending == ".stl") check_stl(bytes, name);
    if (ending == ".ase") check_ase(bytes, name);
    if (ending == ".gltf" || ending == ".glb") check_gltf(bytes, path);
}

}  // namespace croquis::model
