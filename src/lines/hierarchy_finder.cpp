#include "lines/hierarchy_finder.h"

#include <algorithm>
#include <cstdlib>
#include <cstdio>

#include "base/parallel.h"
#include "lines/dual_tree.h"
#include "lines/facing.h"
#include "lines/ordered_set.h"

namespace croquis::lines {
namespace {

constexpr std::size_t pieces = 32;

class HierarchyFinder final : public SilhouetteFinder {
public:
    explicit HierarchyFinder(const Surface& surface)
        : surface_(surface), tree_(surface), pieces_(pieces), set_(surface.edge_count()) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        const Facing facing(surface_, view);
        tree_.choose(facing.height(), 4 * pieces, places_);
        parallel_for(pieces, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end; ++piece) find_piece(facing, piece);
        });
        for (const Piece& piece : pieces_) {
            for (const std::uint32_t e : piece.found) set_.add(e);
        }
        set_.take(found_);
        if(getenv("DBG")) {size_t n=0; for(auto&p:pieces_)n+=p.candidates.size(); printf("tested %.4f found %zu places %zu memory %.2f a face\n",double(n)/double(surface_.edge_count()),found_.size(),places_.size(),double(tree_.memory())/double(surface_.face_count()));}
        return found_;
    }

private:
    struct Piece {
        std::vector<DualTree::Place> places;
        std::vector<std::uint32_t> candidates, found;
    };

    void find_piece(const Facing& facing, std::size_t index) {
        Piece& piece = pieces_[index];
        piece.candidates.clear();
        piece.found.clear();
        piece.places.assign(places_.begin() + std::ptrdiff_t(places_.size() * index / pieces), places_.begin() + std::ptrdiff_t(places_.size() * (index + 1) / pieces));
        tree_.append_edges(facing.height(), piece.places, piece.candidates);
        facing.append_silhouettes(piece.candidates, piece.found);
    }

    const Surface& surface_;
    DualTree tree_;
    std::vector<DualTree::Place> places_;
    std::vector<Piece> pieces_;
    OrderedSet set_;
    std::vector<std::uint32_t> found_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_hierarchy_finder(const Surface& surface) {
    return std::make_unique<HierarchyFinder>(surface);
}

}  // namespace croquis::lines
