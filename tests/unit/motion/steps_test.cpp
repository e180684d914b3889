// The one-step methods: orders, what they keep, the cases of group N, and the source's listings.

#include <array>
#include <limits>
#include <utility>

#include "carom/core/errors.hpp"
#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/measure_order.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/motion/verlet.hpp"
#include "carom/motion/verlet_start.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

// The listing of section 7.2: Taylor for the position, explicit Euler for the velocity.
State sourceVerlet(const State& s, Real t, Real dt, const Acceleration& a) {
  const Coordinates now = a(t, s.position, s.velocity);
  return {s.position + dt * s.velocity + dt * dt / 2 * now, s.velocity + dt * now};
}

// The listing of section 7.3 with x read as s: the force is never asked for at the new place, and
// both accelerations are the same.
State sourceVelocityVerlet(const State& s, Real t, Real dt, const Acceleration& a) {
  const Coordinates before = a(t, s.position, s.velocity);
  const Coordinates position = s.position + dt * s.velocity + dt * dt / 2 * before;
  const Coordinates after = a(t, s.position, s.velocity);
  return {position, s.velocity + dt / 2 * (before + after)};
}

// Velocity Verlet with the old velocity in the new acceleration.
State lateVelocityVerlet(const State& s, Real t, Real dt, const Acceleration& a) {
  const Coordinates before = a(t, s.position, s.velocity);
  const Coordinates position = s.position + dt * s.velocity + dt * dt / 2 * before;
  const Coordinates after = a(t + dt, position, s.velocity);
  return {position, s.velocity + dt / 2 * (before + after)};
}

// The listing of section 7.4: k4 looks along k2.
State sourceRk4(const State& s, Real t, Real h, const Acceleration& a) {
  const Coordinates k1x = s.velocity, k1v = a(t, s.position, s.velocity);
  const Coordinates k2x = s.velocity + h / 2 * k1v,
                    k2v = a(t + h / 2, s.position + h / 2 * k1x, s.velocity + h / 2 * k1v);
  const Coordinates k3x = s.velocity + h / 2 * k2v,
                    k3v = a(t + h / 2, s.position + h / 2 * k2x, s.velocity + h / 2 * k2v);
  const Coordinates k4x = s.velocity + h * k2v,
                    k4v = a(t + h, s.position + h * k2x, s.velocity + h * k2v);
  return {s.position + h / 6 * (k1x + 2 * k2x + 2 * k3x + k4x),
          s.velocity + h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v)};
}

// Störmer's method from a state to a state.
State runVerlet(const State& s, Real dt, int steps, const Acceleration& a) {
  TwoPositions x = verletStart(s, 0, dt, a);
  for (int i = 0; i < steps; ++i) x = verlet(x, i * dt, dt, a);
  return verletState(x, steps * dt, dt, a);
}

struct Problem {
  const char* name;
  State from;
  Acceleration acceleration;
  Real duration;
  Real x;    // of the first coordinate at the end
  int fine;  // how many times more steps it needs than a spring
};

// Three problems with known answers: a spring, Duffing's oscillator, and a pendulum.
std::vector<Problem> problems() {
  return {{"spring", start({1}, {0}), spring, 5, 0.28366218546322626447, 1},
          {"Duffing", start({1}, {0}), duffing, 5, number(motionCase("N13")["x"]), 1},
          {"pendulum", start({1.5}, {0}), pendulum, 10, number(motionCase("N6")["rows"][1][2]), 4}};
}

Real errorAt(const Problem& p, const Step& step, int steps) {
  return std::abs(simulate(step, p.from, 0, p.duration / steps, steps, p.acceleration).position[0] -
                  p.x);
}

// The orders between runs of n, 2n, 4n, ... steps.
template <class ErrorOf>
std::vector<Real> orders(const ErrorOf& errorOf, int n, int halvings) {
  std::vector<Real> result;
  Real coarse = errorOf(n);
  for (int i = 0; i < halvings; ++i) {
    n *= 2;
    const Real fine = errorOf(n);
    result.push_back(measureOrder({2, coarse}, {1, fine}));
    coarse = fine;
  }
  return result;
}

