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

void check_count(std::uint64_t count, const char* what, std::size_t bytes_each, std::size_t size, const std::string& name) {
    if (count <= size / bytes_each) return;
    fail("{}: expected room for {} {}, found a file of {} bytes", name, count, what, size);
}

std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

void check_ply(std::string_view text, std::size_t size, const std::string& name) {
    if (!text.starts_with("ply")) fail("{}: expected a PLY file, found one that does not begin with ply", name);
    const bool ends = text.find("end_header") != std::string_view::npos;
    if (!ends) fail("{}: expected a PLY file, found one without end_header", name);
    for (std::string_view line = trimmed(take_line(text)); !line.starts_with("end_header"); line = trimmed(take_line(text))) {
        if (take_word(line) != "element") continue;
        const std::string_view element = take_word(line);
        check_count(count_of(take_word(line)), element == "face" ? "faces" : "vertices", 2, size, name);
    }
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

/// Every `*MESH_NUM…` line of an ASE file makes Assimp take memory at once; braces make it recurse.
void check_ase(std::string_view text, const std::string& name) {
    if (text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe")) {
        fail("{}: expected UTF-8 text, found UTF-16", name);
    }
    check_nesting(text, name);
    const std::size_t size = text.size();
    for (std::size_t at = text.find("*MESH_NUM"); at != std::string_view::npos; at = text.find("*MESH_NUM", at + 1)) {
        std::string_view line = text.substr(at, std::min<std::size_t>(200, size - at));
        static_cast<void>(take_word(line));
        check_count(count_of(take_word(line).substr(0, 20)), "mesh elements", 4, size, name);
    }
}

}  // namespace

void check_before_assimp(const std::filesystem::path& path, const std::string& ending) {
    const std::string name = path.string();
    const std::string bytes = read_file(path, largest_file);
    if (bytes.empty()) fail("{}: expected a model, found an empty file", name);
    if (ending == ".ply") check_ply(bytes, bytes.size(), name);
    if (ending == ".off") check_off(bytes, bytes.size(), name);
    if (ending == ".stl") check_stl(bytes, name);
    if (ending == ".ase") check_ase(bytes, name);
    if (ending == ".gltf" || ending == ".glb") check_gltf(bytes, path);
}

}  // namespace croquis::model
