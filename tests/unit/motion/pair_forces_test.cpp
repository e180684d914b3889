// The forces between particles.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/motion/pair_forces.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

std::vector<Vector3> crowd(Random& random, int count, Real size) {
  std::vector<Vector3> positions;
  for (int i = 0; i < count; ++i) {
    positions.push_back(size *
                        Vector3(random.between(0, 1), random.between(0, 1), random.between(0, 1)));
  }
  return positions;
}
}  // namespace

TEST_CASE("two atoms rest at the sixth root of two, push when nearer, pull when further") {
  const LennardJones atoms = {2, 3, 2.5};
  const Real rest = 3 * std::pow(2.0, 1.0 / 6);
  CHECK(std::abs(pairForce(atoms, rest * rest).factor) < 1e-15);
  CHECK(pairForce(atoms, 9).factor > 0);
  CHECK(pairForce(atoms, 16).factor < 0);
  // At the distance of no potential the force is 24 e/s, and the energy is the lift alone.
  CHECK(std::abs(pairForce(atoms, 9).factor * 3 - 24 * 2 / 3.0) < 1e-14);
  const Real cut6 = std::pow(2.5, -6.0);
  CHECK(std::abs(pairForce(atoms, 9).energy - 8 * (cut6 - cut6 * cut6)) < 1e-15);
}

TEST_CASE(
    "at the cut-off the energy comes to zero without a jump, and beyond it there is nothing") {
  const LennardJones atoms;
  CHECK(std::abs(pairForce(atoms, 6.25 * (1 - 1e-14)).energy) < 1e-15);
  CHECK(pairForce(atoms, 6.25).energy == 0);
  CHECK(pairForce(atoms, 6.25).factor == 0);
  CHECK(std::abs(pairForce(atoms, 6.25 * (1 - 1e-14)).factor * 2.5 + 0.039) < 1e-3);
}

TEST_CASE("forces are minus the slope of the energy, for every particle and axis") {
  Random random(3);
  const LennardJones atoms;
  std::vector<Vector3> positions;
  for (int i = 0; i < 27; ++i) {  // a lattice, shaken, so that no two are too near
    positions.push_back(
        1.3 * Vector3(i % 3, i / 3 % 3, i / 9) +
        0.1 * Vector3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
  }
  for (const Vector3& box : {Vector3(0, 0, 0), Vector3(5.2, 5.2, 5.2), Vector3(5.2, 0, 0)}) {
    const CrowdForces here = pairForces(positions, atoms, box);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        constexpr Real h = 1e-5;
        std::vector<Vector3> moved = positions;
        moved[i][axis] += h;
        const Real up = pairForces(moved, atoms, box).energy;
        moved[i][axis] -= 2 * h;
        const Real down = pairForces(moved, atoms, box).energy;
        // A pair that crosses the cut-off within 2 h changes the slope by 0.039 at most.
        REQUIRE(std::abs(here.forces[i][axis] + (up - down) / (2 * h)) < 1e-4);
      }
    }
  }
}

TEST_CASE("all forces together are none, and a box shifted by its own length is the same box") {
  Random random(4);
  const LennardJones atoms = {1, 0.1, 2.5};
  const Vector3 box(1, 2, 3);
  std::vector<Vector3> positions = crowd(random, 60, 1);
  const CrowdForces here = pairForces(positions, atoms, box);
  Vector3 sum = Vector3::Zero();
  Real largest = 0;
  for (const Vector3& f : here.forces) {
    sum += f;
    largest = std::max(largest, f.norm());
  }
  REQUIRE(largest > 0);
  CHECK(sum.norm() < 1e-13 * largest);

  positions[7] += Vector3(1, -4, 3);
  const CrowdForces there = pairForces(positions, atoms, box);
  CHECK(std::abs(there.energy / here.energy - 1) < 1e-9);
  CHECK((there.forces[7] - here.forces[7]).norm() < 1e-9 * largest);
}

TEST_CASE("across the edge of the box particles are neighbours") {
  const std::vector<Vector3> positions = {{0.1, 0, 0}, {9.9, 0, 0}};
  const LennardJones atoms = {1, 0.3, 2.5};
  CHECK(pairForces(positions, atoms).energy == 0);
  const CrowdForces boxed = pairForces(positions, atoms, {10, 0, 0});
  CHECK(boxed.forces[0].x() > 0);  // pushed away from the edge
  CHECK(boxed.forces[1].x() < 0);
}

TEST_CASE("crowds that cannot be are refused") {
  const LennardJones atoms;
  const std::vector<Vector3> two = {{0, 0, 0}, {1, 0, 0}};
  CHECK_THROWS_WITH(pairForces(std::vector<Vector3>{{1, 2, 3}, {1, 2, 3}}, atoms),
                    carom_test::ContainsSubstring("must be taken only once"));
  CHECK_THROWS_AS(pairForces(std::vector<Vector3>{{0, kNan, 0}}, atoms), InvalidInput);
  CHECK_THROWS_AS(pairForces(two, {-1, 1, 2.5}), InvalidInput);
  CHECK_THROWS_AS(pairForces(two, {1, 0, 2.5}), InvalidInput);
  CHECK_THROWS_AS(pairForces(two, {1, 1, kNan}), InvalidInput);
  CHECK_THROWS_AS(pairForces(two, atoms, {4.9, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(pairForces(two, atoms, {-10, 0, 0}), InvalidInput);
  CHECK(pairForces(std::vector<Vector3>{}, atoms).forces.empty());
}
