#include "lines/exhaustive_finder.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "lines/facing.h"

namespace croquis::lines {
namespace {

// Large enough to repay a thread, small enough that a piece's found edges stay in the nearest cache.
constexpr std::size_t faces_a_piece = 16384;
constexpr std::size_t edges_a_piece = 8192;

// What the first pass notes of a face.
constexpr std::uint8_t turned_away = 0, turned_to_eye = 1, in_doubt = 2;

/// Decides [begin, end) in single precision, many at once. True when some are left in doubt.
bool decide_clear_faces(std::span<const glm::vec4> planes, const EyeFunction& height, std::span<std::uint8_t> facing) {
    const glm::vec4 factors = height.factors();
    std::uint8_t all = 0;
    for (std::size_t f = 0; f < planes.size(); ++f) {
        const glm::vec4& plane = planes[f];
        const float h = plane.x * factors.x + plane.y * factors.y + plane.z * factors.z + plane.w * factors.w;
        const int over = h > EyeFunction::doubt ? 1 : 0;
        const int under = h >= -EyeFunction::doubt ? 1 : 0;
        const auto noted = static_cast<std::uint8_t>(2 * under - over);
        facing[f] = noted;
        all |= noted;
    }
    return (all & in_doubt) != 0;
}

class ExhaustiveFinder final : public SilhouetteFinder {
public:
    explicit ExhaustiveFinder(const Surface& surface)
        : surface_(surface),
          facing_(surface.face_count()),
          found_in_piece_((surface.edge_count() + edges_a_piece - 1) / edges_a_piece) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        decide_faces(view);
        parallel_for(found_in_piece_.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end; ++piece) compare_faces(piece);
        });
        found_.clear();
        for (const std::vector<std::uint32_t>& found : found_in_piece_) {
            found_.insert(found_.end(), found.begin(), found.end());
        }
        return found_;
    }

private:
    void decide_faces(const Viewpoint& view) {
        const EyeFunction height(view);
        parallel_for(facing_.size(), faces_a_piece, [&](std::size_t begin, std::size_t end) {
            const std::span<std::uint8_t> facing = std::span(facing_).subspan(begin, end - begin);
            if (!decide_clear_faces(surface_.planes().subspan(begin, end - begin), height, facing)) return;
            for (std::size_t f = begin; f < end; ++f) {
                if (facing_[f] != in_doubt) continue;
                facing_[f] = surface_.front_facing(static_cast<std::uint32_t>(f), view) ? turned_to_eye : turned_away;
            }
        });
    }

    /// Edges whose faces differ are noted without a branch: on a scan no one could predict it.
    void compare_faces(std::size_t piece) {
        const std::size_t begin = piece * edges_a_piece;
        const std::size_t end = std::min(begin + edges_a_piece, surface_.edge_count());
        const FacePair* const pairs = surface_.pairs().data();
        const std::uint8_t* const facing = facing_.data();
        std::array<std::uint32_t, edges_a_piece> found;
        std::size_t count = 0;
        for (std::size_t e = begin; e < end; ++e) {
            found[count] = static_cast<std::uint32_t>(e);
            count += facing[pairs[e].first] ^ facing[pairs[e].second];
        }
        found_in_piece_[piece].assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count));
    }

    const Surface& surface_;
    std::vector<std::uint8_t> facing_;
    std::vector<std::vector<std::uint32_t>> found_in_piece_;  // in the order of the edges, whoever finds them
    std::vector<std::uint32_t> found_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_exhaustive_finder(const Surface& surface) {
    return std::make_unique<ExhaustiveFinder>(surface);
}

}  // namespace croquis::lines