void checkOrder(const Step& step, int steps, Real expected) {
  for (const Problem& p : problems()) {
    for (Real order : orders([&](int n) { return errorAt(p, step, n); }, steps * p.fine, 3)) {
      INFO(p.name << ": order " << order);
      CHECK(std::abs(order - expected) < 0.1);
    }
  }
}

Real springEnergy(const State& s) {
  return s.position[0] * s.position[0] + s.velocity[0] * s.velocity[0];
}

}  // namespace

TEST_CASE("explicit Euler is of order 1") {
  checkOrder(explicitEuler, 5000, 1);
}

TEST_CASE("semi-implicit Euler is of order 1") {
  checkOrder(semiImplicitEuler, 1000, 1);
}

TEST_CASE("velocity Verlet is of order 2") {
  checkOrder(velocityVerlet, 200, 2);
}

TEST_CASE("the classical method of Runge and Kutta is of order 4") {
  checkOrder(rk4, 400, 4);
}

TEST_CASE("Verlet with two positions is of order 2, in position and in velocity") {
  for (const Problem& p : problems()) {
    const auto error = [&](int n) {
      return std::abs(runVerlet(p.from, p.duration / n, n, p.acceleration).position[0] - p.x);
    };
    for (Real order : orders(error, 800, 3)) CHECK(std::abs(order - 2) < 0.1);
  }
  const Real v = number(motionCase("N13")["v"]);
  const auto error = [&](int n) {
    return std::abs(runVerlet(start({1}, {0}), 5.0 / n, n, duffing).velocity[0] - v);
  };
  for (Real order : orders(error, 400, 3)) CHECK(std::abs(order - 2) < 0.1);
}

TEST_CASE("the two forms of Verlet's method go through the same positions") {
  const State from = start({1, 0}, {0.3, 0.9});
  for (int steps : {1, 2, 10, 100}) {
    const Coordinates a = runVerlet(from, 0.05, steps, kepler).position;
    const Coordinates b = simulate(velocityVerlet, from, 0, 0.05, steps, kepler).position;
    CHECK(std::abs(a[0] - b[0]) < 1e-12);
    CHECK(std::abs(a[1] - b[1]) < 1e-12);
  }
}

TEST_CASE("Verlet runs forwards, and comes back when its two positions are exchanged") {
  TwoPositions x = verletStart(start({1}, {0}), 0, 0.1, spring);
  const TwoPositions begin = x;
  for (int i = 0; i < 1000; ++i) x = verlet(x, 0, 0.1, spring);
  CHECK(std::abs(x.current[0] - 0.8623188722876839) < 5e-2);  // cos 100: it went forwards
  std::swap(x.previous, x.current);
  for (int i = 0; i < 1000; ++i) x = verlet(x, 0, 0.1, spring);
  CHECK(std::abs(x.current[0] - begin.previous[0]) < 1e-12);
  CHECK(std::abs(x.previous[0] - begin.current[0]) < 1e-12);
}

TEST_CASE("the steps are their formulas, on one step by hand") {
  const Acceleration a = [](Real t, const Coordinates& x, const Coordinates& v) -> Coordinates {
    return column({t + 2 * x[0] - 3 * v[0]});
  };
  const State s = start({1}, {2});  // at t = 1: a = 1 + 2 - 6 = -3
  const State e = explicitEuler(s, 1, 0.5, a);
  CHECK(e.position[0] == 2);
  CHECK(e.velocity[0] == 0.5);
  const State i = semiImplicitEuler(s, 1, 0.5, a);
  CHECK(i.position[0] == 1.25);
  CHECK(i.velocity[0] == 0.5);
  // x' = 1 + 1 - 3/8 = 1.625; a' = 1.5 + 3.25 - 3 * 0.5 = 3.25; v' = 2 + (3.25 - 3)/4
  const State v = velocityVerlet(s, 1, 0.5, a);
  CHECK(v.position[0] == 1.625);
  CHECK(v.velocity[0] == 2.0625);
  const TwoPositions w = verlet({column({0}), column({1})}, 1, 0.5, a);  // v = 2 again
  CHECK(w.previous[0] == 1);
  CHECK(w.current[0] == 1.25);
}

