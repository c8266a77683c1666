#include "built_in_model.h"

#include <filesystem>

#include "base/error.h"
#include "framework/data_folders.h"

namespace croquis::app {
namespace {

constexpr const char* built_in_model = "teapot";

}  // namespace

std::string built_in_model_path(const Common& common) {
    const auto folders = framework::DataFolders::find({common.data_folders.begin(), common.data_folders.end()});
    const std::filesystem::path path = folders.find("models", built_in_model, ".obj");
    if (path.empty()) fail("no built-in model: no data folder has models/{}.obj", built_in_model);
    return path.string();
}

}  // namespace croquis::app
