// The component `lines`: pictures against projected edges, widths, and what is done again and what is not.
#include <glm/vec4.hpp>

#include "components/ink.h"
#include "components/register.h"
#include "support/errors.h"
#include "support/studio.h"

namespace croquis::components {
namespace {

using namespace test_support;

class Lines : public StudioTest {};

// Where a point of the model stands in the picture, pixels of the frame.
glm::dvec2 place_of(const Stage& stage, const glm::dvec3& point, int scale) {
    const model::Camera& camera = stage.camera();
    const glm::dvec3 from_eye = model::SceneSpace::of(stage.model()).from_file(point) - camera.eye;
    const double distance = -glm::dot(from_eye, camera.back), aspect = double(stage.width()) / stage.height();
    const double x = glm::dot(from_eye, camera.right) / (distance * camera.tangent * aspect);
    const double y = glm::dot(from_eye, camera.up) / (distance * camera.tangent);
    return {(x + 1) * 0.5 * stage.width() * scale, (1 - y) * 0.5 * stage.height() * scale};
}

// The edges of the cube from -1 to 1 that an eye sees which has all coordinates above 1: those with a face towards it.
std::vector<Spine> seen_edges_of_cube(const Stage& stage, double stroke_width, int scale,
                                      const glm::dvec3& moved = {}) {
    std::vector<Spine> spines;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double a : {-1.0, 1.0}) {
            for (const double b : {-1.0, 1.0}) {
                if (a < 0 && b < 0) continue;
                glm::dvec3 from, to;
                from[axis] = -1;
                to[axis] = 1;
                from[(axis + 1) % 3] = to[(axis + 1) % 3] = a;
                from[(axis + 2) % 3] = to[(axis + 2) % 3] = b;
                Spine spine;
                spine.points = {place_of(stage, from + moved, scale), place_of(stage, to + moved, scale)};
                spine.widths.assign(2, stroke_width * scale);
                spines.push_back(std::move(spine));
            }
        }
    }
    return spines;
}

constexpr const char* cube_lines =
    "pass lines l { clean false ; contour_width 3 ; silhouette_width 3 ; crease_width 3 ; } ;";

TEST_F(Lines, AreTheSeenEdgesOfACube) {
    for (const int scale : {1, 2}) {
        Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120, .pixel_scale = scale});
        const image::Image picture = stage.picture(cube_lines);
        const InkDifference apart =
            difference(picture, coverage(seen_edges_of_cube(stage, 3, scale), 160 * scale, 120 * scale));
        EXPECT_LT(apart.largest, 0.35) << "scale " << scale;  // where contour and crease meet, both blend
        EXPECT_LT(apart.mean, 0.002) << "scale " << scale;
    }
}

TEST_F(Lines, OfAnAnimatedModelAreThoseOfItsPose) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const auto technique = studio().open(cube_lines);
    stage.draw(*technique);
    model::Pose pose;
    for (const model::Mesh& mesh : stage.model().meshes) {
        pose.push_back({mesh.positions, mesh.normals});
        for (glm::vec3& position : pose.back().positions) position += glm::vec3(0.2f, -0.1f, 0.1f);
    }
    stage.scene().set_pose(std::move(pose));
    const image::Raster<double> moved = coverage(seen_edges_of_cube(stage, 3, 1, {0.2, -0.1, 0.1}), 160, 120);
    EXPECT_LT(difference(stage.picture(*technique), moved).mean, 0.002);
    stage.scene().clear_pose();
    const image::Raster<double> still = coverage(seen_edges_of_cube(stage, 3, 1), 160, 120);
    EXPECT_LT(difference(stage.picture(*technique), still).mean, 0.002);
}

double ink_of(const image::Image& picture) {
    double sum = 0;
    for (const glm::u8vec4& pixel : picture.pixels()) sum += 1.0 - pixel.x / 255.0;
    return sum;
}

