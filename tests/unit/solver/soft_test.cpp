// Soft rows and sub-steps against springs and free fall.

#include <cmath>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/soft_sweep.hpp"
#include "carom/solver/substep.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom;
using carom_test::WithinAbs;
using carom_test::WithinRel;

constexpr Real kTwoPi = 2 * std::numbers::pi;

}  // namespace

TEST_CASE("a soft row moves one body as an implicit spring and damper does") {
  const Real f = 20, zeta = 0.7, h = 1.0 / 120, w = kTwoPi * f;
  const SoftContact soft = softContact(f, zeta, h);
  BoxColumn column = boxColumn(std::vector<Real>{3});
  Real x = -0.004, u = -0.3;
  for (int n = 0; n < 2; ++n) {  // then it would pull, and is let go
    column.rows[0].separation = x;
    column.rows[0].impulse = 0;
    column.bodies[1].velocity.linear.z() = u;
    softSweep(column.bodies, column.rows, soft, h);
    const Real expected = (u - h * w * w * x) / (1 + 2 * zeta * w * h + h * h * w * w);
    CHECK_THAT(column.bodies[1].velocity.linear.z(), WithinAbs(expected, 1e-14));
    u = expected;
    x += h * u;
  }
}

TEST_CASE("shares of a soft contact add up to one, and stiffness is frequency squared") {
  const SoftContact soft = softContact(30, 1, 1e-6);
  CHECK_THAT(soft.massScale + soft.impulseScale, WithinAbs(1, 1e-15));
  // For short steps the row is an explicit spring: massScale biasRate / h = w^2.
  CHECK_THAT(soft.massScale * soft.biasRate / 1e-6, WithinRel(kTwoPi * 30 * kTwoPi * 30, 1e-3));
}

TEST_CASE("a gap may be closed, and not more") {
  const Real h = 0.01;
  BoxColumn column = boxColumn(std::vector<Real>{1});
  column.rows[0].separation = 0.02;
  pullDown(column.bodies, -5);
  softSweep(column.bodies, column.rows, softContact(30, 1, h), h);
  CHECK_THAT(column.bodies[1].velocity.linear.z(), WithinAbs(-2, 1e-14));
}

TEST_CASE("free fall in n parts goes (n + 1) / 2n of g dt^2") {
  for (const int count : {1, 4, 8}) {
    BoxColumn column = boxColumn(std::vector<Real>{2});
    column.rows[0].separation = 100;
    std::vector<Velocity> moved(2);
    substep(column.bodies, column.rows, moved, {.dt = 0.1, .count = count});
    CHECK_THAT(moved[1].linear.z(), WithinAbs(-9.81 * 0.01 * (count + 1) / (2 * count), 1e-14));
    CHECK_THAT(column.bodies[1].velocity.linear.z(), WithinAbs(-0.981, 1e-14));
    CHECK(moved[0].linear.norm() == 0);
    CHECK_THAT(column.rows[0].separation, WithinAbs(100 + moved[1].linear.z(), 1e-12));
  }
}

TEST_CASE("a soft tower of N boxes sinks by N^2 g / w^2") {
  // Each row carries what is above it; between two boxes the effective mass is half of one.
  const int n = 6, count = 8;
  const Real dt = 1.0 / 60, f = 30, w = kTwoPi * f;
  BoxColumn column = boxColumn(std::vector<Real>(n, 1.0));
  const SubstepPlan plan{.dt = dt, .count = count, .soft = softContact(f, 1, dt / count)};
  std::vector<Velocity> moved(n + 1);
  for (int k = 0; k < 1200; ++k) substep(column.bodies, column.rows, moved, plan);
  CHECK_THAT(-moved[n].linear.z(), WithinRel(n * n * 9.81 / (w * w), 1e-6));
}

TEST_CASE("nonsense is refused") {
  CHECK_THROWS_AS(softContact(0, 1, 1), InvalidInput);
  CHECK_THROWS_AS(softContact(1, -1, 1), InvalidInput);
  CHECK_THROWS_AS(softContact(1, 1, 0), InvalidInput);
  BoxColumn column = boxColumn(std::vector<Real>{1});
  std::vector<Velocity> moved(2);
  CHECK_THROWS_AS(substep(column.bodies, column.rows, moved, {.dt = 0}), InvalidInput);
  CHECK_THROWS_AS(substep(column.bodies, column.rows, moved, {.count = 0}), InvalidInput);
  moved.pop_back();
  CHECK_THROWS_AS(substep(column.bodies, column.rows, moved, {}), InvalidInput);
}
