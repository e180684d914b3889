// Grader of 05.drag_force: forces that can be worked out by hand, and any air, with the direction
// and the speed through it chosen first.

#include "carom/impulse/drag_force.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

AirDrag airOf(const Vector3& wind, Real density, Real coefficient, Real area) {
  return {wind, density, coefficient, area};
}

void ask(const Vector3& velocity, const AirDrag& air, const Vector3& expected, const char* what) {
  GRADE(dragForce(velocity, air), expected, withinRelative(1e-14, kRounding),
        given("velocity", velocity, "m/s"), given("air.wind", air.wind, "m/s"),
        given("air.density", air.density, "kg/m^3"), given("air.coefficient", air.coefficient),
        given("air.area", air.area, "m^2"), unit("N"), about(what));
}

struct Flight {
  Vector3 velocity = Vector3::Zero(), direction = Vector3::UnitX();
  Real speed = 0;  // through the air, along the direction
  AirDrag air;
};

Flight anyFlight(Random& random) {
  Flight flight;
  flight.direction = random.direction();
  flight.speed = random.between(0.5, 30);
  const Vector3 wind = random.vector(10);
  const Real density = random.between(0.5, 1.5), coefficient = random.between(0.1, 1.3);
  flight.air = airOf(wind, density, coefficient, random.between(0.01, 2));
  flight.velocity = wind + flight.speed * flight.direction;
  return flight;
}

}  // namespace

TEST_CASE("still") {
  const AirDrag air = airOf({0, 0, 0}, 1.25, 0.5, 0.2);
  ask({0, 0, -4}, air, {0, 0, 1}, "a ball that falls at 4 m/s");
  ask({0, 0, 4}, air, {0, 0, -1}, "the same ball flies upwards");
  ask({0, 8, 0}, air, {0, -4, 0}, "twice as fast, along y");
  ask({3, 0, -4}, air, {-0.9375, 0, 1.25}, "askew, at 5 m/s");
}

TEST_CASE("wind") {
  ask({10, 0, 0}, airOf({-10, 0, 0}, 1.25, 0.8, 0.5), {-100, 0, 0},
      "a cyclist at 10 m/s with a wind of 10 m/s from ahead");
  ask({0, 0, 0}, airOf({0, 4, 0}, 1.25, 1, 2), {0, 20, 0}, "a hoarding that stands in the wind");
  ask({3, 0, 0}, airOf({0, 4, 0}, 1.25, 1, 2), {-18.75, 25, 0}, "a wind from the side");
  ask({5, 0, 0}, airOf({5, 0, 0}, 1.25, 1, 2), {0, 0, 0}, "a leaf that floats along with the wind");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 25; ++n) {
    const Flight flight = anyFlight(random);
    const AirDrag& air = flight.air;
    // How much air it meets per second, and how fast.
    const Real perSecond = air.density * air.area * flight.speed;
    const Real size = perSecond * flight.speed * air.coefficient / 2;
    GRADE(dragForce(flight.velocity, air), -size * flight.direction,
          withinRelative(1e-12, "the wind is taken off the velocity again, which costs digits"),
          given("velocity", flight.velocity, "m/s"), given("air.wind", air.wind, "m/s"),
          given("air.density", air.density, "kg/m^3"), given("air.coefficient", air.coefficient),
          given("air.area", air.area, "m^2"), unit("N"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(dragForce({1, 0, 0}, airOf({0, 0, 0}, -1, 0.5, 1)), given("air.density", -1.0));
}

PROBES() {
  Random random(508);
  for (int n = 0; n < 16; ++n) {
    const Flight flight = anyFlight(random);
    PROBE(dragForce(flight.velocity, flight.air));
  }
}
