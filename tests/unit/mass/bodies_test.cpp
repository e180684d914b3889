// Boxes, parallel axes, compounds, axes: the functions that work on a body rather than on a mesh.

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/box_inertia.hpp"
#include "carom/mass/combine_bodies.hpp"
#include "carom/mass/inertia_about.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/parallel_axis.hpp"
#include "carom/mass/standard_solids.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {
constexpr Real kNaN = std::numeric_limits<Real>::quiet_NaN();

// A rotation about a random axis, by a random angle.
Matrix3 someRotation(Random& random) {
  Vector3 n(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  n /= n.norm();
  const Real angle = random.between(-3, 3);
  Matrix3 N;
  N << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return Matrix3::Identity() + std::sin(angle) * N + (1 - std::cos(angle)) * N * N;
}
}  // namespace

TEST_CASE("the inertia of a box scales with its mass and with the square of its size") {
  const Vector3 size(0.3, 0.5, 0.7);
  CHECK(relativeError(boxInertia(4, size), Matrix3(4 * boxInertia(1, size))) < 1e-15);
  CHECK(relativeError(boxInertia(1, 3 * size), Matrix3(9 * boxInertia(1, size))) < 1e-15);
  CHECK(boxInertia(12, {1, 1, 1}) == Matrix3(2 * Matrix3::Identity()));
}

TEST_CASE("a rod has no inertia about its own length") {
  const Matrix3 rod = boxInertia(1, {2, 1e-9, 1e-9});
  CHECK(rod(0, 0) < 1e-17);
  CHECK_THAT(rod(1, 1), WithinRel(4.0 / 12, 1e-15));
}

TEST_CASE("a box without mass, size or number is refused") {
  CHECK_THROWS_AS(boxInertia(0, {1, 1, 1}), InvalidInput);
  CHECK_THROWS_AS(boxInertia(-1, {1, 1, 1}), InvalidInput);
  CHECK_THROWS_AS(boxInertia(1, {1, 0, 1}), InvalidInput);
  CHECK_THROWS_AS(boxInertia(1, {1, kNaN, 1}), InvalidInput);
  CHECK_THROWS_AS(boxInertia(kNaN, {1, 1, 1}), InvalidInput);
  CHECK_THROWS_AS(boxInertia(1, {1, 1, std::numeric_limits<Real>::infinity()}), InvalidInput);
  CHECK_THROWS_WITH(boxInertia(-1, {1, 1, 1}), ContainsSubstring("-1"));
}

TEST_CASE("moving the point along an axis does not change the moment about that axis") {
  const Matrix3 inertia = boxInertia(6, {1, 2, 3});
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 along = 5 * Vector3::Unit(axis);
    CHECK(parallelAxis(inertia, 6, along)(axis, axis) == inertia(axis, axis));
  }
}

