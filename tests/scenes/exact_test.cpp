// Are the answers right that the scenes are measured against? Each by another road.

#include <cmath>

#include "carom/impulse/bouncing_ball.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/impulse/slide_block.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/motion/rk4_rotor.hpp"
#include "scenes/exact.hpp"
#include "scenes/families.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using carom::Real;
using carom::Vector3;
using carom_test::number;
using carom_test::readCase;
using carom_test::WithinAbs;
using carom_test::WithinRel;
namespace scenes = carom::scenes;

namespace {

// Velocity Verlet with small steps, for x'' = f(x): the independent road of the swinging ones.
template <class F>
void integrate(Real& x, Real& v, Real duration, int steps, F f) {
  const Real h = duration / steps;
  Real a = f(x);
  for (int i = 0; i < steps; ++i) {
    v += h / 2 * a;
    x += h * v;
    a = f(x);
    v += h / 2 * a;
  }
}

}  // namespace

TEST_CASE("the domino of case S7 hits its neighbour when and as fast as the case book says") {
  const auto S7 = readCase("scenes", "S7");
  const scenes::Tipping box;
  const Real hit = number(S7["hit_angle"]);
  CHECK_THAT(scenes::tippingTime(box, hit), WithinRel(number(S7["time"]), 1e-15));
  CHECK_THAT(scenes::tippingSpin(box, hit), WithinRel(number(S7["spin"]), 1e-15));
  // And as stepping the pendulum says.
  Real angle = 0, spin = box.spin;
  const Real inertia = (box.height * box.height + box.thickness * box.thickness) / 3;
  integrate(angle, spin, number(S7["time"]), 200000, [&](Real a) {
    return box.gravity / inertia * (box.height / 2 * std::sin(a) - box.thickness / 2 * std::cos(a));
  });
  CHECK_THAT(angle, WithinAbs(hit, 1e-10));
  CHECK_THAT(spin, WithinAbs(number(S7["spin"]), 1e-10));
}

TEST_CASE("the rocking block of case S10 comes down and rises as the case book says") {
  const auto S10 = readCase("scenes", "S10");
  const scenes::RockingAnswer answer = scenes::rockingAnswer({});
  CHECK_THAT(answer.alpha, WithinRel(number(S10["alpha"]), 1e-15));
  CHECK_THAT(answer.impactTime, WithinRel(number(S10["impact_time"]), 1e-14));
  CHECK_THAT(answer.before, WithinRel(number(S10["before"]), 1e-15));
  CHECK_THAT(answer.nextAngle, WithinRel(number(S10["next_angle"]), 1e-14));
  const Real ratio = answer.after / answer.before;
  CHECK_THAT(ratio * ratio, WithinRel(number(S10["energy_ratio"]), 1e-15));
  Real angle = answer.alpha / 2, spin = 0;
  const Real p = number(S10["p"]);
  integrate(angle, spin, answer.impactTime, 200000,
            [&](Real a) { return -p * p * std::sin(answer.alpha - a); });
  CHECK_THAT(angle, WithinAbs(0, 1e-10));
  CHECK_THAT(-spin, WithinAbs(answer.before, 1e-10));
}

