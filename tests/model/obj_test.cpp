// Our own OBJ reader, and what `finish` makes of doubtful models.
#include <cmath>

#include "fixtures.h"
#include "model/posed_shape.h"

namespace croquis::model::testing {
namespace {

double area_of(const Model& model) {
    double area = 0;
    for (const Mesh& mesh : model.meshes) {
        for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
            const auto p = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.triangles[t + k]]); };
            area += 0.5 * glm::length(glm::cross(p(1) - p(0), p(2) - p(0)));
        }
    }
    return area;
}

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(Obj, ReadsTheWaysOfWritingAFace) {
    const std::string lists = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n";
    for (const char* face :
         {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1", "f -3 -2 -1",
          "f -3/-3/-1 -2/-2/-1 -1/-1/-1", "f 1/ 2/ 3/", "f 1 \\\n2 \\\r\n 3", "f 1 2 3 # triangle", "f\t1  2\t3  \r"}) {
        const auto model = load_text("face.obj", lists + face);
        EXPECT_EQ(model->triangle_count(), 1u) << face;
        EXPECT_EQ(model->meshes[0].positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})) << face;
    }
}

// Row M6: lines along edges mark them; lines elsewhere mark nothing.
TEST(Obj, LinesTagTheEdgesTheyRunAlong) {
    for (const char* offset : {"0", "1e7"}) {
        std::string text;
        for (const char* corner : {"0 0", "2 0", "2 2", "0 2"}) text += fmt::format("v {} {}\n", offset, corner);
        const auto model = load_text("square.obj", text + "f 1 2 3\nf 1 3 4\nl 3 1\nl 2 4\nl 1 2 9\n");
        const Topology& topology = model->topology();
        ASSERT_EQ(topology.tagged_edges.size(), 2u) << offset;  // the diagonal 1-3 and the side 1-2
        std::size_t borders = 0;
        for (const std::uint32_t index : topology.tagged_edges) {
            borders += topology.edges[index].faces[1] == no_face ? 1 : 0;
        }
        EXPECT_EQ(borders, 1u) << offset;
    }
}

TEST(Obj, CutsConcavePolygonsWithinTheirOutline) {
    // An L of three unit squares, from each of its corners, wound both ways.
    const std::vector<glm::vec2> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const bool backwards : {false, true}) {
        for (std::size_t start = 0; start < outline.size(); ++start) {
            std::string text, face = "f";
            for (const glm::vec2& p : outline) text += fmt::format("v {} {} 0.5\n", p.x, p.y);
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const std::size_t corner = (start + (backwards ? outline.size() - i : i)) % outline.size();
                face += fmt::format(" {}", corner + 1);
            }
            const auto model = load_text("l.obj", text + face);
            EXPECT_EQ(model->triangle_count(), 4u);
            EXPECT_NEAR(area_of(*model), 3.0, 1e-6);
            for (const glm::vec3& normal : posed_shape(*model, nullptr).face_normals)
                EXPECT_EQ(normal.z, backwards ? -1.0f : 1.0f);
        }
    }
}

TEST(Obj, NamesAndMaterialsMakeMeshesAndRegions) {
    const auto model = load_text("cube.obj", std::string(cube_points) +
                                                 "usemtl red\nf 4 3 2 1\nf 5 6 7 8\nusemtl blue\nf 1 2 6 5\nf 2 3 7 6\n"
                                                 "usemtl red\nf 3 4 8 7\nf 4 1 5 8\n");
    ASSERT_EQ(model->meshes.size(), 2u);
    EXPECT_EQ(model->meshes[0].triangle_count(), 8u);
    EXPECT_EQ(model->meshes[1].triangle_count(), 4u);
    EXPECT_EQ(model->meshes[0].region, 1u);
    EXPECT_EQ(model->meshes[1].region, 2u);
    EXPECT_EQ(model->materials[model->meshes[1].material].name, "blue");
    // The two blue squares share an edge; the other six of their sides are the border between the regions.
    std::size_t between = 0;
    const Topology& topology = model->topology();
    for (const Edge& edge : topology.edges) {
        const auto region = [&](std::size_t k) { return model->meshes[topology.faces[edge.faces[k]].mesh].region; };
        between += region(0) != region(1) ? 1 : 0;
    }
    EXPECT_EQ(between, 6u);
}

TEST(Obj, ObjectsAndGroupsNameMeshes) {
    const auto model = load_text("names.obj",
                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\no chair\nf 1 2 4\n"
                                 "g left leg\nf 1 3 4\no table\nf 2 3 4\n");
    ASSERT_EQ(model->meshes.size(), 4u);
    EXPECT_EQ(model->meshes[0].name, "");
    EXPECT_EQ(model->meshes[1].name, "chair");
    EXPECT_EQ(model->meshes[2].name, "chair/left leg");
    EXPECT_EQ(model->meshes[3].name, "table");
}