TEST_F(Lines, OfAClassAreAsWideAsAsked) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const auto ink = [&](const std::string& values) {
        return ink_of(stage.picture("pass lines l { " + values + " } ;"));
    };
    const double creases = ink("classes \"crease\" ; crease_width 2 ;");
    EXPECT_GT(creases, 100);
    EXPECT_NEAR(ink("classes \"crease\" ; crease_width 1 ; width 4 ;") / creases, 2.0, 0.05);
    EXPECT_EQ(ink("classes \"crease\" ; crease_width 0 ;"), 0);
    EXPECT_EQ(ink("classes \"crease\" ; crease_angle 100 ;"), 0);
    EXPECT_EQ(ink("classes \"\" ;"), 0);
    // All edges of a cube are creases; those that are contours as well count as these where both are asked for.
    EXPECT_NEAR(ink("classes \"contour crease\" ; contour_width 2 ; crease_width 2 ;"), creases, 0.02 * creases);
    EXPECT_NEAR(ink("classes \"contour crease\" ; contour_width 2 ; crease_width 0 ;"),
                ink("classes \"contour\" ; contour_width 2 ;"), 1.0);
}

TEST_F(Lines, HiddenOnesAreDrawnWhenAsked) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const auto ink = [&](const std::string& values) {
        return ink_of(
            stage.picture("pass lines l { contour_width 2 ; silhouette_width 2 ; crease_width 2 ;"
                          "hidden_width 2 ; hidden_color 0 0 0 1 ; " +
                          values + " } ;"));
    };
    const double seen = ink(""), all = ink("visibility \"none\" ;"), dashed = ink("hidden \"dashed\" ;");
    EXPECT_GT(all, 1.2 * seen) << "12 edges, of which 9 are seen";
    EXPECT_NEAR(dashed, seen + 0.8 * (all - seen), 0.1 * (all - seen)) << "dashes of 12 widths, gaps of 3";
}

TEST_F(Lines, LieInTheColoursAskedForOnWhatTheFrameHolds) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const image::Image picture = stage.picture(
        "pass background b { color 0.2 0.4 0.6 ; } ;"
        "pass lines l { keep_color true ; color 1 0 0 1 ; inner_color 1 1 1 1 ; width 3 ; } ;");
    std::map<int, int> pixels;
    for (const glm::u8vec4& p : picture.pixels()) ++pixels[p.x << 16 | p.y << 8 | p.z];
    EXPECT_GT(pixels[0x336699], 10000) << "background";
    EXPECT_GT(pixels[0xff0000], 500) << "contours";
    EXPECT_GT(pixels[0xffffff], 200) << "creases";
}

// Contours lie over creases: where three creases of the cube end at the outline, the outline is unbroken.
TEST_F(Lines, OutlinesLieOverInnerLines) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5}), .width = 160, .height = 120});
    const std::string white_creases = "inner_color 1 1 1 1 ; contour_width 4 ; crease_width 4 ;";
    const image::Image both = stage.picture("pass lines l { " + white_creases + " } ;");
    const image::Image outline = stage.picture("pass lines l { classes \"contour\" ; " + white_creases + " } ;");
    EXPECT_TRUE(same_pixels(both, outline)) << "white on white paper, and nothing taken from the outline";
}

TEST_F(Lines, OfOtherObjectsAreLeftOutButStillHide) {
    const ModelPointer boxes = model_of(
        {{"small", box_corners({-0.5f, -0.5f, -2}, {0.5f, 0.5f, -1})}, {"large", box_corners({-1, -1, 0}, {1, 1, 1})}});
    Stage stage(studio(), {.model = boxes, .view = seen_from({0, 0, 1}), .width = 160, .height = 120});
    EXPECT_GT(ink_of(stage.picture("pass lines l { objects \"large\" ; } ;")), 100);
    EXPECT_EQ(ink_of(stage.picture("pass lines l { objects \"small\" ; } ;")), 0) << "behind the large one";
}

TEST_F(Lines, AreFoundAndUploadedOnceAView) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5})});
    const auto technique = studio().open("pass render_base b {} ; pass lines l { keep_color true ; } ;");
    stage.draw(*technique);
    const gpu::Counters first = studio().counters();
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().geometry_uploads, first.geometry_uploads) << "nothing changed";
    stage.resize(80, 60);
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().geometry_uploads, first.geometry_uploads + 1) << "another view";
    technique->set("l", "width", 2.0f);
    stage.draw(*technique);
    EXPECT_EQ(studio().counters().geometry_uploads, first.geometry_uploads + 2) << "another width";
    EXPECT_EQ(studio().counters().read_backs, first.read_backs);
    EXPECT_EQ(studio().counters().programs_linked, first.programs_linked);
    EXPECT_EQ(studio().counters().live_geometries, first.live_geometries);
}

