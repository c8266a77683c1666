// Every sample file of the promised formats loads, or is refused with one clear line.
#include <algorithm>
#include <chrono>

#include "fixtures.h"

namespace croquis::model::testing {
namespace {

std::vector<std::filesystem::path> samples() {
    const std::vector<std::string> endings = readable_endings();
    std::vector<std::filesystem::path> paths;
    for (const char* folder : {"OBJ", "MD2", "OFF", "ASE", "PLY", "STL", "glTF", "glTF2", "3DS", "WRL", "invalid"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(sample_folder / folder)) {
            std::string ending = entry.path().extension().string();
            std::transform(ending.begin(), ending.end(), ending.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
            if (std::find(endings.begin(), endings.end(), ending) != endings.end()) paths.push_back(entry.path());
        }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

void expect_sound(const Model& model, const std::string& name) {
    EXPECT_GT(model.triangle_count(), 0u) << name;
    for (const Mesh& mesh : model.meshes) {
        ASSERT_EQ(mesh.normals.size(), mesh.positions.size()) << name;
        EXPECT_TRUE(mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size()) << name;
        EXPECT_TRUE(mesh.colors.empty() || mesh.colors.size() == mesh.positions.size()) << name;
        EXPECT_LT(mesh.material, model.materials.size()) << name;
        EXPECT_GT(mesh.region, 0u) << name;
        EXPECT_GT(mesh.triangle_count(), 0u) << name;
        for (const std::uint32_t corner : mesh.triangles) ASSERT_LT(corner, mesh.positions.size()) << name;
        for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-4f) << name;
    }
    EXPECT_EQ(model.topology().faces.size(), model.triangle_count()) << name;
    for (const AnimationClip& clip : model.clips) {
        for (const MeshPose& pose : pose_at(model, clip, 0.4 * clip.seconds)) {
            for (const glm::vec3& p : pose.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << name << clip.name;
        }
    }
}

TEST(Formats, EverySampleLoadsOrIsRefusedInOneLine) {
    std::size_t loaded = 0, refused = 0;
    for (const std::filesystem::path& path : samples()) {
        const auto start = std::chrono::steady_clock::now();
        try {
            expect_sound(*load(path), path.string());
            ++loaded;
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
            EXPECT_NE(message.find(path.string() + ":"), std::string::npos) << message;
            EXPECT_NE(message.back(), '.') << message;
            ++refused;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << path;
    }
    EXPECT_EQ(loaded + refused, samples().size());
    EXPECT_GE(loaded, 75u);
}

TEST(Formats, RefusalsAreClear) {
    struct Case {
        const char* file;
        const char* error;
    };
    for (const Case& c : {
             Case{"OBJ/box_UTF16BE.obj", "expected UTF-8 text, found UTF-16"},
             Case{"OBJ/point_cloud.obj", "expected triangles, found only lines and points"},
             Case{"PLY/points.ply", "expected triangles, found only lines and points"},
             Case{"ASE/ThreeCubesGreen_UTF16LE.ASE", "expected UTF-8 text, found UTF-16"},
             Case{"OFF/invalid.off", "expected triangles, found 2 of no area"},
             Case{"invalid/OutOfMemory.off", "expected room for 353535235358 vertices, found a file of 309 bytes"},
             Case{"invalid/empty.ply", "expected a model, found an empty file"},
             Case{"glTF2/RecursiveNodes/RecursiveNodes.gltf",
                  "expected nodes at most 200 deep, found node 0 deeper or in a circle"},
             Case{"glTF2/MissingBin/BoxTextured.gltf",
                  "expected a sound gltf file, found: GLTF: could not open referenced file \"BoxTextured0.bin\""},
         }) {
        const std::filesystem::path path = sample_folder / c.file;
        try {
            static_cast<void>(load(path));
            ADD_FAILURE() << c.file << " loaded";
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()), path.string() + ": " + c.error);
        }
    }
}

TEST(Formats, OneModelIsTheSameInAllOfThem) {
    const auto wanted = load(sample_folder / "OBJ/WusonOBJ.obj");
    EXPECT_EQ(wanted->triangle_count(), 3732u);
    for (const char* file : {"WRL/Wuson.wrl", "PLY/Wuson.ply", "STL/Wuson.stl", "OFF/Wuson.off"}) {
        const auto model = load(sample_folder / file);
        EXPECT_EQ(model->triangle_count(), wanted->triangle_count()) << file;
        EXPECT_EQ(model->topology().positions.size(), wanted->topology().positions.size()) << file;
        EXPECT_EQ(model->topology().edges.size(), wanted->topology().edges.size()) << file;
        EXPECT_NEAR(model->bounds.radius(), wanted->bounds.radius(), 1e-4f) << file;
    }
    const auto vrml = load(sample_folder / "WRL/Wuson.wrl");
    // The VRML sample was written with z up: the same box, turned about x.
    const glm::vec3 &low = wanted->bounds.low, &high = wanted->bounds.high;
    EXPECT_LT(glm::length(vrml->bounds.low - glm::vec3(low.x, low.z, -high.y)), 1e-4f);
    EXPECT_LT(glm::length(vrml->bounds.high - glm::vec3(high.x, high.z, -low.y)), 1e-4f);
}

TEST(Formats, AVrmlSceneThatUsesItselfIsRefused) {
    EXPECT_EQ(error_of("x.wrl", "#VRML V2.0 utf8\nDEF A Group { children [ USE A ] }"),
              "x.wrl: expected nodes that do not use themselves, found A");
    EXPECT_EQ(error_of("x.wrl", "#VRML V2.0 utf8\nPROTO P [] { P {} } P {}"),
              "x.wrl: expected nodes that do not use themselves, found P");
    EXPECT_EQ(error_of("x.wrl", "#VRML V2.0 utf8\nInline { url \"x.wrl\" }"),
              "x.wrl: expected a scene in one file, found Inline of another");
    EXPECT_EQ(error_of("x.wrl", "#VRML V1.0 ascii\nCube {}"), "x.wrl: expected VRML V2.0, found V1.0");
    EXPECT_EQ(error_of("x.wrl", "#VRML V2.0 utf8\n" + std::string(100000, '{')),
              "x.wrl: expected brackets nested at most 200 deep, found more");
    EXPECT_EQ(error_of("x.wrl", "#VRML V2.0 utf8\nGroup { children ["),
              "x.wrl: expected a sound VRML file, found: Coin read error: Premature end of file");
}

TEST(Formats, VrmlGivesMaterialsAndShapes) {
    const auto model =
        load_text("x.wrl",
                  "#VRML V2.0 utf8\nDEF red Shape { appearance Appearance { material Material { diffuseColor 1 "
                  "0 0 transparency 0.25 } } geometry Box {} }\nTransform { translation 5 0 0 children [ Shape "
                  "{ geometry Sphere {} } ] }");
    ASSERT_EQ(model->meshes.size(), 2u);
    EXPECT_EQ(model->meshes[0].name, "red");
    EXPECT_EQ(model->materials[0].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(model->materials[0].opacity, 0.75f);
    EXPECT_NEAR(model->bounds.high.x, 6.0f, 0.02f);
    EXPECT_TRUE(model->topology().mesh_is_solid[0]);
    EXPECT_FALSE(model->topology().mesh_is_inverted[1]);
}

}  // namespace
}  // namespace croquis::model::testing
