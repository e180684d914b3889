// How much does friction at a corner change the blow along the normal?
//
// A square of 1 kg and 2 m falls on a rough floor with one corner, at several angles, with 3 m/s
// downwards and 1 m/s sideways. Both impulses are solved for together; beside them stands what the
// normal impulse would be on a smooth floor, and how the corner moves afterwards.

#include <cmath>
#include <iostream>
#include <numbers>

#include "carom/core/elementary.hpp"
#include "carom/impulse/contact_matrix.hpp"
#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/planar_motion.hpp"
#include "carom_io/table.hpp"
#include "sticking_impulse.hpp"

using carom::PlanarBody;
using carom::PlanarContact;
using carom::Real;
using carom::Vector2;

constexpr Real kRestitution = 0.5;
const PlanarBody kFloor;  // nothing can move it

int main() {
  std::cout << "A square, turned by some degrees, falls on a rough floor with one\n"
               "corner, e = 0.5. Impulses [N s], and how the corner moves then [m/s]\n\n";
  carom::io::Table table;
  table.column("turned").column("friction", carom::io::fixed(4));
  table.column("normal", carom::io::fixed(4)).column("on ice", carom::io::fixed(4));
  table.column("slip", carom::io::fixed(3));
  table.column("parting", carom::io::fixed(3)).column("asked for", carom::io::fixed(3));
  for (int degrees = 0; degrees <= 90; degrees += 15) {
    const auto [s, c] = carom::sineCosine(degrees * std::numbers::pi / 180);
    // The corner that lies at (-1, -1) before the square is turned.
    const PlanarContact contact{{0, 1}, {0, 0}, {-c + s, -s - c}};
    const PlanarBody square{carom::planarBodyMass(1, 2.0 / 3), {{1, -3}, 0}};
    const carom::Matrix2 K = carom::contactMatrix(kFloor.mass, square.mass, contact);
    const Vector2 before = carom::planarPointVelocity(square.velocity, contact.armB);
    const Vector2 impulse = carom::stickingImpulse(K, before, kRestitution);
    const Vector2 after = before + K * impulse;
    // A slip of 1e-16 m/s is rounding, and is not printed with a sign.
    const Real slip = std::abs(after.x()) < 1e-12 ? 0 : after.x();
    table.row({static_cast<Real>(degrees), impulse.x(), impulse.y(),
               carom::impulse2d(kFloor, square, contact, kRestitution), slip, after.y(),
               -kRestitution * before.y()});
  }
  std::cout << table;
}
