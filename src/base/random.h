// Random numbers that are a function of (seed, purpose, index): no generator, no clock, no order of calls.
#pragma once

#include <cstdint>
#include <string_view>

namespace croquis {

/// A stream of random numbers for one purpose. The same seed, purpose and index give the same number everywhere.
class Random {
public:
    Random(std::uint64_t seed, std::string_view purpose);

    /// 64 well-mixed bits for an index.
    [[nodiscard]] std::uint64_t bits(std::uint64_t index) const;

    /// A number in [0, 1).
    [[nodiscard]] double unit(std::uint64_t index) const;

    /// A number in [low, high).
    [[nodiscard]] double between(double low, double high, std::uint64_t index) const;

private:
    std::uint64_t key_;
};

}  // namespace croquis
