// MD2: a header of 17 numbers, then tables at the offsets it names. All numbers are little-endian. Assimp gives one
// frame of these files and no animation, hence a reader of our own.
#include "model/md2.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstring>
#include <map>
#include <unordered_map>

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "model/readers.h"
#include "model/textures.h"

namespace croquis::model {
namespace {

constexpr double frames_a_second = 10;
constexpr std::size_t header_size = 68;
constexpr std::size_t skin_name_size = 64;
constexpr std::size_t frame_head_size = 40;           // scale, translation, name
constexpr std::size_t most_frames = 2048;             // the game allows 512
constexpr std::size_t most_shape_vertices = 1 << 24;  // all frames together: 400 MB

struct Table {
    std::size_t count = 0;
    std::size_t offset = 0;
};

struct Header {
    std::size_t skin_width = 0, skin_height = 0, frame_size = 0;
    std::size_t points = 0;
    Table skins, texcoords, triangles, frames;
};

class Md2Reader {
public:
    Md2Reader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    RawModel read(const Progress& progress) {
        read_header();
        RawModel raw;
        raw.meshes.resize(1);
        raw.meshes[0].mesh.name = "md2";
        raw.materials.push_back(skin());
        read_triangles(raw.meshes[0].mesh);
        read_frames(raw, progress);
        return raw;
    }

private:
    [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t bytes) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) value |= std::to_integer<std::uint32_t>(bytes_[at + i]) << (8 * i);
        return value;
    }
    [[nodiscard]] float real(std::size_t at) const { return std::bit_cast<float>(number(at, 4)); }
    [[nodiscard]] std::string text(std::size_t at, std::size_t most) const {
        std::string result;
        for (std::size_t i = 0; i < most && bytes_[at + i] != std::byte{0}; ++i) {
            result.push_back(static_cast<char>(bytes_[at + i]));
        }
        return result;
    }

    void read_header() {
        if (bytes_.size() < header_size) {
            fail("{}: file too short, expected at least {} bytes, found {}", name_, header_size, bytes_.size());
        }
        if (text(0, 4) != "IDP2") fail("{}: expected an MD2 file, found one that does not begin with IDP2", name_);
        if (number(4, 4) != 8) fail("{}: expected MD2 version 8, found {}", name_, number(4, 4));
        header_.skin_width = number(8, 4);
        header_.skin_height = number(12, 4);
        header_.frame_size = number(16, 4);
        header_.points = number(24, 4);
        header_.skins = {number(20, 4), number(44, 4)};
        header_.texcoords = {number(28, 4), number(48, 4)};
        header_.triangles = {number(32, 4), number(52, 4)};
        header_.frames = {number(40, 4), number(56, 4)};
        check_table(header_.skins, skin_name_size, "skins");
        check_table(header_.texcoords, 4, "texture coordinates");
        check_table(header_.triangles, 12, "triangles");
        check_table(header_.frames, header_.frame_size, "frames");
        const std::size_t needed = frame_head_size + 4 * header_.points;
        if (header_.frame_size < needed) {
            fail("{}: expected frames of at least {} bytes, found {}", name_, needed, header_.frame_size);
        }
        if (header_.frames.count == 0 || header_.frames.count > most_frames) {
            fail("{}: expected 1 to {} frames, found {}", name_, most_frames, header_.frames.count);
        }
    }

    void check_table(const Table& table, std::size_t entry_size, const char* what) const {
        if (table.count > 0 && table.offset + table.count * entry_size > bytes_.size()) {
            fail("{}: file too short, expected {} {} up to byte {}, found {} bytes", name_, table.count, what,
                 table.offset + table.count * entry_size, bytes_.size());
        }
    }

    [[nodiscard]] Material skin() const {
        Material material = plain_material();
        material.name = "skin";
        if (header_.skins.count > 0) material.texture_name = text(header_.skins.offset, skin_name_size);
        return material;
    }

