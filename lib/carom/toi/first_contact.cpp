#include "carom/toi/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/toi/moving_core.hpp"

namespace carom {
namespace {

using detail::CoreShape;
using detail::MovingCore;
using detail::movingCores;
using detail::PlacedCore;

constexpr Real kUlp = std::numeric_limits<Real>::epsilon();

// The motion of the centre, less the turning about it.
Vector3 travelled(const Sweep& sweep, Real time) {
  return time * sweep.velocity + time * time / 2 * sweep.acceleration;
}

// When excess + slope t + bend t^2 / 2 comes down to zero, for a bend of zero or less; never:
// infinity.
Real untilNone(Real excess, Real slope, Real bend) {
  if (!(excess > 0)) return 0;
  const Real root = std::sqrt(slope * slope - 2 * bend * excess);
  if (slope < 0) return 2 * excess / (root - slope);
  return bend < 0 ? (slope + root) / -bend : std::numeric_limits<Real>::infinity();
}

// How large the gap of a pair is at least, some time from now, along a normal that stays.
class GapBound {
 public:
  struct Value {
    Real gap = 0;    // at least [m]
    Real slope = 0;  // of the bound [m/s]
  };

  GapBound(const MovingCore& a, const PlacedCore& coreA, const MovingCore& b,
           const PlacedCore& coreB, const Vector3& betweenCentres, Real now, const Vector3& normal)
      : coreA_(coreA),
        coreB_(coreB),
        normal_(normal),
        leanA_(cross(normal, a.sweep.angularVelocity)),
        leanB_(cross(normal, b.sweep.angularVelocity)),
        centreA_(coreA.R_WB * a.sweep.centre),
        centreB_(coreB.R_WB * b.sweep.centre) {
    radii_ = a.core.radius + b.core.radius;
    gap_ = normal.dot(betweenCentres);
    const Vector3 acceleration = b.sweep.acceleration - a.sweep.acceleration;
    speed_ = normal.dot(b.sweep.velocity - a.sweep.velocity) + now * normal.dot(acceleration);
    pull_ = std::min(Real(0), normal.dot(acceleration));
    reach_ = a.reach + b.reach;
    // Points turn across the axis only: what of the normal is along the axis sees nothing of it.
    turning_ = length(leanA_) * a.fromAxis + length(leanB_) * b.fromAxis;
    bend_ = pull_ - length(a.sweep.angularVelocity) * length(leanA_) * a.fromAxis -
            length(b.sweep.angularVelocity) * length(leanB_) * b.fromAxis;
  }

  Value at(Real later) const {
    const Vector3 towardsB = normal_ + later * leanA_, towardsA = normal_ + later * leanB_;
    const Vector3 armA = coreA_.support(towardsB, 0).point - centreA_;
    const Vector3 armB = coreB_.support(-towardsA, 0).point - centreB_;
    return {gap_ + later * speed_ + towardsA.dot(armB) - towardsB.dot(armA) +
                later * later / 2 * bend_ - radii_,
            speed_ + leanB_.dot(armB) - leanA_.dot(armA) + later * bend_};
  }

  // How long at least the gap stays at `least` or more, by what needs no support point: that no
  // body reaches farther than its farthest corner, and none turns faster than that.
  Real simpleAdvance(Real startGap, Real least) const {
    const Real far = untilNone(gap_ - reach_ - radii_ - least, speed_, pull_);
    return std::max(far, untilNone(startGap - least, speed_ - turning_, pull_));
  }

  // When the tangent at the start, bent as far as it can be, comes down to `least`: not later than
  // that, this bound does.
  Real latest(const Value& start, Real least) const {
    return untilNone(start.gap - least, start.slope, bend_);
  }

 private:
  const PlacedCore& coreA_;
  const PlacedCore& coreB_;
  Vector3 normal_, leanA_, leanB_, centreA_, centreB_;
  Real gap_ = 0, speed_ = 0, radii_ = 0;
  Real pull_ = 0;     // the most that acceleration can close the gap [m/s^2], zero or less
  Real reach_ = 0;    // of both bodies
  Real turning_ = 0;  // the most that turning can close the gap [m/s]
  Real bend_ = 0;     // of acceleration and turning together [m/s^2], zero or less
};

// How long the bound stays at `least` or more, up to `remaining`; nearly, and never longer. The
// bound is concave, so a chord lies below it and a tangent above.
Real safeAdvance(const GapBound& bound, Real least, Real remaining) {
  const GapBound::Value start = bound.at(0);
  if (!(start.gap > least)) return 0;
  GapBound::Value end = bound.at(remaining);
  if (end.gap >= least) return remaining;

  const Real simple = bound.simpleAdvance(start.gap, least);
  if (simple >= remaining) return remaining;
  Real low = 0, lowGap = start.gap, high = remaining;
  if (const Real latest = bound.latest(start, least); latest < high) {
    high = latest;
    end = bound.at(high);
    if (end.gap >= least) return std::max(simple, high);
  }
  Real chord = 0;
  for (int i = 0; i < 50; ++i) {
    chord = low + (lowGap - least) / (lowGap - end.gap) * (high - low);
    const Real tangent = end.slope < 0 ? high - (end.gap - least) / end.slope : high;
    if (!(tangent > chord) || chord >= 0.99 * tangent || tangent <= simple) break;
    const GapBound::Value left = bound.at(chord);
    if (left.gap >= least) {
      low = chord;
      lowGap = left.gap;
    }
    if (tangent < high) {
      high = tangent;
      end = bound.at(high);
      if (end.gap >= least) return std::max(simple, high);
    }
  }
  return std::max(simple, chord);
}

class Pair {
 public:
  // `plane`: A is a half-space whose plane goes through its core, the origin, with this normal.
  Pair(const MovingCore& a, const MovingCore& b, const std::optional<Vector3>& plane)
      : a_(a), b_(b), plane_(plane) {
    const Vector3 centreA = a.sweep.start.R_WB * a.sweep.centre;
    const Vector3 centreB = b.sweep.start.R_WB * b.sweep.centre;
    between_ = (b.sweep.start.p_WB - a.sweep.start.p_WB) + (centreB - centreA);
  }

