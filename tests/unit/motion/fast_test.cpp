// The fast ways: many steps at once, steps without allocation, and ten thousand bodies in arrays.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/explicit_euler.hpp"
#include "carom/motion/extrapolation.hpp"
#include "carom/motion/fixed_pair.hpp"
#include "carom/motion/fixed_steps.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/motion/kicked_rotor.hpp"
#include "carom/motion/many_bodies.hpp"
#include "carom/motion/measure_order.hpp"
#include "carom/motion/own_clock.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/semi_implicit_euler.hpp"
#include "carom/motion/split_rotor.hpp"
#include "carom/motion/splitting.hpp"
#include "carom/motion/trajectory.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// The angle of the turn from one attitude to the other [rad].
Real between(const Quaternion& a, const Quaternion& b) {
  return quaternionLogarithm(hamiltonProduct(conjugate(a), b)).norm();
}

RotorState randomRotor(Random& random, Real size) {
  const Quaternion q =
      integrateOrientation({1, 0, 0, 0}, random.direction(), random.between(-3, 3));
  return {q, size * random.vector()};
}

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

Vector2 sun(const Vector2& x) {
  const Real r2 = x.x() * x.x() + x.y() * x.y();
  return -x / (r2 * std::sqrt(r2));
}

// The top of N11, let go at 0.5 rad.
const Vector3 kTop(0.3, 0.3, 0.1);

RotorState releasedTop() {
  return {{carom::cosine(0.25), carom::sine(0.25), 0, 0}, {0, 0, 40}};
}

Vector3 weightOfTop(Real, const RotorState& s) {
  return cross(Vector3(0, 0, 0.5), rotatePoint(conjugate(s.q_WB), {0, 0, -9.81}));
}

}  // namespace

TEST_CASE("many steps at once are the steps one by one") {
  Random random(31);
  for (int i = 0; i < 60; ++i) {
    // From bodies that are round to long ones, each with its axes named in all orders.
    Vector3 moments(1, random.between(1, 2), random.between(2, 2.9));
    if (i % 10 == 0) moments = {2, 2, 1};
    if (i % 3 == 1) moments = Vector3(moments[2], moments[0], moments[1]);
    if (i % 3 == 2) moments = Vector3(moments[1], moments[0], moments[2]);
    const SplitRotor split(moments);
    // Both sides of the angle up to which sines have short series.
    const RotorState from = randomRotor(random, i % 2 == 0 ? 2 : 20);
    RotorState s = from;
    for (int n = 0; n < 50; ++n) s = split.step4(s, 1.0 / 60);
    const RotorState once = split.steps4(from, 1.0 / 60, 50);
    const Real speed = from.angularVelocity.norm();
    INFO("seed 31, body " << i);
    REQUIRE(between(s.q_WB, once.q_WB) < 1e-13 * (1 + speed));
    REQUIRE((s.angularVelocity - once.angularVelocity).norm() < 1e-13 * speed * (1 + speed));
    const RotorState none = split.steps4(from, 1.0 / 60, 0);
    REQUIRE(between(none.q_WB, from.q_WB) < 1e-15);
    REQUIRE((none.angularVelocity - from.angularVelocity).norm() < 1e-15 * speed);
  }
  const SplitRotor still({1, 2, 3});
  CHECK(still.steps4({{0.6, 0, 0.8, 0}, {0, 0, 0}}, 1, 10).q_WB.y == 0.8);
  CHECK_THROWS_WITH(still.steps4({}, 1, -1), ContainsSubstring("count = -1 must be zero or more"));
}

