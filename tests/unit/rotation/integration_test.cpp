#include <limits>

#include "carom/core/elementary.hpp"
#include "carom/core/errors.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_body_rate.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/renormalize.hpp"
#include "rotation_support.hpp"

using namespace carom;
using namespace rotation_test;

TEST_CASE("ten seconds at constant angular velocity are exact in any number of steps (R8)") {
  const auto c = caseNamed("R8");
  const Vector3 omega = vector(c["omega"]);
  const Real duration = number(c["duration"]);
  for (const int steps : {1, 10, 100, 1000, 10000}) {
    Quaternion q;
    for (int i = 0; i < steps; ++i) q = integrateOrientation(q, omega, duration / steps);
    INFO(steps << " steps, error " << distance(q, quaternion(c["q"])));
    CHECK(distance(q, quaternion(c["q"])) <= number(c["accept"]["error"]));
  }
}

TEST_CASE("the angle after ten seconds is that of case R8") {
  const auto c = caseNamed("R8");
  const Quaternion q = integrateOrientation({}, vector(c["omega"]), number(c["duration"]));
  CHECK(std::abs(quaternionLogarithm(q).norm() -
                 std::abs(number(c["angle modulo a turn"]) - 2 * kPi)) <= 3e-14);
}

TEST_CASE("after a million steps the norm is 1 within 4 ulp and the orientation is right") {
  const Vector3 omega(3, -4, 12);
  const Real dt = 0.0009765625;  // 2^-10 s, so that omega dt and the whole angle are exact
  Quaternion q;
  Real worst = 0;
  for (int i = 1; i <= 1000000; ++i) {
    q = integrateOrientation(q, omega, dt);
    worst = std::max(worst, static_cast<Real>(std::abs(norm(q) - 1)));
  }
  CHECK(worst <= 4 * 0x1p-52);
  const Real angle = 13 * dt * 1000000;
  const Quaternion exact = axisAngleToQuaternion(omega, angle);
  INFO("error " << angleBetween(q, exact) << " rad");
  CHECK(angleBetween(q, exact) < 1e-9);
}

TEST_CASE("a million Hamilton products follow the closed form (R6)") {
  const auto c = caseNamed("R6");
  const Real half = number(c["half angle"]);
  // The step of the case is the exact one, rounded.
  const long double s = std::sin(static_cast<long double>(half)) / 13;
  const Quaternion step{static_cast<Real>(std::cos(static_cast<long double>(half))),
                        static_cast<Real>(3 * s), static_cast<Real>(4 * s),
                        static_cast<Real>(12 * s)};
  CHECK(distance(quaternionExponential(2 * half / 13 * vector(c["axis times 13"])), step) <=
        1.2e-16);

  Quaternion q;
  const int steps = c["steps"];
  for (int i = 0; i < steps; ++i) q = hamiltonProduct(q, step);
  CHECK(std::abs(Real(norm(q)) - number(c["norm"])) <= 1e-13);
  const Real size = static_cast<Real>(norm(q));
  CHECK(distance({q.w / size, q.x / size, q.y / size, q.z / size}, quaternion(c["q"])) <=
        number(c["accept"]["direction, products alone"]));

  const Vector3 logarithm = quaternionLogarithm(step);
  CHECK(std::abs(logarithm.norm() / number(c["angle of the rounded step"]) - 1) <= 4e-16);
  CHECK(distance(quaternionExponential(steps * logarithm), quaternion(c["q"])) <=
        number(c["accept"]["direction, exponential of N logarithms"]));
}

TEST_CASE("angular velocity in the world turns after what is there already") {
  // A body lying on its side (x axis up) that spins about the world's z axis spins about its own x.
  const Quaternion onItsSide = axisAngleToQuaternion(Vector3::UnitY(), -kPi / 2);
  const Quaternion turned = integrateOrientation(onItsSide, Vector3(0, 0, 1), 0.5);
  CHECK(distance(turned, hamiltonProduct(axisAngleToQuaternion(Vector3::UnitZ(), 0.5),
                                         onItsSide)) <= 3e-16);
  CHECK(distance(turned, hamiltonProduct(onItsSide,
                                         axisAngleToQuaternion(Vector3::UnitX(), 0.5))) <= 3e-16);
}

