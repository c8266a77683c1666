// Exact sums of products, as expansions: numbers kept as unrounded sums of doubles (Shewchuk 1997).
#include "lines/predicates.h"

#include <array>
#include <cstddef>

namespace croquis::lines {
namespace {

/// A number as a sum of doubles that do not overlap, the largest last.
class Expansion {
public:
    void add(double term) {
        for (std::size_t i = 0; i < count_; ++i) {
            const double sum = term + parts_[i];
            const double virtual_part = sum - term;
            const double error = (term - (sum - virtual_part)) + (parts_[i] - virtual_part);
            parts_[i] = error;
            term = sum;
        }
        parts_[count_++] = term;
    }

    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    /// The value, rounded; its sign is exact.
    [[nodiscard]] double value() const {
        for (std::size_t i = count_; i > 0; --i) {
            if (parts_[i - 1] != 0) return parts_[i - 1];
        }
        return 0;
    }

private:
    std::array<double, 12> parts_{};
    std::size_t count_ = 0;
};

}  // namespace

double exact_orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    Expansion sum;
    sum.add_product(a.x, b.y);
    sum.add_product(-a.y, b.x);
    sum.add_product(b.x, c.y);
    sum.add_product(-b.y, c.x);
    sum.add_product(c.x, a.y);
    sum.add_product(-c.y, a.x);
    return sum.value();
}

}  // namespace croquis::lines
