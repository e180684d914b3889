// How long may a step be before a spring explodes?
//
// A step of any of these methods on a spring is linear: it multiplies position and velocity with a
// matrix of two rows. If an eigenvalue of that matrix is larger than one, something grows with
// every step. Only the product of the step and the spring's angular frequency matters.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/motion/yoshida.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Coordinates;
using carom::Real;
using carom::State;

struct Method {
  std::string name;
  carom::Step step;
};

const std::vector<Method> kMethods = {
    {"explicit Euler", carom::explicitEuler},   {"semi-implicit Euler", carom::semiImplicitEuler},
    {"velocity Verlet", carom::velocityVerlet}, {"Runge and Kutta's", carom::rk4},
    {"Yoshida's, order 4", carom::yoshida4},    {"Yoshida's, order 6", carom::yoshida6},
};

Coordinates spring(Real, const Coordinates& x, const Coordinates&) {
  return -x;
}

//! [growth]
// The larger eigenvalue of the matrix of a step, in size.
Real growth(const Method& method, Real dt) {
  const Coordinates one = Coordinates::Ones(1), none = Coordinates::Zero(1);
  const State x = method.step({one, none}, 0, dt, spring);
  const State v = method.step({none, one}, 0, dt, spring);
  const Real a = x.position[0], b = v.position[0];
  const Real c = x.velocity[0], d = v.velocity[0];
  const Real halfTrace = (a + d) / 2, determinant = a * d - b * c;
  const Real root = halfTrace * halfTrace - determinant;
  if (root < 0) return std::sqrt(determinant);  // a complex pair
  return std::abs(halfTrace) + std::sqrt(root);
}
//! [growth]

// The first step at which something grows by more than rounding, to six digits.
Real longestStep(const Method& method) {
  const auto grows = [&](Real dt) { return growth(method, dt) > 1 + 1e-12; };
  Real low = 0.01, high = low;
  if (grows(low)) return 0;
  while (!grows(high)) high += 0.01;
  low = high - 0.01;
  for (int i = 0; i < 30; ++i) {
    const Real middle = (low + high) / 2;
    (grows(middle) ? high : low) = middle;
  }
  return low;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::cout << "The longest step at which nothing grows, times the angular frequency,\n"
               "and what a step of 0.1 does to the amplitude\n\n";
  carom::io::Table table;
  table.column("method").column("forces").column("longest", carom::io::fixed(4));
  table.column("per force", carom::io::fixed(3)).column("growth at 0.1", carom::io::fixed(9));
  const std::vector<int> forces = {1, 1, 1, 4, 3, 7};
  carom::io::Plot plot("What a step does to the amplitude of a spring");
  plot.xAxis("step times angular frequency").yAxis("growth").xRange(0, 3).yRange(0.6, 2);
  plot.describe(
      "Explicit Euler grows from the start. The symplectic methods stay at one until two "
      "and shoot up from there. Runge and Kutta's falls below one, and grows from 2.8.");
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    const Real longest = longestStep(kMethods[m]);
    table.row(
        {kMethods[m].name, forces[m], longest, longest / forces[m], growth(kMethods[m], 0.1)});
    if (m > 3) continue;
    std::vector<Real> steps, growths;
    for (int i = 1; i <= 300; ++i) {
      steps.push_back(i / 100.0);
      growths.push_back(std::min(growth(kMethods[m], steps.back()), Real(3)));
    }
    plot.curve(kMethods[m].name, steps, growths, {.dashed = m == 2});
  }
  std::cout << table;
  plot.writeSvg(folder / "longest_step.svg");
}
