// What the viewer reads and writes: settings, cameras as text, watched files, models beside the window.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "api/shapes.h"
#include "support/errors.h"
#include "support/temporary_folder.h"
#include "viewer/command_line.h"
#include "viewer/file_watch.h"
#include "viewer/messages.h"
#include "viewer/model_loader.h"
#include "viewer/settings.h"

namespace croquis::viewer {
namespace {

using test_support::error_of;
using test_support::TemporaryFolder;

TEST(SettingsTest, AreReadAsTheyWereWritten) {
    const TemporaryFolder folder;
    Settings settings;
    settings.remember_model("/models/a \"b\".obj");
    settings.remember_model("/models/c.obj");
    settings.technique = "edges";
    settings.window_width = 800;
    settings.ui_scale = 1.5;
    settings.samples = 9;
    settings.shows_overlay = true;
    settings.video = ".webm";
    settings.moves = Moves::light;
    settings.light_stays_with = LightStaysWith::world;
    const auto path = folder.path() / "new" / "viewer.toml";
    settings.save(path);
    const Settings read = Settings::load(path);
    EXPECT_EQ(read.recent_models, (std::vector<std::string>{"/models/c.obj", "/models/a \"b\".obj"}));
    EXPECT_EQ(read.technique, "edges");
    EXPECT_EQ(read.window_width, 800);
    EXPECT_EQ(read.ui_scale, 1.5);
    EXPECT_EQ(read.samples, 9);
    EXPECT_TRUE(read.shows_overlay);
    EXPECT_EQ(read.video, ".webm");
    EXPECT_EQ(read.moves, Moves::light);
    EXPECT_EQ(read.light_stays_with, LightStaysWith::world);
}

TEST(SettingsTest, WhatIsWrongStaysAsItComes) {
    const TemporaryFolder folder;
    const auto path = folder.write("viewer.toml", "technique = 5\nwindow_width = -3\nmoves = \"moon\"\nsamples = 4\n");
    const Settings read = Settings::load(path);
    EXPECT_EQ(read.technique, Settings().technique);
    EXPECT_EQ(read.window_width, Settings().window_width);
    EXPECT_EQ(read.moves, Moves::object);
    EXPECT_EQ(Settings::load(folder.write("broken.toml", "technique = [")).technique, Settings().technique);
    EXPECT_EQ(Settings::load(folder.path() / "none.toml").technique, Settings().technique);
}

TEST(SettingsTest, RecentModelsAreEachOnceTheNewestFirst) {
    Settings settings;
    for (int i = 0; i < 20; ++i) settings.remember_model(fmt::format("{}.obj", i));
    settings.remember_model("15.obj");
    EXPECT_EQ(settings.recent_models.size(), Settings::most_recent);
    EXPECT_EQ(settings.recent_models[0], "15.obj");
    EXPECT_EQ(std::count(settings.recent_models.begin(), settings.recent_models.end(), "15.obj"), 1);
}

TEST(CameraText, IsReadAsItWasWritten) {
    View view;
    view.eye = Vector3{1.25, -2, 1e-7};
    view.target = Vector3{0.1, 0.2, 0.3};
    view.up = {0, 0, 1};
    view.field_of_view = 33.3;
    view.parallel = true;
    for (const auto bound : {Light::Bound::viewer, Light::Bound::world, Light::Bound::point}) {
        const Light light{.bound = bound, .place = {-1, 0.5, 2}, .color = {1, 0.5, 0.25}};
        View read_view;
        Light read_light;
        read_camera_and_light("croquis render a.obj " + camera_and_light(view, light) + " -o b.png", read_view,
                              read_light);
        EXPECT_EQ(read_view.eye, view.eye);
        EXPECT_EQ(read_view.target, view.target);
        EXPECT_EQ(read_view.up, view.up);
        EXPECT_EQ(read_view.field_of_view, view.field_of_view);
        EXPECT_EQ(read_view.parallel, view.parallel);
        EXPECT_EQ(read_light.bound, light.bound);
        EXPECT_EQ(read_light.place, light.place);
        EXPECT_EQ(read_light.color, light.color);
    }
}

TEST(CameraText, MistakesAreTold) {
    View view;
    Light light;
    const auto read = [&](const std::string& text) {
        return error_of([&] { read_camera_and_light(text, view, light); });
    };
    EXPECT_EQ(read("good day"), "expected a camera or a light, as --eye X,Y,Z, found none");
    EXPECT_EQ(read("--eye 1,2"), "--eye: expected X,Y,Z, found \"1,2\"");
    EXPECT_EQ(read("--eye 1,2,nan"), "--eye: expected X,Y,Z, found \"1,2,nan\"");
    EXPECT_EQ(read("--fov wide"), "--fov: expected a number, found \"wide\"");
    EXPECT_EQ(read("--light moon:1,2,3"), "--light: expected viewer:, world: or point:X,Y,Z, found \"moon:1,2,3\"");
    EXPECT_EQ(read("--fov 30 --eye 1,2"), "--eye: expected X,Y,Z, found \"1,2\"");
    EXPECT_EQ(read("--eye 1,2,3 --target 1,2,3"), "--eye: expected it away from the target, found both at 1,2,3");
    EXPECT_EQ(read("--eye 0,5,0 --target 0,0,0 --up 0,2,0"),
              "--up: expected a direction across the line of sight, found 0,2,0");
    EXPECT_EQ(read("--fov 200"), "--fov: expected 1 to 170 degrees, found 200");
    EXPECT_EQ(read("--light viewer:0,0,0"), "--light: expected it away from 0,0,0, found 0,0,0");
    EXPECT_EQ(view.field_of_view, View().field_of_view) << "a mistake changes nothing";
    EXPECT_FALSE(view.eye);
}

TEST(CommandLine, WordsAreQuotedForAShell) {
    EXPECT_EQ(shell_word("plain-word_1.obj"), "plain-word_1.obj");
    EXPECT_EQ(shell_word("two words"), "'two words'");
    EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
    EXPECT_EQ(shell_word(""), "''");
}

TEST(CommandLine, FilesAreNoOptionsAndFoldersAreNamed) {
    const std::string command = render_command("-c.obj", "", "plain", {}, {}, {"my data"});
    EXPECT_TRUE(command.starts_with("croquis render ./-c.obj -t plain --data 'my data' ")) << command;
}

TEST(FileWatchTest, NoticesChangesNewFilesAndTheirEnd) {
    const TemporaryFolder folder;
    const auto file = folder.write("sub/a.glsl", "one");
    FileWatch watch;
    watch.watch({folder.path(), folder.path() / "not_there"});
    EXPECT_FALSE(watch.has_changed());
    folder.write("sub/a.glsl", "three");
    EXPECT_TRUE(watch.has_changed());
    EXPECT_FALSE(watch.has_changed());
    folder.write("sub/b.glsl", "");
    EXPECT_TRUE(watch.has_changed());
    std::filesystem::remove(file);
    EXPECT_TRUE(watch.has_changed());
    EXPECT_FALSE(watch.has_changed());
}

TEST(FileWatchTest, AnotherPlaceHidesNoChange) {
    const TemporaryFolder folder;
    const auto file = folder.write("a.technique", "one");
    FileWatch watch;
    watch.watch({file});
    folder.write("a.technique", "three");
    watch.watch({file, folder.write("b.technique", "")});
    EXPECT_TRUE(watch.has_changed());
    EXPECT_FALSE(watch.has_changed());
    watch.watch({});
    folder.write("a.technique", "another");
    EXPECT_FALSE(watch.has_changed());
}

TEST(MessagesTest, AnExcerptPointsAtTheMistake) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a:b.technique", "help \"x\" ;\n  pass nothing ;\n").string();
    EXPECT_EQ(excerpt(file + ":2:8: unknown component"), "  pass nothing ;\n       ^");
    EXPECT_EQ(excerpt(file + ":2: unknown component"), "  pass nothing ;");
    EXPECT_EQ(excerpt(file + ":9:1: beyond its end"), "");
    EXPECT_EQ(excerpt("unknown technique \"a:b\""), "");
    EXPECT_EQ(excerpt("/nowhere/a.technique:1:1: gone"), "");
}

