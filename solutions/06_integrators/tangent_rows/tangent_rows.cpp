// Exercise 06.tangent_rows: a table of the tangent, which somebody got wrong.
// Check it with: ./course check 06.tangent_rows

#include "tangent_rows.hpp"

#include "carom/core/checks.hpp"
#include "carom/motion/rk4.hpp"

namespace carom {
namespace {

// Given: y' = 1 + y^2, with y for the velocity. This part is right.
Coordinates slope(Real, const Coordinates&, const Coordinates& y) {
  return Coordinates::Constant(1, 1 + y[0] * y[0]);
}

}  // namespace

std::vector<TangentRow> tangentRows(Real end, int steps) {
  if (!(end > 0 && end < 1.57)) reject("end", toText(end), "must be between 0 and pi/2");
  if (steps < 1) reject("steps", std::to_string(steps), "must be at least one");
  const Real h = end / steps;
  State now = {Coordinates::Zero(1), Coordinates::Zero(1)};
  std::vector<TangentRow> rows;
  //# solution
  rows.push_back({0, 0});
  for (int i = 1; i <= steps; ++i) {
    now = rk4(now, (i - 1) * h, h, slope);
    rows.push_back({i * end / steps, now.velocity[0]});
  }
  //# stub
  //#| for (Real x = 0; x <= end; x = x + h) {
  //#|   now = rk4(now, x, h, slope);
  //#|   rows.push_back({x, now.velocity[0]});
  //#| }
  //# end
  return rows;
}

}  // namespace carom
