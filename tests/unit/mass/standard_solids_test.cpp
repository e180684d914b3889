// Closed forms against meshes, against each other, and against their limits.

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/standard_solids.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// A mesh of n steps approaches the smooth solid as 1/n²: two finenesses, extrapolated, give the
// smooth values.
void checkIsLimitOf(const std::function<TriangleMesh(int)>& mesh, const MassProperties& solid) {
  const MassProperties coarse = massProperties(mesh(60), 2);
  const MassProperties fine = massProperties(mesh(120), 2);
  const Real volume = (4 * fine.volume - coarse.volume) / 3;
  const Vector3 center = (4 * fine.center - coarse.center) / 3;
  const Matrix3 inertia = (4 * fine.inertia - coarse.inertia) / 3;
  CHECK(relativeError(volume, solid.volume) < 1e-5);
  CHECK_THAT(solid.mass, WithinRel(2 * solid.volume, 1e-15));
  CHECK((center - solid.center).norm() < 1e-5);
  CHECK(relativeError(inertia, solid.inertia) < 1e-5);
  // Without extrapolation they differ: the test would see a mesh that is right by accident.
  CHECK(relativeError(fine.volume, solid.volume) > 1e-5);
}

// A quarter circle of n steps about (0, height), from `from` to `to` degrees above the horizontal.
void addArc(std::vector<Vector2>& profile, Real radius, Real height, int from, int to, int n) {
  for (int i = 0; i <= n; ++i) {
    const Real angle = (from + (to - from) * Real(i) / n) * std::numbers::pi / 180;
    const bool onAxis = (i == 0 && std::abs(from) == 90) || (i == n && std::abs(to) == 90);
    profile.emplace_back(onAxis ? 0 : radius * std::cos(angle), height + radius * std::sin(angle));
  }
}

}  // namespace

TEST_CASE("a ball, an ellipsoid and a torus are the limits of their meshes") {
  checkIsLimitOf([](int n) { return ellipsoidMesh({1.5, 1.5, 1.5}, n); }, solidBall(1.5, 2));
  checkIsLimitOf([](int n) { return ellipsoidMesh({1, 2, 3}, n); }, solidEllipsoid({1, 2, 3}, 2));
  checkIsLimitOf([](int n) { return torusMesh(2, 0.7, 2 * n, n); }, solidTorus(2, 0.7, 2));
}

TEST_CASE("a cylinder, a cone and a capsule are the limits of their meshes") {
  checkIsLimitOf(
      [](int n) {
        const std::vector<Vector2> profile{{0, -1}, {0.5, -1}, {0.5, 1}, {0, 1}};
        return latheMesh(profile, n);
      },
      solidCylinder(0.5, 2, 2));
  checkIsLimitOf(
      [](int n) {
        const std::vector<Vector2> profile{{0, 0}, {0.5, 0}, {0, 2}};
        return latheMesh(profile, n);
      },
      solidCone(0.5, 2, 2));
  checkIsLimitOf(
      [](int n) {
        std::vector<Vector2> profile;
        addArc(profile, 0.5, -1, -90, 0, n / 2);
        addArc(profile, 0.5, 1, 0, 90, n / 2);
        return latheMesh(profile, 2 * n);
      },
      solidCapsule(0.5, 2, 2));
}

TEST_CASE("a hollow ball is the limit of two meshes, one reversed") {
  checkIsLimitOf(
      [](int n) {
        return joined(ellipsoidMesh({1, 1, 1}, n), reversed(ellipsoidMesh({0.6, 0.6, 0.6}, n)));
      },
      hollowBall(0.6, 1, 2));
}

TEST_CASE("a box and a tetrahedron agree with their meshes to the last digits") {
  const MassProperties box = solidBox({1, 2, 3}, 7);
  const MassProperties boxFromMesh = massProperties(boxMesh({-0.5, -1, -1.5}, {0.5, 1, 1.5}), 7);
  CHECK(box.volume == boxFromMesh.volume);
  CHECK(relativeError(box.inertia, boxFromMesh.inertia) < 1e-15);

  const Vector3 a(1, 2, 3);
  const Vector3 b(-4, 0.5, 2);
  const Vector3 c(0, 0, -1);
  const Vector3 d(2, 7, 1);
  const MassProperties tetra = solidTetrahedron(a, b, c, d, 7);
  const MassProperties mirrored = solidTetrahedron(b, a, c, d, 7);
  const MassProperties fromMesh = massProperties(tetrahedronMesh(a, b, c, d), 7);
  for (const MassProperties& body : {tetra, mirrored}) {
    CHECK(relativeError(body.volume, fromMesh.volume) < 1e-15);
    CHECK((body.center - fromMesh.center).norm() < 1e-15);
    CHECK(relativeError(body.inertia, fromMesh.inertia) < 2e-15);
  }
}

TEST_CASE("solids pass into one another") {
  // An ellipsoid with equal axes, and a capsule of no height, are balls; a hollow of nothing
  // changes nothing.
  const MassProperties ball = solidBall(0.8, 3);
  for (const MassProperties& same : {solidEllipsoid({0.8, 0.8, 0.8}, 3), solidCapsule(0.8, 0, 3),
                                     hollowBall(0, 0.8, 3), solidCapsule(0.8, 1e-13, 3)}) {
    CHECK(relativeError(same.volume, ball.volume) < 1e-12);
    CHECK(relativeError(same.inertia, ball.inertia) < 1e-12);
  }
  // A long thin capsule, cylinder and box are the same rod.
  const Real rod = 1.0 / 12;
  CHECK_THAT(solidCapsule(1e-6, 1, 1).inertia(0, 0) / solidCapsule(1e-6, 1, 1).mass,
             WithinRel(rod, 1e-5));
  CHECK_THAT(solidCylinder(1e-6, 1, 1).inertia(1, 1) / solidCylinder(1e-6, 1, 1).mass,
             WithinRel(rod, 1e-10));
  // A torus with a thin tube is a ring: m R² about its axis, half that across.
  const MassProperties ring = solidTorus(3, 1e-6, 1);
  CHECK_THAT(ring.inertia(2, 2) / ring.mass, WithinRel(9, 1e-12));
  CHECK_THAT(ring.inertia(0, 0) / ring.mass, WithinRel(4.5, 1e-12));
}

TEST_CASE("sizes that make no solid are refused") {
  const Real nan = std::nan("");
  CHECK_THROWS_AS(solidBall(0, 1), InvalidInput);
  CHECK_THROWS_AS(solidBall(1, -1), InvalidInput);
  CHECK_THROWS_AS(solidBall(nan, 1), InvalidInput);
  CHECK_THROWS_AS(hollowBall(1, 1, 1), InvalidInput);
  CHECK_THROWS_AS(hollowBall(-0.1, 1, 1), InvalidInput);
  CHECK_THROWS_AS(solidBox({1, -1, 1}, 1), InvalidInput);
  CHECK_THROWS_AS(solidEllipsoid({1, 0, 1}, 1), InvalidInput);
  CHECK_THROWS_AS(solidCylinder(1, 0, 1), InvalidInput);
  CHECK_THROWS_AS(solidCapsule(1, -1, 1), InvalidInput);
  CHECK_THROWS_AS(solidCapsule(1, nan, 1), InvalidInput);
  CHECK_THROWS_AS(solidCone(1, 1, 0), InvalidInput);
  CHECK_THROWS_AS(solidTorus(1, 2, 1), InvalidInput);
  CHECK_THROWS_AS(solidTetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, 1), InvalidInput);
}
