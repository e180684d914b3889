// Rows: sweeps against the exact solution, what is kept, and friction within its cone.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/impulse/linear_complementarity.hpp"
#include "carom/solver/active_rows.hpp"
#include "carom/solver/box_column.hpp"
#include "carom/solver/friction_pyramid_to_cone.hpp"
#include "carom/solver/lcp_small.hpp"
#include "carom/solver/sequential_impulses.hpp"
#include "carom/solver/warm_start.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom;
using carom_test::WithinAbs;
using carom_test::WithinRel;

// A bar of 1 m and 1 kg over the ground, with two feet 20 cm apart under its middle.
BoxColumn barOnFeet() {
  BoxColumn scene;
  scene.bodies.resize(2);
  scene.bodies[1].mass.inverseMass = 1;
  scene.bodies[1].mass.inverseInertia = 12 * Matrix3::Identity();
  for (const Real side : {-0.1, 0.1}) {
    ContactRow row;
    row.bodyB = 1;
    row.contact.armB = {side, 0, 0};
    row.name = side < 0 ? 1 : 2;
    scene.rows.push_back(row);
  }
  return scene;
}

// Bodies that touch at random, each row a point on two of them.
BoxColumn heap(Random& random, int bodies, int rows) {
  BoxColumn scene;
  scene.bodies.resize(static_cast<std::size_t>(bodies));
  const auto around = [&] {
    Vector3 v;
    for (int k = 0; k < 3; ++k) v[k] = random.between(-1, 1);
    return v;
  };
  for (int i = 1; i < bodies; ++i) {
    MovingBody& body = scene.bodies[static_cast<std::size_t>(i)];
    body.mass.inverseMass = random.between(0.2, 2);
    body.mass.inverseInertia = random.between(0.5, 4) * Matrix3::Identity();
    body.velocity.linear = around();
    body.velocity.angular = around();
  }
  for (int i = 0; i < rows; ++i) {
    ContactRow row;
    row.bodyB = 1 + i % (bodies - 1);
    row.bodyA = row.bodyB - 1;
    row.contact.normal = around().normalized();
    row.contact.armA = around();
    row.contact.armB = around();
    row.name = i;
    scene.rows.push_back(row);
  }
  return scene;
}

std::vector<Real> impulsesOf(const BoxColumn& scene) {
  std::vector<Real> all;
  for (const ContactRow& row : scene.rows) all.push_back(row.impulse);
  return all;
}

}  // namespace

TEST_CASE("a bar that lands on one foot and then on the other comes to rest") {
  // The first foot stops the bar alone; with the second one that is too much, and it takes back.
  BoxColumn bar = barOnFeet();
  bar.bodies[1].velocity.linear.z() = -1;
  sequentialImpulses(bar.bodies, bar.rows, 60);
  CHECK(bar.bodies[1].velocity.linear.norm() < 1e-12);
  CHECK(bar.bodies[1].velocity.angular.norm() < 1e-12);
  CHECK_THAT(bar.rows[0].impulse, WithinAbs(0.5, 1e-12));
  CHECK_THAT(bar.rows[1].impulse, WithinAbs(0.5, 1e-12));
}

TEST_CASE("sweeps over a column of N boxes contract by cos^2(pi / 2N)") {
  for (const int n : {2, 5, 10}) {
    BoxColumn column = boxColumn(std::vector<Real>(static_cast<std::size_t>(n), 1.0));
    pullDown(column.bodies, -1);
    const auto errorAfter = [&](int sweeps) {
      sequentialImpulses(column.bodies, column.rows, sweeps);
      return std::abs(column.rows[0].impulse - n);
    };
    const Real first = errorAfter(20 * n);
    const Real factor = errorAfter(1) / first;
    const Real c = std::cos(std::numbers::pi / (2 * n));
    CHECK_THAT(factor, WithinRel(c * c, 1e-6));
  }
}

TEST_CASE("ten cold sweeps leave the bottom of a stack of ten with a third of its load") {
  // Case S1: 3.5 of 10.
  BoxColumn column = boxColumn(std::vector<Real>(10, 1.0));
  pullDown(column.bodies, -1);
  sequentialImpulses(column.bodies, column.rows, 10);
  CHECK_THAT(column.rows[0].impulse, WithinAbs(3.5, 0.05));
}

TEST_CASE("a heavy box on a light one contracts by M / (M + m)") {
  for (const Real heavy : {10.0, 1000.0}) {
    BoxColumn column = boxColumn(std::vector<Real>{1, heavy});
    pullDown(column.bodies, -1);
    sequentialImpulses(column.bodies, column.rows, 5);
    const Real before = 1 + heavy - column.rows[0].impulse;
    sequentialImpulses(column.bodies, column.rows, 1);
    const Real after = 1 + heavy - column.rows[0].impulse;
    CHECK_THAT(after / before, WithinRel(heavy / (heavy + 1), 1e-9));
  }
}

TEST_CASE("begun with the answer, a sweep changes nothing") {
  BoxColumn column = boxColumn(std::vector<Real>{1, 2, 5});
  const std::vector<KeptImpulse> kept = {{1, 7}, {0, 8}, {2, 5}};
  pullDown(column.bodies, -1);
  warmStart(column.bodies, column.rows, kept, 1);
  sequentialImpulses(column.bodies, column.rows, 1);
  CHECK(impulsesOf(column) == std::vector<Real>{8, 7, 5});
  for (const MovingBody& body : column.bodies) CHECK(body.velocity.linear.norm() < 1e-15);
}

