// Bodies that turn: Euler's equation, the steps, the splitting, and the exact answers.

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/exact_rotor.hpp"
#include "carom/motion/explicit_gyroscopic_step.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/motion/gyroscopic_step.hpp"
#include "carom/motion/jacobi_elliptic.hpp"
#include "carom/motion/kicked_rotor.hpp"
#include "carom/motion/measure_order.hpp"
#include "carom/motion/rk4_rotor.hpp"
#include "carom/motion/rotor.hpp"
#include "carom/motion/split_rotor.hpp"
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

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kPi = std::numbers::pi;
const Vector3 kMoments(1, 2, 3);
const RotorState kTumbling = {{1, 0, 0, 0}, {2, 0, 1.5}};

Quaternion quaternion(const json& v) {
  return {number(v[0]), number(v[1]), number(v[2]), number(v[3])};
}

// The angle of the turn from one attitude to the other [rad].
Real between(const Quaternion& a, const Quaternion& b) {
  return quaternionLogarithm(hamiltonProduct(conjugate(a), b)).norm();
}

RotorState randomState(Random& random, Real size) {
  const Vector3 axis = random.direction();
  const Quaternion q = integrateOrientation({1, 0, 0, 0}, axis, random.between(-3, 3));
  return {q, size * Vector3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1))};
}

// The largest difference of a component; half the angle for near attitudes.
Real difference(const Quaternion& a, const Quaternion& b) {
  const Vector4 p(a.w, a.x, a.y, a.z), q(b.w, b.x, b.y, b.z);
  return std::min((p - q).cwiseAbs().maxCoeff(), (p + q).cwiseAbs().maxCoeff());
}

// An engine's step: the term by `step`, then the attitude along the new angular velocity.
template <class StepOf>
RotorState run(const StepOf& step, const RotorState& from, Real dt, int steps) {
  RotorState s = from;
  for (int i = 0; i < steps; ++i) {
    s.angularVelocity = step(s.angularVelocity, dt);
    s.q_WB = integrateOrientation(s.q_WB, rotatePoint(s.q_WB, s.angularVelocity), dt);
  }
  return s;
}

Vector3 implicitStep(const Vector3& w, Real dt) {
  return gyroscopicStep(kMoments.asDiagonal(), w, dt);
}

Vector3 explicitStep(const Vector3& w, Real dt) {
  return explicitGyroscopicStep(kMoments, w, dt);
}

Vector3 noStep(const Vector3& w, Real) {
  return w;
}

Real energyGain(const RotorState& s) {
  return rotationEnergy(kMoments, s.angularVelocity) /
             rotationEnergy(kMoments, kTumbling.angularVelocity) -
         1;
}

}  // namespace

TEST_CASE("Euler's equation turns the angular momentum backwards in the body") {
  const Vector3 w(2, -1, 1.5), tau(0.3, 0.1, -0.2);
  const Vector3 a = eulerAcceleration(kMoments, w, tau);
  const Vector3 L = kMoments.cwiseProduct(w);
  CHECK((kMoments.cwiseProduct(a) - (tau - cross(w, L))).norm() < 1e-15);
  CHECK(rotationEnergy(kMoments, w) == (4 + 2 + 6.75) / 2);
  // A body of equal moments feels no such term, nor one that turns about a principal axis.
  CHECK(eulerAcceleration({2, 2, 2}, w, {0, 0, 0}).norm() == 0);
  CHECK(eulerAcceleration(kMoments, {0, 5, 0}, {0, 0, 0}).norm() == 0);
}

TEST_CASE("N7: leaving the term out, the body keeps its energy and loses its way") {
  const Quaternion expected = quaternion(motionCase("N7")["q_10"]);
  for (int rate : {60, 960}) {
    const RotorState s = run(noStep, kTumbling, 1.0 / rate, 10 * rate);
    CHECK(std::abs(between(s.q_WB, expected) - 0.80) < 0.01);
    // L, which nothing acts on, has turned with the body.
    const Vector3 before = angularMomentum(kMoments, kTumbling);
    CHECK((angularMomentum(kMoments, s) - before).norm() > 0.05 * before.norm());
  }
}