TEST_F(Lines, SayWhatIsWrong) {
    const auto technique = studio().open("pass lines l {} ;");
    const auto error_of_setting = [&](const char* name, const char* value) {
        return error_of([&] { technique->set("l", name, std::string(value)); });
    };
    EXPECT_EQ(error_of_setting("classes", "contour silhuette"),
              "expected a class of lines, found \"silhuette\"; did you mean \"silhouette\"?");
    EXPECT_EQ(error_of_setting("finder", "exaustive"),
              "expected a finder of silhouettes, found \"exaustive\"; did you mean \"exhaustive\"?");
    EXPECT_EQ(error_of_setting("style", "no such style"), "there is no stroke style \"no such style\"");
    Stage stage(studio(), {});
    EXPECT_GT(ink_of(stage.picture(*technique)), 100) << "the mistakes changed nothing";
    EXPECT_EQ(error_of([&] { (void)studio().open("pass lines l { classes \"all of them\" ; } ;"); }),
              "test.technique:1:1: pass \"l\": expected a class of lines, found \"of\"");
}

// What goes wrong on the other thread is told by the frame that needs it, each time, until it is set right.
TEST_F(Lines, MistakesOfTheOtherThreadReachTheFrame) {
    Stage stage(studio(), {.view = seen_from({1, 0.7, 1.5})});
    const auto technique = studio().open("pass lines l { finder \"gauss_map\" ; } ;");
    const std::string said = error_of([&] { stage.draw(*technique); });
    EXPECT_NE(said, "no error") << "Gauss maps do not serve perspective";
    EXPECT_EQ(error_of([&] { stage.draw(*technique); }), said);
    technique->set("l", "finder", std::string("automatic"));
    EXPECT_GT(ink_of(stage.picture(*technique)), 100);
}

// A component that only tells when it is called.
class Recorder final : public framework::Component {
public:
    Recorder(const framework::Pass& pass, std::vector<std::string>& calls) : Component(pass), calls_(calls) {}

protected:
    void prepare(framework::RenderContext&) override { calls_.push_back("prepare " + pass_.name()); }
    void render(framework::RenderContext&) override { calls_.push_back("render " + pass_.name()); }

private:
    std::vector<std::string>& calls_;
};

TEST_F(Lines, AllPassesPrepareBeforeTheFirstDraws) {
    std::vector<std::string> calls;
    const auto library = std::make_shared<const framework::Library>(studio().resources().folders());
    framework::ComponentTable table;
    table["background"] = [&](const framework::Pass& pass) { return std::make_unique<Recorder>(pass, calls); };
    const framework::TechniqueDefinition definition = framework::read_technique(
        "test",
        {"test.technique", "pass background a {} ; pass background b { render false ; } ; pass background c {} ;"},
        library->descriptors(), {});
    framework::Technique technique(library, definition, studio().resources(), table);
    Stage stage(studio(), {});
    stage.draw(technique);
    EXPECT_EQ(calls, (std::vector<std::string>{"prepare a", "prepare c", "render a", "render c"}));
}

// A pass that fails, so that the frame ends while lines are being found.
class Failing final : public framework::Component {
public:
    explicit Failing(const framework::Pass& pass) : Component(pass) {}

protected:
    void render(framework::RenderContext&) override { fail("no paper"); }
};

TEST_F(Lines, CanBeClosedWhileTheyAreFound) {
    const auto library = std::make_shared<const framework::Library>(studio().resources().folders());
    framework::ComponentTable table = core_components();
    table["background"] = [](const framework::Pass& pass) { return std::make_unique<Failing>(pass); };
    const framework::TechniqueDefinition definition = framework::read_technique(
        "test", {"test.technique", "pass background b {} ; pass lines l { keep_color true ; } ;"},
        library->descriptors(), {});
    Stage stage(studio(), {.model = icosphere(4)});
    for (int i = 0; i < 5; ++i) {
        framework::Technique technique(library, definition, studio().resources(), table);
        for (int frame = 0; frame <= i % 2; ++frame) {
            EXPECT_EQ(error_of([&] { stage.draw(technique); }), "no paper");
            stage.resize(64 + i, 48);
        }
    }
}

}  // namespace
}  // namespace croquis::components
