#include "lines/hierarchy_finder.h"

#include "base/parallel.h"
#include "lines/dual_tree.h"
#include "lines/facing.h"
#include "lines/ordered_set.h"

namespace croquis::lines {
namespace {

// A view's work is cut into that many pieces, each of some nodes of the tree.
constexpr std::size_t piece_count = 32;
constexpr std::size_t nodes_a_piece = 4;

class HierarchyFinder final : public SilhouetteFinder {
public:
    explicit HierarchyFinder(const Surface& surface)
        : surface_(surface), tree_(surface), pieces_(piece_count), set_(surface.edge_count()) {}

    const std::vector<std::uint32_t>& find(const Viewpoint& view) override {
        const Facing facing(surface_, view);
        tree_.choose(facing.height(), piece_count * nodes_a_piece, nodes_);
        parallel_for(piece_count, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t piece = begin; piece < end; ++piece) find_piece(facing, piece);
        });
        for (const Piece& piece : pieces_) {
            for (const std::uint32_t e : piece.found) set_.add(e);
        }
        set_.take(found_);
        return found_;
    }

private:
    struct Piece {
        std::vector<DualTree::Place> nodes;
        std::vector<std::uint32_t> candidates, found;
    };

    void find_piece(const Facing& facing, std::size_t index) {
        Piece& piece = pieces_[index];
        const auto begin_of = [&](std::size_t i) {
            return nodes_.begin() + static_cast<std::ptrdiff_t>(nodes_.size() * i / piece_count);
        };
        piece.nodes.assign(begin_of(index), begin_of(index + 1));
        piece.candidates.clear();
        tree_.append_edges(facing.height(), piece.nodes, piece.candidates);
        piece.found.clear();
        facing.append_silhouettes(piece.candidates, piece.found);
    }

    const Surface& surface_;
    DualTree tree_;
    std::vector<DualTree::Place> nodes_;
    std::vector<Piece> pieces_;
    OrderedSet set_;
    std::vector<std::uint32_t> found_;
};

}  // namespace

std::unique_ptr<SilhouetteFinder> make_hierarchy_finder(const Surface& surface) {
    return std::make_unique<HierarchyFinder>(surface);
}

}  // namespace croquis::lines
