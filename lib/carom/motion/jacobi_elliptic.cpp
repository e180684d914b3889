#include "carom/motion/jacobi_elliptic.hpp"

#include <cmath>
#include <numbers>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"

namespace carom {
namespace {

constexpr Real kPi = std::numbers::pi;

}  // namespace

// The halved difference c = sqrt(a^2 - b^2) shrinks quadratically: c' = c^2 / (4 a'). Where it is a
// tenth of a rounding error of a, the modulus is zero for all that doubles can tell.
JacobiElliptic::JacobiElliptic(Real complement, Real modulus) {
  if (!(complement > 0 && complement <= 1)) {
    reject("complement", toText(complement), "must be above zero and at most one");
  }
  if (!(modulus >= 0 && modulus <= 1)) {
    reject("modulus", toText(modulus), "must be from zero to one");
  }
  a_[0] = 1;
  b_[0] = complement;
  Real c = modulus;
  for (std::size_t i = 0; c > 1e-17 * a_[i] && steps_ < kMost; ++i, ++steps_) {
    a_[i + 1] = (a_[i] + b_[i]) / 2;
    b_[i + 1] = std::sqrt(a_[i] * b_[i]);
    c = c * c / (4 * a_[i + 1]);
  }
}

JacobiElliptic::JacobiElliptic(Real complement)
    : JacobiElliptic(complement, complement > 0 && complement <= 1
                                     ? std::sqrt((1 - complement) * (1 + complement))
                                     : 0) {}

Real JacobiElliptic::quarterPeriod() const {
  return kPi / (2 * mean());
}

EllipticFunctions JacobiElliptic::at(Real phase) const {
  const SineCosine circle = sineCosine(phase);
  if (circle.sine == 0) return {0, circle.cosine, 1};
  // Bulirsch's recurrence for cn/sn, from the smallest modulus back to the one wanted.
  Real ratio = circle.cosine / circle.sine, dn = 1;
  Real c = ratio * mean();
  for (int i = steps_ - 1; i >= 0; --i) {
    ratio *= c;
    c *= dn;
    dn = (b(i) + ratio) / (a(i) + ratio);
    ratio = c / a(i);
  }
  // Beyond 1e150 the square would overflow, and the root is |c| long before.
  const Real size = std::abs(c) < 1e150 ? std::sqrt(1 + c * c) : std::abs(c);
  const Real sn = std::copysign(1 / size, circle.sine);
  return {sn, c * sn, dn};
}

// The phase in the first quadrant: tan(next - last) = (b/a) tan(last) doubles the angle at each
// mean.
Real JacobiElliptic::firstPhase(Real sn, Real cn) const {
  Real angle = arctangent2(sn, cn), scale = 1;
  for (int i = 0; i < steps_; ++i) {
    const SineCosine s = sineCosine(angle);
    const Real step = arctangent2(b(i) * s.sine, a(i) * s.cosine);
    // In the same turn as the angle itself: the two are never further apart than a quarter turn.
    angle += step + 2 * kPi * std::round((angle - step) / (2 * kPi));
    scale /= 2;
  }
  return angle * scale;
}

Real JacobiElliptic::phaseOf(Real sn, Real cn) const {
  requireFinite(sn, "sn");
  requireFinite(cn, "cn");
  const Real s = std::abs(sn), c = std::abs(cn), k = b(0);
  // Near a quarter period the angle is nearly a right one and says little; there the distance to
  // the quarter period is found, sn(K - u) / cn(K - u) = cn / (k' sn).
  Real phase = k * s * s < c * c ? firstPhase(s, c) : kPi / 2 - firstPhase(c, k * s);
  if (cn < 0) phase = kPi - phase;
  return sn < 0 ? -phase : phase;
}

}  // namespace carom