TEST_CASE("hard balls of case S8 are where 60 digits say, as far as they can be") {
  const auto S8 = readCase("scenes", "S8");
  const scenes::Scene scene = scenes::gasScene();
  std::vector<scenes::HardBall> balls;
  Real energy = 0;
  for (const scenes::Body& body : scene.bodies) {
    if (!body.moves) continue;
    scenes::HardBall ball{{}, {}, 0.1L, 1};
    for (std::size_t k = 0; k < 3; ++k) {
      ball.x[k] = body.start.position[static_cast<int>(k)];
      ball.v[k] = body.start.velocity[static_cast<int>(k)];
    }
    energy += body.start.velocity.squaredNorm() / 2;
    balls.push_back(ball);
  }
  CHECK_THAT(energy, WithinAbs(number(S8["energy"]), 1e-14));
  long double now = 0;
  long impacts = 0;
  for (const auto& moment : S8["moments"]) {
    const long double time = number(moment["time"]);
    impacts += scenes::hardBalls(balls, {{0, 0, 0}, {1, 1, 1}}, time - now);
    now = time;
    CHECK(impacts == moment["impacts"].get<long>());
    // The start is given as doubles, of which the last digit is multiplied as well.
    const Real allowed = 1000 * number(moment["amplification"]) * 1e-16;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK_THAT(static_cast<Real>(balls[0].x[k]), WithinAbs(number(moment["ball_0"][k]), allowed));
    }
  }
  Real later = 0;
  for (const scenes::HardBall& ball : balls) {
    for (const long double v : ball.v) later += static_cast<Real>(v * v) / 2;
  }
  CHECK_THAT(later, WithinRel(energy, 1e-14));
}

TEST_CASE("hard balls count the digits of pi, as in case T13") {
  const auto T13 = readCase("scenes", "T13");
  for (int power = 0; power < 4; ++power) {
    const scenes::Scene scene = scenes::breakScene("T13", power);
    std::vector<scenes::HardBall> balls;
    for (int i : {1, 2}) {
      const scenes::Body& body = scene.bodies[static_cast<std::size_t>(i)];
      balls.push_back(
          {{body.start.position.x(), 0, 0}, {body.start.velocity.x(), 0, 0}, 0.5L, body.mass});
    }
    const scenes::HardRoom wall{{0, -10, -10}, {1e9L, 10, 10}};
    CHECK(scenes::hardBalls(balls, wall, 1000) ==
          T13["counts"][static_cast<std::size_t>(power)].get<long>());
    if (power == 2) {
      CHECK_THAT(static_cast<Real>(balls[0].v[0]), WithinAbs(number(T13["small"]), 1e-15));
      CHECK_THAT(static_cast<Real>(balls[1].v[0]), WithinAbs(number(T13["big"]), 1e-15));
    }
  }
}

TEST_CASE("a small ball on a big one flies up as case S9 says, if it is small and near") {
  const auto S9 = readCase("scenes", "S9");
  for (const auto& row : S9["rows"]) {
    const long double ratio = number(row["ratio"]);
    std::vector<scenes::HardBall> balls{{{0, 0, 1 + 1e-6L}, {0, 0, 0}, 1e-6L, ratio},
                                        {{0, 0, 1 + 3e-6L + 1e-9L}, {0, 0, 0}, 1e-6L, 1}};
    constexpr long double kNone = 1e9L;
    const scenes::HardRoom floor{{-kNone, -kNone, 0}, {kNone, kNone, kNone}, 9.81L};
    // Until just after both impacts, then up to the top by its energy.
    scenes::hardBalls(balls, floor, std::sqrt(2 / 9.81L) + 1e-6L);
    const long double v = balls[1].v[2];
    const long double height = balls[1].x[2] + v * v / (2 * 9.81L);
    CHECK_THAT(static_cast<Real>(height), WithinAbs(number(row["rebound"]), 1e-4));
  }
}

TEST_CASE("touching balls of a cradle pass on what comes in") {
  for (int moving : {1, 2}) {
    const scenes::Scene scene = scenes::cradleScene("cradle", moving);
    const auto judge = scene.judge(scene);
    // Rigid answer: as many go out as came in, at the same speed; the others rest.
    std::vector<scenes::State> end = scenes::startOf(scene);
    const Real hit = 0.97 / 2;  // when
    for (int i = 0; i < 5; ++i) {
      scenes::State& ball = end[static_cast<std::size_t>(i)];
      ball.position.x() = i;
      ball.velocity = Vector3::Zero();
      if (i < 5 - moving) continue;
      ball.velocity.x() = 2;
      ball.position.x() = i + 2 * (scene.duration - hit);
    }
    if (moving == 2) end[0].position.x() = 0, end[1].position.x() = 1;
    judge->see(0, scenes::startOf(scene));
    judge->see(scene.duration, end);
    for (const scenes::Figure& figure : judge->figures()) {
      INFO(figure.name);
      CHECK_THAT(figure.value, WithinAbs(0, 1e-14));
    }
  }
}

