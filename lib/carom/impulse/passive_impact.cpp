#include "carom/impulse/passive_impact.hpp"

#include <cmath>

#include "carom/impulse/contact_equations.hpp"

namespace carom {

namespace {

// How much of what sticking adds is allowed: at most `wanted`, and no more than puts the impulse on
// the cone. `normal` is (1 + e) P_I; what sticking adds has the size `across` and the normal part
// `along`.
Real shareOfStick(Real wanted, Real normal, Real across, Real along, Real friction) {
  if (wanted * across <= friction * (normal + wanted * along)) return wanted;
  // Here across - friction along is more than friction normal / wanted, so the division is safe.
  return friction * normal / (across - friction * along);
}

}  // namespace

Impact passiveImpact(const MovingBody& a, const MovingBody& b, const Contact& contact,
                     const ImpactLaw& law) {
  const ContactEquations eq = checkedEquations(a, b, contact, law);
  if (eq.parting >= 0 || !(eq.inverseMass > 0)) return {};

  // P_I, and P_II - P_I: the friction that stops the slip which P_I leaves, and the normal impulse
  // that goes with it.
  const Real plastic = -eq.parting / eq.inverseMass;
  const Vector2 slip = eq.slip - eq.parting * eq.coupling;
  const Vector2 addedTangential = -solvePositive(eq.tangential, slip);
  const Real addedNormal = -eq.coupling.dot(addedTangential);

  const Real wanted = 1 + law.tangentialRestitution;
  const Real normal = (1 + law.restitution) * plastic;
  const Real share =
      shareOfStick(wanted, normal, addedTangential.norm(), addedNormal, law.friction);
  return {eq.inWorld(normal + share * addedNormal, share * addedTangential),
          share == wanted ? ContactMotion::sticks : ContactMotion::slides};
}

PlanarImpact passiveImpact(const PlanarBody& a, const PlanarBody& b, const PlanarContact& contact,
                           const ImpactLaw& law) {
  const PlanarContactEquations eq = checkedEquations(a, b, contact, law);
  if (eq.parting >= 0 || !(eq.inverseMass > 0)) return {};

  const Real plastic = -eq.parting / eq.inverseMass;
  const Real slip = eq.slip - eq.parting * eq.coupling;
  const Real addedTangential = eq.tangential > 0 ? -slip / eq.tangential : 0;
  const Real addedNormal = -eq.coupling * addedTangential;

  const Real wanted = 1 + law.tangentialRestitution;
  const Real normal = (1 + law.restitution) * plastic;
  const Real share =
      shareOfStick(wanted, normal, std::abs(addedTangential), addedNormal, law.friction);
  return {eq.inWorld(normal + share * addedNormal, share * addedTangential),
          share == wanted ? ContactMotion::sticks : ContactMotion::slides};
}

}  // namespace carom
