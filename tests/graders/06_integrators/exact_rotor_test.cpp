// Grader of 06.exact_rotor: steady rotations in closed form, what stays, the cone of the axis by
// Rodrigues' formula, and the derivative of the attitude.

#include "carom/motion/exact_rotor.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "grading/fields_motion.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

// By an angle about a unit axis.
Quaternion turn(const Vector3& axis, Real angle) {
  const Real s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x(), s * axis.y(), s * axis.z()};
}

RoundMoments anyMoments(Random& random) {
  return {random.between(1, 2), random.between(0.3, 0.9) + random.integer(0, 1) * 2};
}

RotorState anyStart(Random& random) {
  const Vector3 w = random.vector(1);
  return {turn(random.direction(), random.between(0.5, 3)),
          {w.x() + 1.5, w.y() + 0.5, random.between(1, 3)}};
}

Vector3 momentumInWorld(const RoundMoments& moments, const RotorState& state) {
  const Vector3& w = state.angularVelocity;
  return rotatePoint(
      state.q_WB, Vector3(moments.across * w.x(), moments.across * w.y(), moments.along * w.z()));
}

Vector3 axisInWorld(const RotorState& state) {
  return rotatePoint(state.q_WB, Vector3(0, 0, 1));
}

// v turned by an angle about a unit axis: Rodrigues' formula.
Vector3 turned(const Vector3& v, const Vector3& axis, Real angle) {
  const Real c = std::cos(angle);
  return c * v + std::sin(angle) * cross(axis, v) + (1 - c) * axis.dot(v) * axis;
}

// The rate of the attitude along the body's axes, from two moments close to each other: twice the
// vector part of q* dq/dt.
Vector3 rateOfAttitude(const RoundMoments& moments, const RotorState& start, Real time) {
  const Real h = 1e-4;
  const Quaternion before = exactRotor(moments, start, time - h).q_WB;
  const Quaternion after = exactRotor(moments, start, time + h).q_WB;
  const Quaternion change = hamiltonProduct(conjugate(before), after);
  const Real sign = change.w < 0 ? -1 : 1;
  return sign / h * Vector3(change.x, change.y, change.z);
}

const Quaternion kLevel = {1, 0, 0, 0};

}  // namespace

TEST_CASE("steady") {
  const RoundMoments plate = {1, 2}, ball = {1.5, 1.5};
  const Quaternion tilted = turn({1, 0, 0}, 0.5);
  GRADE(exactRotor(plate, {kLevel, {0, 0, 3}}, 0.4).q_WB, turn({0, 0, 1}, 1.2),
        within(1e-14, kRounding), upToSign(), given("across", plate.across, "kg m^2"),
        given("along", plate.along, "kg m^2"), given("q_WB", kLevel),
        given("angularVelocity", Vector3(0, 0, 3), "rad/s"), given("time", 0.4, "s"),
        about("a plate that spins about its axis"));
  GRADE(exactRotor(plate, {kLevel, {2, 0, 0}}, 0.7).q_WB, turn({1, 0, 0}, 1.4),
        within(1e-14, kRounding), upToSign(), given("across", plate.across, "kg m^2"),
        given("along", plate.along, "kg m^2"), given("q_WB", kLevel),
        given("angularVelocity", Vector3(2, 0, 0), "rad/s"), given("time", 0.7, "s"),
        about("the plate turns about an axis across"));
  GRADE(exactRotor(ball, {tilted, {0, 0.8, 0.6}}, 2).q_WB,
        hamiltonProduct(tilted, turn({0, 0.8, 0.6}, 2)), within(1e-14, kRounding), upToSign(),
        given("across", ball.across, "kg m^2"), given("along", ball.along, "kg m^2"),
        given("q_WB", tilted), given("angularVelocity", Vector3(0, 0.8, 0.6), "rad/s"),
        given("time", 2.0, "s"), about("a ball turns about any axis"));
}

