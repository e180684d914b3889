// What do the source's equations for an impulse do, and what should they?
//
// Equations 27 to 31 in the plane, on the smallest cases that tell right from wrong: each row is one
// impact, computed once as it is printed in the source and once with the library. Beside the
// velocities stands what an impact must not change.

#include <iostream>
#include <string>

#include "carom/impulse/change_velocities.hpp"
#include "carom/impulse/combine_restitution.hpp"
#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/planar_motion.hpp"
#include "carom_io/table.hpp"

using carom::PlanarBody;
using carom::PlanarContact;
using carom::Real;
using carom::Vector2;

const Vector2 kNormal = Vector2::UnitX();  // from A to B

PlanarBody body(Real mass, Real inertia, Real speed) {
  return {carom::planarBodyMass(mass, inertia), {{speed, 0}, 0}};
}

Real momentum(const PlanarBody& a, const PlanarBody& b) {
  return a.velocity.linear.x() / a.mass.inverseMass + b.velocity.linear.x() / b.mass.inverseMass;
}

Real energy(const PlanarBody& body) {
  const Real turning =
      body.mass.inverseInertia == 0
          ? 0
          : body.velocity.angular * body.velocity.angular / body.mass.inverseInertia;
  return (body.velocity.linear.squaredNorm() / body.mass.inverseMass + turning) / 2;
}

//! [source29]
// Equation 29 adds the impulse to B as (28) adds it to A.
void applyAsInSource(Real j, PlanarBody& a, PlanarBody& b) {
  a.velocity.linear += j * a.mass.inverseMass * kNormal;
  b.velocity.linear += j * b.mass.inverseMass * kNormal;
}
//! [source29]

void headOn() {
  std::cout << "Two balls, 1 kg at 3 m/s and 2 kg at -1 m/s, meet head-on\n\n";
  carom::io::Table table;
  table.column("e", carom::io::fixed(1)).column("by");
  for (const char* title : {"A [m/s]", "B [m/s]", "momentum [N s]", "energy [J]"}) {
    table.column(title, carom::io::fixed(3));
  }
  const PlanarBody a = body(1, 1, 3), b = body(2, 1, -1);
  table.row({"", "before", 3.0, -1.0, momentum(a, b), energy(a) + energy(b)});
  for (const Real e : {1.0, 0.5, 0.0}) {
    const PlanarContact contact{kNormal, Vector2::Zero(), Vector2::Zero()};
    const Real j = carom::impulse2d(a, b, contact, e);
    for (const bool source : {false, true}) {
      PlanarBody after = a, other = b;
      // The source's j is that of A, whose normal points from B to A: the opposite of ours.
      if (source) {
        applyAsInSource(-j, after, other);
      } else {
        changeVelocities(after, other, contact, j * kNormal);
      }
      table.row({e, source ? "the source (29)" : "the library", after.velocity.linear.x(),
                 other.velocity.linear.x(), momentum(after, other), energy(after) + energy(other)});
    }
  }
  std::cout << table;
}

//! [source31]
// The denominator of equation 31, with its dot product, for a body B.
Real sourceDenominator(const PlanarBody& b, const PlanarContact& contact) {
  const Real rn = contact.armB.dot(contact.normal);
  return b.mass.inverseMass + rn * rn * b.mass.inverseInertia;
}
//! [source31]

void againstWall() {
  std::cout << "\nA disc of 1 kg and 1 m flies into a wall at 1 m/s. A rod of 3 kg and\n2 m, at "
               "rest, is hit 0.8 m from its middle by 1 kg with 5 m/s. e = 1.\nL: angular momentum "
               "about the middle of the rod [kg m^2/s]\n\n";
  carom::io::Table table;
  table.column("").column("by").column("j [N s]", carom::io::fixed(3));
  table.column("v [m/s]", carom::io::fixed(3)).column("spin [1/s]", carom::io::fixed(3));
  table.column("E [J]", carom::io::fixed(2)).column("L", carom::io::fixed(1));

  // The wall is A, so B flies against the normal.
  const PlanarBody wall;
  for (const bool source : {false, true}) {
    PlanarBody disc = body(1, 0.5, -1), still = wall;
    const PlanarContact contact{kNormal, Vector2::Zero(), {-1, 0}};
    const Real j =
        source ? 2 / sourceDenominator(disc, contact) : carom::impulse2d(wall, disc, contact, 1);
    changeVelocities(still, disc, contact, j * kNormal);
    table.row({"disc, head-on", source ? "the source (31)" : "the library", j,
               disc.velocity.linear.x(), disc.velocity.angular, energy(disc), 0.0});
  }
  table.row({"rod, off-centre", "before", "", 0.0, 0.0, energy(body(1, 1, 5)), 0.8 * 5});
  for (const bool source : {false, true}) {
    PlanarBody ball = body(1, 1, 5), rod = body(3, 1, 0);
    const PlanarContact contact{kNormal, Vector2::Zero(), {0, -0.8}};
    const Real j = source ? 10 / (ball.mass.inverseMass + sourceDenominator(rod, contact))
                          : carom::impulse2d(ball, rod, contact, 1);
    changeVelocities(ball, rod, contact, j * kNormal);
    // Equation 30: the turning is r . j n, zero for this hit.
    if (source) rod.velocity.angular = contact.armB.dot(j * kNormal) * rod.mass.inverseInertia;
    // About the middle of the rod: the ball flies past it at 0.8 m.
    const Real angularMomentum = 0.8 * ball.velocity.linear.x() + rod.velocity.angular;
    table.row({"rod, off-centre", source ? "the source (31)" : "the library", j,
               rod.velocity.linear.x(), rod.velocity.angular, energy(ball) + energy(rod),
               angularMomentum});
  }
  std::cout << table;
}

void arms() {
  std::cout << "\nA disc of 1 m moves forwards at 1 m/s and spins backwards at 2 rad/s.\nHow fast "
               "is its lowest point?\n\n";
  carom::io::Table table;
  table.column("arm").column("velocity [m/s]", carom::io::fixed(1));
  const carom::PlanarVelocity motion{{1, 0}, 2};
  //! [arm]
  const Vector2 center(0, 1), lowest(0, 0);
  const Vector2 right = carom::planarPointVelocity(motion, lowest - center);
  const Vector2 wrong = carom::planarPointVelocity(motion, center - lowest);
  //! [arm]
  table.row({"contact - centre of mass (25)", right.x()});
  table.row({"centre of mass - contact (section 6.4)", wrong.x()});
  std::cout << table;
}

void restitutions() {
  std::cout << "\nTwo balls with e = 0.8 each: the energy of their relative motion, times\n\n";
  carom::io::Table table;
  table.column("rule").column("e", carom::io::fixed(2));
  table.column("after one impact", carom::io::fixed(3));
  table.column("after ten", carom::io::significant(6));
  using Rule = carom::RestitutionRule;
  const auto row = [&table](const std::string& name, Real e) {
    Real ten = 1;
    for (int i = 0; i < 10; ++i) ten *= e * e;
    table.row({name, e, e * e, ten});
  };
  row("sum (the source)", 0.8 + 0.8);
  row("product", carom::combineRestitution(0.8, 0.8, Rule::product));
  row("average", carom::combineRestitution(0.8, 0.8, Rule::average));
  row("geometric mean", carom::combineRestitution(0.8, 0.8, Rule::geometricMean));
  row("maximum", carom::combineRestitution(0.8, 0.8, Rule::maximum));
  std::cout << table;
}

int main() {
  headOn();
  againstWall();
  arms();
  restitutions();
}
