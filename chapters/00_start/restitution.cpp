// What does the coefficient of restitution do, and what goes wrong without one small question?
//
// The two balls of first_collision meet with five coefficients. Then they meet with five steps of
// time, once as they should and once without asking whether they approach one another.

#include <iostream>

#include "carom_io/table.hpp"
#include "two_balls.hpp"

using namespace two_balls;
using carom::io::fixed;

// What became of the pair, measured along the normal of the first contact.
struct Result {
  Real overlap = 0;   // when the contact is noticed [m]
  Real approach = 0;  // just before [m/s]
  Real apart = 0;     // at the end [m/s]
  Real lost = 0;      // kinetic energy [J]
};

Result play(Real dt, Real restitution, bool askFirst) {
  Pair pair;
  const Real initialEnergy = energy(pair);
  Vector2 normal = Vector2::Zero();
  Result result;
  for (int i = 0; i * dt < 1.6; ++i) {
    const Pair before = pair;
    step(pair, dt, restitution, askFirst);
    if (result.approach == 0 && pair.red.velocity != before.red.velocity) {
      const Vector2 offset = pair.red.position - pair.blue.position;
      normal = offset.normalized();
      result.overlap = 2 * kRadius - offset.norm();
      result.approach = normal.dot(before.blue.velocity - before.red.velocity);
    }
  }
  result.apart = normal.dot(pair.red.velocity - pair.blue.velocity);
  result.lost = initialEnergy - energy(pair);
  return result;
}

int main() {
  std::cout << "Five coefficients, steps of 1 ms\n\n";
  carom::io::Table cases;
  cases.column("e", fixed(2)).column("approach [m/s]", fixed(4)).column("apart [m/s]", fixed(4));
  cases.column("energy lost [mJ]", fixed(4)).column("formula [mJ]", fixed(4));
  for (Real e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Result r = play(0.001, e, true);
    //! [formula]
    const Real k = 1 / kMass + 1 / kMass;  // [1/kg]
    const Real formula = (1 - e * e) * r.approach * r.approach / (2 * k);
    //! [formula]
    cases.row({e, r.approach, r.apart, 1000 * r.lost, 1000 * formula});
  }
  std::cout << cases << "\nSpeed apart / speed of approach, which should be e = 0.5\n\n";

  carom::io::Table steps;
  steps.column("step [ms]", fixed(0)).column("overlap [mm]", fixed(3));
  steps.column("asked", fixed(3)).column("not asked", fixed(3));
  for (Real milliseconds : {1, 2, 5, 10, 20}) {
    const Result asked = play(milliseconds / 1000, 0.5, true);
    const Result notAsked = play(milliseconds / 1000, 0.5, false);
    steps.row({milliseconds, 1000 * asked.overlap, asked.apart / asked.approach,
               notAsked.apart / notAsked.approach});
  }
  std::cout << steps;
}
