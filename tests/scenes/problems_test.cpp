// Is the error of every problem that of the motion? For bodies that move as they should it is
// nothing but rounding, whatever the step; for bodies that are off by a known amount it is that.

#include "scenes/problems.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "carom/core/cross.hpp"
#include "carom/impulse/bouncing_ball.hpp"
#include "carom/impulse/roll_ball.hpp"
#include "carom/impulse/slide_block.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "scenes/exact.hpp"
#include "scenes/law.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using carom::Real;
using carom::Vector3;
using carom_test::WithinAbs;
using carom_test::WithinRel;
using namespace carom::scenes;

namespace {

Problem problemNamed(const std::string& name) {
  for (const Problem& problem : allProblems()) {
    if (problem.name == name) return problem;
  }
  throw std::runtime_error("no problem " + name);
}

// The error that a problem's first question finds in a law. \param steps between two looks
Real errorOf(const Problem& problem, int steps, const Law::Motion& motion) {
  const Scene scene = problem.make();
  const auto figures = runLaw(scene, scene.lookEvery / steps, motion);
  return std::abs(figures.at(problem.questions.front().figure));
}

// A body that should move as `exact` says, and is `off` from there after the start.
Law::Motion aside(const Law::Motion& exact, const Vector3& off) {
  return [exact, off](int body, Real time) {
    State state = exact(body, time);
    if (body > 0 && time > 0) state.position += off;
    return state;
  };
}

State startOfBody(const Scene& scene, int body) {
  return scene.bodies[static_cast<std::size_t>(body)].start;
}

Law::Motion bouncing() {
  return [](int body, Real time) {
    State state;
    if (body == 0) return state;
    const auto ball = carom::bounceBall({5, 0}, {.restitution = 0.8, .gravity = 9.81}, time);
    state.position = {0, 0, 0.5 + ball.height};
    return state;
  };
}

Law::Motion sliding(Real speed, Real angle) {
  return [speed, angle](int body, Real time) {
    State state;
    if (body == 0) return state;
    const carom::Slope slope{.angle = angle, .friction = 0.5, .gravity = 9.81};
    state.position = {carom::slideBlock({0, speed}, slope, time).position, 0, 0.5};
    return state;
  };
}

Law::Motion rolling(const Scene& scene, const carom::TableLaw& law) {
  return [scene, law](int body, Real time) {
    State state = startOfBody(scene, body);
    if (body == 0) return state;
    const carom::TableBall start{state.position.head<2>(), state.velocity.head<2>(),
                                 state.angularVelocity};
    const carom::TableBall ball = carom::rollBall(start, law, time);
    state.position.head<2>() = ball.position;
    state.velocity.head<2>() = ball.velocity;
    state.angularVelocity = ball.angularVelocity;
    return state;
  };
}

Law::Motion still(const Scene& scene) {
  return [scene](int body, Real) { return startOfBody(scene, body); };
}

}  // namespace

TEST_CASE("every problem has a name of its own, questions, and moments within its scene") {
  std::set<std::string> names;
  for (const Problem& problem : allProblems()) {
    INFO(problem.name);
    CHECK(names.insert(problem.name).second);
    const Scene scene = problem.make();
    CHECK(problem.name.starts_with(scene.name));
    REQUIRE(scene.lookEvery > 0);
    const Real looks = scene.duration / scene.lookEvery;
    CHECK_THAT(looks, WithinAbs(std::round(looks), 1e-9));
    CHECK(looks >= 1);
    REQUIRE_FALSE(problem.questions.empty());
    // The judge answers every question, and the condition, even if nothing moves.
    const auto judge = scene.judge(scene);
    for (int look = 0; look <= std::lround(looks); ++look) {
      judge->see(look * scene.lookEvery, startOf(scene));
    }
    const auto figures = figuresOf(*judge);
    for (const Question& question : problem.questions) {
      CHECK(figures.contains(question.figure));
      CHECK(question.rounding > 0);
    }
    CHECK((problem.condition.empty() || figures.contains(problem.condition)));
  }
}

