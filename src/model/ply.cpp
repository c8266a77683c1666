// PLY, our own reader: Assimp's crashes or hangs on damaged files. Text and binary of either byte order; vertices with
// normals, texture coordinates and colours; faces of any size, or triangle strips.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/error.h"
#include "base/files.h"
#include "model/readers.h"
#include "model/text_lines.h"
#include "model/textures.h"
#include "model/triangulate.h"
#include "model/vertices.h"

namespace croquis::model {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
    std::string name;
    Type type = Type::float32;
    bool is_list = false;
    Type count_type = Type::uint8;
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

/// What a property of a vertex means; the order of `Vertex::values`.
constexpr const char* meanings[][4] = {{"x"},
                                       {"y"},
                                       {"z"},
                                       {"nx", "normal_x"},
                                       {"ny", "normal_y"},
                                       {"nz", "normal_z"},
                                       {"s", "u", "texture_u", "s0"},
                                       {"t", "v", "texture_v", "t0"},
                                       {"red", "r", "diffuse_red"},
                                       {"green", "g", "diffuse_green"},
                                       {"blue", "b", "diffuse_blue"},
                                       {"alpha", "a", "diffuse_alpha"}};
constexpr int no_meaning = -1, normal_meaning = 3, texcoord_meaning = 6, color_meaning = 8, alpha_meaning = 11;

int meaning_of(const std::string& name) {
    for (int m = 0; m < int(std::size(meanings)); ++m) {
        for (const char* known : meanings[m]) {
            if (known != nullptr && name == known) return m;
        }
    }
    return no_meaning;
}

class PlyReader {
public:
    PlyReader(const std::filesystem::path& path, const Progress& progress)
        : path_(path), name_(path.string()), reading_(progress.part(0, 0.6)), building_(progress.part(0.6, 1)) {}

    RawModel read() {
        bytes_ = read_file(path_, largest_file);
        rest_ = bytes_;
        read_header();
        for (const Element& element : elements_) {
            check_room(element);
            if (element.name == "vertex") {
                read_vertices(element);
            } else if (element.name == "face" || element.name == "tristrips") {
                read_faces(element);
            } else {
                skip(element);
            }
        }
        if (mesh_.triangles.empty()) fail_without_triangles(name_, !points_.empty());
        bytes_ = {};
        return build();
    }

private:
    std::string_view take_line() {
        const std::size_t end = rest_.find('\n');
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        return trimmed(line);
    }

    Type type_of(std::string_view word) const {
        constexpr const char* names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                            {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                            {"float", "float32"}, {"double", "float64"}};
        for (std::size_t t = 0; t < std::size(names); ++t) {
            if (word == names[t][0] || word == names[t][1]) return static_cast<Type>(t);
        }
        fail("{}: expected a type such as float or uchar, found \"{}\"", name_, word.substr(0, 40));
    }

    void read_header() {
        if (bytes_.empty()) fail("{}: expected a model, found an empty file", name_);
        if (take_line() != "ply") fail("{}: expected a PLY file, found one that does not begin with ply", name_);
        while (true) {
            if (rest_.empty()) fail("{}: expected a PLY header, found none that ends with end_header", name_);
            std::string_view line = take_line();
            const std::string_view keyword = take_word(line);
            if (keyword == "end_header") break;
            if (keyword == "format") read_format(take_word(line));
            if (keyword == "element") read_element(line);
            if (keyword == "property" && !elements_.empty()) read_property(line);
            if (keyword == "comment" && take_word(line) == "TextureFile") texture_ = trimmed(line);
        }
    }

    void read_format(std::string_view format) {
        is_text_ = format == "ascii";
        is_big_endian_ = format == "binary_big_endian";
        if (!is_text_ && !is_big_endian_ && format != "binary_little_endian") {
            fail("{}: expected format ascii or binary, found \"{}\"", name_, format.substr(0, 40));
        }
    }

    void read_element(std::string_view line) {
        Element element;
        element.name = take_word(line);
        double count = 0;
        if (!take_number(line, count) || !(count >= 0) || count > 4e9) {
            fail("{}: expected a count of element \"{}\", found none", name_, element.name);
        }
        element.count = static_cast<std::uint64_t>(count);
        elements_.push_back(std::move(element));
    }

