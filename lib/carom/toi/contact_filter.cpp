#include "carom/toi/contact_filter.hpp"

#include <algorithm>
#include <cmath>

#include "carom/precision/double_double.hpp"
#include "carom/toi/exact_contact.hpp"

namespace carom {
namespace {

constexpr Real kAreaError = 0x1p-47;                // times two largest coordinates
constexpr Real kVolumeError = 0x1p-45;              // times three
constexpr Real kSharpVolumeError = 0x1p-92;         // times three, with twice the digits
constexpr Real kLeast = 0x1p-150, kMost = 0x1p150;  // products of three stay doubles
constexpr int kHalvings = 10;  // more decide little, and the exact way costs as much as 100 of them

Real mix(Real a, Real b, Real t) {
  return (1 - t) * a + t * b;
}

// Bernstein coefficients on [lo, hi] of those on [0, 1]: the polar form at the ends.
Quadratic<Real> restricted(const Quadratic<Real>& b, Real lo, Real hi) {
  const Real low0 = mix(b[0], b[1], lo), low1 = mix(b[1], b[2], lo);
  return {mix(low0, low1, lo), mix(low0, low1, hi),
          mix(mix(b[0], b[1], hi), mix(b[1], b[2], hi), hi)};
}

Cubic<Real> restricted(const Cubic<Real>& b, Real lo, Real hi) {
  const Quadratic<Real> low = {mix(b[0], b[1], lo), mix(b[1], b[2], lo), mix(b[2], b[3], lo)};
  const Quadratic<Real> high = {mix(b[0], b[1], hi), mix(b[1], b[2], hi), mix(b[2], b[3], hi)};
  const Quadratic<Real> first = restricted(low, lo, hi), last = restricted(high, lo, hi);
  return {first[0], first[1], first[2], last[2]};
}

int signBeyond(Real value, Real error) {
  return (value > error) - (value < -error);
}

// The sign that a polynomial has everywhere on an interval, for certain; 0 if it may change.
template <std::size_t N>
int steadySign(const std::array<Real, N>& bernstein, Real error) {
  const int sign = signBeyond(bernstein[0], error);
  for (const Real b : bernstein) {
    if (signBeyond(b, error) != sign) return 0;
  }
  return sign;
}

// Descartes: exactly one root for certain, whatever the signs are that are not known.
bool hasOneRoot(const Cubic<Real>& b, Real error) {
  const int first = signBeyond(b[0], error), last = signBeyond(b[3], error);
  if (first == 0 || last != -first) return false;
  return signBeyond(b[1], error) == first || signBeyond(b[2], error) == last;
}

struct Span {
  Real lo = 0;
  Real hi = 1;
};

class Filter {
 public:
  Filter(FeaturePair pair, const MovingPoints& points) : pair_(pair), points_(points) {
    const SeenFrom seen = seenFrom(pair);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 start = points.start[seen.points[i]] - points.start[seen.origin];
      const Vector3 end = points.end[seen.points[i]] - points.end[seen.origin];
      size_[i] = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        corners_[i].first[k] = start[row], corners_[i].second[k] = end[row];
        size_[i] = std::max({size_[i], std::abs(start[row]), std::abs(end[row])});
      }
    }
    for (std::size_t k = 0; k < 3; ++k) areas_[0][k] = crossComponent(corners_[1], corners_[2], k);
    volume_ = dotProduct(corners_[0], areas_[0]);
    volume_[1] /= 3, volume_[2] /= 3;
    volumeError_ = kVolumeError * size_[0] * size_[1] * size_[2];
  }

  bool isInRange() const {
    return std::all_of(size_.begin(), size_.end(),
                       [](Real size) { return size >= kLeast && size <= kMost; });
  }