TEST_CASE("RK4 integrates polynomials in time up to degree three exactly") {
  const Acceleration a = [](Real t, const Coordinates&, const Coordinates&) -> Coordinates {
    return column({4 * t * t * t - 3 * t * t});
  };
  const State s = rk4(start({0}, {0}), 1, 2, a);  // v = t^4 - t^3 from 1 to 3
  CHECK(std::abs(s.velocity[0] - 54) < 1e-13);
  CHECK(std::abs(rk4(s, 3, -2, a).velocity[0]) < 1e-13);  // and back
}

TEST_CASE("N1: free fall") {
  const json expected = motionCase("N1");
  const Acceleration g = [](Real, const Coordinates&, const Coordinates&) -> Coordinates {
    return column({-9.81});
  };
  const std::vector<Step> exact = {velocityVerlet, rk4};
  for (Real h : {1.0, 0.1, 0.01}) {
    const int n = static_cast<int>(std::lround(10 / h));
    for (const Step& step : exact) {
      const State s = simulate(step, start({0}, {0}), 0, h, n, g);
      CHECK(std::abs(s.position[0] / number(expected["x"]) - 1) < 1e-13);
      CHECK(std::abs(s.velocity[0] / number(expected["v"]) - 1) < 1e-13);
    }
    const Real late = simulate(explicitEuler, start({0}, {0}), 0, h, n, g).position[0];
    const Real early = simulate(semiImplicitEuler, start({0}, {0}), 0, h, n, g).position[0];
    CHECK(std::abs(late + 490.5 - 49.05 * h) < 1e-10);
    CHECK(std::abs(early + 490.5 + 49.05 * h) < 1e-10);
    CHECK(std::abs(runVerlet(start({0}, {0}), h, n, g).position[0] + 490.5) < 1e-9);
  }
  // Counting gravity twice, as equation 45 does: 490.5 m too deep.
  const Acceleration twice = [](Real, const Coordinates&, const Coordinates&) -> Coordinates {
    return column({-9.81 - 9.81});
  };
  CHECK(std::abs(simulate(rk4, start({0}, {0}), 0, 0.1, 100, twice).position[0] + 981) < 1e-9);
}

TEST_CASE("N2: falling through air, and coming back from above") {
  const json expected = motionCase("N2");
  const State fallen = simulate(rk4, start({0}, {0}), 0, 0.01, 500, fallWithDrag);
  CHECK(std::abs(fallen.position[0] - number(expected["drop_x"])) < 1e-9);
  CHECK(std::abs(fallen.velocity[0] - number(expected["drop_v"])) < 1e-9);
  // With a finer step it reaches the 12 digits of the case.
  const State finer = simulate(rk4, start({0}, {0}), 0, 0.001, 5000, fallWithDrag);
  CHECK(std::abs(finer.position[0] / number(expected["drop_x"]) - 1) < 1e-12);
  CHECK(std::abs(finer.velocity[0] / number(expected["drop_v"]) - 1) < 1e-12);

  const Real up = number(expected["time_up"]);
  const State top = simulate(rk4, start({0}, {-30}), 0, up / 4000, 4000, fallWithDrag);
  CHECK(std::abs(-top.position[0] / number(expected["height"]) - 1) < 1e-12);
  CHECK(std::abs(top.velocity[0]) < 1e-11);

  for (Real order : orders(
           [&](int n) {
             return std::abs(simulate(velocityVerlet, start({0}, {0}), 0, 5.0 / n, n, fallWithDrag)
                                 .position[0] -
                             number(expected["drop_x"]));
           },
           200, 3)) {
    CHECK(std::abs(order - 2) < 0.1);
  }
}