TEST_CASE("turning in place is a step, and short turns are as right as long ones") {
  const Vector3 moments(1, 2, 3);
  const SplitRotor split(moments);
  Random random(32);
  for (int i = 0; i < 200; ++i) {
    const RotorState from = randomRotor(random, 3);
    TurningBody body = {from.q_WB, moments.cwiseProduct(from.angularVelocity)};
    const Real size = body.momentum.norm();
    // Angles from far below to far above the one at which the series of the sines change.
    const Real dt = std::exp(random.between(-9, 1));
    split.turn4(body, dt);
    const RotorState step = split.step4(from, dt);
    INFO("seed 32, body " << i << ", dt " << dt);
    REQUIRE(between(body.q_WB, step.q_WB) < 1e-15);
    REQUIRE(split.angularVelocity(body.momentum) == step.angularVelocity);
    REQUIRE(std::abs(body.momentum.norm() / size - 1) < 2e-15);
    // L in the world has not moved.
    const Vector3 L = angularMomentum(moments, from);
    REQUIRE((angularMomentum(moments, step) - L).norm() < 5e-15 * size);
  }
}

TEST_CASE("scene F: a box that tumbles about its middle axis, for 100 s") {
  const json expected = motionCase("F");
  const Vector3 moments(13, 10, 5);
  const RotorState start = {{1, 0, 0, 0}, {0.01, 5, 0.01}};
  const auto value = [&](const char* name, int i) { return number(expected[name][i]); };
  const Quaternion q = {value("q", 0), value("q", 1), value("q", 2), value("q", 3)};
  const Vector3 w(value("w", 0), value("w", 1), value("w", 2));

  const RotorState end = FreeRotor(moments, start).at(100);
  INFO("from the anchor " << between(end.q_WB, q) << " rad");
  CHECK(between(end.q_WB, q) < 1e-10);
  CHECK((end.angularVelocity - w).norm() < 1e-10);

  // Stepped, with the state rounded at each step.
  const Real energy = rotationEnergy(moments, start.angularVelocity);
  const Vector3 L = angularMomentum(moments, start);
  RotorState s = start;
  Real worstEnergy = 0, worstSize = 0, worstDirection = 0;
  for (int i = 0; i < 6000; ++i) {
    s = FreeRotor(moments, s).at(1.0 / 60);
    const Vector3 now = angularMomentum(moments, s);
    worstEnergy =
        std::max(worstEnergy, std::abs(rotationEnergy(moments, s.angularVelocity) / energy - 1));
    worstSize = std::max(worstSize, std::abs(now.norm() / L.norm() - 1));
    worstDirection = std::max(worstDirection, (now.normalized() - L.normalized()).norm());
  }
  INFO("stepped " << between(s.q_WB, q) << " rad; energy " << worstEnergy << ", |L| " << worstSize
                  << ", direction of L " << worstDirection);
  CHECK(between(s.q_WB, q) < 1e-8);
  CHECK(worstEnergy < 1e-13);
  CHECK(worstSize < 1e-13);
  CHECK(worstDirection < 1e-12);
}

TEST_CASE("splittings of free lengths are of the order that they claim") {
  const Real duff = number(motionCase("N13")["x"]);
  const Real swing = number(motionCase("N6")["rows"][1][2]);
  struct Run {
    const char* name;
    Real x, expected, duration;
    Real (*force)(Real);
    int steps4, steps6;  // none: the errors are below rounding before the order shows
  };
  const std::vector<Run> runs = {
      {"spring", 1, carom::cosine(5.0), 5, [](Real x) { return -x; }, 40, 10},
      {"Duffing", 1, duff, 5, [](Real x) { return -x - x * x * x; }, 40, 20},
      {"pendulum", 1.5, swing, 10, [](Real x) { return -9.81 * carom::sine(x); }, 640, 0}};
  for (const Run& run : runs) {
    const auto order = [&](const Splitting& method, int steps) {
      const auto error = [&](int n) {
        Real x = run.x, v = 0;
        splitSteps(x, v, 0, run.duration / n, n, method,
                   [&](Real, Real p) { return run.force(p); });
        return std::abs(x - run.expected);
      };
      return measureOrder({2, error(steps)}, {1, error(2 * steps)});
    };
    const Real four = order(kBlanesMoan4, run.steps4);
    INFO(run.name << ": order " << four);
    CHECK(std::abs(four - 4) < 0.1);
    if (run.steps6 == 0) continue;
    const Real six = order(kBlanesMoan6, run.steps6);
    INFO(run.name << ": order " << six);
    CHECK(std::abs(six - 6) < 0.1);
  }
  // A planet, by the return to where it began.
  const auto missed = [](int n) {
    Vector2 x(0.9, 0), v(0, std::sqrt(1.1 / 0.9));
    const Real turn = 6.283185307179586476925287;
    splitSteps(x, v, 0, turn / n, n, kBlanesMoan6, [](Real, const Vector2& p) { return sun(p); });
    return (x - Vector2(0.9, 0)).norm();
  };
  const Real six = measureOrder({2, missed(25)}, {1, missed(50)});
  INFO("planet: order " << six << " from " << missed(25));
  CHECK(std::abs(six - 6) < 0.1);
}

