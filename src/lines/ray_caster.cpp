#include "lines/ray_caster.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"

namespace croquis::lines {
namespace {

/// What a ray's filter works with: Embree hands the context on to it.
struct Question {
    RTCIntersectContext context;  // first: Embree knows this part
    const Surface* surface = nullptr;
    glm::dvec3 from{0.0}, to{0.0};
    std::span<const std::uint32_t> excluded;
    double shortest = 0;  // share of the segment that a hit must lie beyond
    std::uint32_t at_most = 0;
    std::uint32_t count = 0;
    std::vector<Piercing>* piercings = nullptr;
};

/// Where the segment meets the face's plane, as a share of its length; outside of 0 to 1 where it does not.
double share_of_plane(const Question& question, std::uint32_t face) {
    const Surface& surface = *question.surface;
    const auto& [a, b, c] = surface.topology().faces[face].vertices;
    const glm::dvec3 corner = surface.point(a);
    const glm::dvec3 normal = glm::cross(surface.point(b) - corner, surface.point(c) - corner);
    const double start = glm::dot(normal, question.from - corner);
    const double end = glm::dot(normal, question.to - corner);
    return start == end ? -1.0 : start / (start - end);
}

// Embree takes a hit unless the filter clears `valid`; clearing goes on with the ray.
void count_layer(const RTCFilterFunctionNArguments* arguments) {
    Question& question = *reinterpret_cast<Question*>(arguments->context);
    const std::uint32_t face = RTCHitN_primID(arguments->hit, arguments->N, 0);
    arguments->valid[0] = 0;
    if (std::find(question.excluded.begin(), question.excluded.end(), face) != question.excluded.end()) return;
    const double share = share_of_plane(question, face);
    if (!(share > question.shortest && share < 1.0)) return;
    if (++question.count >= question.at_most) arguments->valid[0] = -1;
}

void note_piercing(const RTCFilterFunctionNArguments* arguments) {
    Question& question = *reinterpret_cast<Question*>(arguments->context);
    const std::uint32_t face = RTCHitN_primID(arguments->hit, arguments->N, 0);
    arguments->valid[0] = 0;
    if (std::find(question.excluded.begin(), question.excluded.end(), face) != question.excluded.end()) return;
    const double share = share_of_plane(question, face);
    if (share > 0.0 && share < 1.0) question.piercings->push_back({face, share});
}

RTCDevice shared_device() {
    struct Device {
        RTCDevice device = rtcNewDevice("start_threads=0,set_affinity=0");
        ~Device() { rtcReleaseDevice(device); }
    };
    static const Device device;
    if (device.device == nullptr) fail("expected Embree to start, found error {}", int(rtcGetDeviceError(nullptr)));
    return device.device;
}

void cast(RTCScene scene, Question& question, RTCFilterFunctionN filter) {
    rtcInitIntersectContext(&question.context);
    question.context.filter = filter;
    const glm::dvec3 direction = question.to - question.from;
    RTCRay ray{};
    ray.org_x = static_cast<float>(question.from.x);
    ray.org_y = static_cast<float>(question.from.y);
    ray.org_z = static_cast<float>(question.from.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = 0.0f;
    ray.tfar = 1.0f;
    ray.mask = 0xffffffffu;
    rtcOccluded1(scene, &question.context, &ray);
}

}  // namespace

struct RayCaster::Tree {
    const Surface& surface;
    std::vector<glm::vec3> points;  // scene space; Embree reads 16 bytes at the last one
    RTCScene scene = nullptr;

    explicit Tree(const Surface& of) : surface(of), points(of.vertex_count() + 1) {}
    ~Tree() {
        if (scene != nullptr) rtcReleaseScene(scene);
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
};

RayCaster::RayCaster(const Surface& surface) : tree_(std::make_unique<Tree>(surface)) {
    parallel_for(surface.vertex_count(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            tree_->points[v] = glm::vec3(surface.point(static_cast<std::uint32_t>(v)));
        }
    });
    const RTCDevice device = shared_device();
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, tree_->points.data(), 0,
                               sizeof(glm::vec3), surface.vertex_count());
    const std::vector<model::Face>& faces = surface.topology().faces;
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, faces.data(), 0,
                               sizeof(model::Face), faces.size());
    rtcCommitGeometry(geometry);
    tree_->scene = rtcNewScene(device);
    rtcSetSceneFlags(tree_->scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_COMPACT |
                                                              RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    rtcAttachGeometry(tree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(tree_->scene);
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE) {
        fail("expected a tree over {} faces, found Embree's error {}", faces.size(), int(error));
    }
}

RayCaster::~RayCaster() = default;

std::uint32_t RayCaster::layers(const glm::dvec3& from, const glm::dvec3& to, std::span<const std::uint32_t> excluded,
                                double tolerance, std::uint32_t at_most) const {
    Question question;
    question.surface = &tree_->surface;
    question.from = from;
    question.to = to;
    question.excluded = excluded;
    question.shortest = tolerance / glm::distance(from, to);
    question.at_most = at_most;
    cast(tree_->scene, question, count_layer);
    return question.count;
}

void RayCaster::find_piercings(const glm::dvec3& from, const glm::dvec3& to, std::span<const std::uint32_t> excluded,
                               std::vector<Piercing>& found) const {
    Question question;
    question.surface = &tree_->surface;
    question.from = from;
    question.to = to;
    question.excluded = excluded;
    question.piercings = &found;
    const auto begin = static_cast<std::ptrdiff_t>(found.size());
    cast(tree_->scene, question, note_piercing);
    std::sort(found.begin() + begin, found.end(), [](const Piercing& a, const Piercing& b) {
        return a.share != b.share ? a.share < b.share : a.face < b.face;
    });
}

}  // namespace croquis::lines