std::optional<ModelLoader::Arrival> wait_for(ModelLoader& loader) {
    for (int i = 0; i < 2000; ++i) {
        if (auto arrival = loader.take()) return arrival;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::nullopt;
}

TEST(ModelLoaderTest, BringsTheModelOrTheMistake) {
    const TemporaryFolder folder;
    ModelLoader loader;
    loader.start(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string(), "");
    EXPECT_TRUE(loader.is_reading());
    const auto arrival = wait_for(loader);
    ASSERT_TRUE(arrival && arrival->model);
    EXPECT_EQ(arrival->model->triangle_count(), 1u);
    EXPECT_FALSE(loader.is_reading());
    loader.start((folder.path() / "none.obj").string(), "");
    const auto mistake = wait_for(loader);
    ASSERT_TRUE(mistake);
    EXPECT_FALSE(mistake->model);
    EXPECT_NE(mistake->error.find("none.obj: no such file"), std::string::npos) << mistake->error;
}

TEST(ModelLoaderTest, WhatIsCancelledNeverArrives) {
    const TemporaryFolder folder;
    ModelLoader loader;
    loader.start(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string(), "");
    loader.cancel();
    EXPECT_FALSE(loader.is_reading());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_FALSE(loader.take());
}

}  // namespace
}  // namespace croquis::viewer
