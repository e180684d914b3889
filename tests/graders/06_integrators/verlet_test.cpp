// Grader of 06.verlet: parabolas, which the method follows exactly; springs, whose positions are
// cosines of an angle of its own; the way back; and forces that change with time.

#include "carom/motion/verlet.hpp"

#include "graders/06_integrators/motions.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

TwoPositions after(TwoPositions positions, Real time, Real dt, int steps,
                   const Acceleration& force) {
  for (int i = 0; i < steps; ++i) positions = verlet(positions, time + i * dt, dt, force);
  return positions;
}

TwoPositions swapped(const TwoPositions& positions) {
  return {positions.current, positions.previous};
}

struct Parabola {
  Coordinates start, velocity, acceleration;
  Coordinates at(Real t) const {
    return start + t * velocity + t * t / 2 * acceleration;
  }
};

// On a spring with a = -omega^2 x the positions are cosines of i theta, where
// cos theta = 1 - (omega dt)^2 / 2.
Coordinates cosines(const Coordinates& size, const Coordinates& phase, Real omegaDt, int i) {
  const Real theta = 2 * std::asin(omegaDt / 2);
  return size.cwiseProduct(Coordinates((i * theta + phase.array()).cos()));
}

}  // namespace

TEST_CASE("thrown") {
  const TwoPositions rest = {column({-0.04905}), column({0})};
  GRADE(verlet(rest, 0, 0.1, falling(column({-9.81}))),
        TwoPositions({column({0}), column({-0.04905})}), within(1e-15, kRounding),
        given("positions", rest, "m"), given("dt", 0.1, "s"), unit("m"),
        about("a stone at the top of its flight, which falls with 9.81 m/s^2"));
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    const Vector3 velocity = random.vector(5);
    const Parabola flight = {column({1, 2, 3}), column({velocity.x(), velocity.y(), velocity.z()}),
                             column({0, 0, -9.81})};
    const Real dt = random.between(0.05, 0.3);
    const TwoPositions now = {flight.at(-dt), flight.at(0)};
    GRADE(verlet(now, 0, dt, falling(flight.acceleration)),
          TwoPositions({flight.at(0), flight.at(dt)}), within(1e-13, kRounding),
          given("positions", now, "m"), given("dt", dt, "s"), unit("m"),
          about("a stone that is thrown: three moments of one parabola"));
  }
}

TEST_CASE("spring") {
  const TwoPositions now = {column({0.995}), column({1})};
  GRADE(verlet(now, 0, 0.1, springs(1, 1)), TwoPositions({column({1}), column({0.995})}),
        within(1e-15, kRounding), given("positions", now, "m"), given("dt", 0.1, "s"), unit("m"),
        about("a spring with a = -x at its turning point"));
  Random random(seed() + 1);
  for (int n = 0; n < 4; ++n) {
    const Coordinates size = column({random.between(0.5, 2), random.between(0.5, 2)});
    const Coordinates phase = column({random.between(0, 6), random.between(0, 6)});
    const Real omega = random.between(1, 4), dt = random.between(0.05, 0.3);
    const int steps = random.integer(50, 200);
    const TwoPositions start = {cosines(size, phase, omega * dt, 0),
                                cosines(size, phase, omega * dt, 1)};
    GRADE(after(start, 0, dt, steps, springs(2, omega)),
          TwoPositions({cosines(size, phase, omega * dt, steps),
                        cosines(size, phase, omega * dt, steps + 1)}),
          within(1e-9, "the roundings of the steps"), given("positions", start, "m"),
          given("dt", dt, "s"), given("omega", omega, "rad/s"), given("steps", steps), unit("m"),
          about("two springs with a = -omega^2 x, after many steps"));
  }
}

TEST_CASE("back") {
  Random random(seed() + 2);
  for (int n = 0; n < 6; ++n) {
    const MadeUp motion(random, 2, false);
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.3);
    const TwoPositions now = {motion.position(t), motion.position(t + dt)};
    // The force is taken from one moment: a field of springs about a fixed place.
    const Coordinates middle = motion.position(t + 1);
    const Acceleration field =
        forceOn(2, [middle](Real, const Coordinates& x, const Coordinates&) -> Coordinates {
          return -2 * (x - middle);
        });
    // Out of the middle of three: both ways must agree with 2 x - (the sum of its neighbours).
    const Coordinates next = (2 - 2 * dt * dt) * now.current - now.previous + 2 * dt * dt * middle;
    GRADE(verlet({next, now.current}, 0, dt, field), TwoPositions({now.current, now.previous}),
          within(1e-13, kRounding), given("positions", TwoPositions({next, now.current}), "m"),
          given("dt", dt, "s"), given("springs about", middle, "m"), unit("m"),
          about("springs with a = -2 (x - middle): the last step of a motion, run backwards"));
    GRADE(swapped(after(swapped(after(now, 0, dt, 20, field)), 0, dt, 20, field)), now,
          within(1e-10, "the roundings of the steps"), given("positions", now, "m"),
          given("dt", dt, "s"), unit("m"),
          about("twenty steps forth, the positions swapped, twenty back, and swapped again"));
  }
}

TEST_CASE("any") {
  Random random(seed() + 3);
  for (int n = 0; n < 12; ++n) {
    const MadeUp motion(random, random.integer(1, 3), false);
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    const TwoPositions now = {motion.position(t - dt), motion.position(t)};
    const Coordinates bend = dt * dt * motion.acceleration(t);
    GRADE(verlet(now, t, dt, motion.force()),
          TwoPositions({now.current, bend - now.previous + 2 * now.current}),
          within(1e-13, kRounding), given("positions", now, "m"), given("time", t, "s"),
          given("dt", dt, "s"), given("acceleration now", motion.acceleration(t), "m/s^2"),
          unit("m"), about("a force that depends on time and place"));
  }
}

TEST_CASE("refuses") {
  const TwoPositions now = {column({1}), column({2})};
  GRADE_REFUSES(verlet(now, 0, 0, springs(1, 1)), given("dt", 0.0, "s"));
}

PROBES() {
  Random random(603);
  for (int n = 0; n < 16; ++n) {
    const MadeUp motion(random, random.integer(1, 2), false);
    const Real t = random.between(0, 5), dt = random.between(0.05, 0.5);
    PROBE(verlet({motion.position(t - dt), motion.position(t)}, t, dt, motion.force()));
  }
}