TEST_CASE("N7: the explicit gyroscopic step gains energy, the implicit one loses it") {
  const Quaternion expected = quaternion(motionCase("N7")["q_10"]);
  const RotorState a = run(explicitStep, kTumbling, 1.0 / 60, 600);
  CHECK(std::abs(energyGain(a) - 0.17) < 0.005);
  CHECK(std::abs(between(a.q_WB, expected) - 0.92) < 0.005);
  const RotorState b = run(explicitStep, kTumbling, 1.0 / 960, 9600);
  CHECK(std::abs(energyGain(b) - 9.6e-3) < 5e-5);

  const RotorState c = run(implicitStep, kTumbling, 1.0 / 60, 600);
  CHECK(std::abs(energyGain(c) + 0.13) < 0.005);
  CHECK(std::abs(between(c.q_WB, expected) - 0.79) < 0.005);
  const RotorState d = run(implicitStep, kTumbling, 1.0 / 960, 9600);
  CHECK(std::abs(energyGain(d) + 9.4e-3) < 5e-5);
}

TEST_CASE("bodies that tumble under the implicit gyroscopic step lose energy, and never explode") {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const Vector3 start = randomState(random, 3).angularVelocity;
    Vector3 w = start;
    for (int n = 0; n < 600; ++n) w = implicitStep(w, 1.0 / 60);
    INFO("seed 5, body " << i);
    REQUIRE(rotationEnergy(kMoments, w) <= rotationEnergy(kMoments, start));
  }
  // A ball has no such term.
  CHECK(gyroscopicStep(2 * Matrix3::Identity(), {1, 2, 3}, 0.1) == Vector3(1, 2, 3));
}

TEST_CASE("one turn of Newton's method solves the implicit equation to second order") {
  const Vector3 w(2, 1, 1.5);
  const auto residual = [&](Real dt) {
    const Vector3 after = implicitStep(w, dt);
    return (kMoments.cwiseProduct(after - w) + dt * cross(after, kMoments.cwiseProduct(after)))
        .norm();
  };
  // What is left is the square of the change, times dt.
  CHECK(std::abs(measureOrder({0.01, residual(0.01)}, {0.005, residual(0.005)}) - 3) < 0.1);
}

TEST_CASE("the measured orders of the steps for rotations") {
  const FreeRotor exact(kMoments, kTumbling);
  const SplitRotor split(kMoments);
  const std::vector<RotorState> starts = {
      kTumbling, {{1, 0, 0, 0}, {0.3, 1.2, -0.4}}, {{0.6, 0, 0.8, 0}, {1, 1, 1}}};
  const auto error = [&](const RotorState& from, auto step, int n) {
    RotorState s = from;
    for (int i = 0; i < n; ++i) s = step(s, 2.0 / n);
    return between(s.q_WB, FreeRotor(kMoments, from).at(2).q_WB);
  };
  const auto order = [&](const RotorState& from, auto step, int n) {
    return measureOrder({2, error(from, step, n)}, {1, error(from, step, 2 * n)});
  };
  const auto engine = [](auto step) {
    return [step](const RotorState& s, Real dt) { return run(step, s, dt, 1); };
  };
  for (const RotorState& from : starts) {
    CHECK(std::abs(order(from, engine(explicitStep), 4000) - 1) < 0.1);
    CHECK(std::abs(order(from, engine(implicitStep), 4000) - 1) < 0.1);
    for (int n : {100, 200, 400}) {
      CHECK(
          std::abs(order(
                       from, [&](const RotorState& s, Real dt) { return split.step2(s, dt); }, n) -
                   2) < 0.1);
      CHECK(std::abs(order(
                         from,
                         [&](const RotorState& s, Real dt) { return rk4Rotor(kMoments, s, 0, dt); },
                         n) -
                     4) < 0.1);
    }
    for (int n : {30, 60, 120}) {
      const Real measured = order(
          from, [&](const RotorState& s, Real dt) { return split.step4(s, dt); }, n);
      INFO("splitting of order 4 measures " << measured);
      CHECK(std::abs(measured - 4) < 0.1);
    }
  }
}

TEST_CASE("N7: the splitting of order 4 and RK4 at 60 steps a second") {
  const Quaternion expected = quaternion(motionCase("N7")["q_10"]);
  const SplitRotor split(kMoments);
  RotorState s = kTumbling, r = kTumbling;
  for (int i = 0; i < 600; ++i) {
    s = split.step4(s, 1.0 / 60);
    r = rk4Rotor(kMoments, r, i / 60.0, 1.0 / 60);
  }
  INFO("splitting " << between(s.q_WB, expected) << " rad, RK4 " << between(r.q_WB, expected));
  CHECK(between(s.q_WB, expected) < 1e-6);
  CHECK(between(r.q_WB, expected) < 1e-3);
  CHECK(std::abs(energyGain(r) / -1.5e-9 - 1) < 0.05);
}

