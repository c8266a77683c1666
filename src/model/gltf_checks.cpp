// glTF files that Assimp 5.2 would follow into a crash: nodes in circles, accessors beyond their buffers.
#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/error.h"
#include "model/assimp_scene.h"
#include "model/readers.h"

namespace croquis::model {
namespace {

using Json = nlohmann::json;

constexpr int deepest = 200;

/// The JSON part of a .glb file.
std::string json_of_binary(const std::string& bytes, const std::string& name) {
    constexpr std::size_t head = 20;
    if (bytes.size() < head) fail("{}: file too short, expected at least {} bytes, found {}", name, head, bytes.size());
    std::uint32_t version = 0, length = 0, type = 0;
    std::memcpy(&version, bytes.data() + 4, 4);
    std::memcpy(&length, bytes.data() + 12, 4);
    std::memcpy(&type, bytes.data() + 16, 4);
    if (version != 2) fail("{}: expected binary glTF of version 2, found version {}", name, version);
    if (length > bytes.size() - head) {
        fail("{}: file too short, expected {} bytes of JSON, found {}", name, length, bytes.size() - head);
    }
    return bytes.substr(head, length);
}

std::uint64_t number(const Json& object, const char* key, std::uint64_t otherwise) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : otherwise;
}

class GltfCheck {
public:
    GltfCheck(const Json& json, const std::string& name) : json_(json), name_(name) {}

    void check() {
        check_nodes();
        check_accessors();
    }

private:
    /// The entries of a list of objects; none where the file has no such list (or is of version 1).
    const Json& list(const char* key) const {
        static const Json none = Json::array();
        const auto found = json_.find(key);
        if (found == json_.end() || !found->is_array()) return none;
        for (const Json& entry : *found) {
            if (!entry.is_object()) fail("{}: expected objects in \"{}\", found {}", name_, key, entry.type_name());
        }
        return *found;
    }

    void check_nodes() {
        const Json& nodes = list("nodes");
        std::vector<std::size_t> parent(nodes.size(), nodes.size());
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            const auto children = nodes[n].find("children");
            if (children == nodes[n].end() || !children->is_array()) continue;
            for (const Json& child : *children) {
                if (!child.is_number_unsigned() || child.get<std::uint64_t>() >= nodes.size()) {
                    fail("{}: expected children of node {} below {}, found {}", name_, n, nodes.size(), child.dump());
                }
                const auto c = child.get<std::size_t>();
                if (parent[c] != nodes.size())
                    fail("{}: expected a tree of nodes, found node {} with two parents", name_, c);
                parent[c] = n;
            }
        }
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            int depth = 0;
            for (std::size_t up = parent[n]; up != nodes.size(); up = parent[up]) {
                if (++depth > deepest) {
                    fail("{}: expected nodes at most {} deep, found node {} deeper or in a circle", name_, deepest, n);
                }
            }
        }
    }

    void check_accessors() {
        const Json& views = list("bufferViews");
        const Json& accessors = list("accessors");
        for (std::size_t a = 0; a < accessors.size(); ++a) {
            const std::uint64_t count = number(accessors[a], "count", 0);
            const std::uint64_t view = number(accessors[a], "bufferView", views.size());
            if (view < views.size()) {
                const std::uint64_t room = number(views[view], "byteLength", 0);
                if (count > room)
                    fail("{}: expected accessor {} of {} entries in a view, found {} bytes", name_, a, count, room);
            } else if (accessors[a].contains("bufferView")) {
                fail("{}: expected the view of accessor {} below {}, found {}", name_, a, views.size(), view);
            } else if (count > largest_file / 64) {
                fail("{}: expected accessor {} with data, found {} entries without", name_, a, count);
            }
        }
    }

    const Json& json_;
    const std::string& name_;
};

}  // namespace

void check_gltf(const std::string& bytes, const std::filesystem::path& path) {
    const std::string name = path.string();
    const bool binary = bytes.starts_with("glTF");
    const std::string text = binary ? json_of_binary(bytes, name) : std::string();
    const std::string& json_text = binary ? text : bytes;
    check_nesting(json_text, name);
    const Json json = Json::parse(json_text, nullptr, false);
    if (json.is_discarded() || !json.is_object()) {
        fail("{}: expected a glTF file, found one that is no JSON object", name);
    }
    GltfCheck(json, name).check();
}

}  // namespace croquis::model