TEST_CASE("steps of a splitting join, know the time, and run backwards") {
  for (const Splitting& method : {kBlanesMoan4, kBlanesMoan6}) {
    Real sumOfDrifts = 0, sumOfKicks = 0;
    for (std::size_t i = 0; i < method.drifts.size(); ++i) {
      sumOfDrifts += method.drifts[i];
      CHECK(method.drifts[i] == method.drifts[method.drifts.size() - 1 - i]);
    }
    for (std::size_t i = 0; i < method.kicks.size(); ++i) {
      sumOfKicks += method.kicks[i];
      CHECK(method.kicks[i] == method.kicks[method.kicks.size() - 1 - i]);
    }
    CHECK(std::abs(sumOfDrifts - 1) < 1e-15);
    CHECK(std::abs(sumOfKicks - 1) < 1e-15);

    // A force of time and place; each look is counted.
    int looks = 0;
    const auto force = [&](Real t, const Vector2& x) -> Vector2 {
      ++looks;
      return sun(x) + 0.1 * t * Vector2(1, 2);
    };
    Vector2 x(1, 0), v(0, 1), y = x, u = v;
    splitSteps(x, v, 3, 0.1, 20, method, force);
    const auto stages = static_cast<int>(std::min(method.kicks.size(), method.drifts.size()));
    CHECK(looks <= 20 * stages + 1);
    for (int i = 0; i < 20; ++i) splitSteps(y, u, 3 + 0.1 * i, 0.1, 1, method, force);
    CHECK((x - y).norm() < 1e-13);
    CHECK((v - u).norm() < 1e-13);
    splitSteps(x, v, 5, -0.1, 20, method, force);
    CHECK((x - Vector2(1, 0)).norm() < 1e-13);
    CHECK((v - Vector2(0, 1)).norm() < 1e-13);
    splitSteps(x, v, 5, -0.1, 0, method, force);
    CHECK((x - Vector2(1, 0)).norm() < 1e-13);
  }
}

TEST_CASE("N11: kicks of free lengths find the top with few looks at its weight") {
  const json expected = motionCase("N11");
  const SplitRotor body(kTop);
  int looks = 0;
  const auto tilt = [&](int steps) {
    looks = 0;
    const Torque weight = [&](Real t, const RotorState& s) {
      ++looks;
      return weightOfTop(t, s);
    };
    const RotorState s =
        kickedRotor(body, releasedTop(), 0, 2.0 / steps, steps, kBlanesMoan6, weight);
    const Vector3 axis = rotatePoint(s.q_WB, {0, 0, 1});
    return carom::arctangent2(std::hypot(axis.x(), axis.y()), axis.z());
  };
  const Real theta = number(expected["theta"]);
  CHECK(std::abs(tilt(60) - theta) < 1e-9);
  CHECK(looks <= 840);
  const Real order = measureOrder({2, std::abs(tilt(20) - theta)}, {1, std::abs(tilt(40) - theta)});
  INFO("order " << order);
  CHECK(std::abs(order - 6) < 0.3);
  CHECK_THROWS_AS(kickedRotor(body, releasedTop(), 0, 1, -1, kBlanesMoan6, weightOfTop),
                  InvalidInput);
  CHECK_THROWS_AS(kickedRotor(body, releasedTop(), kNan, 1, 1, kBlanesMoan6, weightOfTop),
                  InvalidInput);
}