    /// Corners that share a point and a texture coordinate are one vertex. MD2 winds clockwise: turned here.
    void read_triangles(Mesh& mesh) {
        std::unordered_map<std::uint32_t, std::uint32_t> vertex_of;
        const bool textured = header_.texcoords.count > 0 && header_.skin_width > 0 && header_.skin_height > 0;
        for (std::size_t t = 0; t < header_.triangles.count; ++t) {
            const std::size_t at = header_.triangles.offset + 12 * t;
            for (const std::size_t corner : {std::size_t{0}, std::size_t{2}, std::size_t{1}}) {
                const std::uint32_t point = number(at + 2 * corner, 2);
                const std::uint32_t texcoord = textured ? number(at + 6 + 2 * corner, 2) : 0;
                const auto next = static_cast<std::uint32_t>(points_.size());
                const auto [entry, is_new] = vertex_of.try_emplace(point << 16 | texcoord, next);
                mesh.triangles.push_back(entry->second);
                if (!is_new) continue;
                points_.push_back(point);
                if (textured) mesh.texcoords.push_back(texcoord_at(texcoord));
            }
        }
        if (points_.size() * header_.frames.count > most_shape_vertices) {
            fail("{}: expected at most {} vertices in all frames, found {}", name_, most_shape_vertices,
                 points_.size() * header_.frames.count);
        }
    }

    /// Texels count from the upper left.
    [[nodiscard]] glm::vec2 texcoord_at(std::uint32_t index) const {
        if (index >= header_.texcoords.count) return {};
        const std::size_t at = header_.texcoords.offset + std::size_t{4} * index;
        const auto s = static_cast<std::int16_t>(number(at, 2)), t = static_cast<std::int16_t>(number(at + 2, 2));
        return {float(s) / float(header_.skin_width), 1.0f - float(t) / float(header_.skin_height)};
    }

    [[nodiscard]] Shape frame(std::size_t index) const {
        const std::size_t at = header_.frames.offset + index * header_.frame_size;
        const glm::vec3 scale(real(at), real(at + 4), real(at + 8));
        const glm::vec3 translation(real(at + 12), real(at + 16), real(at + 20));
        Shape shape;
        shape.name = text(at + 24, 16);
        shape.positions.reserve(points_.size());
        constexpr float no_number = std::numeric_limits<float>::quiet_NaN();
        for (const std::uint32_t point : points_) {
            if (point >= header_.points) {  // finish drops the faces
                shape.positions.emplace_back(no_number);
                continue;
            }
            const std::size_t byte = at + frame_head_size + std::size_t{4} * point;
            const glm::vec3 packed(float(number(byte, 1)), float(number(byte + 1, 1)), float(number(byte + 2, 1)));
            const glm::vec3 p = packed * scale + translation;
            shape.positions.emplace_back(p.x, p.z, -p.y);
        }
        return shape;
    }

    void read_frames(RawModel& raw, const Progress& progress) const {
        Mesh& mesh = raw.meshes[0].mesh;
        MeshRig rig;
        for (std::size_t f = 0; f < header_.frames.count; ++f) {
            progress.reach(double(f) / double(header_.frames.count));
            rig.shapes.push_back(frame(f));
        }
        mesh.positions = rig.shapes[0].positions;
        if (header_.frames.count == 1) return;
        rig.positions = mesh.positions;
        raw.clips = clips_of(rig.shapes);
        raw.rig.nodes.push_back(Node{"root"});
        raw.rig.meshes.push_back(std::move(rig));
    }

    /// Frames that follow each other and are numbered through.
    struct Run {
        std::string stem;
        std::string first_name;
        std::size_t begin = 0, end = 0;
    };

    [[nodiscard]] static std::size_t digits_at_end(const std::string& name) {
        std::size_t digits = 0;
        while (digits < name.size() && std::isdigit(static_cast<unsigned char>(name[name.size() - 1 - digits])))
            ++digits;
        return digits;
    }

    [[nodiscard]] static std::vector<Run> runs_of(std::span<const Shape> frames) {
        std::vector<Run> runs;
        std::string expected;  // the number that goes on with the run
        for (std::size_t f = 0; f < frames.size(); ++f) {
            const std::string& name = frames[f].name;
            const std::size_t digits = digits_at_end(name);
            const std::string stem = name.substr(0, name.size() - digits);
            const long number = digits > 0 && digits < 10 ? std::stol(name.substr(name.size() - digits)) : 0;
            if (runs.empty() || runs.back().stem != stem || (digits > 0 && std::to_string(number) != expected)) {
                runs.push_back({stem, name, f, f});
            }
            runs.back().end = f + 1;
            expected = std::to_string(number + 1);
        }
        return runs;
    }