TEST_CASE("the splitting keeps angular momentum, and its energy does not drift in 1e6 steps") {
  const SplitRotor split(kMoments);
  RotorState two = kTumbling, four = kTumbling;
  const Vector3 L = angularMomentum(kMoments, kTumbling);
  Real early2 = 0, late2 = 0, early4 = 0, late4 = 0;
  for (int i = 0; i < 1000000; ++i) {
    two = split.step2(two, 1.0 / 60);
    four = split.step4(four, 1.0 / 60);
    if (i < 100000) {
      early2 = std::max(early2, std::abs(energyGain(two)));
      early4 = std::max(early4, std::abs(energyGain(four)));
    } else if (i >= 900000) {
      late2 = std::max(late2, std::abs(energyGain(two)));
      late4 = std::max(late4, std::abs(energyGain(four)));
    }
  }
  INFO("energy errors " << early2 << " " << late2 << " " << early4 << " " << late4);
  CHECK(late2 < 1.01 * early2);
  CHECK(late4 < 1.1 * early4);
  CHECK((angularMomentum(kMoments, two) - L).norm() < 1e-10 * L.norm());
  CHECK((angularMomentum(kMoments, four) - L).norm() < 1e-10 * L.norm());
}

TEST_CASE("the splitting runs backwards to where it came from, and is exact for a round body") {
  Random random(8);
  for (int i = 0; i < 50; ++i) {
    const RotorState s = randomState(random, 3);
    const SplitRotor split(kMoments);
    const RotorState there = split.step4(s, 0.1), back = split.step4(there, -0.1);
    INFO("seed 8, body " << i);
    REQUIRE(between(back.q_WB, s.q_WB) < 1e-14);
    REQUIRE((back.angularVelocity - s.angularVelocity).norm() < 1e-14);

    const SplitRotor round({2, 2, 1});
    const RotorState one = round.step2(s, 0.7), exact = exactRotor({2, 1}, s, 0.7);
    REQUIRE(between(one.q_WB, exact.q_WB) < 1e-14);
    REQUIRE((one.angularVelocity - exact.angularVelocity).norm() < 1e-14);
  }
}

TEST_CASE(
    "Jacobi's functions fulfil their identities, from a circle to the last modulus before one") {
  for (Real k1 : {1.0, 0.999999, 0.8, 0.5, 0.1, 1e-4, 1e-8, 1e-15, 1e-100}) {
    const JacobiElliptic f(k1);
    for (int i = -20; i <= 20; ++i) {
      const Real phase = 0.171 * i;
      const EllipticFunctions e = f.at(phase);
      INFO("k' = " << k1 << ", phase " << phase);
      REQUIRE(std::abs(e.sn * e.sn + e.cn * e.cn - 1) < 1e-15);
      REQUIRE(std::abs(e.dn * e.dn - (e.cn * e.cn + k1 * k1 * e.sn * e.sn)) < 2e-15);
      // Back to the phase. Where the functions hardly move, little can be known of it.
      const Real back = f.phaseOf(e.sn, e.cn);
      const Real turns = std::round((phase - back) / (2 * kPi));
      REQUIRE(std::abs(phase - back - 2 * kPi * turns) < 3e-15 / std::sqrt(k1));
    }
    CHECK(f.at(0).sn == 0);
    CHECK(f.at(0).dn == 1);
    CHECK(std::abs(f.at(kPi / 2).dn - k1) < 1e-15);
  }
  // k = k': the quarter period of the lemniscate, known since Gauss.
  CHECK(std::abs(JacobiElliptic(std::sqrt(0.5)).quarterPeriod() - 1.8540746773013719184) < 4e-16);
  CHECK(JacobiElliptic(1).quarterPeriod() == kPi / 2);
  CHECK_THROWS_WITH(JacobiElliptic(0), ContainsSubstring("complement = 0 must be above zero"));
  CHECK_THROWS_AS(JacobiElliptic(1.5), InvalidInput);
  CHECK_THROWS_AS(JacobiElliptic(kNan), InvalidInput);
}

