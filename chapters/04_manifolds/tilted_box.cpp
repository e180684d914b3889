// One contact point or four: what jumps when a box tilts by next to nothing?
//
// A box of 2 m by 2 m stands one micrometre deep in the floor. It tilts to the right and then as
// far to the left. However small the tilt, the lowest point jumps by the whole width; the depths of
// the four points change by as little as the box tilts.

#include <iostream>
#include <vector>

#include "carom_io/table.hpp"
#include "tilted_contact.hpp"

using carom::Real;

int main() {
  const std::vector<Real> tilts = {1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
  carom::io::Table table;
  table.column("tilt [rad]", carom::io::scientific(0));
  table.column("jump of the lowest point [m]", carom::io::fixed(6));
  table.column("change of a depth [m]", carom::io::scientific(2));
  for (const carom::TiltedContact& row : carom::tiltedContact(1, 1e-6, tilts)) {
    table.row({row.tilt, row.jump, row.depthChange});
  }
  std::cout << "A box of 2 m that tilts to one side, and then as far to the other\n\n" << table;
}