TEST_CASE("N4: a spring for a thousand seconds") {
  const json expected = motionCase("N4");
  const State from = start({1}, {0});
  const Real h = 0.1;
  // The energies that each method should arrive at.
  const State euler = simulate(explicitEuler, from, 0, h, 10000, spring);
  CHECK(std::abs(springEnergy(euler) / number(expected["explicit_euler_energy"]) - 1) < 1e-10);
  const State kutta = simulate(rk4, from, 0, h, 10000, spring);
  CHECK(std::abs(springEnergy(kutta) / number(expected["rk4_energy"]) - 1) < 1e-12);

  // What the symplectic ones keep instead of the energy.
  State symplectic = from, verlet = from;
  for (int i = 0; i < 10000; ++i) {
    symplectic = semiImplicitEuler(symplectic, 0, h, spring);
    verlet = velocityVerlet(verlet, 0, h, spring);
    const Real x = symplectic.position[0], v = symplectic.velocity[0];
    REQUIRE(std::abs(x * x + v * v - h * x * v - 1) < 1e-13);
    const Real y = verlet.position[0], u = verlet.velocity[0];
    REQUIRE(std::abs(y * y * (1 - h * h / 4) + u * u - (1 - h * h / 4)) < 1e-13);
  }
  // Verlet's phase runs ahead by a known factor.
  const Real phase = number(expected["verlet_phase"]) * 1000;
  CHECK(std::abs(verlet.position[0] - carom::cosine(phase)) < 1e-11);
}

TEST_CASE("N4: stability limits of a spring") {
  const State from = start({1}, {0});
  for (const Step& step : {Step(semiImplicitEuler), Step(velocityVerlet)}) {
    CHECK(springEnergy(simulate(step, from, 0, 1.99, 1000, spring)) < 1000);
    CHECK(springEnergy(simulate(step, from, 0, 2.01, 1000, spring)) > 1e6);
  }
  CHECK(springEnergy(simulate(rk4, from, 0, 2.82, 1000, spring)) < 1);
  CHECK(springEnergy(simulate(rk4, from, 0, 2.84, 1000, spring)) > 1e6);
}

TEST_CASE("N12: RK4 finds the tangent") {
  const json expected = motionCase("N12");
  const Acceleration f = [](Real, const Coordinates&, const Coordinates& y) -> Coordinates {
    return column({1 + y[0] * y[0]});
  };
  const auto error = [&](const Step& step, int n) {
    return simulate(step, start({0}, {0}), 0, 1.0 / n, n, f).velocity[0] -
           number(expected["tan_1"]);
  };
  CHECK(std::abs(error(rk4, 10) / number(expected["rk4_error"]) - 1) < 1e-8);
  for (Real order : orders([&](int n) { return std::abs(error(rk4, n)); }, 160, 2)) {
    CHECK(std::abs(order - 4) < 0.1);
  }
  // The source's listing, which takes k2 where k3 belongs, is of order three.
  CHECK(std::abs(error(sourceRk4, 10) / number(expected["source_error"]) - 1) < 1e-10);
  for (Real order : orders([&](int n) { return std::abs(error(sourceRk4, n)); }, 160, 3)) {
    CHECK(std::abs(order - 3) < 0.1);
  }
}

TEST_CASE("N14: velocity Verlet keeps its order when the force depends on the velocity") {
  const Real x = number(motionCase("N14")["x"]);
  const Acceleration damped = [](Real, const Coordinates& p, const Coordinates& v) -> Coordinates {
    return -p - v / 2;
  };
  const auto error = [&](const Step& step) {
    return [&, step](int n) {
      return std::abs(simulate(step, start({1}, {0}), 0, 5.0 / n, n, damped).position[0] - x);
    };
  };
  for (Real order : orders(error(velocityVerlet), 100, 3)) CHECK(std::abs(order - 2) < 0.1);
  for (Real order : orders(error(lateVelocityVerlet), 100, 3)) CHECK(std::abs(order - 1) < 0.1);
}