TEST(Obj, SixNumbersAreAColoredPoint) {
    const auto model = load_text("colors.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(model->meshes[0].colors,
              (std::vector<glm::u8vec4>{{255, 0, 0, 255}, {0, 128, 0, 255}, {255, 255, 255, 255}}));
}

TEST(Obj, MaterialsComeFromTheirFile) {
    const TemporaryFolder folder;
    // A 2x1 image in PNM: red, green.
    folder.write("Skin One.ppm", std::string("P6\n2 1\n255\n\xff\x00\x00\x00\xff\x00", 17));
    folder.write(
        "the materials.mtl",
        "newmtl plain\nKd 0.2 0.4 0.6\nnewmtl washed\nKa 1 1 1\nKd 0.5 0.5 0.5\nKs 0.25 0.5 0.75\nNs 200\nd 0.5\n"
        "newmtl dark\nKa 0.1 0.1 0.1\nTr 0.25\nNs 0\nnewmtl skin\n"
        "map_Kd -s 1 1 1 -clamp on C:\\textures\\skin one.ppm\nnewmtl bare\nmap_Kd nowhere.png\n");
    const auto model = load(folder.write(
        "m.obj",
        "mtllib the materials.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl plain\nf 1 2 3\nusemtl washed\nf 1 2 3\n"
        "usemtl dark\nf 1 2 3\nusemtl skin\nf 1 2 3\nusemtl bare\nf 1 2 3\nusemtl unheard of\nf 1 2 3\n"));
    ASSERT_EQ(model->materials.size(), 6u);
    const Material &plain = model->materials[0], &washed = model->materials[1], &dark = model->materials[2];
    EXPECT_EQ(plain.diffuse, glm::vec3(0.2f, 0.4f, 0.6f));
    EXPECT_LT(glm::length(plain.ambient - 0.15f * plain.diffuse), 1e-6f);
    EXPECT_EQ(plain.specular, glm::vec3(0.0f));
    EXPECT_EQ(plain.shininess, 32.0f);
    EXPECT_LT(glm::length(washed.ambient - glm::vec3(0.075f)), 1e-6f);
    EXPECT_EQ(washed.specular, glm::vec3(0.25f, 0.5f, 0.75f));
    EXPECT_EQ(washed.shininess, 200.0f);
    EXPECT_EQ(washed.opacity, 0.5f);
    EXPECT_EQ(dark.ambient, glm::vec3(0.1f));
    EXPECT_EQ(dark.opacity, 0.75f);
    EXPECT_EQ(dark.shininess, 32.0f);
    ASSERT_TRUE(model->materials[3].texture);
    EXPECT_EQ(model->materials[3].texture->at(1, 0), glm::u8vec4(0, 255, 0, 255));
    EXPECT_FALSE(model->materials[4].texture);
    EXPECT_EQ(model->materials[5].name, "unheard of");
}

