#include "carom/toi/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/toi/moving_core.hpp"

namespace carom {
namespace {

using detail::CoreShape;
using detail::forEachCore;
using detail::MovingCore;
using detail::PlacedCore;

constexpr Real kUlp = std::numeric_limits<Real>::epsilon();

// When excess + slope t + bend t^2 / 2 comes down to zero, for a bend of zero or less; never:
// infinity.
Real untilNone(Real excess, Real slope, Real bend) {
  if (!(excess > 0)) return 0;
  const Real root = std::sqrt(slope * slope - 2 * bend * excess);
  if (slope < 0) return 2 * excess / (root - slope);
  return bend < 0 ? (slope + root) / -bend : std::numeric_limits<Real>::infinity();
}

// A pair at one moment, all that its gap can be bounded by.
struct Moment {
  const MovingCore& a;
  const MovingCore& b;
  const PlacedCore& coreA;
  const PlacedCore& coreB;
  Vector3 between;       // from the centre of A to that of B [m]
  Vector3 velocity;      // of B's centre against A's [m/s]
  Vector3 acceleration;  // the same [m/s^2]
  Vector3 normal;        // of the gap
};

// How long at least the gap stays at `least` or more, by what needs no support point: that no body
// reaches farther than its farthest corner, and none turns faster than that.
Real simpleAdvance(const Moment& m, Real gap, Real least) {
  const Real speed = m.normal.dot(m.velocity);
  const Real pull = std::min(Real(0), m.normal.dot(m.acceleration));
  const Real outside = m.normal.dot(m.between) - m.a.reach - m.b.reach;
  const Real far = untilNone(outside - m.a.core.radius - m.b.core.radius - least, speed, pull);
  const Real turning = length(cross(m.normal, m.a.sweep.angularVelocity)) * m.a.fromAxis +
                       length(cross(m.normal, m.b.sweep.angularVelocity)) * m.b.fromAxis;
  return std::max(far, untilNone(gap - least, speed - turning, pull));
}

// How large the gap is at least, for a while, along a normal that turns with `spin`. Any spin makes
// a bound; it is a good one if it is how the true normal turns.
class GapBound {
 public:
  struct Value {
    Real gap = 0;    // at least [m]
    Real slope = 0;  // of the bound [m/s]
  };

  // Holds for times from zero to `horizon`.
  GapBound(const Moment& m, const Vector3& spin, Real horizon)
      : m_(m),
        leanA_(cross(m.normal, Vector3(m.a.sweep.angularVelocity - spin))),
        leanB_(cross(m.normal, Vector3(m.b.sweep.angularVelocity - spin))),
        centreA_(m.coreA.R_WB * m.a.sweep.centre),
        centreB_(m.coreB.R_WB * m.b.sweep.centre) {
    gap_ = m.normal.dot(m.between) - m.a.core.radius - m.b.core.radius;
    speed_ = m.normal.dot(m.velocity) + cross(spin, m.normal).dot(m.between);
    const Real rate = length(spin);
    if (rate == 0) {
      // Points turn across the axis only: what of the normal is along the axis sees nothing of it.
      bend_ = std::min(Real(0), m.normal.dot(m.acceleration)) -
              length(m.a.sweep.angularVelocity) * length(leanA_) * m.a.fromAxis -
              length(m.b.sweep.angularVelocity) * length(leanB_) * m.b.fromAxis;
    } else {
      // The second derivative of (turned normal) . (turned arm): M'' = [w-s][w] - [s][w-s].
      const auto ofTurning = [&](const MovingCore& body) {
        const Vector3& w = body.sweep.angularVelocity;
        return length(Vector3(w - spin)) * (length(w) + rate) * body.reach;
      };
      const Real pull = length(m.acceleration), fastest = length(m.velocity) + pull * horizon;
      const Real farthest = length(m.between) + fastest * horizon;
      bend_ =
          -(rate * rate * farthest + 2 * rate * fastest + pull) - ofTurning(m.a) - ofTurning(m.b);
    }
  }

  Value at(Real later) const {
    const Vector3 forA = m_.normal + later * leanA_, forB = m_.normal + later * leanB_;
    const Vector3 armA = m_.coreA.support(forA, 0).point - centreA_;
    const Vector3 armB = m_.coreB.support(-forB, 0).point - centreB_;
    return {gap_ + later * speed_ + forB.dot(armB) - forA.dot(armA) + later * later / 2 * bend_,
            speed_ + leanB_.dot(armB) - leanA_.dot(armA) + later * bend_};
  }

  // When the tangent at the start, bent as far as it can be, comes down to `least`: the bound does
  // so then or before.
  Real latest(const Value& start, Real least) const {
    return untilNone(start.gap - least, start.slope, bend_);
  }