TEST_CASE("N13: Duffing's oscillator is an elliptic function") {
  const json expected = motionCase("N13");
  const JacobiElliptic f(std::sqrt(0.75));  // m = 1/4
  const EllipticFunctions e = f.at(std::sqrt(2.0) * 5 * f.mean());
  CHECK(std::abs(e.cn - number(expected["x"])) < 1e-15);
  CHECK(std::abs(-std::sqrt(2.0) * e.sn * e.dn - number(expected["v"])) < 3e-15);
}

TEST_CASE("N7: the free rotor at any time") {
  const json expected = motionCase("N7");
  const FreeRotor rotor(kMoments, kTumbling);
  CHECK(std::abs(rotor.period() / number(expected["period"]) - 1) < 1e-15);
  const RotorState ten = rotor.at(10), thousand = rotor.at(1000);
  INFO("attitude " << between(ten.q_WB, quaternion(expected["q_10"])) << " rad, w at 1000 s "
                   << (thousand.angularVelocity - vector(expected["w_1000"])).norm());
  CHECK(between(ten.q_WB, quaternion(expected["q_10"])) < 1e-13);
  CHECK((ten.angularVelocity - vector(expected["w_10"])).norm() < 1e-13);
  CHECK((thousand.angularVelocity - vector(expected["w_1000"])).norm() < 1e-13);
}

TEST_CASE("N8: the tennis racket flips when it should") {
  const json expected = motionCase("N8");
  const RotorState start = {{1, 0, 0, 0}, {0.001, 5, 0}};
  const FreeRotor rotor(kMoments, start);
  CHECK(std::abs(rotor.period() / number(expected["period"]) - 1) < 1e-14);
  const RotorState s = rotor.at(30);
  CHECK(between(s.q_WB, quaternion(expected["q"])) < 1e-10);
  CHECK((s.angularVelocity - vector(expected["w"])).norm() < 1e-10);
  const Real energy = rotationEnergy(kMoments, start.angularVelocity);
  const Vector3 L = angularMomentum(kMoments, start);
  for (int i = 0; i <= 300; ++i) {
    const RotorState now = rotor.at(0.1 * i);
    REQUIRE(std::abs(rotationEnergy(kMoments, now.angularVelocity) / energy - 1) < 1e-13);
    REQUIRE((angularMomentum(kMoments, now) - L).norm() < 1e-12 * L.norm());
  }
  // Growth of a small deviation, as long as it is small.
  const FreeRotor slight(kMoments, {{1, 0, 0, 0}, {1e-9, 5, 0}});
  const Real grown = slight.at(2).angularVelocity.x() / slight.at(1).angularVelocity.x();
  CHECK(std::abs(std::log(grown) / number(expected["growth"]) - 1) < 1e-2);
}

TEST_CASE("N9: a round body, by its closed form and by the general one") {
  const json expected = motionCase("N9");
  const RotorState start = {{1, 0, 0, 0}, {1, 0, 4}};
  const RotorState a = exactRotor({2, 1}, start, 10);
  INFO("closed form " << difference(a.q_WB, quaternion(expected["q"])));
  CHECK(difference(a.q_WB, quaternion(expected["q"])) < 1e-14);
  CHECK((a.angularVelocity - vector(expected["w"])).norm() < 1e-14);
  const RotorState b = FreeRotor({2, 2, 1}, start).at(10);
  INFO("general form " << difference(b.q_WB, quaternion(expected["q"])));
  CHECK(difference(b.q_WB, quaternion(expected["q"])) < 1e-14);
  CHECK((b.angularVelocity - vector(expected["w"])).norm() < 2e-14);
}

TEST_CASE("the free rotor follows the body wherever it starts, and whatever its axes are called") {
  Random random(21);
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (int i = 0; i < 120; ++i) {
    const Vector3 sorted(1, random.between(1.05, 2), random.between(2.05, 2.9));
    const auto& o = orders[static_cast<std::size_t>(i % 6)];
    const Vector3 moments(sorted[o[0]], sorted[o[1]], sorted[o[2]]);
    const RotorState start = randomState(random, 4);
    const FreeRotor rotor(moments, start, 3);
    INFO("seed 21, body " << i);
    // Where it starts.
    REQUIRE(between(rotor.at(3).q_WB, start.q_WB) < 1e-14);
    REQUIRE((rotor.at(3).angularVelocity - start.angularVelocity).norm() < 2e-14);
    // Where RK4 with fine steps goes.
    RotorState s = start;
    for (int n = 0; n < 2000; ++n) s = rk4Rotor(moments, s, 0, 1e-3);
    REQUIRE(between(rotor.at(5).q_WB, s.q_WB) < 1e-9);
    REQUIRE((rotor.at(5).angularVelocity - s.angularVelocity).norm() < 1e-9);
    // From any moment on it goes the same way: backwards too.
    const FreeRotor later(moments, rotor.at(40), 40);
    REQUIRE(between(later.at(-20).q_WB, rotor.at(-20).q_WB) < 1e-10);
  }
}

