// Least squares with reparametrisation (Schneider 1990).
#include "output/cubic_fit.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace croquis::output {
namespace {

constexpr double most_turn = 2.0;   // radians of one piece: a cubic that turns more is a poor arc
constexpr int most_rounds = 6;      // of reparametrisation
constexpr double slow = 1.0;        // a round that leaves more of the error is the last
constexpr double hopeless = 20;     // times the tolerance: no parametrisation helps
constexpr double flat_turn = 0.01;  // radians between a handle and its chord
constexpr double flat_share = 0.1;  // of the tolerance

double turn_between(const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
}

/// A sample and what the line has done up to it.
struct Station {
    CurveSample sample;
    double along = 0;   // length
    double turned = 0;  // radians, to either side
};

std::vector<Station> stations_of(std::span<const CurveSample> samples) {
    std::vector<Station> stations;
    for (const CurveSample& sample : samples) {
        Station station{sample, 0, 0};
        if (!stations.empty()) {
            const Station& before = stations.back();
            station.along = before.along + glm::distance(before.sample.position, sample.position);
            station.turned = before.turned + turn_between(before.sample.direction, sample.direction);
        }
        stations.push_back(station);
    }
    return stations;
}

/// A run of samples, and the share of the way that each stands at.
class Run {
public:
    explicit Run(std::span<const Station> stations)
        : stations_(stations), length_(stations.back().along - stations.front().along) {
        shares_.reserve(stations.size());
        for (const Station& station : stations) shares_.push_back((station.along - stations.front().along) / length_);
    }

    /// The cubic with the run's ends and directions that passes the samples, each at its share, most nearly.
    [[nodiscard]] Cubic best() const {
        const CurveSample &first = stations_.front().sample, &last = stations_.back().sample;
        const Cubic ends{{first.position, first.position, last.position, last.position}};
        double aa = 0, ab = 0, bb = 0, ap = 0, bp = 0;  // of the normal equations for both handles' lengths
        for (std::size_t i = 1; i + 1 < stations_.size(); ++i) {
            const double t = shares_[i], s = 1 - t;
            const glm::dvec2 a = (3 * s * s * t) * first.direction, b = (-3 * s * t * t) * last.direction;
            const glm::dvec2 rest = stations_[i].sample.position - ends.at(t);
            aa += glm::dot(a, a);
            ab += glm::dot(a, b);
            bb += glm::dot(b, b);
            ap += glm::dot(a, rest);
            bp += glm::dot(b, rest);
        }
        const double determinant = aa * bb - ab * ab;
        double leaving = (ap * bb - bp * ab) / determinant, arriving = (aa * bp - ab * ap) / determinant;
        const auto is_sound = [&](double handle) { return handle > 0.02 * length_ && handle < length_; };
        if (!(determinant > 1e-12 * aa * bb && is_sound(leaving) && is_sound(arriving))) {
            leaving = arriving = length_ / 3;
        }
        return {{first.position, first.position + leaving * first.direction, last.position - arriving * last.direction,
                 last.position}};
    }

    [[nodiscard]] double farthest_from(const Cubic& cubic) const {
        double farthest = 0;
        for (std::size_t i = 1; i + 1 < stations_.size(); ++i) {
            const double distance = glm::distance(cubic.at(shares_[i]), stations_[i].sample.position);
            if (!(distance <= farthest)) farthest = distance;
        }
        return farthest;
    }

    /// Moves each share to where the cubic passes its sample most nearly: one step of Newton's method.
    void move_shares(const Cubic& cubic) {
        for (std::size_t i = 1; i + 1 < stations_.size(); ++i) {
            const glm::dvec2 off = cubic.at(shares_[i]) - stations_[i].sample.position, slope = cubic.slope(shares_[i]);
            const double fall = glm::dot(slope, slope) + glm::dot(off, cubic.bend(shares_[i]));
            if (fall > 0) shares_[i] = std::clamp(shares_[i] - glm::dot(off, slope) / fall, 0.0, 1.0);
        }
    }

private:
    std::span<const Station> stations_;
    double length_;
    std::vector<double> shares_;
};

// Neither handle leaves the chord by much of the tolerance, nor turns off it so that it shows.
bool is_flat(const Cubic& cubic, double tolerance) {
    const glm::dvec2 chord = cubic.control[3] - cubic.control[0];
    const auto lies_along = [&](const glm::dvec2& handle) {
        const double turn = turn_between(handle, chord);
        return turn < flat_turn && glm::length(handle) * turn < flat_share * tolerance;
    };
    return lies_along(cubic.control[1] - cubic.control[0]) && lies_along(cubic.control[3] - cubic.control[2]);
}

CurvePiece piece_of(const Cubic& cubic, double tolerance) {
    const CurvePiece::Kind kind = is_flat(cubic, tolerance) ? CurvePiece::Kind::straight : CurvePiece::Kind::cubic;
    return {kind, cubic.control[1], cubic.control[2], cubic.control[3]};
}

// The cubic that passes all samples within the tolerance, if one was found. It is, for two.
std::optional<Cubic> fitted(std::span<const Station> stations, double tolerance) {
    if (stations.size() > 2 && stations.back().turned - stations.front().turned > most_turn) return std::nullopt;
    Run run(stations);
    Cubic cubic = run.best();
    double miss = run.farthest_from(cubic);
    double before = hopeless * tolerance;
    for (int round = 0; round < most_rounds && miss > tolerance && miss < slow * before; ++round) {
        before = miss;
        run.move_shares(cubic);
        cubic = run.best();
        miss = run.farthest_from(cubic);
    }
    if (!(miss <= tolerance)) return std::nullopt;
    return cubic;
}

struct Fit {
    Cubic cubic;
    std::size_t last = 0;  // sample that it passes
};

// The longest piece from the first sample on: twice as long until it does not fit, then what is between. Schneider cuts
// where the fit is worst; this takes a quarter fewer pieces.
Fit longest_fit(std::span<const Station> stations, double tolerance) {
    Fit fit{*fitted(stations.first(2), tolerance), 1};
    std::size_t fails = stations.size();
    for (std::size_t step = 4; fit.last + 1 < fails;) {
        const bool never_failed = fails == stations.size();
        const std::size_t end = never_failed ? std::min(fit.last + step, fails - 1) : (fit.last + fails) / 2;
        if (const std::optional<Cubic> cubic = fitted(stations.first(end + 1), tolerance)) {
            fit = {*cubic, end};
            step *= 2;
        } else {
            fails = end;
        }
    }
    return fit;
}

}  // namespace

void fit_cubics(std::span<const CurveSample> samples, double tolerance, std::vector<CurvePiece>& pieces) {
    const std::vector<Station> stations = stations_of(samples);
    for (std::span<const Station> rest = stations; rest.size() > 1;) {
        const Fit fit = longest_fit(rest, tolerance);
        pieces.push_back(piece_of(fit.cubic, tolerance));
        rest = rest.subspan(fit.last);
    }
}

}  // namespace croquis::output