TEST_CASE("velocity") {
  // For C = 2 A Euler's equations are dwx/dt = -wy wz, dwy/dt = wx wz.
  const Real quarter = std::acos(-1.0) / 2;
  GRADE(exactRotor({1, 2}, {kLevel, {1, 0, 1}}, quarter).angularVelocity, Vector3(0, 1, 1),
        within(1e-14, kRounding), given("across", 1.0, "kg m^2"), given("along", 2.0, "kg m^2"),
        given("angularVelocity", Vector3(1, 0, 1), "rad/s"), given("time", quarter, "s"),
        unit("rad/s"), about("a plate, after a quarter of its wobble"));
  // For C = A/2 they are dwx/dt = wy wz / 2, dwy/dt = -wx wz / 2.
  GRADE(exactRotor({2, 1}, {kLevel, {1, 0, 1}}, 2 * quarter).angularVelocity, Vector3(0, -1, 1),
        within(1e-14, kRounding), given("across", 2.0, "kg m^2"), given("along", 1.0, "kg m^2"),
        given("angularVelocity", Vector3(1, 0, 1), "rad/s"), given("time", 2 * quarter, "s"),
        unit("rad/s"), about("a rod, after a quarter of its wobble"));
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    const RoundMoments moments = anyMoments(random);
    const RotorState start = anyStart(random);
    const Real time = random.between(-5, 5);
    const Real rate = (moments.along / moments.across - 1) * start.angularVelocity.z();
    GRADE(exactRotor(moments, start, time).angularVelocity,
          turned(start.angularVelocity, {0, 0, 1}, rate * time), within(1e-13, kRounding),
          given("across", moments.across, "kg m^2"), given("along", moments.along, "kg m^2"),
          given("angularVelocity", start.angularVelocity, "rad/s"), given("time", time, "s"),
          unit("rad/s"), about("any round body, forwards and backwards in time"));
  }
}

TEST_CASE("cone") {
  Random random(seed() + 1);
  for (int n = 0; n < 8; ++n) {
    const RoundMoments moments = anyMoments(random);
    const RotorState start = anyStart(random);
    const Real time = random.between(1, 8);
    const Vector3 L = momentumInWorld(moments, start);
    const Real size = std::sqrt(L.squaredNorm());
    GRADE(axisInWorld(exactRotor(moments, start, time)),
          turned(axisInWorld(start), L / size, size / moments.across * time),
          within(1e-13, kRounding), given("across", moments.across, "kg m^2"),
          given("along", moments.along, "kg m^2"), given("start", start), given("time", time, "s"),
          about("the axis of the body in the world: it goes round L at the rate |L|/A"));
    GRADE(momentumInWorld(moments, exactRotor(moments, start, time)), L, within(1e-12, kRounding),
          given("across", moments.across, "kg m^2"), given("along", moments.along, "kg m^2"),
          given("start", start), given("time", time, "s"), unit("kg m^2/s"),
          about("angular momentum in the world: it stays"));
  }
}

TEST_CASE("rate") {
  Random random(seed() + 2);
  for (int n = 0; n < 8; ++n) {
    const RoundMoments moments = anyMoments(random);
    const RotorState start = anyStart(random);
    const Real time = random.between(-5, 5);
    const Real rate = (moments.along / moments.across - 1) * start.angularVelocity.z();
    GRADE(rateOfAttitude(moments, start, time),
          turned(start.angularVelocity, {0, 0, 1}, rate * time),
          within(1e-5, "taken from two moments 0.2 ms apart"),
          given("across", moments.across, "kg m^2"), given("along", moments.along, "kg m^2"),
          given("start", start), given("time", time, "s"), unit("rad/s"),
          about("how fast the attitude turns, along the body's axes, must be w at that time"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(exactRotor({0, 1}, {kLevel, {1, 0, 0}}, 1), given("across", 0.0, "kg m^2"));
}

PROBES() {
  Random random(609);
  for (int n = 0; n < 16; ++n) {
    const RoundMoments moments = anyMoments(random);
    const RotorState start = anyStart(random);
    // q and -q are one attitude: what is asked for is where it takes two axes.
    const RotorState state = exactRotor(moments, start, random.between(0.5, 4));
    PROBE((std::vector<Vector3>{axisInWorld(state), rotatePoint(state.q_WB, Vector3(1, 0, 0)),
                                state.angularVelocity}));
  }
}