    void read_property(std::string_view line) {
        Property property;
        std::string_view word = take_word(line);
        property.is_list = word == "list";
        if (property.is_list) {
            property.count_type = type_of(take_word(line));
            word = take_word(line);
        }
        property.type = type_of(word);
        property.name = take_word(line);
        elements_.back().properties.push_back(std::move(property));
    }

    /// Each entry takes at least a byte for each of its properties.
    void check_room(const Element& element) const {
        const std::uint64_t least = std::max<std::uint64_t>(1, element.properties.size());
        if (element.count <= (rest_.size() + 1) / least) return;
        fail("{}: expected room for {} entries of element \"{}\", found {} bytes", name_, element.count, element.name,
             rest_.size());
    }

    void tell_of_entry(std::uint64_t entry) const {
        constexpr std::uint64_t entries_between = 1 << 14;
        if (entry % entries_between == 0) reading_.reach(1.0 - double(rest_.size()) / double(bytes_.size()));
    }

    double next(Type type) {
        if (is_text_) return next_in_text();
        constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
        const std::size_t size = sizes[static_cast<std::size_t>(type)];
        if (rest_.size() < size) fail("{}: file too short, expected more vertices or faces", name_);
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t shift = 8 * (is_big_endian_ ? size - 1 - i : i);
            bits |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << shift;
        }
        rest_.remove_prefix(size);
        switch (type) {
            case Type::int8:
                return static_cast<std::int8_t>(bits);
            case Type::int16:
                return static_cast<std::int16_t>(bits);
            case Type::int32:
                return static_cast<std::int32_t>(bits);
            case Type::float32:
                return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
            case Type::float64:
                return std::bit_cast<double>(bits);
            default:
                return static_cast<double>(bits);
        }
    }

    double next_in_text() {
        const auto is_space = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
        std::size_t begin = 0;
        while (begin < rest_.size() && is_space(rest_[begin])) ++begin;
        std::size_t end = begin;
        while (end < rest_.size() && !is_space(rest_[end])) ++end;
        std::string_view word = rest_.substr(begin, end - begin);
        if (word.empty()) fail("{}: file too short, expected more vertices or faces", name_);
        double number = 0;
        if (!take_number(word, number)) fail("{}: expected a number, found \"{}\"", name_, word.substr(0, 40));
        rest_.remove_prefix(end);
        return number;
    }

    std::uint64_t next_count(const Property& list) {
        const double count = next(list.count_type);
        if (!(count >= 0) || count > static_cast<double>(rest_.size())) {
            fail("{}: expected a list that fits the file, found one of {} entries", name_, count);
        }
        return static_cast<std::uint64_t>(count);
    }

    void skip(const Property& property) {
        std::uint64_t count = property.is_list ? next_count(property) : 1;
        while (count-- > 0) static_cast<void>(next(property.type));
    }

