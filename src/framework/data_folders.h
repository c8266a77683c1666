// Where shipped and the user's own descriptors, techniques, shaders and textures are found.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace croquis::framework {

/// Data folders in order of precedence: the user's own first, the shipped one last.
class DataFolders {
public:
    /// Throws Error for a folder that does not exist.
    explicit DataFolders(std::vector<std::filesystem::path> folders);

    /// The user's folders and then the shipped one: the environment's CROQUIS_DATA, else beside the program, else where
    /// it was installed, else where it was built. Throws Error saying where it looked.
    [[nodiscard]] static DataFolders find(const std::vector<std::filesystem::path>& users_own = {});

    [[nodiscard]] const std::vector<std::filesystem::path>& folders() const { return folders_; }

    /// The first file `kind/name + ending` that exists, or an empty path. Throws Error for a name that leaves its
    /// folder
    /// ("../secret", "/etc/passwd") or goes through a link out of it.
    [[nodiscard]] std::filesystem::path find(const std::string& kind, const std::string& name,
                                             const std::string& ending) const;

    /// The names, without ending, of all files `kind/*ending`, sorted, each once.
    [[nodiscard]] std::vector<std::string> names(const std::string& kind, const std::string& ending) const;

private:
    std::vector<std::filesystem::path> folders_;
};

/// Throws Error when a name could leave its folder.
void check_stays_inside(const std::string& name);

}  // namespace croquis::framework