TEST_CASE("energy and angular momentum of the free rotor hold at any time") {
  Random random(22);
  for (int i = 0; i < 200; ++i) {
    const Vector3 moments(1, random.between(1, 2), random.between(2, 2.9));
    const RotorState start = randomState(random, 10);
    const FreeRotor rotor(moments, start);
    const Real energy = rotationEnergy(moments, start.angularVelocity);
    const Vector3 L = angularMomentum(moments, start);
    for (Real t : {-1e6, -7.0, 0.1, 33.0, 1e4, 1e9}) {
      const RotorState s = rotor.at(t);
      INFO("seed 22, body " << i << ", time " << t);
      REQUIRE(std::abs(rotationEnergy(moments, s.angularVelocity) / energy - 1) < 1e-13);
      REQUIRE((angularMomentum(moments, s) - L).norm() < 1e-12 * L.norm());
      REQUIRE(std::abs(angularMomentum(moments, s).norm() / L.norm() - 1) < 1e-13);
    }
  }
}

TEST_CASE("bodies that are round, nearly round, or spheres, need no other formula") {
  const RotorState start = {{0.6, 0, 0.8, 0}, {1, 0.5, 2}};
  for (Real off : {0.0, 1e-16, 1e-12, 1e-8, 1e-4}) {
    // Nearly round about z; the difference in the answer is of the size of `off`.
    const RotorState a = FreeRotor({2, 2 * (1 + off), 1}, start).at(10);
    const RotorState b = exactRotor({2, 1}, start, 10);
    CHECK(between(a.q_WB, b.q_WB) < 1e-13 + 30 * off);
    const RotorState c = FreeRotor({1, 1 + off, 2}, start).at(10);
    const RotorState d = exactRotor({1, 2}, start, 10);
    CHECK(between(c.q_WB, d.q_WB) < 1e-13 + 30 * off);
    // Nearly a sphere.
    const RotorState e = FreeRotor({1, 1 + off, 1 + 3 * off}, start).at(10);
    const Quaternion f =
        integrateOrientation(start.q_WB, rotatePoint(start.q_WB, start.angularVelocity), 10);
    CHECK(between(e.q_WB, f) < 1e-13 + 60 * off);
  }
  const RotorState g = exactRotor({1, 1}, start, 10);
  CHECK(g.angularVelocity == start.angularVelocity);
}

TEST_CASE("steady rotations are steady, and nearly steady ones nearly so") {
  for (int axis = 0; axis < 3; ++axis) {
    Vector3 w = Vector3::Zero();
    w[axis] = 5;
    const FreeRotor exact(kMoments, {{1, 0, 0, 0}, w});
    CHECK(exact.period() == 0);
    CHECK(exact.at(100).angularVelocity == w);
    CHECK(between(exact.at(7).q_WB, integrateOrientation({1, 0, 0, 0}, w, 7)) < 1e-13);
    if (axis == 1) continue;  // unstable: nothing nearly steady there
    for (Real tiny : {1e-4, 1e-9, 1e-30, 1e-120, 1e-160, 1e-300}) {
      Vector3 near = w;
      near[(axis + 1) % 3] = tiny;
      near[(axis + 2) % 3] = -2 * tiny;
      const RotorState s = FreeRotor(kMoments, {{1, 0, 0, 0}, near}).at(7);
      INFO("axis " << axis << ", off by " << tiny);
      CHECK(between(s.q_WB, integrateOrientation({1, 0, 0, 0}, w, 7)) < 1e-13 + 10 * tiny);
      CHECK((s.angularVelocity - w).norm() < 1e-13 + 10 * tiny);
    }
  }
  // At rest.
  const FreeRotor still(kMoments, {{0.6, 0, 0.8, 0}, {0, 0, 0}});
  CHECK(between(still.at(1e6).q_WB, {0.6, 0, 0.8, 0}) < 1e-15);
}