    void skip(const Element& element) {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            for (const Property& property : element.properties) skip(property);
        }
    }

    void read_vertices(const Element& element) {
        std::vector<int> meaning;
        bool has[std::size(meanings)] = {};
        for (const Property& property : element.properties) {
            meaning.push_back(property.is_list ? no_meaning : meaning_of(property.name));
            if (meaning.back() != no_meaning) has[meaning.back()] = true;
            // Colours are 0 to 255 as whole numbers, 0 to 1 as fractions.
            if (meaning.back() >= color_meaning) color_scale_ = property.type < Type::float32 ? 1.0 : 255.0;
        }
        if (!has[0] || !has[1] || !has[2]) fail("{}: expected vertices with x, y and z, found none", name_);
        points_.reserve(element.count);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            tell_of_entry(i);
            double values[std::size(meanings)] = {};
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                if (meaning[p] == no_meaning) {
                    skip(element.properties[p]);
                } else {
                    values[meaning[p]] = next(element.properties[p].type);
                }
            }
            points_.emplace_back(values[0], values[1], values[2]);
            if (has[normal_meaning]) mesh_.normals.emplace_back(values[3], values[4], values[5]);
            if (has[texcoord_meaning]) mesh_.texcoords.emplace_back(values[6], values[7]);
            if (!has[color_meaning]) continue;
            if (!has[alpha_meaning]) values[alpha_meaning] = 255.0 / color_scale_;
            mesh_.colors.push_back(to_color(&values[color_meaning]));
        }
    }

    [[nodiscard]] glm::u8vec4 to_color(const double* values) const {
        glm::u8vec4 color;
        for (int c = 0; c < 4; ++c) {
            const double value = values[c] * color_scale_ + 0.5;
            color[c] = value > 0 ? static_cast<std::uint8_t>(std::min(value, 255.0)) : std::uint8_t{0};
        }
        return color;
    }

    void read_faces(const Element& element) {
        for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            tell_of_entry(i);
            for (const Property& property : element.properties) {
                const bool is_face =
                    property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
                if (!is_face) {
                    skip(property);
                    continue;
                }
                face_.clear();
                for (std::uint64_t left = next_count(property); left > 0; --left) face_.push_back(next(property.type));
                element.name == "tristrips" ? add_strips() : add_face();
            }
        }
    }

    /// An index as the mesh holds it; out of range where it is none: `finish` drops the face.
    static std::uint32_t to_index(double number) {
        return number >= 0 && number < 4e9 ? static_cast<std::uint32_t>(number) : 0xffffffffu;
    }

    void add_triangle(double a, double b, double c) {
        mesh_.triangles.insert(mesh_.triangles.end(), {to_index(a), to_index(b), to_index(c)});
    }

    void add_face() {
        if (face_.size() == 3) return add_triangle(face_[0], face_[1], face_[2]);
        polygon_.clear();
        cut_.clear();
        for (const double index : face_) {
            const std::uint32_t v = to_index(index);
            polygon_.push_back(v < points_.size() ? points_[v] : glm::dvec3(0.0));
        }
        triangulate(polygon_, cut_);
        for (std::size_t t = 0; t < cut_.size(); t += 3)
            add_triangle(face_[cut_[t]], face_[cut_[t + 1]], face_[cut_[t + 2]]);
    }

    /// Strips in one list, each ended by -1; every second triangle is wound the other way.
    void add_strips() {
        std::size_t start = 0;
        for (std::size_t i = 0; i < face_.size(); ++i) {
            if (face_[i] < 0) {
                start = i + 1;
            } else if (i >= start + 2) {
                const bool odd = (i - start) % 2 == 1;
                add_triangle(face_[i - 2], face_[odd ? i : i - 1], face_[odd ? i - 1 : i]);
            }
        }
    }

    RawModel build() {
        RawModel raw;
        glm::dvec3 low(1e300), high(-1e300);
        for (const glm::dvec3& p : points_) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        if (glm::length(high - low) < 1e18) raw.origin = suitable_origin(low, high);
        mesh_.positions.reserve(points_.size());
        for (const glm::dvec3& p : points_) mesh_.positions.emplace_back(p - raw.origin);
        points_ = {};
        building_.reach(0);
        join_vertices(mesh_, nullptr, building_);
        raw.meshes.emplace_back();
        raw.meshes[0].mesh = std::move(mesh_);
        raw.materials.push_back(plain_material());
        if (!texture_.empty()) TextureFinder(path_).attach(raw.materials[0], texture_);
        return raw;
    }

    std::filesystem::path path_;
    std::string name_, texture_;
    Progress reading_, building_;
    std::string bytes_;
    std::string_view rest_;
    std::vector<Element> elements_;
    bool is_text_ = true, is_big_endian_ = false;
    double color_scale_ = 1;
    std::vector<glm::dvec3> points_;
    Mesh mesh_;
    std::vector<double> face_;
    std::vector<glm::dvec3> polygon_;
    std::vector<std::uint32_t> cut_;
};

}  // namespace

RawModel read_ply(const std::filesystem::path& path, const Progress& progress) {
    return PlyReader(path, progress).read();
}

}  // namespace croquis::model