 private:
  const Moment& m_;
  Vector3 leanA_, leanB_, centreA_, centreB_;
  Real gap_ = 0, speed_ = 0, bend_ = 0;
};

// How long the bound stays at `least` or more, up to `horizon`; nearly, and never longer. The bound
// is concave, so a chord lies below it and a tangent above.
Real safeAdvance(const GapBound& bound, Real least, Real horizon) {
  const GapBound::Value start = bound.at(0);
  if (!(start.gap > least)) return 0;
  Real low = 0, lowGap = start.gap;
  Real high = std::min(horizon, bound.latest(start, least));
  GapBound::Value end = bound.at(high);
  if (end.gap >= least) return high;
  Real chord = 0;
  for (int i = 0; i < 50; ++i) {
    chord = low + (lowGap - least) / (lowGap - end.gap) * (high - low);
    const Real tangent = end.slope < 0 ? high - (end.gap - least) / end.slope : high;
    if (!(tangent > chord) || chord >= 0.99 * tangent) break;
    const GapBound::Value left = bound.at(chord);
    if (left.gap >= least) {
      low = chord;
      lowGap = left.gap;
    }
    if (tangent < high) {
      high = tangent;
      end = bound.at(high);
      if (end.gap >= least) return high;
    }
  }
  return chord;
}

// The longest step that one of the bounds allows. `spin`: how the normal seems to turn. The normal
// of a half-space does not.
Real longestAdvance(const Moment& m, bool plane, const Vector3& spin, Real gap, Real least,
                    Real remaining) {
  Real best = std::max(simpleAdvance(m, gap, least),
                       safeAdvance(GapBound(m, Vector3::Zero(), remaining), least, remaining));
  if (plane) return std::min(best, remaining);
  // Until it is known how the normal turns: as a face of A does, or one of B.
  const bool known = !spin.isZero(0);
  for (const Vector3& turn : {known ? spin : m.a.sweep.angularVelocity,
                              known ? Vector3(Vector3::Zero()) : m.b.sweep.angularVelocity}) {
    if (best >= remaining) return remaining;
    if (turn.isZero(0)) continue;
    const Real horizon = std::min(remaining, 4 * best);
    best = std::max(best, safeAdvance(GapBound(m, turn, horizon), least, horizon));
  }
  return std::min(best, remaining);
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
    const Vector3 acceleration = b_.sweep.acceleration - a_.sweep.acceleration;
    TimeOfImpact result;
    Real now = 0;
    Vector3 lastNormal = Vector3::Zero();
    Real lastAdvance = 0;
    while (true) {
      const PlacedCore coreA(a_.core, poseAt(a_.sweep, now).R_WB);
      const PlacedCore coreB(b_.core, poseAt(b_.sweep, now).R_WB);
      const Vector3 centres = between_ + (travelled(b_.sweep, now) - travelled(a_.sweep, now));
      const Vector3 origins =
          centres + (coreA.R_WB * a_.sweep.centre - coreB.R_WB * b_.sweep.centre);
      const Separation found = separation(coreA, coreB, origins);
      const Real rounding = kUlp * (4 * centres.cwiseAbs().maxCoeff() + 8 * (a_.reach + b_.reach));
      const Real tolerance = std::max(wanted.tolerance, 3 * rounding);

      const Vector3 spin = lastAdvance > 0 ? Vector3(cross(lastNormal, found.normal) / lastAdvance)
                                           : Vector3::Zero();

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

      const Vector3 velocity = (b_.sweep.velocity - a_.sweep.velocity) + now * acceleration;
      const Moment moment = {a_, b_, coreA, coreB, centres, velocity, acceleration, found.normal};
      const Real remaining = duration - now;
      const Real advance = longestAdvance(moment, plane_.has_value(), spin, found.separation,
                                          tolerance / 3, remaining);
      if (advance >= remaining) {
        result.status = ImpactStatus::kNoHit;
        return result;
      }
      ++result.steps;
      if (now + advance == now) return endWith(ImpactStatus::kHit);  // the clock is too coarse
      lastNormal = found.normal;
      lastAdvance = advance;
      now += advance;
    }
  }

 private:
  Separation separation(const PlacedCore& coreA, const PlacedCore& coreB, const Vector3& origins) {
    if (!plane_) {
      return detail::gjkOfCores(a_.core, {coreA.R_WB, Vector3::Zero()}, b_.core,
                                {coreB.R_WB, origins}, &cache_);
    }
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

// The earliest contact so far, and of one more pair of parts.
void keepEarliest(const MovingCore& a, const MovingCore& b, const std::optional<Vector3>& plane,
                  Real duration, const ContactSearch& search, TimeOfImpact& best) {
  if (best.status == ImpactStatus::kOverlapping) return;
  const bool found = best.status != ImpactStatus::kNoHit;
  TimeOfImpact next = Pair(a, b, plane).search(found ? best.time : duration, search);
  next.steps += best.steps;
  if (next.status != ImpactStatus::kNoHit && (!found || next.time < best.time)) best = next;
  best.steps = next.steps;
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
  TimeOfImpact best;
  if (planeA || planeB) {
    const MovingCore floor = planeA ? planeOf(*planeA, A) : planeOf(*planeB, B);
    const Vector3 normal = planeA ? directionToWorld(A.start, planeA->normal)
                                  : directionToWorld(B.start, planeB->normal);
    forEachCore(planeA ? b : a, planeA ? B : A, [&](const MovingCore& part) {
      keepEarliest(floor, part, normal, duration, search, best);
    });
    if (planeB) best.normal = -best.normal;
    return best;
  }
  forEachCore(a, A, [&](const MovingCore& one) {
    forEachCore(b, B, [&](const MovingCore& other) {
      keepEarliest(one, other, std::nullopt, duration, search, best);
    });
  });
  return best;
}

}  // namespace carom
