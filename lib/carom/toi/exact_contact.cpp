#include "carom/toi/exact_contact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/toi/exact_polynomial.hpp"

namespace carom {
namespace {

using Whole = WholeNumber;

// The power of two that all coordinates are multiples of.
int commonUnit(const MovingPoints& points) {
  int unit = std::numeric_limits<int>::max();
  for (const auto* places : {&points.start, &points.end}) {
    for (const Vector3& p : *places) {
      requireFinite(p, "point");
      for (int k = 0; k < 3; ++k) {
        if (p[k] == 0) continue;
        int power = 0;
        const Real mantissa = std::frexp(std::abs(p[k]), &power);
        const auto bits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
        unit = std::min(unit, power - 53 + std::countr_zero(bits));
      }
    }
  }
  return unit == std::numeric_limits<int>::max() ? 0 : unit;
}

// A polynomial from its coefficients.
template <std::size_t N>
ExactPolynomial polynomial(const std::array<Whole, N>& c) {
  return ExactPolynomial(std::vector<Whole>(c.begin(), c.end()));
}

// The polynomials of one pair of features; areas are made when they are asked for.
class ExactPair {
 public:
  ExactPair(FeaturePair pair, const MovingPoints& points) : pair_(pair) {
    const int unit = commonUnit(points);
    const SeenFrom seen = seenFrom(pair);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto difference = [&](const std::array<Vector3, 4>& places) {
          const auto row = static_cast<Eigen::Index>(k);
          return Whole::inUnits(places[seen.points[i]][row], unit) -
                 Whole::inUnits(places[seen.origin][row], unit);
        };
        corners_[i].first[k] = difference(points.start);
        corners_[i].second[k] = difference(points.end) - corners_[i].first[k];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) bc_[k] = crossComponent(corners_[1], corners_[2], k);
  }

  ExactPolynomial volume() const {
    return polynomial(dotProduct(corners_[0], bc_));
  }

  // B x C, C x A, A x B and their sum along axis k.
  const std::array<ExactPolynomial, 4>& areas(std::size_t k) {
    std::array<ExactPolynomial, 4>& made = areas_[k];
    if (!isMade_[k]) {
      made[0] = polynomial(bc_[k]);
      made[1] = polynomial(crossComponent(corners_[2], corners_[0], k));
      made[2] = polynomial(crossComponent(corners_[0], corners_[1], k));
      made[3] = made[0] + made[1] + made[2];
      isMade_[k] = true;
    }
    return made;
  }

  // The differences along axis k that must not all have one sign if points on a line meet.
  std::vector<ExactPolynomial> differences(std::size_t k) const {
    const auto linear = [&](std::size_t i) {
      return ExactPolynomial({corners_[i].first[k], corners_[i].second[k]});
    };
    if (pair_ == FeaturePair::kVertexFace) return {linear(0), linear(1), linear(2)};
    const ExactPolynomial minusC({Whole() - corners_[2].first[k], Whole() - corners_[2].second[k]});
    return {linear(0), linear(1), linear(0) + minusC, linear(1) + minusC};
  }

  // Do the features meet at a time at which the four points lie in a plane?
  bool meetAt(ExactRoot& time) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<ExactPolynomial, 4>& area = areas(k);
      const int bc = time.signOf(area[0]), ca = time.signOf(area[1]), ab = time.signOf(area[2]);
      if (bc == 0 && ca == 0 && ab == 0) continue;
      const int abc = pair_ == FeaturePair::kEdgeEdge ? time.signOf(area[3]) : 0;
      return judgeAreas(pair_, bc, ca, ab, abc) != PlanarVerdict::kApart;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      int positive = 0, negative = 0, all = 0;
      for (const ExactPolynomial& difference : differences(k)) {
        const int sign = time.signOf(difference);
        positive += sign > 0, negative += sign < 0, ++all;
      }
      if (positive == all || negative == all) return false;
    }
    return true;
  }

 private:
  FeaturePair pair_;
  std::array<LinearVector<Whole>, 3> corners_;  // A, B, C: place at the start, and velocity
  std::array<Quadratic<Whole>, 3> bc_;
  std::array<std::array<ExactPolynomial, 4>, 3> areas_;
  std::array<bool, 3> isMade_ = {};
};

std::optional<Real> firstMeeting(ExactPair& pair, const ExactPolynomial& candidates) {
  for (ExactRoot& root : rootsInUnitInterval(candidates)) {
    if (pair.meetAt(root)) return root.roundedDown();
  }
  return std::nullopt;
}

// Everything moves in one plane: contact begins at the start or where an area changes its sign.
std::optional<Real> firstMeetingInPlane(ExactPair& pair) {
  ExactRoot start{DyadicCell{}};
  if (pair.meetAt(start)) return 0;
  std::vector<ExactPolynomial> candidates;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const ExactPolynomial& area : pair.areas(k)) candidates.push_back(area);
  }
  const auto isZero = [](const ExactPolynomial& p) { return p.isZero(); };
  if (std::all_of(candidates.begin(), candidates.end(), isZero)) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const ExactPolynomial& difference : pair.differences(k))
        candidates.push_back(difference);
    }
  }
  // Rounding keeps the order, so the first of the rounded times is the first time, rounded.
  std::optional<Real> first;
  for (const ExactPolynomial& p : candidates) {
    if (p.isZero()) continue;
    const std::optional<Real> time = firstMeeting(pair, p);
    if (time && (!first || *time < *first)) first = time;
  }
  return first;
}

}  // namespace

std::optional<Real> exactFirstContact(FeaturePair pair, const MovingPoints& points) {
  ExactPair exact(pair, points);
  const ExactPolynomial volume = exact.volume();
  return volume.isZero() ? firstMeetingInPlane(exact) : firstMeeting(exact, volume);
}

int exactVolumeSign(FeaturePair pair, const MovingPoints& points, Real time) {
  int power = 0;
  const Real mantissa = std::frexp(time, &power);
  if (time == 0) return ExactPair(pair, points).volume().signAt({});
  // time = m / 2^e
  const int e = 53 - power;
  return ExactPair(pair, points).volume().signAt({Whole::inUnits(mantissa, -53), e});
}

}  // namespace carom
