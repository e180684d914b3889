// How much does half the step help?
//
// Duffing's spring, which gets stiffer as it is stretched, x'' = -x - x^3, swings for 5 s; where it
// is then, Jacobi's functions say. Each method makes the run with shorter and shorter steps. What
// half the step does to the error is the method's order, and says whether a program is the method
// that it claims to be. Then an ordinary spring in oil, whose force depends on the velocity.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/jacobi_elliptic.hpp"
#include "carom/motion/measure_order.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/motion/yoshida.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "source_listings.hpp"

using carom::Coordinates;
using carom::Real;
using carom::State;
using carom::StepError;

const Real kEnd = 5;  // [s]

struct Problem {
  carom::Acceleration acceleration;
  Real exact;  // position at the end
};

Problem stiffeningSpring() {
  const carom::JacobiElliptic jacobi(std::sqrt(0.75));
  return {[](Real, const Coordinates& x, const Coordinates&) -> Coordinates {
            return -x - x.cwiseProduct(x).cwiseProduct(x);
          },
          jacobi.at(std::sqrt(2.0) * kEnd * jacobi.mean()).cn};
}

// x'' = -x - x'/2, so x = exp(-t/4) (cos wt + sin wt / (4w)), w^2 = 15/16.
Problem springInOil() {
  const Real w = std::sqrt(15.0) / 4;
  const auto [s, c] = carom::sineCosine(w * kEnd);
  return {
      [](Real, const Coordinates& x, const Coordinates& v) -> Coordinates { return -x - v / 2; },
      0.28650479686019010032 * (c + s / (4 * w))};  // exp(-5/4)
}

struct Method {
  std::string name;
  carom::Step step;
};

//! [error]
StepError errorOf(const Method& method, const Problem& problem, int steps) {
  const State start = {Coordinates::Ones(1), Coordinates::Zero(1)};
  const Real dt = kEnd / steps;
  const auto& force = problem.acceleration;
  const State end = simulate(method.step, start, 0, dt, steps, force);
  return {dt, std::abs(end.position[0] - problem.exact)};
}
//! [error]

// Errors with 200, 400 and 800 steps, and the order between the last two.
void measure(const std::vector<Method>& methods, const Problem& problem) {
  carom::io::Table table;
  table.column("method").column("dt = 25 ms", carom::io::scientific(1));
  table.column("12.5 ms", carom::io::scientific(1)).column("6.25 ms", carom::io::scientific(1));
  table.column("order", carom::io::fixed(2));
  for (const Method& method : methods) {
    const StepError a = errorOf(method, problem, 200), b = errorOf(method, problem, 400),
                    c = errorOf(method, problem, 800);
    table.row({method.name, a.error, b.error, c.error, carom::measureOrder(b, c)});
  }
  std::cout << table << '\n';
}

void draw(const std::vector<Method>& methods, const Problem& problem,
          const std::filesystem::path& file) {
  carom::io::Plot plot("Duffing's spring after 5 s");
  plot.xAxis("step [s]", carom::io::Scale::Logarithmic);
  plot.yAxis("error", carom::io::Scale::Logarithmic);
  plot.describe("Straight lines of slope 1, 2, 3, 4 and 6. The steeper ones end at 1e-15.");
  for (const Method& method : methods) {
    std::vector<Real> steps, errors;
    for (int n = 25; n <= 25600; n *= 2) {
      const StepError e = errorOf(method, problem, n);
      if (!(e.error > 1e-17 && e.error < 10)) continue;
      steps.push_back(e.dt);
      errors.push_back(e.error);
    }
    plot.curve(method.name, steps, errors, {.marks = true});
  }
  plot.writeSvg(file);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<Method> methods = {
      {"explicit Euler", carom::explicitEuler},   {"semi-implicit Euler", carom::semiImplicitEuler},
      {"source's 7.2, \"Verlet\"", sourceVerlet}, {"source's 7.3", sourceVelocityVerlet},
      {"velocity Verlet", carom::velocityVerlet}, {"source's 7.4, \"RK4\"", sourceRungeKutta},
      {"Runge and Kutta's", carom::rk4},          {"Yoshida's, order 4", carom::yoshida4},
      {"Yoshida's, order 6", carom::yoshida6},
  };
  std::cout << "A spring that stiffens, error of the position after 5 s\n\n";
  measure(methods, stiffeningSpring());
  std::cout << "A spring in oil\n\n";
  measure({{"velocity Verlet", carom::velocityVerlet},
           {"with the old velocity", withOldVelocity},
           {"Runge and Kutta's", carom::rk4}},
          springInOil());

  const std::vector<Method> drawn = {methods[0], methods[2], methods[4],
                                     methods[5], methods[6], methods[8]};
  draw(drawn, stiffeningSpring(), folder / "order_of_accuracy.svg");
}