TEST_CASE(
    "about every single axis the tensor form is equation 19: m times the distance of the axes "
    "squared") {
  Random random(1);
  const Matrix3 inertia = solidEllipsoid({1, 2, 3}, 1).inertia;
  for (int i = 0; i < 100; ++i) {
    const Vector3 d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    Vector3 n(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    n /= n.norm();
    const Real distanceSquared = cross(d, n).squaredNorm();
    const Real expected = momentAboutAxis(inertia, n) + 2.5 * distanceSquared;
    CHECK_THAT(momentAboutAxis(parallelAxis(inertia, 2.5, d), n), WithinRel(expected, 1e-14));
  }
}

TEST_CASE(
    "a force on a rod's end turns it about its centre: shifting the inertia there is wrong by two "
    "thirds") {
  // Source, text under equation 19. A free rod of length 2, mass 1; a force 1 across it at x = 0.8.
  const Matrix3 rod = solidBox({2, 0.01, 0.01}, 1 / (2 * 0.01 * 0.01)).inertia;
  const Real torque = 0.8;
  const Real right = torque / rod(2, 2);
  const Real wrong = torque / parallelAxis(rod, 1, {0.8, 0, 0})(2, 2);
  CHECK_THAT(wrong / right, WithinAbs(0.34, 0.01));
}

TEST_CASE("parallel axes refuse what is not a number") {
  CHECK_THROWS_AS(parallelAxis(Matrix3::Identity(), kNaN, {0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(parallelAxis(Matrix3::Identity(), 1, {0, kNaN, 0}), InvalidInput);
  CHECK_THROWS_AS(parallelAxis(Matrix3::Constant(kNaN), 1, {0, 0, 0}), InvalidInput);
}

TEST_CASE("the moment about an axis is n I n, not what the inverse tensor gives") {
  const Matrix3 inertia = Vector3(1, 2, 3).asDiagonal();
  const Vector3 n = Vector3(1, 1, 0) / std::sqrt(2.0);
  CHECK_THAT(momentAboutAxis(inertia, n), WithinAbs(1.5, 1e-15));
  CHECK_THAT(momentAboutAxis(inertia, {7, 7, 0}), WithinAbs(1.5, 1e-15));
  CHECK_THAT(momentAboutAxis(inertia, {1e-200, 1e-200, 0}), WithinAbs(1.5, 1e-15));
  const Vector3 sourceText(n.x() / 1, n.y() / 2, n.z() / 3);  // I^-1 n
  CHECK_THAT(sourceText.norm(), WithinAbs(0.7906, 1e-4));
  CHECK_THROWS_AS(momentAboutAxis(inertia, {0, 0, 0}), InvalidInput);
  CHECK_THROWS_AS(momentAboutAxis(inertia, {kNaN, 0, 1}), InvalidInput);
}

TEST_CASE(
    "a skater who draws in her arms spins faster and has more energy, at the same angular "
    "momentum") {
  // Momentum L = 12 about the axis; arms out 4 kg m^2, arms in 2: kinetic energy L^2 / 2I.
  const Vector3 up(0, 0, 1);
  const Real L = 12;
  const auto energy = [&](Real moment) {
    return L * L / (2 * momentAboutAxis(moment * Matrix3::Identity(), up));
  };
  CHECK(energy(4) == 18);
  CHECK(energy(2) == 36);
}

TEST_CASE(
    "a tensor in other axes is still the same property: trace, determinant and moments stay") {
  Random random(2);
  const Matrix3 inertia = solidTetrahedron({0, 0, 0}, {5, 0, 0}, {0, 4, 0}, {0, 0, 3}, 1).inertia;
  for (int i = 0; i < 50; ++i) {
    const Matrix3 R = someRotation(random);
    const Matrix3 turned = rotateInertia(inertia, R);
    CHECK(turned == turned.transpose());
    CHECK_THAT(turned.trace(), WithinRel(inertia.trace(), 1e-14));
    const Vector3 n(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    CHECK_THAT(momentAboutAxis(turned, R * n), WithinRel(momentAboutAxis(inertia, n), 1e-14));
  }
}

TEST_CASE("a box cut into eight and put together again is the box") {
  std::vector<MassProperties> parts;
  for (int i = 0; i < 8; ++i) {
    MassProperties part = solidBox({0.5, 1, 1.5}, 2);
    part.center = {(i & 1) != 0 ? 0.25 : -0.25, (i & 2) != 0 ? 0.5 : -0.5,
                   (i & 4) != 0 ? 0.75 : -0.75};
    parts.push_back(part);
  }
  const MassProperties whole = combineBodies(parts);
  const MassProperties expected = solidBox({1, 2, 3}, 2);
  CHECK(whole.volume == expected.volume);
  CHECK(whole.mass == expected.mass);
  CHECK(whole.center.norm() < 1e-15);
  CHECK(relativeError(whole.inertia, expected.inertia) < 1e-15);
}

TEST_CASE("two bodies as one mesh and as a compound weigh the same, in any order") {
  const TriangleMesh ball = translated(icosphereMesh(0.5, 2), {1, 2, 3});
  const TriangleMesh box = boxMesh({-1, -1, -1}, {0, 0.5, 0.25});
  const MassProperties together = massProperties(joined(ball, box), 3);
  const std::array parts{massProperties(ball, 3), massProperties(box, 3)};
  const std::array swapped{parts[1], parts[0]};
  for (const MassProperties& whole : {combineBodies(parts), combineBodies(swapped)}) {
    CHECK(relativeError(whole.mass, together.mass) < 1e-15);
    CHECK((whole.center - together.center).norm() < 1e-15);
    CHECK(relativeError(whole.inertia, together.inertia) < 1e-14);
  }
}

TEST_CASE("one body alone is itself, none and weightless ones are refused") {
  const MassProperties body = solidCone(1, 2, 3);
  const MassProperties same = combineBodies(std::array{body});
  CHECK(same.mass == body.mass);
  CHECK((same.center - body.center).norm() < 1e-15);
  CHECK(relativeError(same.inertia, body.inertia) < 1e-15);
  CHECK_THROWS_AS(combineBodies({}), InvalidInput);
  CHECK_THROWS_AS(combineBodies(std::array{MassProperties{}}), InvalidInput);
}
