// Exercise 09.sequential_impulses: many contacts, one after the other
// Check it with: ./course check 09.sequential_impulses

#include "carom/solver/sequential_impulses.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

void sequentialImpulses(std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps) {
  if (sweeps < 0) reject("sweeps", std::to_string(sweeps), "must not be negative");
  //# solution
  for (int n = 0; n < sweeps; ++n) {
    for (ContactRow& row : rows) {
      const Real missing = row.target - partingSpeed(row, bodies);
      const Real total = std::max(Real(0), row.impulse + rowMass(row, bodies) * missing);
      pushRow(row, total - row.impulse, bodies);
      row.impulse = total;
    }
  }
  //# stub
  // partingSpeed(row, bodies) is how fast its bodies part, rowMass(row, bodies) how much impulse
  // changes that by 1 m/s, pushRow(row, impulse, bodies) pushes them apart.
  // row.impulse is the sum of what the row has given so far.
  //#| return todo<void>("sequentialImpulses");
  //# end
}

}  // namespace carom
