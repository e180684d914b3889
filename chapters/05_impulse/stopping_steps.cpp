// How wrong is the place where a sliding crate stops, if time goes in steps?
//
// A crate slides with 4 m/s over a level floor, mu = 0.3. With each halving of the step the error
// halves as well: a method of first order.

#include <iostream>
#include <vector>

#include "carom_io/table.hpp"
#include "stopping_errors.hpp"

using carom::Real;

int main() {
  const std::vector<Real> steps = {1.0 / 15, 1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480};
  carom::io::Table table;
  table.column("step [ms]", carom::io::fixed(3)).column("stops at [m]", carom::io::fixed(5));
  table.column("error [mm]", carom::io::fixed(3)).column("times less", carom::io::fixed(2));
  Real before = 0;
  for (const carom::StoppingError& row : carom::stoppingErrors(4, 0.3, steps)) {
    const carom::io::Cell less =
        before == 0 ? carom::io::Cell("") : carom::io::Cell(before / row.error);
    table.row({1000 * row.step, row.distance, 1000 * row.error, less});
    before = row.error;
  }
  std::cout << "A crate at 4 m/s on a floor of mu = 0.3\n\n" << table;
}