TEST_CASE("steps of fixed size are the plain steps, bit for bit") {
  const Acceleration plain = [](Real t, const Coordinates& x, const Coordinates& v) -> Coordinates {
    return column({-x[0] * x[1] - 0.3 * v[0] + t, x[0] - x[1] * v[1]});
  };
  const auto fixed = [](Real t, const Vector2& x, const Vector2& v) -> Vector2 {
    return {-x[0] * x[1] - 0.3 * v[0] + t, x[0] - x[1] * v[1]};
  };
  const auto same = [&](const Step& step, auto fast, const char* name) {
    State s = start({0.7, -0.4}, {0.2, 1.1});
    FixedState<Vector2> f = {{0.7, -0.4}, {0.2, 1.1}};
    for (int i = 0; i < 200; ++i) {
      s = step(s, 0.01 * i, 0.01, plain);
      fast(f, 0.01 * i, 0.01, fixed);
      INFO(name << ", step " << i);
      REQUIRE(s.position[0] == f.position[0]);
      REQUIRE(s.position[1] == f.position[1]);
      REQUIRE(s.velocity[0] == f.velocity[0]);
      REQUIRE(s.velocity[1] == f.velocity[1]);
    }
  };
  same(
      explicitEuler, [](auto&&... a) { explicitEulerStep(a...); }, "explicit Euler");
  same(
      semiImplicitEuler, [](auto&&... a) { semiImplicitEulerStep(a...); }, "semi-implicit Euler");
  same(
      velocityVerlet, [](auto&&... a) { velocityVerletStep(a...); }, "velocity Verlet");
  same(
      rk4, [](auto&&... a) { rk4Step(a...); }, "RK4");
}

TEST_CASE("ten thousand falling bodies in arrays fall as each of them would") {
  Random random(33);
  std::vector<Real> x(1001), v(1001);  // an odd number: one is left over from pairs
  for (Real& p : x) p = random.between(-10, 10);
  for (Real& u : v) u = random.between(-10, 10);
  for (Real g : {0.0, -9.81}) {
    std::vector<Real> y = x, u = v;
    for (int n = 0; n < 50; ++n) stepFalling(y, u, g, 1.0 / 60);
    const Acceleration fall = [g](Real, const Coordinates& p, const Coordinates&) -> Coordinates {
      return Coordinates::Constant(p.size(), g);
    };
    const State s = simulate(velocityVerlet, start(x, v), 0, 1.0 / 60, 50, fall);
    for (std::size_t i = 0; i < x.size(); ++i) {
      INFO("seed 33, body " << i << ", g " << g);
      REQUIRE(y[i] == s.position[static_cast<Eigen::Index>(i)]);
      REQUIRE(u[i] == s.velocity[static_cast<Eigen::Index>(i)]);
    }
  }
}