TEST_CASE("the tumbling box of scene F is where small steps of Runge and Kutta bring it") {
  const scenes::Scene scene = scenes::rotorScene();
  const scenes::Body& box = scene.bodies[0];
  carom::RotorState state{box.start.orientation, box.start.angularVelocity};
  const carom::FreeRotor exact(box.moments, state);
  constexpr int kSteps = 100000;
  for (int i = 0; i < kSteps; ++i) state = carom::rk4Rotor(box.moments, state, 0, 10.0 / kSteps);
  const carom::RotorState closed = exact.at(10);
  const Real same = state.q_WB.w * closed.q_WB.w + state.q_WB.x * closed.q_WB.x +
                    state.q_WB.y * closed.q_WB.y + state.q_WB.z * closed.q_WB.z;
  CHECK_THAT(std::abs(same), WithinAbs(1, 1e-15));
  // Every passage of the middle axis multiplies what rounding has done by some thousands.
  CHECK((state.angularVelocity - closed.angularVelocity).norm() < 1e-7);
}

TEST_CASE("sliding, rolling and bouncing end where their energy says") {
  // A: the heights of the tops are powers of e^2.
  const carom::BounceLaw law{.restitution = 0.8, .gravity = 9.81};
  for (int n = 1; n <= 5; ++n) {
    const Real top =
        (carom::impactTime({5, 0}, law, n) + carom::impactTime({5, 0}, law, n + 1)) / 2;
    CHECK_THAT(carom::bounceBall({5, 0}, law, top).height, WithinRel(5 * std::pow(0.64, n), 1e-13));
  }
  // B: the work of friction is the kinetic energy.
  const Real way = carom::slideBlock({0, 5}, {.friction = 0.5, .gravity = 9.81}, 2).position;
  CHECK_THAT(0.5 * 9.81 * way, WithinRel(12.5, 1e-15));
  // C and I15: angular momentum about a line on the table is kept, so v + 2/5 R (w x n) is.
  const carom::TableBall start{{0, 0}, {2, 0}, {-30, 10, 0}};
  const carom::TableBall end = carom::rollBall(start, {.radius = 1, .friction = 0.2}, 5);
  const auto kept = [](const carom::TableBall& ball) {
    return carom::Vector2(ball.velocity.x() + 0.4 * ball.angularVelocity.y(),
                          ball.velocity.y() - 0.4 * ball.angularVelocity.x());
  };
  CHECK((kept(start) - kept(end)).norm() < 1e-13);
  CHECK(carom::slipOf(end, {.radius = 1, .friction = 0.2}).norm() < 1e-13);
}

TEST_CASE("the arches of case S6 are as thin as the case book says, and hinge at the same joint") {
  const auto S6 = readCase("scenes", "S6");
  for (const auto& row : S6["rows"]) {
    const scenes::ArchAnswer answer = scenes::archAnswer(row["stones"].get<int>());
    CHECK_THAT(answer.thickness, WithinRel(number(row["thickness"]), 1e-15));
    CHECK(answer.joint == row["joint"].get<int>());
  }
}

TEST_CASE("the card house of case S5 needs the friction of the case book") {
  CHECK_THAT(scenes::cardFriction(0.35),
             WithinRel(number(readCase("scenes", "S5")["critical_friction"]), 1e-15));
}

TEST_CASE("the pyramid of case S11 hands its weight down as the case book says") {
  const auto S11 = readCase("scenes", "S11");
  const auto forces = scenes::pyramidLoads(5);
  REQUIRE(forces.size() == S11["lowest"].size());
  Real sum = 0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    for (std::size_t half = 0; half < 2; ++half) {
      CHECK(forces[i][half] == number(S11["lowest"][i][half]));
      sum += forces[i][half];
    }
  }
  CHECK(sum == number(S11["ground"]));
}
