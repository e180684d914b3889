// What is left of the energy of a pendulum after a million steps?
//
// A pendulum is let go at one radian and followed for 4.6 hours, sixty steps a second. What counts
// is not how far the energy swings, but whether it comes back: the largest error in the first
// hundredth of the run stands beside that in the last.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Coordinates;
using carom::Real;
using carom::State;

const int kSteps = 1000000;
const Real kStep = 1.0 / 60;         // [s]
const Real kGravityByLength = 9.81;  // [1/s^2]

Real swing(Real, Real angle) {
  return -kGravityByLength * carom::sine(angle);
}

// In units of m g l.
Real energy(Real angle, Real rate) {
  return rate * rate / (2 * kGravityByLength) - carom::cosine(angle);
}

/// Makes one step and answers with the energy.
using Run = std::function<Real()>;

Run plain(const carom::Step& step) {
  State s = {Coordinates::Ones(1), Coordinates::Zero(1)};
  return [step, s]() mutable {
    s = step(s, 0, kStep, [](Real t, const Coordinates& x, const Coordinates&) -> Coordinates {
      return Coordinates::Constant(1, swing(t, x[0]));
    });
    return energy(s.position[0], s.velocity[0]);
  };
}

Run composed(std::span<const Real> weights) {
  return [weights, angle = Real(1), rate = Real(0)]() mutable {
    carom::composedStep(angle, rate, 0, kStep, weights, swing);
    return energy(angle, rate);
  };
}

Run compensated(std::span<const Real> weights) {
  return [weights, motion = carom::CarefulMotion<Real>{1, 0, 0, 0}]() mutable {
    carom::composedStep(motion, 0, kStep, weights, swing);
    return energy(motion.position, motion.velocity);
  };
}

struct Method {
  std::string name;
  Run run;
};

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::vector<Method> methods = {
      {"explicit Euler", plain(carom::explicitEuler)},
      {"semi-implicit Euler", plain(carom::semiImplicitEuler)},
      {"velocity Verlet", plain(carom::velocityVerlet)},
      {"Runge and Kutta's", plain(carom::rk4)},
      {"Yoshida's, order 6", composed(carom::kYoshida6Weights)},
      {"Kahan and Li's, order 8", composed(carom::kKahanLi8Weights)},
      {"the same, compensated", compensated(carom::kKahanLi8Weights)},
  };
  std::cout << "Largest error of the energy [m g l] in a million steps of 1/60 s\n\n";
  carom::io::Table table;
  table.column("method").column("first 10,000", carom::io::scientific(1));
  table.column("last 10,000", carom::io::scientific(1));
  table.column("mean of the last", carom::io::scientific(1));
  carom::io::Plot plot("Energy of a pendulum");
  plot.xAxis("steps", carom::io::Scale::Logarithmic);
  plot.yAxis("largest error so far [m g l]", carom::io::Scale::Logarithmic).xRange(10, kSteps);
  plot.describe("Explicit Euler and Runge and Kutta's method rise all the way; the others do not.");
  for (Method& method : methods) {
    const Real start = energy(1, 0);
    std::vector<Real> steps, errors;
    Real first = 0, last = 0, sum = 0, worst = 0;
    for (int i = 1; i <= kSteps; ++i) {
      const Real error = method.run() - start;
      worst = std::max(worst, std::abs(error));
      if (i == 10000) first = worst;
      if (i > kSteps - 10000) {
        last = std::max(last, std::abs(error));
        sum += error;
      }
      if (i >= 10 && i >= 1.2 * (steps.empty() ? 0 : steps.back())) {
        steps.push_back(i);
        errors.push_back(worst);
      }
    }
    table.row({method.name, first, last, sum / 10000});
    plot.curve(method.name, steps, errors, {.dashed = method.name == methods.back().name});
  }
  std::cout << table;
  plot.writeSvg(folder / "million_steps.svg");
}