TEST_CASE("the halves of a step for many bodies are velocity Verlet, but for rounding") {
  Random random(34);
  std::vector<Real> x(99), v(99), a(99);
  for (Real& p : x) p = random.between(-1, 1);
  const State from = start(x, v);
  const auto springs = [&] {
    for (std::size_t i = 0; i < x.size(); ++i) a[i] = -x[i];
  };
  springs();
  for (int n = 0; n < 500; ++n) {
    beginSteps(x, v, a, 0.1);
    springs();
    endSteps(v, a, 0.1);
  }
  const State s = simulate(velocityVerlet, from, 0, 0.1, 500, spring);
  for (std::size_t i = 0; i < x.size(); ++i) {
    REQUIRE(std::abs(x[i] - s.position[static_cast<Eigen::Index>(i)]) < 1e-12);
    REQUIRE(std::abs(v[i] - s.velocity[static_cast<Eigen::Index>(i)]) < 1e-12);
  }
  std::vector<Real> few(98);
  CHECK_THROWS_WITH(stepFalling(few, v, 0, 1), ContainsSubstring("number of positions = 98"));
  CHECK_THROWS_AS(stepFalling(x, v, kNan, 1), InvalidInput);
  CHECK_THROWS_AS(stepFalling(x, v, 0, kNan), InvalidInput);
  CHECK_THROWS_AS(beginSteps(few, v, a, 1), InvalidInput);
  CHECK_THROWS_AS(beginSteps(x, v, few, 1), InvalidInput);
  CHECK_THROWS_AS(beginSteps(x, v, a, kNan), InvalidInput);
  CHECK_THROWS_AS(endSteps(v, few, 1), InvalidInput);
  CHECK_THROWS_AS(endSteps(v, a, kNan), InvalidInput);
}

TEST_CASE("N5: with a clock of its own, a planet is known to 1e-9 after a thousand seconds") {
  const json expected = motionCase("N5");
  struct Orbit {
    const char* name;
    Real e;
  };
  for (const Orbit& orbit : {Orbit{"e_0.6", 0.6}, Orbit{"e_0.9", 0.9}, Orbit{"e_0.99", 0.99}}) {
    int looks = 0;
    const auto field = [&](const Vector2& x) -> Pull<Vector2> {
      ++looks;
      return {sun(x), 1 / x.norm()};
    };
    ClockedMotion<Vector2> planet = withClock(
        Vector2(1 - orbit.e, 0), Vector2(0, std::sqrt((1 + orbit.e) / (1 - orbit.e))), field);
    // 36 steps of 17 looks in each turn, whatever the orbit: within the 1e5 of the case.
    followToTime(planet, 1000, 6.2831853 / 36, kKahanLi8Weights, field);
    const Vector2 there(number(expected[orbit.name][0]), number(expected[orbit.name][1]));
    const Vector2 speed(number(expected[orbit.name][2]), number(expected[orbit.name][3]));
    INFO("e " << orbit.e << ": " << (planet.position - there).norm() << " m, "
              << (planet.velocity - speed).norm() << " m/s, " << looks << " looks");
    CHECK(planet.time == 1000);
    CHECK((planet.position - there).norm() < 1e-9);
    CHECK((planet.velocity - speed).norm() < 1e-9);
    CHECK(looks <= 100000);
    // It has not left its ellipse.
    const Real turning =
        planet.position.x() * planet.velocity.y() - planet.position.y() * planet.velocity.x();
    CHECK(std::abs(turning / std::sqrt(1 - orbit.e * orbit.e) - 1) < 1e-13);
    CHECK(std::abs(planet.velocity.squaredNorm() / 2 - 1 / planet.position.norm() + 0.5) < 1e-12);
  }
}

TEST_CASE("a clock that would never arrive is refused") {
  const auto field = [](const Vector2& x) -> Pull<Vector2> { return {sun(x), 1 / x.norm()}; };
  ClockedMotion<Vector2> planet = withClock(Vector2(1, 0), Vector2(0, 1), field);
  const Real nan = std::nan("");
  CHECK_THROWS_AS(followToTime(planet, 1, 0, kVerletWeights, field), InvalidInput);
  CHECK_THROWS_AS(followToTime(planet, 1, nan, kVerletWeights, field), InvalidInput);
  CHECK_THROWS_AS(followToTime(planet, nan, 0.1, kVerletWeights, field), InvalidInput);
}

