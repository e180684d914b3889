// How far is a stone off after ten seconds of falling in steps?
//
// A stone falls from rest, without air, as in figure 9 of the source. Each method makes steps of
// 1 s, 0.1 s and 0.01 s; the answer is known, so what is printed is the error. Then the same
// methods with gravity counted as equation 45 counts it, and a clock that adds its steps up.

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
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Acceleration;
using carom::Coordinates;
using carom::Real;
using carom::State;
using carom::Step;

const Real kGravity = -9.81;  // [m/s^2]
const State kAtRest = {Coordinates::Zero(1), Coordinates::Zero(1)};

Coordinates fall(Real, const Coordinates&, const Coordinates&) {
  return Coordinates::Constant(1, kGravity);
}

//! [gravity_twice]
// Equation 45: the sum of all forces holds the weight already.
Coordinates fallTwice(Real, const Coordinates&, const Coordinates&) {
  const Real mass = 1, sumOfAllForces = mass * kGravity;
  return Coordinates::Constant(1, kGravity + sumOfAllForces / mass);
}
//! [gravity_twice]

struct Method {
  std::string name;
  Step step;
};

const std::vector<Method> kMethods = {
    {"explicit Euler", carom::explicitEuler},
    {"semi-implicit Euler", carom::semiImplicitEuler},
    {"velocity Verlet", carom::velocityVerlet},
    {"Runge and Kutta's", carom::rk4},
};

Real heightAt(const Method& method, Real dt, Real time, const Acceleration& acceleration) {
  const int steps = static_cast<int>(std::lround(time / dt));
  return carom::simulate(method.step, kAtRest, 0, dt, steps, acceleration).position[0];
}

void figure9(const std::filesystem::path& folder) {
  carom::io::Plot plot("A stone falls, in steps of a second");
  plot.xAxis("time [s]").yAxis("height [m]");
  plot.describe("Explicit Euler stays above the parabola, semi-implicit Euler below it.");
  for (std::size_t m : {0, 1}) {
    std::vector<Real> times, heights;
    for (int i = 0; i <= 10; ++i) {
      times.push_back(i);
      heights.push_back(heightAt(kMethods[m], 1, i, fall));
    }
    plot.curve(kMethods[m].name, times, heights, {.marks = true});
  }
  std::vector<Real> times, heights;
  for (int i = 0; i <= 100; ++i) {
    times.push_back(i / 10.0);
    heights.push_back(kGravity * times.back() * times.back() / 2);
  }
  plot.curve("exact", times, heights, {.dashed = true});
  plot.writeSvg(folder / "falling.svg");
}

int main(int argc, char** argv) {
  const Real exact = kGravity * 100 / 2;
  std::cout << "Height after 10 s, minus the exact " << exact << " m\n\n";
  carom::io::Table table;
  table.column("method").column("dt = 1 s", carom::io::fixed(4));
  table.column("0.1 s", carom::io::fixed(4)).column("0.01 s", carom::io::fixed(4));
  table.column("gravity twice", carom::io::fixed(1));
  for (const Method& method : kMethods) {
    table.row({method.name, heightAt(method, 1, 10, fall) - exact,
               heightAt(method, 0.1, 10, fall) - exact, heightAt(method, 0.01, 10, fall) - exact,
               heightAt(method, 0.01, 10, fallTwice) - exact});
  }
  std::cout << table << '\n';

  //! [clock]
  int steps = 0;
  Real t = 0;
  do {
    t = t + 0.1;
    steps = steps + 1;
  } while (t < 10);
  //! [clock]
  std::cout << "Adding 0.1 s until t is 10: " << steps << " steps, the clock shows "
            << carom::io::Cell(t).text(carom::io::fixed(14)) << " s\n";

  figure9(argc > 1 ? argv[1] : ".");
}
