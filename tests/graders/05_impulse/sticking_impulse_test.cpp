// Grader of 05.sticking_impulse: the corner of a square in fractions, and any contacts, whose
// velocity after the impulse must be what was wanted.

#include "sticking_impulse.hpp"

#include <cmath>

#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of numbers of this size";

struct Corner {
  Matrix2 K = Matrix2::Identity();
  Vector2 velocity = Vector2::Zero();
  Real e = 0;
};

// The corner of a body at the end of an arm: along the floor it gives way by turning with the arm's
// height, out of the floor with its width.
Corner cornerOf(Real mass, Real inertia, const Vector2& arm, const Vector2& velocity, Real e) {
  Corner corner;
  corner.K << 1 / mass + arm.y() * arm.y() / inertia, -arm.x() * arm.y() / inertia,
      -arm.x() * arm.y() / inertia, 1 / mass + arm.x() * arm.x() / inertia;
  corner.velocity = velocity;
  corner.e = e;
  return corner;
}

Corner anyCorner(Random& random) {
  const Real mass = random.between(0.5, 3), inertia = random.between(0.2, 2);
  const Real x = random.between(0.3, 1) * (random.integer(0, 1) == 0 ? 1 : -1);
  const Real y = random.between(-1.2, -0.3);
  const Real slip = random.between(0.5, 3) * (random.integer(0, 1) == 0 ? 1 : -1);
  const Real approach = random.between(0.5, 4);
  return cornerOf(mass, inertia, {x, y}, {slip, -approach}, random.between(0.1, 1));
}

Vector2 velocityAfter(const Corner& c) {
  return c.velocity + c.K * stickingImpulse(c.K, c.velocity, c.e);
}

}  // namespace

TEST_CASE("corner") {
  // A square of 1 kg and 2 m, its corner at (-4/5, -11/10).
  Matrix2 K;
  K << 2.815, -1.32, -1.32, 1.96;
  const Vector2 velocity(3.2, -4.6);
  GRADE(stickingImpulse(K, velocity, 0.5), Vector2(2836.0 / 3775, 30399.0 / 7550),
        within(2e-14, kRounding), given("K", K, "1/kg"), given("velocity", velocity, "m/s"),
        given("restitution", 0.5), unit("N s"), about("a square of 1 kg falls on its corner"));
}

TEST_CASE("wishes") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Corner c = anyCorner(random);
    GRADE(velocityAfter(c), Vector2(0, -c.e * c.velocity.y()), within(1e-13, kRounding),
          given("K", c.K, "1/kg"), given("velocity", c.velocity, "m/s"), given("restitution", c.e),
          unit("m/s"), about("the velocity of the corner after the impulse: slip and parting"));
  }
}

TEST_CASE("straight") {
  const Vector2 velocity(1, -3);
  const Matrix2 K = cornerOf(2, 0.5, {0, -1}, velocity, 0.5).K;
  GRADE(stickingImpulse(K, velocity, 0.5), Vector2(-0.4, 9), within(1e-14, kRounding),
        given("K", K, "1/kg"), given("velocity", velocity, "m/s"), given("restitution", 0.5),
        unit("N s"), about("the corner is straight below the centre of mass"));
}

TEST_CASE("refuses") {
  Matrix2 flat;
  flat << 1, 1, 1, 1;
  GRADE_REFUSES(stickingImpulse(flat, {1, -1}, 0.5), given("K", flat, "1/kg"));
  GRADE_REFUSES(stickingImpulse(Matrix2::Identity(), {1, -1}, 1.6), given("restitution", 1.6));
}

PROBES() {
  Random random(514);
  for (int n = 0; n < 16; ++n) {
    const Corner c = anyCorner(random);
    PROBE(stickingImpulse(c.K, c.velocity, c.e));
  }
}
