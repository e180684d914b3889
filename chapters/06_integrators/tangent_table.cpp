// Which value belongs beside which x?
//
// The example of section 7.4 of the source: a table of the tangent from 0 to 1, from y' = 1 + y^2
// in steps of a tenth. Beside it what the source's listing prints.

#include <cmath>
#include <iostream>
#include <vector>

#include "carom_io/table.hpp"
#include "tangent_rows.hpp"

using carom::Real;
using carom::TangentRow;

// The listing, line by line: the step comes before the row, the fourth slope takes k2, and x is
// added up.
std::vector<TangentRow> sourceRows(Real from, Real to, Real h) {
  const auto f = [](Real, Real y) { return 1 + y * y; };
  std::vector<TangentRow> rows;
  Real y = 0;
  for (Real x = from; x <= to; x = x + h) {
    const Real k1 = h * f(x, y);
    const Real k2 = h * f(x + h / 2, y + k1 / 2);
    const Real k3 = h * f(x + h / 2, y + k2 / 2);
    const Real k4 = h * f(x + h, y + k2);
    y = y + (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    rows.push_back({x, y});
  }
  return rows;
}

int main() {
  const std::vector<TangentRow> rows = carom::tangentRows(1, 10), source = sourceRows(0, 1, 0.1);
  carom::io::Table table;
  table.column("x", carom::io::fixed(1)).column("y", carom::io::fixed(6));
  table.column("tan x", carom::io::fixed(6)).column("error", carom::io::scientific(1));
  table.column("the source prints", carom::io::fixed(6));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Real tangent = std::tan(rows[i].x);
    table.row({rows[i].x, rows[i].y, tangent, rows[i].y - tangent,
               i < source.size() ? carom::io::Cell(source[i].y) : carom::io::Cell("")});
  }
  std::cout << "y' = 1 + y^2 in steps of 0.1\n\n" << table;
}