TEST_CASE("angular velocities of one frame add as vectors, in the limit of small steps") {
  // Turning by a and then by b is turning by a + b, but for a term a x b / 2 of second order.
  const Vector3 a(1, 0, 0), b(0, 2, 0);
  for (const Real dt : {1e-2, 1e-3, 1e-4}) {
    const Quaternion inTurn = integrateOrientation(integrateOrientation({}, a, dt), b, dt);
    const Quaternion together = integrateOrientation({}, a + b, dt);
    CHECK(angleBetween(inTurn, together) == carom_test::Approx(dt * dt).epsilon(0.01));
  }
}

TEST_CASE("no time and no angular velocity change nothing, and time can run backwards") {
  Random random(501);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q = random.rotation();
    const Vector3 omega = random.inBox(20);
    REQUIRE(distance(integrateOrientation(q, omega, 0), q) <= 3e-16);
    REQUIRE(distance(integrateOrientation(q, Vector3::Zero(), 5), q) <= 3e-16);
    REQUIRE(distance(integrateOrientation(integrateOrientation(q, omega, 0.3), omega, -0.3), q) <=
            1e-15);
  }
}

TEST_CASE("an orientation that has drifted is brought back to norm 1 by a step") {
  const Quaternion q = integrateOrientation({3, 0, 0, 0}, {0, 0, 1}, 0.5);
  CHECK(distance(q, axisAngleToQuaternion(Vector3::UnitZ(), 0.5)) <= 3e-16);
}

TEST_CASE("a step that cannot be made is refused by name") {
  const Real infinite = std::numeric_limits<Real>::infinity();
  const Vector3 ez = Vector3::UnitZ();
  CHECK_THROWS_WITH(integrateOrientation({}, {0, 0, 1}, infinite), "dt = inf must be finite");
  CHECK_THROWS_AS(integrateOrientation({}, {0, infinite, 1}, 1), InvalidInput);
  CHECK_THROWS_AS(integrateOrientation({0, 0, 0, 0}, {0, 0, 1}, 1), InvalidInput);
  CHECK_THROWS_AS(integrateOrientation({}, {1e200, 0, 1}, 1e200), InvalidInput);
  CHECK_THROWS_AS(integrateBodyRate({}, {ez, ez, Vector3(infinite, 0, 1)}, 1), InvalidInput);
  CHECK_THROWS_AS(integrateBodyRate({}, {ez, ez, ez}, infinite), InvalidInput);
}

namespace {

// The coning motion of case R8b: its angular velocity in the body, and its orientation.
struct Coning {
  Real a, W;
  Vector3 rate(Real t) const {
    const Real s = sine(a / 2);
    return {-W * sine(a) * sine(W * t), W * sine(a) * cosine(W * t), -2 * W * s * s};
  }
  Quaternion orientation(Real t) const {
    const Real s = sine(a / 2);
    return {cosine(a / 2), s * cosine(W * t), s * sine(W * t), 0};
  }
};

Real coningError(const Coning& motion, const Quaternion& exact, int steps) {
  const Real h = 10.0 / steps;
  Quaternion q = motion.orientation(0);
  for (int i = 0; i < steps; ++i) {
    const Real t = i * h;
    q = integrateBodyRate(
        q,
        {motion.rate(t + kGaussPoints[0] * h), motion.rate(t + kGaussPoints[1] * h),
         motion.rate(t + kGaussPoints[2] * h)},
        h);
  }
  return angleBetween(q, exact);
}

// One value of the rate per step, taken a fraction of the step after its start.
Real simpleConingError(const Coning& motion, const Quaternion& exact, int steps, Real fraction) {
  const Real h = 10.0 / steps;
  Quaternion q = motion.orientation(0);
  for (int i = 0; i < steps; ++i) {
    q = hamiltonProduct(q, quaternionExponential(motion.rate((i + fraction) * h) * h));
  }
  return angleBetween(q, exact);
}

}  // namespace

