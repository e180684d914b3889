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
#include "carom/detection/core_shape.hpp"
#include "carom/detection/gjk.hpp"

namespace carom {
namespace {

using detail::CoreShape;
using detail::PlacedCore;

constexpr Real kUlp = std::numeric_limits<Real>::epsilon();

// A convex part on its way: its core, and how its points can bend their paths.
struct MovingCore {
  CoreShape core;
  Sweep sweep;
  Real reach = 0;  // no point of the core is farther from the centre [m]
  Real bend = 0;   // |w|^2 times the greatest distance from the axis: no point bends more [m/s^2]
};

// Calls visit(corner) for points of the body's frame whose hull holds the core.
template <class Visit>
void forEachCorner(const CoreShape& core, const Visit& visit) {
  if (core.kind == detail::CoreKind::hull) {
    for (const Vector3& v : core.hull->vertices) visit(v);
    return;
  }
  for (int i = 0; i < 8; ++i) {
    const Vector3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    visit(Vector3(signs.cwiseProduct(core.extents)));
  }
}

MovingCore movingCore(const CoreShape& core, const Sweep& sweep) {
  MovingCore moving = {core, sweep};
  const Real rate = length(sweep.angularVelocity);
  Real farthest = 0, fromAxis = 0;  // squared
  forEachCorner(core, [&](const Vector3& corner) {
    const Vector3 arm = sweep.start.R_WB * (corner - sweep.centre);
    farthest = std::max(farthest, arm.squaredNorm());
    if (rate > 0) {
      fromAxis =
          std::max(fromAxis, cross(Vector3(sweep.angularVelocity / rate), arm).squaredNorm());
    }
  });
  moving.reach = std::sqrt(farthest);
  moving.bend = rate * rate * std::sqrt(fromAxis);
  return moving;
}

// The motion of the centre, less the turning about it.
Vector3 travelled(const Sweep& sweep, Real time) {
  return time * sweep.velocity + time * time / 2 * sweep.acceleration;
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
    // Points bend towards the axis only: what of the normal is along the axis sees nothing of it.
    const auto seen = [&](const MovingCore& m, const Vector3& lean) {
      const Real rate = length(m.sweep.angularVelocity);
      return rate > 0 ? m.bend * std::min(Real(1), length(lean) / rate) : 0;
    };
    bend_ = std::min(Real(0), normal.dot(acceleration)) - seen(a, leanA_) - seen(b, leanB_);
  }

  Value at(Real later) const {
    const Vector3 towardsB = normal_ + later * leanA_, towardsA = normal_ + later * leanB_;
    const Vector3 armA = coreA_.support(towardsB, 0).point - centreA_;
    const Vector3 armB = coreB_.support(-towardsA, 0).point - centreB_;
    return {gap_ + later * speed_ + towardsA.dot(armB) - towardsB.dot(armA) +
                later * later / 2 * bend_ - radii_,
            speed_ + leanB_.dot(armB) - leanA_.dot(armA) + later * bend_};
  }

  // How much the bound can bend [m/s^2], zero or less.
  Real bend() const {
    return bend_;
  }

 private:
  const PlacedCore& coreA_;
  const PlacedCore& coreB_;
  Vector3 normal_, leanA_, leanB_, centreA_, centreB_;
  Real gap_ = 0, speed_ = 0, bend_ = 0, radii_ = 0;
};

// How long the bound stays at `least` or more, up to `remaining`; nearly, and never longer. The
// bound is concave, so a chord lies below it and a tangent above.
Real safeAdvance(const GapBound& bound, Real least, Real remaining) {
  const GapBound::Value start = bound.at(0);
  if (!(start.gap > least)) return 0;
  GapBound::Value end = bound.at(remaining);
  if (end.gap >= least) return remaining;

  Real low = 0, lowGap = start.gap, high = remaining;
  // Where the tangent at the start, bent as far as it can be, comes down to `least`.
  const Real excess = start.gap - least, falling = -start.slope;
  const Real root = std::sqrt(falling * falling - 2 * bound.bend() * excess);
  const Real first = falling >= 0 ? 2 * excess / (falling + root) : (falling - root) / bound.bend();
  if (first < high) {
    high = first;
    end = bound.at(high);
    if (end.gap >= least) return high;
  }
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

// What a pair is asked for at one time.
struct Meeting {
  Separation separation;
  Real rounding = 0;  // of the gap [m]
};

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

struct Part {
  CoreShape core;
  Sweep sweep;
};

// The convex parts of a solid, each with the motion of the whole.
std::vector<Part> partsOf(const Shape& shape, const Sweep& sweep) {
  std::vector<Part> parts;
  const auto add = [&](const auto& convex, const Pose& inBody) {
    Sweep own = sweep;
    own.start = composed(sweep.start, inBody);
    own.centre = pointToBody(inBody, sweep.centre);
    parts.push_back({detail::coreOf(convex), own});
  };
  std::visit(
      [&](const auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, Compound>) {
          for (const CompoundPart& part : s.parts) {
            std::visit([&](const auto& convex) { add(convex, part.pose); }, part.shape);
          }
        } else if constexpr (!std::is_same_v<S, HalfSpace>) {
          add(s, Pose{});
        }
      },
      shape);
  return parts;
}

// The plane of a half-space as a point on its way, which does not turn.
Part planeOf(const HalfSpace& plane, const Sweep& sweep) {
  Part part = {CoreShape{}, sweep};
  part.sweep.start.p_WB = pointToWorld(sweep.start, plane.offset * plane.normal);
  part.sweep.centre.setZero();
  return part;
}

TimeOfImpact earliest(const std::vector<Part>& as, const std::vector<Part>& bs,
                      const std::optional<Vector3>& plane, Real duration,
                      const ContactSearch& search) {
  TimeOfImpact best;
  for (const Part& a : as) {
    for (const Part& b : bs) {
      const MovingCore movingA = movingCore(a.core, a.sweep), movingB = movingCore(b.core, b.sweep);
      const bool found = best.status != ImpactStatus::kNoHit;
      TimeOfImpact next =
          Pair(movingA, movingB, plane).search(found ? best.time : duration, search);
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
  requireUsable(A, "A");
  requireUsable(B, "B");
  requireNonNegative(duration, "duration");
  requireNonNegative(search.tolerance, "search.tolerance");
  if (search.maxSteps < 1) {
    reject("search.maxSteps", std::to_string(search.maxSteps), "must be positive");
  }
  const HalfSpace* planeA = std::get_if<HalfSpace>(&a);
  const HalfSpace* planeB = std::get_if<HalfSpace>(&b);
  if (planeA && planeB) reject("shapes", "two half-spaces", "must not both be without end");
  for (const Sweep* moving : {planeA ? &A : nullptr, planeB ? &B : nullptr}) {
    if (moving && !moving->angularVelocity.isZero(0)) {
      reject("angularVelocity of a half-space", toText(moving->angularVelocity), "must be zero");
    }
  }
  if (planeB) {
    TimeOfImpact result = earliest({planeOf(*planeB, B)}, partsOf(a, A),
                                   directionToWorld(B.start, planeB->normal), duration, search);
    result.normal = -result.normal;
    return result;
  }
  if (planeA) {
    return earliest({planeOf(*planeA, A)}, partsOf(b, B), directionToWorld(A.start, planeA->normal),
                    duration, search);
  }
  return earliest(partsOf(a, A), partsOf(b, B), std::nullopt, duration, search);
}

}  // namespace carom