  Filtered search() {
    if (steadySign(volume_, volumeError_) != 0) return {FilterVerdict::kMiss, 0, false};
    makeAreas();
    std::array<Span, kHalvings + 2> open;
    std::array<int, kHalvings + 2> depth = {};
    int count = 1;
    // From left to right, so the first contact comes first.
    while (count > 0) {
      --count;
      const Span span = open[static_cast<std::size_t>(count)];
      const int halvings = depth[static_cast<std::size_t>(count)];
      const Cubic<Real> volume = halvings == 0 ? volume_ : restricted(volume_, span.lo, span.hi);
      if (steadySign(volume, volumeError_) != 0) continue;
      if (judge(span) == PlanarVerdict::kApart) continue;
      if (hasOneRoot(volume, volumeError_)) {
        const Span root = enclose(span, volume[0] < 0 ? -1 : 1);
        const PlanarVerdict verdict = judge(root);
        if (verdict == PlanarVerdict::kApart) continue;
        if (verdict == PlanarVerdict::kUnclear) return {};
        return sharpen(root, volume[0] < 0 ? -1 : 1);
      }
      if (halvings == kHalvings) return {};
      const Real middle = (span.lo + span.hi) / 2;
      for (const Span& half : {Span{middle, span.hi}, Span{span.lo, middle}}) {
        open[static_cast<std::size_t>(count)] = half;
        depth[static_cast<std::size_t>(count)] = halvings + 1;
        ++count;
      }
    }
    return {FilterVerdict::kMiss, 0, false};
  }

 private:
  void makeAreas() {
    for (std::size_t k = 0; k < 3; ++k) {
      areas_[1][k] = crossComponent(corners_[2], corners_[0], k);
      areas_[2][k] = crossComponent(corners_[0], corners_[1], k);
      for (std::size_t i = 0; i < 3; ++i) areas_[i][k][1] /= 2;
      for (std::size_t j = 0; j < 3; ++j) {
        areas_[3][k][j] = (areas_[0][k][j] + areas_[1][k][j]) + areas_[2][k][j];
      }
    }
    areaError_[0] = kAreaError * size_[1] * size_[2];
    areaError_[1] = kAreaError * size_[2] * size_[0];
    areaError_[2] = kAreaError * size_[0] * size_[1];
    areaError_[3] = 2 * (areaError_[0] + areaError_[1] + areaError_[2]);
  }