TEST_CASE("the system's own clock gives the orders of the compositions") {
  const auto field = [](const Vector2& x) -> Pull<Vector2> { return {sun(x), 1 / x.norm()}; };
  const auto error = [&](std::span<const Real> weights, int steps) {
    ClockedMotion<Vector2> planet = withClock(Vector2(0.1, 0), Vector2(0, std::sqrt(19.0)), field);
    followToTime(planet, 8, 8.0 / steps, weights, field);
    // e = 0.9, from Kepler's equation M = E - e sin E by Newton's method.
    Real E = 8;
    for (int i = 0; i < 50; ++i) {
      E -= (E - 0.9 * carom::sine(E) - 8) / (1 - 0.9 * carom::cosine(E));
    }
    const Vector2 there(carom::cosine(E) - 0.9, std::sqrt(0.19) * carom::sine(E));
    return (planet.position - there).norm();
  };
  const auto order = [&](std::span<const Real> weights, int n) {
    return measureOrder({2, error(weights, n)}, {1, error(weights, 2 * n)});
  };
  CHECK(std::abs(order(kVerletWeights, 400) - 2) < 0.1);
  CHECK(std::abs(order(kYoshida4Weights, 400) - 4) < 0.1);
  CHECK(std::abs(order(kKahanLi6Weights, 100) - 6) < 0.2);
}

TEST_CASE("the weights of extrapolation add up to one, and take powers of the step away") {
  for (int m = 1; m <= kMostAnswers; ++m) {
    const auto weights = extrapolationWeights(m);
    // With n steps the error is a polynomial in 1/n^2; all its terms below 1/n^(2m) vanish.
    for (int power = 0; power < m; ++power) {
      Real sum = 0;
      for (int k = m; k >= 1; --k) {
        Real term = weights[static_cast<std::size_t>(k - 1)];
        for (int i = 0; i < power; ++i) term /= k * k;
        sum += term;
      }
      INFO(m << " answers, power " << power);
      CHECK(std::abs(sum - (power == 0 ? 1 : 0)) < 1e-12);
    }
  }
}

TEST_CASE("extrapolated steps are of twice the order that there are answers") {
  const Real duff = number(motionCase("N13")["x"]), v = number(motionCase("N13")["v"]);
  const auto error = [&](int answers, int n) {
    Real x = 1, u = 0;
    extrapolatedSteps(x, u, 0, 5.0 / n, n, answers, [](Real, Real p) { return -p - p * p * p; });
    return std::hypot(x - duff, u - v);
  };
  const std::vector<int> first = {400, 80, 40, 30};
  for (int m = 1; m <= 4; ++m) {
    const int n = first[static_cast<std::size_t>(m - 1)];
    const Real order = measureOrder({2, error(m, n)}, {1, error(m, 2 * n)});
    INFO(m << " answers: order " << order << " from " << error(m, n));
    CHECK(std::abs(order - 2 * m) < 0.1);
  }
  CHECK(error(8, 8) < 1e-10);

  // One answer is Verlet's own step; the time is known; and no steps change nothing.
  Vector2 x(1, 0), u(0, 1), y = x, w = u;
  const auto force = [](Real t, const Vector2& p) -> Vector2 { return sun(p) + Vector2(t, 0); };
  extrapolatedSteps(x, u, 2, 0.01, 50, 1, force);
  for (int i = 0; i < 50; ++i) composedStep(y, w, 2 + 0.01 * i, 0.01, kVerletWeights, force);
  CHECK((x - y).norm() < 1e-14);
  CHECK((u - w).norm() < 1e-14);
  extrapolatedSteps(x, u, 2, 0.01, 0, 3, force);
  CHECK((x - y).norm() < 1e-14);
}