TEST_CASE("one body that moves as it should has no error, and one a millimetre aside has one") {
  const Vector3 up(0, 0, 1e-3), ahead(1e-3, 0, 0);
  const Scene roll = problemNamed("C_roll").make(), masse = problemNamed("I15_masse").make();
  struct Known {
    const char* problem;
    Law::Motion exact;
    Vector3 off;
  };
  const std::vector<Known> all{
      {"A_bounce", bouncing(), up},
      {"A_bounce_film", bouncing(), up},
      {"B_slide", sliding(5, 0), ahead},
      {"C_roll", rolling(roll, {.radius = 0.5, .friction = 0.3, .gravity = 9.81}), ahead},
      {"I8_below", sliding(0, std::atan(0.5) - 1e-6), ahead},
      {"I8_at", sliding(0, std::atan(0.5)), ahead},
      {"I8_above", sliding(0, std::atan(0.5) + 1e-6), ahead},
      {"I8_steep", sliding(0, std::atan(0.5) + 1e-2), ahead},
      {"I15_masse", rolling(masse, {.radius = 1, .friction = 0.2}), ahead}};
  for (const Known& known : all) {
    const Problem problem = problemNamed(known.problem);
    INFO(known.problem);
    for (const int steps : {1, 4, 64}) {
      CHECK(errorOf(problem, steps, known.exact) <= problem.questions.front().rounding);
      // The rms has the start in it, which is right.
      CHECK_THAT(errorOf(problem, steps, aside(known.exact, known.off)), WithinRel(1e-3, 0.05));
    }
  }
}

TEST_CASE(
    "a stack that stands still is right, and one that leans a millimetre has drifted so far") {
  for (const char* name : {"G_stack10", "G_stack40", "I_1000on1", "I_alternating"}) {
    const Problem problem = problemNamed(name);
    const Scene scene = problem.make();
    INFO(name);
    CHECK(errorOf(problem, 1, still(scene)) == 0);
    CHECK_THAT(errorOf(problem, 2, aside(still(scene), {0, 1e-3, 0})), WithinRel(1e-3, 1e-9));
    CHECK(runLaw(scene, 1, still(scene)).at(problem.condition) == 1);
    const auto fallen = aside(still(scene), {1, 0, 0});
    CHECK(runLaw(scene, 1, fallen).at(problem.condition) == 0);
  }
}

TEST_CASE("balls from impact to impact have no error, and one a micrometre aside has one") {
  for (const char* name : {"I13_oblique", "I5_cradle1", "I5_cradle2", "T13_break31", "T13_break314",
                           "S9_ratio3", "S9_ratio1000", "S8_gas"}) {
    const Problem problem = problemNamed(name);
    const Scene scene = problem.make();
    std::vector<HardBall> balls;
    std::vector<int> ballOf(scene.bodies.size(), -1);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      if (!body.moves) continue;
      ballOf[i] = static_cast<int>(balls.size());
      HardBall ball{{}, {}, std::get<carom::Ball>(body.shape).radius, body.mass};
      for (std::size_t k = 0; k < 3; ++k) {
        ball.x[k] = body.start.position[static_cast<int>(k)];
        ball.v[k] = body.start.velocity[static_cast<int>(k)];
      }
      balls.push_back(ball);
    }
    constexpr long double kFar = 1e9L;  // no wall that anything gets to
    HardRoom room{{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}};
    if (scene.name == "S8_gas") room = {{0, 0, 0}, {1, 1, 1}};
    if (scene.name.starts_with("T13")) room.low[0] = 0;
    if (scene.name.starts_with("S9")) {
      room.low[2] = 0, room.high[2] = std::numeric_limits<long double>::infinity();
      room.gravity = 9.81L;
    }
    const Law::Motion exact = [&](int body, Real time) {
      State state = startOfBody(scene, body);
      const int number = ballOf[static_cast<std::size_t>(body)];
      if (number < 0) return state;
      std::vector<HardBall> now = balls;
      hardBalls(now, room, time);
      const HardBall& ball = now[static_cast<std::size_t>(number)];
      for (std::size_t k = 0; k < 3; ++k) {
        state.position[static_cast<int>(k)] = static_cast<Real>(ball.x[k]);
        state.velocity[static_cast<int>(k)] = static_cast<Real>(ball.v[k]);
      }
      return state;
    };
    INFO(name);
    CHECK(errorOf(problem, 1, exact) <= problem.questions.front().rounding);
    CHECK_THAT(errorOf(problem, 1, aside(exact, {0, 1e-6, 0})), WithinRel(1e-6, 1e-4));
  }
}