// Runge and Kutta's method on the four numbers of the quaternion, made a rotation after each step.
Real rungeKuttaConingError(const Coning& motion, const Quaternion& exact, int steps) {
  const Real h = 10.0 / steps;
  const auto slope = [&motion](const Quaternion& q, Real t) {
    const Vector3 w = motion.rate(t) / 2;
    return hamiltonProduct(q, {0, w.x(), w.y(), w.z()});
  };
  const auto plus = [](const Quaternion& q, Real f, const Quaternion& k) {
    return Quaternion{q.w + f * k.w, q.x + f * k.x, q.y + f * k.y, q.z + f * k.z};
  };
  Quaternion q = motion.orientation(0);
  for (int i = 0; i < steps; ++i) {
    const Real t = i * h;
    const Quaternion k1 = slope(q, t);
    const Quaternion k2 = slope(plus(q, h / 2, k1), t + h / 2);
    const Quaternion k3 = slope(plus(q, h / 2, k2), t + h / 2);
    const Quaternion k4 = slope(plus(q, h, k3), t + h);
    q = renormalize(plus(plus(plus(plus(q, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4));
  }
  return angleBetween(q, exact);
}

// The fewest steps, of those tried, after which the error stays below a millionth of a radian.
template <class Error>
int stepsFor(const Error& error) {
  int steps = 16;
  while (error(steps) > 1e-6) steps += std::max(1, steps / 32);
  return steps;
}

TEST_CASE("for a millionth of a radian three rates a step need a fifth of what Runge-Kutta needs") {
  const auto c = caseNamed("R8b");
  const Coning motion{number(c["half cone angle"]), number(c["W"])};
  const Quaternion exact = quaternion(c["q"]);
  const int ours = 3 * stepsFor([&](int steps) { return coningError(motion, exact, steps); });
  const int theirs =
      4 * stepsFor([&](int steps) { return rungeKuttaConingError(motion, exact, steps); });
  INFO(ours << " and " << theirs << " rates in ten seconds");
  CHECK(theirs >= 5 * ours);
}

TEST_CASE("a constant rate in the body is followed exactly in any number of steps") {
  const Vector3 rate(3, -4, 12);
  const Quaternion start = axisAngleToQuaternion({1, 2, 2}, 0.7);
  const Quaternion exact = hamiltonProduct(start, quaternionExponential(10 * rate));
  for (const int steps : {1, 3, 10, 100, 1000, 10000}) {
    Quaternion q = start;
    for (int i = 0; i < steps; ++i) q = integrateBodyRate(q, {rate, rate, rate}, 10.0 / steps);
    INFO(steps << " steps");
    // The rounding of each step, which is random: its sum grows as the root of their number.
    CHECK(angleBetween(q, exact) <= 4e-16 * (1 + 10 * std::sqrt(steps)));
  }
}

TEST_CASE("a coning body is followed to sixth order (R8b)") {
  const auto c = caseNamed("R8b");
  const Coning motion{number(c["half cone angle"]), number(c["W"])};
  const Quaternion exact = quaternion(c["q"]);
  CHECK(distance(motion.rate(0), vector(c["rate at 0"])) <= 1e-15);
  CHECK(distance(motion.rate(0.37), vector(c["rate at 0.37"])) <= 4e-15);
  CHECK(distance(motion.orientation(10), exact) <= 1e-15);

  const Real error = coningError(motion, exact, 2000);
  INFO("h = 0.005: " << error << " rad");
  CHECK(error <= number(c["accept"]["angle error at h=0.005"]));
  const Real order = std::log2(coningError(motion, exact, 500) / coningError(motion, exact, 1000));
  CHECK(order == carom_test::Approx(6).margin(0.1));

  // What the simpler ways give is known too.
  const auto wrong = c["wrong"];
  CHECK(simpleConingError(motion, exact, 1000, 0) ==
        carom_test::Approx(number(wrong["angle error at h=0.01"])).epsilon(0.005));
  CHECK(simpleConingError(motion, exact, 2000, 0) ==
        carom_test::Approx(number(wrong["angle error at h=0.005"])).epsilon(0.005));
  CHECK(simpleConingError(motion, exact, 1000, 0.5) ==
        carom_test::Approx(number(wrong["midpoint at h=0.01"])).epsilon(0.005));
  CHECK(simpleConingError(motion, exact, 2000, 0.5) ==
        carom_test::Approx(number(wrong["midpoint at h=0.005"])).epsilon(0.005));
}

TEST_CASE("a constant rate in the body is the same as a constant rate in the world, turned") {
  Random random(502);
  for (int i = 0; i < 1000; ++i) {
    const Quaternion q = random.rotation();
    const Vector3 rate = random.inBox(3);
    REQUIRE(distance(integrateBodyRate(q, {rate, rate, rate}, 0.7),
                     integrateOrientation(q, quaternionToMatrix(q) * rate, 0.7)) <= 2e-15);
  }
}