TEST_CASE("N15: the energy of a pendulum over 1e5 steps") {
  const json expected = motionCase("N15");
  const auto energy = [](const State& s) {
    return s.velocity[0] * s.velocity[0] / (2 * 9.81) - carom::cosine(s.position[0]);
  };
  const State from = start({1}, {0});
  const Real e = energy(from), h = 1.0 / 60;
  CHECK(std::abs(e - number(expected["energy"])) < 1e-15);
  State verlet = from;
  Real early = 0, late = 0;  // the largest error in the first and in the last tenth
  for (int i = 0; i < 100000; ++i) {
    verlet = velocityVerlet(verlet, 0, h, pendulum);
    Real& worst = i < 10000 ? early : late;
    if (i < 10000 || i >= 90000) worst = std::max(worst, std::abs(energy(verlet) - e));
  }
  CHECK(early < 3e-4);
  CHECK(late < 1.001 * early);  // it swings, and does not grow
  const Real lost = energy(simulate(rk4, from, 0, h, 100000, pendulum)) - e;
  CHECK(std::abs(lost / -9.3e-6 - 1) < 0.02);
}

TEST_CASE("the source's listings of 7.2 and 7.3 are of first order, and explode") {
  for (const Step& step : {Step(sourceVerlet), Step(sourceVelocityVerlet)}) {
    const Problem p = problems()[1];
    for (Real order : orders([&](int n) { return errorAt(p, step, n); }, 10000, 2)) {
      CHECK(std::abs(order - 1) < 0.1);
    }
    const State s = simulate(step, start({1}, {0}), 0, 0.1, 1000, spring);
    CHECK(springEnergy(s) > 100);
  }
  const State s = simulate(sourceVerlet, start({1}, {0}), 0, 0.1, 1000, spring);
  CHECK(std::abs(springEnergy(s) / 150 - 1) < 0.05);
  CHECK(std::abs(springEnergy(simulate(velocityVerlet, start({1}, {0}), 0, 0.1, 1000, spring)) -
                 0.9994) < 3e-3);
}

TEST_CASE("what section 7.1 calls forward Euler is semi-implicit Euler") {
  // The listing, line by line.
  Real s = 1, v = 0;
  for (int i = 0; i < 1000; ++i) {
    const Real a = -s;
    v = v + a * 0.1;
    s = s + v * 0.1;
  }
  const State ours = simulate(semiImplicitEuler, start({1}, {0}), 0, 0.1, 1000, spring);
  CHECK(ours.position[0] == s);
  CHECK(ours.velocity[0] == v);
  const State forward = simulate(explicitEuler, start({1}, {0}), 0, 0.1, 1000, spring);
  CHECK(springEnergy(ours) < 1.1);
  CHECK(std::abs(springEnergy(forward) / 2.1e4 - 1) < 0.01);
}

TEST_CASE("a loop that adds dt until t is ten takes a step too many; counting does not") {
  int steps = 0;
  for (Real t = 0; t < 10; t += 0.1) ++steps;
  CHECK(steps == 101);
  std::vector<Real> times;
  const Acceleration watch = [&](Real t, const Coordinates& x, const Coordinates&) -> Coordinates {
    times.push_back(t);
    return x;
  };
  simulate(explicitEuler, start({0}, {0}), 0, 0.1, 100, watch);
  CHECK(times.size() == 100);
  CHECK(times.back() == 99 * 0.1);
}