TEST_CASE("the oblique hit of the case book: the balls part at a right angle") {
  const Scene scene = problemNamed("I13_oblique").make();
  std::vector<HardBall> balls{{{0, 0, 0}, {0, 0, 0}, 1, 1}, {{-4.3L, 1.4L, 0}, {5, 0, 0}, 1, 1}};
  CHECK(static_cast<Real>(balls[1].x[1]) == scene.bodies[1].start.position.y());
  constexpr long double kFar = 1e9L;
  CHECK(hardBalls(balls, {{-kFar, -kFar, -kFar}, {kFar, kFar, kFar}}, scene.duration) == 1);
  // The target leaves with cos of the angle of the hit, the other with its sine, which is 0.7.
  const auto speed = [](const HardBall& b) { return std::hypot(b.v[0], b.v[1]) / 5; };
  CHECK_THAT(static_cast<Real>(speed(balls[0])), WithinAbs(std::sqrt(1 - 0.49), 1e-15));
  CHECK_THAT(static_cast<Real>(speed(balls[1])), WithinAbs(0.7, 1e-15));
}

TEST_CASE("the rotor that turns as its closed form says is right; turned on by 1e-4 it is not") {
  const Problem problem = problemNamed("F_rotor");
  const Scene scene = problem.make();
  const State start = scene.bodies[0].start;
  const carom::FreeRotor rotor(scene.bodies[0].moments, {start.orientation, start.angularVelocity});
  const auto turned = [&](Real angle) {
    return [&, angle](int, Real time) {
      State state = start;
      const auto now = rotor.at(time);
      const auto more = carom::axisAngleToQuaternion(Vector3::UnitX(), angle);
      state.orientation = carom::hamiltonProduct(now.q_WB, more);
      return state;
    };
  };
  CHECK(errorOf(problem, 1, turned(0)) <= problem.questions.front().rounding);
  CHECK_THAT(errorOf(problem, 8, turned(1e-4)), WithinRel(1e-4, 1e-6));
}

TEST_CASE("a gas that keeps its speeds keeps its energy; a thousandth faster it is seen") {
  for (const char* name : {"E_elastic666", "E2_free666"}) {
    const Problem problem = problemNamed(name);
    const Scene scene = problem.make();
    const auto faster = [&](Real factor) {
      return [&, factor](int body, Real time) {
        State state = startOfBody(scene, body);
        if (time > 0) state.velocity *= factor;
        return state;
      };
    };
    INFO(name);
    CHECK(errorOf(problem, 1, faster(1)) == 0);
    // Twice a thousandth, of all looks but the first.
    const Real looks = std::round(scene.duration / scene.lookEvery);
    const Real expected = 2.001e-3 * std::sqrt(looks / (looks + 1));
    CHECK_THAT(errorOf(problem, 1, faster(1.001)), WithinRel(expected, 1e-9));
  }
}

TEST_CASE("the top precesses at the rate of the case book, with its tip at rest") {
  const Problem problem = problemNamed("N10_top");
  const Scene scene = problem.make();
  const State start = scene.bodies[1].start;
  const Real rate = carom_test::number(carom_test::readCase("motion", "N10")["slow"]);
  const Vector3 axis = start.position / 0.5;
  CHECK_THAT(std::acos(axis.z()), WithinAbs(std::acos(-1.0) / 6, 1e-15));
  CHECK_THAT(start.angularVelocity.dot(axis), WithinAbs(60, 1e-13));
  CHECK_THAT((start.angularVelocity - start.angularVelocity.dot(axis) * axis).norm(),
             WithinAbs(rate * axis.head<2>().norm(), 1e-14));
  CHECK((start.velocity - carom::cross(start.angularVelocity, start.position)).norm() == 0);
  const auto precessing = [&](Real slow) {
    return [&, slow](int body, Real time) {
      State state = startOfBody(scene, body);
      if (body == 0) return state;
      const auto turn = carom::axisAngleToQuaternion(Vector3::UnitZ(), slow * time);
      state.orientation = carom::hamiltonProduct(turn, state.orientation);
      return state;
    };
  };
  CHECK(errorOf(problem, 1, precessing(rate)) < 1e-14);
  // A thousandth faster, after 2 s, at the axis' distance from the vertical.
  CHECK_THAT(errorOf(problem, 1, precessing(1.001 * rate)), WithinRel(2e-3 * rate * 0.5, 1e-5));
}
