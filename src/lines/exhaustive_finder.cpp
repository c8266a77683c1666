#include "lines/exhaustive_finder.h"

#include "base/parallel.h"

namespace croquis::lines {
namespace {

class ExhaustiveFinder final : public SilhouetteFinder {
public:
    explicit ExhaustiveFinder(const Surface& surface) : surface_(surface), front_(surface.face_count()) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        parallel_for(front_.size(), 8192, [&](std::size_t begin, std::size_t end) {
            for (std::size_t f = begin; f < end; ++f) {
                front_[f] = surface_.front_facing(static_cast<std::uint32_t>(f), view) ? 1 : 0;
            }
        });
        found_.clear();
        const auto pairs = surface_.pairs();
        for (std::uint32_t e = 0; e < pairs.size(); ++e) {
            if (front_[pairs[e].first] != front_[pairs[e].second]) found_.push_back(e);
        }
        return found_;
    }

private:
    const Surface& surface_;
    std::vector<std::uint8_t> front_;
    std::vector<std::uint32_t> found_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_exhaustive_finder(const Surface& surface) {
    return std::make_unique<ExhaustiveFinder>(surface);
}

}  // namespace croquis::lines