  // What holds during the whole span, if the four points lie in a plane at any time of it.
  PlanarVerdict judge(const Span& span) const {
    const bool whole = span.lo == 0 && span.hi == 1;
    PlanarVerdict result = PlanarVerdict::kUnclear;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<int, 4> sign = {};
      const std::size_t count = pair_ == FeaturePair::kEdgeEdge ? 4 : 3;
      for (std::size_t i = 0; i < count; ++i) {
        const Quadratic<Real>& area = areas_[i][k];
        sign[i] = steadySign(whole ? area : restricted(area, span.lo, span.hi), areaError_[i]);
      }
      const PlanarVerdict verdict = judgeAreas(pair_, sign[0], sign[1], sign[2], sign[3]);
      if (verdict == PlanarVerdict::kApart) return verdict;
      if (verdict == PlanarVerdict::kMeet) result = verdict;
    }
    return result;
  }

  // Value and slope of the volume, in doubles.
  std::array<Real, 2> volumeAt(Real t) const {
    const Quadratic<Real> once = {mix(volume_[0], volume_[1], t), mix(volume_[1], volume_[2], t),
                                  mix(volume_[2], volume_[3], t)};
    const Real left = mix(once[0], once[1], t), right = mix(once[1], once[2], t);
    return {mix(left, right, t), 3 * (right - left)};
  }

  // A short span around the only root in a longer one, with certain signs at its ends: Newton, and
  // bisection where Newton would leave.
  Span enclose(Span span, int signBelow) const {
    Span bracket = span;
    Real t = (span.lo + span.hi) / 2, slope = 0;
    for (int i = 0; i < 60; ++i) {
      const auto [value, rise] = volumeAt(t);
      slope = rise;
      if (std::abs(value) <= volumeError_) break;
      (value * signBelow > 0 ? bracket.lo : bracket.hi) = t;
      const Real next = t - value / rise;
      t = next > bracket.lo && next < bracket.hi ? next : (bracket.lo + bracket.hi) / 2;
    }
    // Outwards from there until the signs are certain again.
    Real reach = std::max(4 * volumeError_ / std::abs(slope), 0x1p-50 * t);
    for (; reach < 1; reach *= 8) {
      const Span around{t - reach, t + reach};
      if (around.lo > bracket.lo && signBeyond(volumeAt(around.lo)[0], volumeError_) == signBelow) {
        bracket.lo = around.lo;
      }
      if (around.hi < bracket.hi &&
          signBeyond(volumeAt(around.hi)[0], volumeError_) == -signBelow) {
        bracket.hi = around.hi;
      }
      if (around.lo <= bracket.lo && around.hi >= bracket.hi) break;
    }
    return bracket;
  }

  // The root as the exact one rounded down: the last double with the sign that is below it.
  Filtered sharpen(const Span& root, int signBelow) const {
    std::array<LinearVector<DoubleDouble>, 3> corners;
    const SeenFrom seen = seenFrom(pair_);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        const auto difference = [&](const std::array<Vector3, 4>& places) {
          return exactDifference(places[seen.points[i]][row], places[seen.origin][row]);
        };
        corners[i].first[k] = difference(points_.start);
        corners[i].second[k] = difference(points_.end);
      }
    }
    std::array<Quadratic<DoubleDouble>, 3> bc;
    for (std::size_t k = 0; k < 3; ++k) bc[k] = crossComponent(corners[1], corners[2], k);
    const Cubic<DoubleDouble> c = dotProduct(corners[0], bc);
    const auto volumeSharp = [&](Real t) {
      const DoubleDouble x = exactDifference(1, t), y = t;
      return (c[0] * x + c[1] * y) * (x * x) + (c[2] * x + c[3] * y) * (y * y);
    };

    Filtered result{FilterVerdict::kHit, 0, false};
    const Real error = kSharpVolumeError * size_[0] * size_[1] * size_[2];
    const auto signSharp = [&](Real t) {
      const int sign = signBeyond(volumeSharp(t).high, error);
      if (sign != 0) return sign;
      result.neededExact = true;
      return exactVolumeSign(pair_, points_, t);
    };

    Real t = (root.lo + root.hi) / 2;
    for (int i = 0; i < 2; ++i) {
      const Real step = volumeSharp(t).high / volumeAt(t)[1];
      const Real next = t - step;
      if (next >= root.lo && next <= root.hi) t = next;
    }
    for (int i = 0; i < 16; ++i) {
      const Real above = std::nextafter(t, 2);
      const int sign = signSharp(t);
      if (sign == -signBelow) {
        t = std::nextafter(t, -1);
        continue;
      }
      if (sign == 0 || signSharp(above) == -signBelow) {
        result.time = t;
        return result;
      }
      t = above;
    }
    return {};
  }

  FeaturePair pair_;
  const MovingPoints& points_;
  std::array<LinearVector<Real>, 3> corners_;  // A, B, C: at the start and at the end
  std::array<Real, 3> size_;                   // largest coordinate of each
  // B x C, C x A, A x B and their sum, along each axis.
  std::array<std::array<Quadratic<Real>, 3>, 4> areas_;
  std::array<Real, 4> areaError_ = {};
  Cubic<Real> volume_;
  Real volumeError_ = 0;
};

}  // namespace

bool axisKeepsApart(FeaturePair pair, const MovingPoints& points) {
  const std::size_t ofA = pair == FeaturePair::kVertexFace ? 1 : 2;
  for (Eigen::Index k = 0; k < 3; ++k) {
    bool above = true, below = true;
    for (std::size_t i = 0; i < ofA; ++i) {
      for (std::size_t j = ofA; j < 4; ++j) {
        const Real start = points.start[i][k], end = points.end[i][k];
        const Real otherStart = points.start[j][k], otherEnd = points.end[j][k];
        above = above && start > otherStart && end > otherEnd;
        below = below && start < otherStart && end < otherEnd;
      }
    }
    if (above || below) return true;
  }
  return false;
}

Filtered filterContact(FeaturePair pair, const MovingPoints& points) {
  Filter filter(pair, points);
  if (!filter.isInRange()) return {};
  return filter.search();
}

}  // namespace carom