TEST_CASE("on the border between two motions the body comes to the middle axis and stays") {
  // 2 E I2 = L^2 exactly: I1 (I2 - I1) w1^2 = I3 (I3 - I2) w3^2 with I = (1, 2, 4).
  const Vector3 moments(1, 2, 4);
  const Real w1 = 2 * std::sqrt(2.0);
  const FreeRotor rotor(moments, {{1, 0, 0, 0}, {w1, 0, 1}});
  const RotorState later = rotor.at(10);
  const Real speed = std::sqrt(moments.cwiseProduct(Vector3(w1, 0, 1)).squaredNorm()) / 2;
  CHECK(std::abs(std::abs(later.angularVelocity.y()) - speed) < 1e-6);
  RotorState s = {{1, 0, 0, 0}, {w1, 0, 1}};
  for (int i = 0; i < 2000; ++i) s = rk4Rotor(moments, s, 0, 1e-3);
  CHECK(between(rotor.at(2).q_WB, s.q_WB) < 1e-7);
}

TEST_CASE("stepping the exact rotor from rounded states stays exact") {
  const FreeRotor whole(kMoments, kTumbling);
  RotorState s = kTumbling;
  for (int i = 0; i < 6000; ++i) s = FreeRotor(kMoments, s).at(1.0 / 60);
  INFO("after 100 s " << between(s.q_WB, whole.at(100).q_WB));
  CHECK(between(s.q_WB, whole.at(100).q_WB) < 1e-8);
  CHECK(std::abs(energyGain(s)) < 1e-12);
}

namespace {

// The top of N10: a mass of 1 kg half a metre above its point. Moments are about the point.
const Vector3 kTop(0.3, 0.3, 0.1);

Vector3 weightOfTop(Real, const RotorState& s) {
  return cross(Vector3(0, 0, 0.5), rotatePoint(conjugate(s.q_WB), {0, 0, -9.81}));
}

Vector3 axisOf(const RotorState& s) {
  return rotatePoint(s.q_WB, {0, 0, 1});
}

Real tiltOf(const RotorState& s) {
  const Vector3 axis = axisOf(s);
  return carom::arctangent2(std::hypot(axis.x(), axis.y()), axis.z());
}

RotorState tilted(Real angle) {
  const SineCosine half = sineCosine(angle / 2);
  return {{half.cosine, half.sine, 0, 0}, {0, 0, 0}};
}

}  // namespace

TEST_CASE("N10: a top that precesses steadily for 100 s") {
  const json expected = motionCase("N10");
  const SplitRotor body(kTop);
  RotorState s = tilted(kPi / 6);
  const Real precession = number(expected["slow"]);
  const Vector3 up = rotatePoint(conjugate(s.q_WB), {0, 0, 1});  // along the axes of the body
  s.angularVelocity = precession * Vector3(up.x(), up.y(), 0) + Vector3(0, 0, 60);
  const Vector3 first = axisOf(s);
  Real worst = 0;
  constexpr int kSteps = 50000;
  for (int i = 0; i < kSteps; ++i) {
    s = kickedRotor(body, s, i * 2e-3, 2e-3, kKahanLi6Weights, weightOfTop);
    worst = std::max(worst, std::abs(tiltOf(s) - kPi / 6));
  }
  const Vector3 last = axisOf(s);
  const Real turned = carom::arctangent2(first.x() * last.y() - first.y() * last.x(),
                                         first.x() * last.x() + first.y() * last.y());
  const Real off = std::remainder(turned - precession * 100, 2 * kPi) / 100;
  INFO("tilt off by " << worst << " rad, precession by " << off << " rad/s");
  CHECK(worst < 1e-10);
  CHECK(std::abs(off) < 1e-10);
}

