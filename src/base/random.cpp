#include "base/random.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

constexpr std::uint64_t golden_step = 0x9e3779b97f4a7c15ULL;

}  // namespace

Random::Random(std::uint64_t seed, std::string_view purpose) : key_(mix(seed + golden_step)) {
    for (const char letter : purpose) key_ = mix(key_ ^ static_cast<unsigned char>(letter)) + golden_step;
}

std::uint64_t Random::bits(std::uint64_t index) const { return mix(key_ + (index + 1) * golden_step); }

double Random::unit(std::uint64_t index) const { return static_cast<double>(bits(index) >> 11) * 0x1.0p-53; }

double Random::between(double low, double high, std::uint64_t index) const {
    const double value = low + (high - low) * unit(index);
    return low < high ? std::min(value, std::nextafter(high, low)) : value;  // rounding may have reached the end
}

}  // namespace croquis
