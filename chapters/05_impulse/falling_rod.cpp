// Can an impact with friction make energy?
//
// First a square whose corner hits the floor: the impulse along the normal and that of friction, one
// after the other and together. Then a rod that hits the floor with its lower end while it moves
// forwards or backwards. Two laws of impact, both with the same coefficients; both give the end of
// the rod the speed that was asked for.

#include <filesystem>
#include <iostream>
#include <numbers>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/impulse/contact_matrix.hpp"
#include "carom/impulse/coulomb_impact.hpp"
#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/passive_impact.hpp"
#include "carom/impulse/planar_motion.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::ImpactLaw;
using carom::PlanarBody;
using carom::PlanarContact;
using carom::Real;
using carom::Vector2;

const Vector2 kUp(0, 1);
const PlanarBody kFloor;  // nothing can move it

Vector2 velocityAt(const PlanarBody& body, const PlanarContact& contact) {
  return carom::planarPointVelocity(body.velocity, contact.armB);
}

// Section 6.5 of the source: the two impulses are reckoned and applied
// apart. Here with a friction that would be enough to stop the slip.
Vector2 apart(const PlanarBody& body, const PlanarContact& contact, Real e) {
  const carom::Matrix2 K = carom::contactMatrix(kFloor.mass, body.mass, contact);
  const Vector2 normal = carom::impulse2d(kFloor, body, contact, e) * kUp;
  const Vector2 left = velocityAt(body, contact) + K * normal;
  const Vector2 friction(-left.x() / K(0, 0), 0);
  return normal + friction;
}

void corner() {
  std::cout << "A square of 1 kg and 2 m hits the floor with a corner, e = 0.5, rough floor\n\n";
  const PlanarBody square{carom::planarBodyMass(1, 2.0 / 3), {{1, -3}, 2}};
  const PlanarContact contact{kUp, Vector2::Zero(), {-0.8, -1.1}};
  const ImpactLaw rough{.restitution = 0.5, .friction = 1};
  const carom::Matrix2 K = carom::contactMatrix(kFloor.mass, square.mass, contact);
  const Vector2 before = velocityAt(square, contact);
  carom::io::Table table;
  table.column("impulses").column("friction", carom::io::fixed(4));
  table.column("normal [N s]", carom::io::fixed(4)).column("slip [m/s]", carom::io::fixed(3));
  table.column("parting [m/s]", carom::io::fixed(3));
  const auto row = [&](const char* name, const Vector2& impulse) {
    const Vector2 after = before + K * impulse;
    table.row({name, impulse.x(), impulse.y(), after.x(), after.y()});
  };
  row("one after the other", apart(square, contact, rough.restitution));
  row("together", carom::coulombImpact(kFloor, square, contact, rough).impulse);
  std::cout << table << "Asked for: no slip, parting at "
            << carom::io::Cell(-rough.restitution * before.y()).text(carom::io::fixed(3))
            << " m/s\n\n";
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  corner();

  std::cout << "A rod of 1 kg and 2 m at 47 degrees falls on its end at 1 m/s,\ne = 0.9, friction "
               "0.5: energy after the impact over that before\n\n";
  const auto [s, c] = carom::sineCosine(47 * std::numbers::pi / 180);
  const PlanarContact contact{kUp, Vector2::Zero(), {-c, -s}};
  const ImpactLaw law{.restitution = 0.9, .friction = 0.5};
  carom::io::Table table;
  table.column("forward speed [m/s]", carom::io::fixed(2));
  table.column("Newton and Coulomb", carom::io::fixed(4));
  table.column("the passive law", carom::io::fixed(4));
  std::vector<Real> speeds, newton, passive;
  for (int i = -20; i <= 20; ++i) {
    const PlanarBody rod{carom::planarBodyMass(1, 1.0 / 3), {{i / 10.0, -1}, 0}};
    const carom::Matrix2 K = carom::contactMatrix(kFloor.mass, rod.mass, contact);
    const Vector2 u = velocityAt(rod, contact);
    const auto energyAfter = [&](const Vector2& impulse) {
      const Real before = rod.velocity.linear.squaredNorm() / 2;
      return 1 + carom::impactEnergyChange(K, u, impulse) / before;
    };
    speeds.push_back(u.x());
    newton.push_back(energyAfter(carom::coulombImpact(kFloor, rod, contact, law).impulse));
    passive.push_back(energyAfter(carom::passiveImpact(kFloor, rod, contact, law).impulse));
    if (i % 5 == 0) table.row({speeds.back(), newton.back(), passive.back()});
  }
  std::cout << table;
  carom::io::Plot plot("Energy of a rod after an impact");
  plot.xAxis("forward speed [m/s]").yAxis("energy after / energy before").yRange(0, 1.2);
  plot.describe("With Newton's restitution and Coulomb's friction the curve rises above one.");
  plot.curve("Newton and Coulomb", speeds, newton).curve("the passive law", speeds, passive);
  plot.curve("no change", {-2, 2}, {1, 1}, {.dashed = true, .width = 1});
  plot.writeSvg(folder / "falling_rod.svg");
}