TEST_CASE("N11: a top that is let go nods, and comes to rest at each cusp") {
  const json expected = motionCase("N11");
  const SplitRotor body(kTop);
  RotorState s = tilted(0.5);
  s.angularVelocity = {0, 0, 40};
  const Vector3 first = axisOf(s);
  Real deepest = 0;
  for (int i = 0; i < 2000; ++i) {
    s = kickedRotor(body, s, i * 1e-3, 1e-3, kKahanLi6Weights, weightOfTop);
    deepest = std::max(deepest, tiltOf(s));
  }
  const Vector3 last = axisOf(s);
  const Real turned = carom::arctangent2(first.x() * last.y() - first.y() * last.x(),
                                         first.x() * last.x() + first.y() * last.y());
  INFO("theta off by " << tiltOf(s) - number(expected["theta"]) << ", phi by "
                       << turned - number(expected["phi"]));
  CHECK(std::abs(tiltOf(s) - number(expected["theta"])) < 1e-9);
  CHECK(std::abs(turned - number(expected["phi"])) < 1e-9);
  CHECK(std::abs(deepest - number(expected["theta_max"])) < 1e-5);

  // Runge and Kutta, with its torque, finds the same.
  RotorState r = tilted(0.5);
  r.angularVelocity = {0, 0, 40};
  for (int i = 0; i < 4000; ++i) r = rk4Rotor(kTop, r, i * 5e-4, 5e-4, weightOfTop);
  CHECK(std::abs(tiltOf(r) - number(expected["theta"])) < 1e-6);
}

TEST_CASE("a body of three unlike moments under torque is stepped to order 4") {
  const SplitRotor body(kMoments);
  const auto error = [&](int n) {
    RotorState s = kTumbling;
    for (int i = 0; i < n; ++i) {
      s = kickedRotor(body, s, 2.0 * i / n, 2.0 / n, kYoshida4Weights, weightOfTop);
    }
    RotorState fine = kTumbling;
    for (int i = 0; i < 4000; ++i) {
      fine = rk4Rotor(kMoments, fine, i * 5e-4, 5e-4, weightOfTop);
    }
    return between(s.q_WB, fine.q_WB);
  };
  const Real order = measureOrder({2, error(100)}, {1, error(200)});
  INFO("order " << order);
  CHECK(std::abs(order - 4) < 0.15);
  CHECK_THROWS_AS(kickedRotor(body, kTumbling, 0, 1, kYoshida4Weights, Torque()), InvalidInput);
  CHECK_THROWS_AS(kickedRotor(body, kTumbling, kNan, 1, kYoshida4Weights, weightOfTop),
                  InvalidInput);
}

TEST_CASE("bodies that cannot be are refused") {
  CHECK_THROWS_WITH(FreeRotor({1, 0, 3}, kTumbling), ContainsSubstring("moments = (1, 0, 3)"));
  CHECK_THROWS_AS(FreeRotor({1, 2, kNan}, kTumbling), InvalidInput);
  CHECK_THROWS_WITH(FreeRotor(kMoments, {{2, 0, 0, 0}, {1, 1, 1}}), ContainsSubstring("q_WB"));
  CHECK_THROWS_AS(FreeRotor(kMoments, {{1, 0, 0, 0}, {kNan, 1, 1}}), InvalidInput);
  CHECK_THROWS_AS(FreeRotor(kMoments, {{1, 0, 0, 0}, {1e200, 1, 1}}), InvalidInput);
  CHECK_THROWS_AS(FreeRotor(kMoments, kTumbling).at(kNan), InvalidInput);
  CHECK_THROWS_AS(SplitRotor({1, -1, 1}), InvalidInput);
  CHECK_THROWS_AS(SplitRotor(kMoments).step2(kTumbling, kNan), InvalidInput);
  CHECK_THROWS_AS(SplitRotor(kMoments).step4({{kNan, 0, 0, 0}, {1, 1, 1}}, 1), InvalidInput);
  CHECK_THROWS_AS(rk4Rotor({0, 1, 1}, kTumbling, 0, 1), InvalidInput);
  CHECK_THROWS_AS(rk4Rotor(kMoments, kTumbling, kNan, 1), InvalidInput);
  CHECK_THROWS_WITH(exactRotor({0, 1}, kTumbling, 1), ContainsSubstring("across = 0"));
  CHECK_THROWS_AS(exactRotor({1, 1}, kTumbling, kNan), InvalidInput);
  CHECK_THROWS_AS(gyroscopicStep(Matrix3::Zero(), {1, 1, 1}, 0.1), InvalidInput);
  CHECK_THROWS_AS(gyroscopicStep(Matrix3::Identity(), {1, kNan, 1}, 0.1), InvalidInput);
  CHECK_THROWS_AS(explicitGyroscopicStep({1, 1, 0}, {1, 1, 1}, 0.1), InvalidInput);
  CHECK_THROWS_AS(explicitGyroscopicStep(kMoments, {1, 1, 1}, kNan), InvalidInput);
}