  TimeOfImpact search(Real duration, const ContactSearch& wanted) {
    TimeOfImpact result;
    Real now = 0;
    while (true) {
      const Matrix3 turnA = poseAt(a_.sweep, now).R_WB, turnB = poseAt(b_.sweep, now).R_WB;
      const PlacedCore coreA(a_.core, turnA), coreB(b_.core, turnB);
      const Vector3 centres = between_ + (travelled(b_.sweep, now) - travelled(a_.sweep, now));
      const Vector3 origins = centres + (turnA * a_.sweep.centre - turnB * b_.sweep.centre);
      const Separation found = separation(coreA, turnA, coreB, turnB, origins);
      const Real rounding = kUlp * (4 * centres.cwiseAbs().maxCoeff() + 8 * (a_.reach + b_.reach));
      const Real tolerance = std::max(wanted.tolerance, 3 * rounding);

      const auto endWith = [&](ImpactStatus status) {
        const Vector3 origin = poseAt(a_.sweep, now).p_WB;
        result.status = status;
        result.time = now;
        result.gap = found.separation;
        result.normal = found.normal;
        result.point = origin + (found.pointA + found.pointB) / 2;
        return result;
      };
      if (found.separation < -tolerance) {
        // Only the start can overlap: no advance goes further than contact.
        if (result.steps == 0) return endWith(ImpactStatus::kOverlapping);
        return endWith(ImpactStatus::kHit);
      }
      if (found.separation <= tolerance) return endWith(ImpactStatus::kHit);
      if (result.steps == wanted.maxSteps) return endWith(ImpactStatus::kLimit);

      const GapBound bound(a_, coreA, b_, coreB, centres, now, found.normal);
      const Real remaining = duration - now;
      const Real advance = safeAdvance(bound, tolerance / 3, remaining);
      if (advance >= remaining) {
        result.status = ImpactStatus::kNoHit;
        return result;
      }
      ++result.steps;
      if (now + advance == now) return endWith(ImpactStatus::kHit);  // the clock is too coarse
      now += advance;
    }
  }

 private:
  Separation separation(const PlacedCore& coreA, const Matrix3& turnA, const PlacedCore& coreB,
                        const Matrix3& turnB, const Vector3& origins) {
    if (!plane_) {
      return detail::gjkOfCores(a_.core, {turnA, Vector3::Zero()}, b_.core, {turnB, origins},
                                &cache_);
    }
    (void)coreA;
    Separation result;
    result.normal = *plane_;
    const Vector3 lowest = origins + coreB.support(-*plane_, 0).point - b_.core.radius * *plane_;
    result.separation = plane_->dot(lowest);
    result.pointB = lowest;
    result.pointA = lowest - result.separation * *plane_;
    return result;
  }

  const MovingCore& a_;
  const MovingCore& b_;
  std::optional<Vector3> plane_;
  Vector3 between_;  // from the centre of A to that of B at the start
  SimplexCache cache_;
};

// The plane of a half-space as a point on its way, which does not turn.
MovingCore planeOf(const HalfSpace& plane, const Sweep& sweep) {
  MovingCore part = {CoreShape{}, sweep};
  part.sweep.start.p_WB = pointToWorld(sweep.start, plane.offset * plane.normal);
  part.sweep.centre.setZero();
  return part;
}

TimeOfImpact earliest(const std::vector<MovingCore>& as, const std::vector<MovingCore>& bs,
                      const std::optional<Vector3>& plane, Real duration,
                      const ContactSearch& search) {
  TimeOfImpact best;
  for (const MovingCore& a : as) {
    for (const MovingCore& b : bs) {
      const bool found = best.status != ImpactStatus::kNoHit;
      TimeOfImpact next = Pair(a, b, plane).search(found ? best.time : duration, search);
      next.steps += best.steps;
      if (next.status != ImpactStatus::kNoHit && (!found || next.time < best.time)) {
        best = next;
      }
      best.steps = next.steps;
      if (best.status == ImpactStatus::kOverlapping) return best;
    }
  }
  return best;
}

}  // namespace

TimeOfImpact firstContact(const Shape& a, const Sweep& A, const Shape& b, const Sweep& B,
                          Real duration, const ContactSearch& search) {
  detail::requireSearchable(a, A, b, B, duration);
  requireNonNegative(search.tolerance, "search.tolerance");
  if (search.maxSteps < 1) {
    reject("search.maxSteps", std::to_string(search.maxSteps), "must be positive");
  }
  const HalfSpace* planeA = std::get_if<HalfSpace>(&a);
  const HalfSpace* planeB = std::get_if<HalfSpace>(&b);
  if (planeB) {
    TimeOfImpact result = earliest({planeOf(*planeB, B)}, movingCores(a, A),
                                   directionToWorld(B.start, planeB->normal), duration, search);
    result.normal = -result.normal;
    return result;
  }
  if (planeA) {
    return earliest({planeOf(*planeA, A)}, movingCores(b, B),
                    directionToWorld(A.start, planeA->normal), duration, search);
  }
  return earliest(movingCores(a, A), movingCores(b, B), std::nullopt, duration, search);
}

}  // namespace carom
