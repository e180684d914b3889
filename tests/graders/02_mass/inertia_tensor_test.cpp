// Grader of 02.inertia_tensor: boxes and tetrahedra whose integrals can be done on paper, and an
// ellipsoid of triangles whose integrals were computed with fractions.

#include "carom/mass/inertia_tensor.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/mass/meshes.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "some dozens of roundings of numbers of this size";

Matrix3 diagonal(Real xx, Real yy, Real zz) {
  return Vector3(xx, yy, zz).asDiagonal();
}

Matrix3 boxTensor(Real mass, const Vector3& size) {
  const Vector3 q = size.cwiseProduct(size) * mass / 12;
  return diagonal(q.y() + q.z(), q.x() + q.z(), q.x() + q.y());
}

// A right-handed frame, from two random directions.
Matrix3 anyRotation(Random& random) {
  const Vector3 x = random.direction();
  Vector3 y = random.direction();
  y -= x * x.dot(y);
  while (y.norm() < 0.1) {
    y = random.direction();
    y -= x * x.dot(y);
  }
  y /= y.norm();
  Matrix3 R;
  R.col(0) = x;
  R.col(1) = y;
  R.col(2) = cross(x, y);
  return R;
}

// The corner of a box with edges a, b, c: integrals of powers over it are factorials.
TriangleMesh cornerOfBox(Real a, Real b, Real c) {
  return tetrahedronMesh({0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c});
}

Matrix3 cornerTensor(Real a, Real b, Real c) {
  const Real volume = a * b * c / 6;
  // ∫x² = V a²/10 and ∫xy = V ab/20 about the corner; taken off is V times the centre (a,b,c)/4
  // squared.
  const Vector3 edges(a, b, c);
  const Vector3 squares = volume * edges.cwiseProduct(edges) * (Real(1) / 10 - Real(1) / 16);
  const auto product = [volume](Real u, Real v) {
    return volume * u * v * (Real(1) / 20 - Real(1) / 16);
  };
  Matrix3 I =
      diagonal(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
  I(0, 1) = I(1, 0) = -product(a, b);
  I(1, 2) = I(2, 1) = -product(b, c);
  I(2, 0) = I(0, 2) = -product(c, a);
  return I;
}

}  // namespace

TEST_CASE("box") {
  GRADE(inertiaTensor(boxMesh({0, 0, 0}, {1, 2, 3}), 1), diagonal(6.5, 5, 2.5),
        within(2e-14, kRounding), given("mesh", "the box [0,1]x[0,2]x[0,3]"),
        given("density", 1.0, "kg/m^3"), unit("kg m^2"));
  GRADE(inertiaTensor(boxMesh({-1, -1, -1}, {1, 1, 1}), 3), diagonal(16, 16, 16),
        within(1e-13, kRounding), given("mesh", "the cube [-1,1]^3"),
        given("density", 3.0, "kg/m^3"), unit("kg m^2"));
}

TEST_CASE("about_centre") {
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Vector3 size = Vector3(1.5, 1.5, 1.5) + random.vector();
    const Vector3 corner = random.vector(4);
    const Real density = random.between(0.5, 4);
    const Real mass = density * size.prod();
    GRADE(inertiaTensor(boxMesh(corner, corner + size), density), boxTensor(mass, size),
          within(1e-11, kRounding), given("low corner of a box", corner, "m"),
          given("its edges", size, "m"), given("density", density, "kg/m^3"), unit("kg m^2"));
  }
}

TEST_CASE("products") {
  Matrix3 expected;
  expected << 9.375, 2.5, 1.875, 2.5, 12.75, 1.5, 1.875, 1.5, 15.375;
  GRADE(inertiaTensor(cornerOfBox(5, 4, 3), 1), expected, within(1e-13, kRounding),
        given("mesh", "the tetrahedron (0,0,0), (5,0,0), (0,4,0), (0,0,3)"),
        given("density", 1.0, "kg/m^3"), unit("kg m^2"));
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Vector3 edges = Vector3(1.5, 1.5, 1.5) + random.vector();
    GRADE(inertiaTensor(cornerOfBox(edges.x(), edges.y(), edges.z()), 1),
          cornerTensor(edges.x(), edges.y(), edges.z()), within(1e-13, kRounding),
          given("a tetrahedron with three edges along the axes", edges, "m"),
          given("density", 1.0, "kg/m^3"), unit("kg m^2"));
  }
}

TEST_CASE("ellipsoid") {
  // Half axes 3, 2, 1 with 8 rings, every coordinate a multiple of 2^-20: integrated with
  // fractions.
  const TriangleMesh ellipsoid = snapToGrid(ellipsoidMesh({3, 2, 1}, 8), 0x1p-20);
  const Matrix3 exact =
      diagonal(22.49721530726455721668269, 44.88028652449195462015539, 58.1959810219077879950359);
  GRADE(inertiaTensor(ellipsoid, 1), exact, within(2e-12, kRounding),
        given("mesh", "an ellipsoid of 224 triangles with half axes 3, 2, 1 m"),
        given("density", 1.0, "kg/m^3"), unit("kg m^2"));
  Random random(seed());
  for (int n = 0; n < 5; ++n) {
    const Matrix3 R = anyRotation(random);
    GRADE(inertiaTensor(transformed(ellipsoid, R), 1), Matrix3(R * exact * R.transpose()),
          within(2e-12, kRounding),
          given("mesh", "the same ellipsoid, turned so that its axes are the columns of"),
          given("R", R), given("density", 1.0, "kg/m^3"), unit("kg m^2"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(inertiaTensor(cornerOfBox(1, 1, 1), 0), given("density", 0.0, "kg/m^3"));
  GRADE_REFUSES(inertiaTensor({}, 1), given("mesh", "no triangles at all"));
}

PROBES() {
  Random random(24);
  for (int n = 0; n < 16; ++n) {
    const Vector3 a = random.vector(2);
    const TriangleMesh mesh =
        tetrahedronMesh(a, a + random.vector(), a + random.vector(), a + random.vector());
    const Real density = random.between(2, 4);
    PROBE(inertiaTensor(mesh, density));
  }
}