TEST_CASE("N11: extrapolated kicks find the top to 1e-11 with less than three hundred torques") {
  const json expected = motionCase("N11");
  const SplitRotor body(kTop);
  int looks = 0;
  const Torque weight = [&](Real t, const RotorState& s) {
    ++looks;
    return weightOfTop(t, s);
  };
  const auto tilt = [&](int steps, int answers) {
    looks = 0;
    const RotorState s =
        extrapolatedRotor(body, releasedTop(), 0, 2.0 / steps, steps, answers, weight);
    const Vector3 axis = rotatePoint(s.q_WB, {0, 0, 1});
    return carom::arctangent2(std::hypot(axis.x(), axis.y()), axis.z());
  };
  const Real theta = number(expected["theta"]);
  CHECK(std::abs(tilt(14, 6) - theta) < 1e-11);
  CHECK(looks == 14 * 21);
  const Real order =
      measureOrder({2, std::abs(tilt(150, 2) - theta)}, {1, std::abs(tilt(300, 2) - theta)});
  INFO("order " << order);
  CHECK(std::abs(order - 4) < 0.1);
  const RotorState from = releasedTop();
  CHECK(extrapolatedRotor(body, from, 0, 1, 0, 3, weightOfTop).angularVelocity ==
        from.angularVelocity);
  CHECK_THROWS_AS(extrapolatedRotor(body, from, 0, 1, -1, 3, weightOfTop), InvalidInput);
  CHECK_THROWS_WITH(extrapolatedRotor(body, from, 0, 1, 1, 9, weightOfTop),
                    ContainsSubstring("answers = 9 must be from 1 to 8"));
  CHECK_THROWS_AS(extrapolatedRotor(body, from, 0, 1, 1, 0, weightOfTop), InvalidInput);
  CHECK_THROWS_AS(extrapolatedRotor(body, from, kNan, 1, 1, 3, weightOfTop), InvalidInput);
  CHECK_THROWS_AS(extrapolatedRotor(body, from, 0, 1, 1, 3, Torque()), InvalidInput);
}

TEST_CASE("pairs of fixed size are those of Trajectory, bit for bit") {
  using Y = Eigen::Matrix<Real, 4, 1>;
  const auto flow = [](Real, const Y& y) -> Y {
    const Real r2 = y[0] * y[0] + y[1] * y[1];
    const Real r3 = r2 * std::sqrt(r2);
    return {y[2], y[3], -y[0] / r3, -y[1] / r3};
  };
  const State from = perihelion(0.6);
  const Y y0(from.position[0], from.position[1], from.velocity[0], from.velocity[1]);
  for (Real end : {20.0, -7.0}) {
    for (Real tolerance : {1e-5, 1e-9, 1e-13}) {
      const Tolerance asked{tolerance, tolerance, 100000};
      const FixedRun<4> eight = fixedPair<kDormandPrince8, 4>(y0, 0, end, asked, flow);
      const FixedRun<4> five = fixedPair<kDormandPrince5, 4>(y0, 0, end, asked, flow);
      const auto same = [&](const FixedRun<4>& run, Pair pair) {
        const AdaptiveRun plain = Trajectory(from, 0, end, kepler, asked, pair).run();
        INFO("end " << end << ", tolerance " << tolerance);
        CHECK(run.status == AdaptiveStatus::kReachedEnd);
        CHECK(run.time == plain.time);
        CHECK(run.accepted == plain.accepted);
        CHECK(run.rejected == plain.rejected);
        CHECK(run.y[0] == plain.state.position[0]);
        CHECK(run.y[3] == plain.state.velocity[1]);
      };
      same(eight, Pair::kOrder8);
      same(five, Pair::kOrder5);
    }
  }
  const FixedRun<4> few = fixedPair<kDormandPrince8, 4>(y0, 0, 100, {1e-9, 1e-9, 50}, flow);
  CHECK(few.status == AdaptiveStatus::kTooManySteps);
  CHECK(few.accepted + few.rejected == 50);
  // A fall into the sun.
  const FixedRun<4> fall =
      fixedPair<kDormandPrince8, 4>(Y(1, 0, 0, 0), 0, 2, {1e-9, 1e-9, 100000}, flow);
  CHECK(fall.status == AdaptiveStatus::kStepTooSmall);
  CHECK(std::abs(fall.time - 1.1107207345395915618) < 1e-6);
  CHECK_THROWS_AS((fixedPair<kDormandPrince8, 4>(y0, 0, 1, {1e-9, 0, 10}, flow)), InvalidInput);
}