TEST(Obj, WithoutMaterialsItHasTheDefaults) {
    for (const char* use : {"", "usemtl unheard of\n"}) {
        const auto model = load_text("m.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + use + "f 1 2 3\n");
        ASSERT_EQ(model->materials.size(), 1u);
        const Material &given = model->materials[0], defaults;
        EXPECT_LT(glm::length(given.ambient - defaults.ambient), 1e-6f);
        EXPECT_EQ(given.diffuse, defaults.diffuse);
        EXPECT_EQ(given.specular, defaults.specular);
        EXPECT_EQ(given.shininess, defaults.shininess);
        EXPECT_EQ(given.opacity, defaults.opacity);
    }
}

TEST(Obj, DropsTrianglesWithMissingVerticesWithOneWarning) {
    ::testing::internal::CaptureStderr();
    const auto model = load_text("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
    const std::string warning = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(model->triangle_count(), 1u);
    EXPECT_TRUE(warning.ends_with("m.obj: left out 1 triangle with vertices that the file does not have\n")) << warning;
    EXPECT_EQ(std::count(warning.begin(), warning.end(), '\n'), 1);
}

TEST(Obj, FarFromItsOriginItKeepsItsDetail) {
    const auto model = load_text("far.obj", sphere(10, 10, 0.001, 1e6));
    EXPECT_NEAR(model->origin.x, 1e6, 0.01);
    EXPECT_NEAR(model->bounds.radius(), 0.001 * std::sqrt(3.0), 1e-4);
    EXPECT_EQ(model->topology().positions.size(), 2u + 9u * 10u);
    EXPECT_TRUE(model->topology().mesh_is_solid[0]);
    EXPECT_EQ(load_text("near.obj", sphere(10, 10, 1, 5))->origin, glm::dvec3(0.0));
}

TEST(Obj, DropsWhatCannotBeDrawn) {
    const auto model =
        load_text("doubtful.obj", std::string(triangle) +
                                      "v nan 0 0\nv inf 0 0\nv 2 0 0\nv 1e30 0 0\n"
                                      "f 1 2 4\nf 1 2 5\nf 1 2 99\nf 0 1 2\nf -40 1 2\nf 1 1 2\nf 1 2 6\nf 1 2 7\n");
    EXPECT_EQ(model->triangle_count(), 1u);
    EXPECT_EQ(model->vertex_count(), 3u);
}

TEST(Obj, RefusesWithOneClearLine) {
    struct Case {
        const char* text;
        const char* error;
    };
    for (const Case& c : {
             Case{"", "x.obj: expected triangles, found none"},
             Case{"# nothing\n", "x.obj: expected triangles, found none"},
             Case{"v 0 0 0\nv 1 0 0\nl 1 2\n", "x.obj: expected triangles, found only lines and points"},
             Case{"v 0 0 0\np 1\n", "x.obj: expected triangles, found only lines and points"},
             Case{"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "x.obj: expected triangles, found 1 of no area"},
             Case{"v 0 0\n", "x.obj:1: expected a number, found the end of the line"},
             Case{"v 0 0 0\n\nv 0 zero 0\n", "x.obj:3: expected a number, found \"zero\""},
             Case{"v 0 0 0\nf 1 a 2\n", "x.obj:2: expected a vertex index, found something else"},
             Case{"v 0 0 0\nf 1;1 1 1\n", "x.obj:2: expected corners such as 1/2/3, found \" 1;1 1 1\""},
             Case{"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 7 8 9\n",
                  "x.obj: expected triangles, found 1 with vertices that the file does not have"},
             Case{"v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\nf 1 2 4\n",
                  "x.obj: expected triangles, found 1 with vertices that the file does not have and 2 with points that "
                  "are no "
                  "finite numbers below 1e18"},
         }) {
        EXPECT_EQ(error_of("x.obj", c.text), c.error);
    }
    const std::string utf16("\xff\xfe#\0\n\0v\0", 8), unmarked("v\0 \0000\0 \0", 8);
    EXPECT_EQ(error_of("x.obj", utf16), "x.obj: expected UTF-8 text, found UTF-16");
    EXPECT_EQ(error_of("x.obj", unmarked), "x.obj: expected UTF-8 text, found UTF-16");
}

TEST(Obj, TakesAnyLineEndAndAByteOrderMark) {
    for (const char* text :
         {"\xef\xbb\xbfv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"}) {
        EXPECT_EQ(load_text("ends.obj", text)->triangle_count(), 1u);
    }
}

TEST(Obj, LinesLongerThanTheBufferAreRead) {
    std::string text = triangle, face = "f";
    for (int i = 0; i < 200000; ++i) face += " 1 2 3";
    EXPECT_EQ(load_text("long.obj", text + "# " + std::string(3'000'000, 'x') + "\nf 2 3 1\n")->triangle_count(), 2u);
    EXPECT_NO_THROW(static_cast<void>(load_text("long.obj", text + face + "\n")));
}

TEST(Load, RefusesOtherFiles) {
    EXPECT_EQ(
        error_of("x.objj", "v"),
        "x.objj: expected a model file (.obj .md2 .wrl .off .ase .ply .stl .gltf .glb .3ds), found ending .objj; did "
        "you mean \".obj\"?");
    EXPECT_EQ(error_of("x", "v"),
              "x: expected a model file (.obj .md2 .wrl .off .ase .ply .stl .gltf .glb .3ds), found no ending");
    try {
        static_cast<void>(load("no-such-folder/no-such.obj"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "no-such-folder/no-such.obj: no such file");
    }
}

TEST(Load, GivesEveryMaterialTheChosenTexture) {
    const TemporaryFolder folder;
    LoadOptions options;
    options.texture = folder.write("t.ppm", std::string("P6\n1 1\n255\n\x01\x02\x03", 14));
    const auto model = load(folder.write("x.obj", triangle), options);
    ASSERT_TRUE(model->materials[0].texture);
    EXPECT_EQ(model->materials[0].texture->at(0, 0), glm::u8vec4(1, 2, 3, 255));
}

}  // namespace
}  // namespace croquis::model::testing
