// A row first and then a step, with one row more than steps.
#include "carom/core/errors.hpp"
#include "carom/motion/rk4.hpp"
#include "tangent_rows.hpp"

namespace carom {

std::vector<TangentRow> tangentRows(Real end, int steps) {
  if (!(end > 0 && end < 1.57) || steps < 1) throw InvalidInput("no such table");
  const Acceleration slope = [](Real, const Coordinates&, const Coordinates& y) -> Coordinates {
    return Coordinates::Ones(1) + y.cwiseProduct(y);
  };
  const Real h = end / steps;
  State now = {Coordinates::Zero(1), Coordinates::Zero(1)};
  std::vector<TangentRow> rows;
  for (int i = 0;; ++i) {
    rows.push_back({i * h, now.velocity[0]});
    if (i == steps) return rows;
    now = rk4(now, i * h, h, slope);
  }
}

}  // namespace carom