TEST_CASE("what begins has no past, and half a step has half the impulses") {
  BoxColumn column = boxColumn(std::vector<Real>{1, 1});
  column.rows[1].impulse = 99;
  warmStart(column.bodies, column.rows, std::vector<KeptImpulse>{{0, 3}, {5, 4}}, 0.5);
  CHECK(impulsesOf(column) == std::vector<Real>{1.5, 0});
  CHECK(column.bodies[1].velocity.linear.z() == 1.5);
  CHECK(column.bodies[2].velocity.linear.z() == 0);
}

TEST_CASE("the exact solution of a column is its weight from above") {
  BoxColumn column = boxColumn(std::vector<Real>{1, 1000, 1e6});
  pullDown(column.bodies, -9.81);
  const RowProblem problem = rowProblem(column.bodies, column.rows);
  const std::vector<Real> x = lcpSmall(problem.matrix, problem.speeds);
  CHECK_THAT(x[0], WithinRel(9.81 * 1'001'001, 1e-9));
  CHECK_THAT(x[1], WithinRel(9.81 * 1'001'000, 1e-9));
  CHECK_THAT(x[2], WithinRel(9.81e6, 1e-9));
}

TEST_CASE("trying everything and pivoting agree on heaps, and sweeps go there") {
  Random random(9);
  for (int n = 0; n < 40; ++n) {
    const int rows = 2 + n % 6;
    BoxColumn scene = heap(random, 4, rows);
    const RowProblem problem = rowProblem(scene.bodies, scene.rows);
    const std::vector<Real> exact = lcpSmall(problem.matrix, problem.speeds);
    DenseMatrix A(rows, rows);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < rows; ++j)
        A(i, j) = problem.matrix[static_cast<std::size_t>(i * rows + j)];
    }
    const Complementarity other = solveComplementarity(A, problem.speeds);
    REQUIRE(other.status == ComplementarityStatus::solved);
    sequentialImpulses(scene.bodies, scene.rows, 20'000);
    Real speeds = 0;
    for (const Real speed : problem.speeds) speeds = std::max(speeds, std::abs(speed));
    for (int i = 0; i < rows; ++i) {
      // Impulses need not be unique, the speeds after them are.
      Real exactly = problem.speeds[static_cast<std::size_t>(i)], pivoted = exactly;
      for (int j = 0; j < rows; ++j) {
        exactly += A(i, j) * exact[static_cast<std::size_t>(j)];
        pivoted += A(i, j) * other.z[static_cast<std::size_t>(j)];
      }
      CHECK_THAT(pivoted, WithinAbs(exactly, 1e-9 * speeds));
      const Real swept = partingSpeed(scene.rows[static_cast<std::size_t>(i)], scene.bodies);
      CHECK_THAT(swept, WithinAbs(exactly, 1e-6 * speeds));
    }
  }
}

TEST_CASE("redundant feet: some exact solution, and rest") {
  BoxColumn bar = barOnFeet();
  bar.rows.push_back(bar.rows[0]);
  bar.rows.push_back(bar.rows[1]);
  pullDown(bar.bodies, -1);
  const RowProblem problem = rowProblem(bar.bodies, bar.rows);
  const std::vector<Real> x = lcpSmall(problem.matrix, problem.speeds);
  CHECK_THAT(x[0] + x[2], WithinAbs(0.5, 1e-12));
  CHECK_THAT(x[1] + x[3], WithinAbs(0.5, 1e-12));
}

TEST_CASE("what cannot be solved is refused") {
  CHECK_THROWS_AS(lcpSmall(std::vector<Real>{0}, std::vector<Real>{-1}), InvalidInput);
  CHECK_THROWS_AS(lcpSmall(std::vector<Real>{1, 0}, std::vector<Real>{-1}), InvalidInput);
  CHECK_THROWS_AS(lcpSmall(std::vector<Real>(169, 1), std::vector<Real>(13, 1)), InvalidInput);
  BoxColumn column = boxColumn(std::vector<Real>{1});
  CHECK_THROWS_AS(sequentialImpulses(column.bodies, column.rows, -1), InvalidInput);
  CHECK_THROWS_AS(warmStart(column.bodies, column.rows, {}, -1), InvalidInput);
  CHECK_THROWS_AS(boxColumn(std::vector<Real>{1, 0}), InvalidInput);
  CHECK_THROWS_AS(frictionPyramidToCone({0, 0}, {1, 0}, -1, 1), InvalidInput);
  CHECK_THROWS_AS(frictionPyramidToCone({0, 0}, {1, 0}, 1, -1), InvalidInput);
}

TEST_CASE("friction is as strong in all directions, and against the slip") {
  for (int k = 0; k < 16; ++k) {
    const Real angle = k * std::numbers::pi / 8;
    const Vector2 slip(3 * std::cos(angle), 3 * std::sin(angle));
    const Vector2 friction = frictionPyramidToCone(Vector2::Zero(), slip, 2, 0.5);
    CHECK((friction + slip / 6).norm() < 1e-15);
  }
}

TEST_CASE("friction that is enough stops the slip, and gives back what was too much") {
  CHECK(frictionPyramidToCone({0.1, 0}, {0.2, -0.1}, 0.5, 1) == Vector2(0, 0.05));
  CHECK(frictionPyramidToCone({0, 0}, {0.2, -0.1}, 0.5, 0) == Vector2(0, 0));
}