    /// A stem that several runs share tells them apart by the digits before the last two: `pain101` and `pain201` begin
    /// the clips "pain1" and "pain2".
    [[nodiscard]] static std::vector<AnimationClip> clips_of(std::span<const Shape> frames) {
        const std::vector<Run> runs = runs_of(frames);
        std::map<std::string, int> runs_of_stem;
        std::map<std::string, int> clips_of_name;
        for (const Run& run : runs) ++runs_of_stem[run.stem];
        std::vector<AnimationClip> clips;
        for (const Run& run : runs) {
            std::string name = run.stem;
            if (runs_of_stem[run.stem] > 1) {
                const std::size_t cut = std::min<std::size_t>(2, run.first_name.size() - run.stem.size());
                name = run.first_name.substr(0, run.first_name.size() - cut);
            }
            if (name.empty()) name = "animation";
            const int same = clips_of_name[name]++;
            if (same > 0) name += fmt::format(" ({})", same + 1);
            clips.push_back(clip_of(name, run.begin, run.end));
        }
        return clips;
    }

    [[nodiscard]] static AnimationClip clip_of(const std::string& name, std::size_t begin, std::size_t end) {
        ShapeTrack track;
        const auto add_key = [&](std::size_t position, std::size_t frame) {
            std::vector<float> weights(frame + 1, 0.0f);
            weights[frame] = 1.0f;
            track.weights.push_back({static_cast<double>(position) / frames_a_second, std::move(weights)});
        };
        for (std::size_t f = begin; f < end; ++f) add_key(f - begin, f);
        add_key(end - begin, begin);
        AnimationClip clip;
        clip.name = name;
        clip.seconds = static_cast<double>(end - begin) / frames_a_second;
        clip.shapes.push_back(std::move(track));
        return clip;
    }

    std::span<const std::byte> bytes_;
    const std::string& name_;
    Header header_;
    std::vector<std::uint32_t> points_;  // of each vertex
};

bool is_image(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<const char*, 8> endings = {".pcx", ".png", ".jpg", ".jpeg", ".tga", ".bmp", ".gif", ".psd"};
    return std::any_of(endings.begin(), endings.end(), [&](const char* known) { return ending == known; });
}

/// An image that can only be this model's skin: one named as the model, the only one whose name begins so, or the only
/// one in the folder. Empty when there is none.
std::filesystem::path guess_skin(const std::filesystem::path& model) {
    std::vector<std::filesystem::path> all, alike;
    std::error_code error;
    const std::filesystem::path folder = model.has_parent_path() ? model.parent_path() : std::filesystem::path(".");
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::filesystem::path& path = entry->path();
        if (!is_image(path)) continue;
        if (path.stem() == model.stem()) return path;
        all.push_back(path);
        if (path.stem().string().starts_with(model.stem().string())) alike.push_back(path);
    }
    if (alike.size() == 1) return alike.front();
    return all.size() == 1 ? all.front() : std::filesystem::path();
}

}  // namespace

RawModel read_md2(std::span<const std::byte> bytes, const std::string& name, const Progress& progress) {
    return Md2Reader(bytes, name).read(progress);
}

RawModel read_md2(const std::filesystem::path& path, const Progress& progress) {
    const std::string bytes = read_file(path, largest_file);
    RawModel raw = read_md2(std::as_bytes(std::span(bytes)), path.string(), progress);
    TextureFinder textures(path);
    Material& material = raw.materials[0];
    const std::string embedded = std::exchange(material.texture_name, {});
    std::filesystem::path skin = textures.find(embedded);
    if (skin.empty()) skin = guess_skin(path);
    if (!skin.empty()) {
        textures.attach(material, skin.filename().string());
    } else if (!embedded.empty()) {
        warn("{}: skin {} not found; drawn without it", path.string(), embedded);
    }
    if (material.texture) material.diffuse = glm::vec3(1.0f);
    material.ambient = default_ambient(material.diffuse);
    return raw;
}

}  // namespace croquis::model
