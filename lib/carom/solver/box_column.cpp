#include "carom/solver/box_column.hpp"

#include "carom/core/checks.hpp"

namespace carom {

BoxColumn boxColumn(std::span<const Real> masses) {
  BoxColumn column;
  column.bodies.emplace_back();
  for (const Real mass : masses) {
    requirePositive(mass, "mass");
    ContactRow row;
    row.bodyA = static_cast<int>(column.bodies.size()) - 1;
    row.bodyB = row.bodyA + 1;
    row.name = row.bodyA;
    column.rows.push_back(row);
    column.bodies.emplace_back().mass.inverseMass = 1 / mass;
  }
  return column;
}

void pullDown(std::span<MovingBody> bodies, Real change) {
  for (MovingBody& body : bodies) {
    if (body.mass.inverseMass > 0) body.velocity.linear.z() += change;
  }
}

}  // namespace carom