TEST_CASE("the listing of section 7.4 prints every value a step late, and a line too many") {
  // Its loop as it stands, printing x beside what y has become.
  std::vector<std::pair<Real, Real>> lines;
  Real y = 0;
  const Real h = 0.1;
  for (Real x = 0; x <= 1; x = x + h) {
    const auto f = [](Real v) { return 1 + v * v; };
    const Real k1 = h * f(y), k2 = h * f(y + k1 / 2), k3 = h * f(y + k2 / 2), k4 = h * f(y + k2);
    y = y + (k1 + 2 * k2 + 2 * k3 + k4) / 6;
    lines.emplace_back(x, y);
  }
  REQUIRE(lines.size() == 11);
  CHECK(std::abs(lines.back().first - 1) < 1e-15);
  CHECK(std::abs(lines.back().second - 1.963313) < 5e-7);  // tan 1.1 is 1.964760, tan 1 is 1.557408
  CHECK(std::abs(lines[9].second - std::tan(1.0)) < 1e-3);
}

TEST_CASE("the measured order is the slope between two runs") {
  CHECK(measureOrder({0.1, 1e-3}, {0.05, 2.5e-4}) == 2);
  CHECK(std::abs(measureOrder({0.3, 2 * 0.3 * 0.3 * 0.3}, {0.1, 2e-3}) - 3) < 1e-14);
  CHECK_THROWS_WITH(measureOrder({0.1, 0}, {0.05, 1}), ContainsSubstring("coarse.error = 0"));
  CHECK_THROWS_AS(measureOrder({0.1, 1}, {0.1, 1}), InvalidInput);
  CHECK_THROWS_AS(measureOrder({0.1, 1}, {0.2, 1}), InvalidInput);
  CHECK_THROWS_AS(measureOrder({-0.1, 1}, {0.05, 1}), InvalidInput);
  CHECK_THROWS_AS(measureOrder({0.1, 1}, {0.05, kNan}), InvalidInput);
}

TEST_CASE("a state that cannot be is refused, and so is a force that answers nonsense") {
  const std::vector<Step> steps = {explicitEuler, semiImplicitEuler, velocityVerlet, rk4};
  for (const Step& step : steps) {
    CHECK_THROWS_WITH(step(start({1}, {1, 2}), 0, 1, spring),
                      ContainsSubstring("number of velocities = 2"));
    CHECK_THROWS_WITH(step(start({1, kNan}, {1, 2}), 0, 1, spring),
                      ContainsSubstring("position[1] = nan must be finite"));
    CHECK_THROWS_WITH(step(start({1}, {kNan}), 0, 1, spring), ContainsSubstring("velocity[0]"));
    CHECK_THROWS_AS(step(start({1}, {1}), kNan, 1, spring), InvalidInput);
    CHECK_THROWS_AS(step(start({1}, {1}), 0, kNan, spring), InvalidInput);
    CHECK_THROWS_WITH(step(start({1, 2}, {1, 2}), 0, 1, duffing),
                      ContainsSubstring("number of accelerations = 1"));
    CHECK_THROWS_AS(step(start({1}, {1}), 0, 1, Acceleration()), InvalidInput);
    // A step of no length stays where it is.
    CHECK(step(start({1}, {2}), 0, 0, spring).position[0] == 1);
  }
  CHECK_THROWS_AS(verlet({column({1}), column({kNan})}, 0, 1, spring), InvalidInput);
  CHECK_THROWS_AS(verlet({column({1}), column({1, 2})}, 0, 1, spring), InvalidInput);
  CHECK_THROWS_AS(verlet({column({1}), column({1})}, 0, 0, spring), InvalidInput);
  CHECK_THROWS_AS(verletStart(start({1}, {1}), 0, 0, spring), InvalidInput);
  CHECK_THROWS_AS(simulate(rk4, start({1}, {1}), 0, 1, -1, spring), InvalidInput);
  CHECK_THROWS_AS(simulate(Step(), start({1}, {1}), 0, 1, 1, spring), InvalidInput);
}
