#include "carom/impulse/coulomb_impact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "carom/impulse/contact_equations.hpp"

namespace carom {

namespace {

// Friction between none, x = 0, and sticking, x = 1: -(S + s)^-1 w with s = trace(S) (1 - x)/x.
Vector2 frictionAt(Real x, const Matrix2& S, const Vector2& w) {
  Matrix2 softened = x * S;
  softened.diagonal().array() += (1 - x) * S.trace();
  return -x * solvePositive(softened, w);
}

// The friction on the edge of the cone: the root of |jt| - mu (j0 - c . jt) between x = 0 and 1.
Vector2 slidingFriction(const ContactEquations& eq, const Vector2& w, Real j0, Real friction) {
  const auto outside = [&](const Vector2& jt) {
    return jt.norm() - friction * (j0 - eq.coupling.dot(jt));
  };
  // Anderson and Björck: a chord between two signs; the end that stays behind is made lighter, so
  // that both close in. Bisection when the chord stalls.
  Real a = 0, fa = -friction * j0;
  Vector2 jt = frictionAt(1, eq.tangential, w);
  Real b = 1, fb = outside(jt);
  constexpr int kMost = 100;  // bisection alone would need 53
  for (int i = 0; i < kMost && fb != 0; ++i) {
    if (std::abs(b - a) <= std::numeric_limits<Real>::epsilon() * b) break;
    Real x = b - fb * (b - a) / (fb - fa);
    if (!(x > std::min(a, b) && x < std::max(a, b)) || i > 50) x = (a + b) / 2;
    jt = frictionAt(x, eq.tangential, w);
    const Real f = outside(jt);
    if ((f > 0) == (fb > 0)) {
      const Real lighter = 1 - f / fb;
      fa *= lighter > 0 ? lighter : 0.5;
    } else {
      a = b, fa = fb;
    }
    b = x, fb = f;
  }
  return jt;
}

}  // namespace

Impact coulombImpact(const MovingBody& a, const MovingBody& b, const Contact& contact,
                     const ImpactLaw& law) {
  const ContactEquations eq = checkedEquations(a, b, contact, law);
  if (eq.parting >= 0 || !(eq.inverseMass > 0)) return {};

  // Without friction: the normal impulse, and the slip that is left.
  const Real j0 = -(1 + law.restitution) * eq.parting / eq.inverseMass;
  const Vector2 w = eq.slip + eq.inverseMass * j0 * eq.coupling;

  // What sticking takes.
  const Vector2 stick = -solvePositive(eq.tangential, w);
  const Real normalOfStick = j0 - eq.coupling.dot(stick);
  if (stick.norm() <= law.friction * normalOfStick) {
    return {eq.inWorld(normalOfStick, stick), ContactMotion::sticks};
  }
  if (law.friction == 0) return {eq.inWorld(j0, Vector2::Zero()), ContactMotion::slides};

  // Of the root only the direction is kept; the sizes then follow exactly.
  const Vector2 jt = slidingFriction(eq, w, j0, law.friction);
  const Vector2 direction = jt / jt.norm();
  const Real jn = j0 / (1 + law.friction * eq.coupling.dot(direction));
  return {eq.inWorld(jn, law.friction * jn * direction), ContactMotion::slides};
}

PlanarImpact coulombImpact(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
                           const ImpactLaw& law) {
  const PlanarContactEquations eq = checkedEquations(a, b, contact, law);
  if (eq.parting >= 0 || !(eq.inverseMass > 0)) return {};

  const Real j0 = -(1 + law.restitution) * eq.parting / eq.inverseMass;
  const Real w = eq.slip + eq.inverseMass * j0 * eq.coupling;
  const Real stick = eq.tangential > 0 ? -w / eq.tangential : 0;
  const Real normalOfStick = j0 - eq.coupling * stick;
  if (std::abs(stick) <= law.friction * normalOfStick) {
    return {eq.inWorld(normalOfStick, stick), ContactMotion::sticks};
  }
  // Sticking is outside of the cone, so this divisor is positive: it is more than mu j0 / |stick|.
  const Real direction = std::copysign(1.0, stick);
  const Real jn = j0 / (1 + law.friction * eq.coupling * direction);
  return {eq.inWorld(jn, law.friction * jn * direction), ContactMotion::slides};
}

}  // namespace carom
