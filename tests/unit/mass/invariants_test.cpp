// What must not depend on where a body is, how it is turned, how large it is, or how it is meshed.

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/inertia_about.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/shell_centroid.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom/mass/standard_solids.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

Vector3 somePoint(Random& random, Real size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Matrix3 someRotation(Random& random) {
  Vector3 n = somePoint(random, 1);
  n /= n.norm();
  const Real angle = random.between(-3, 3);
  Matrix3 N;
  N << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return Matrix3::Identity() + std::sin(angle) * N + (1 - std::cos(angle)) * N * N;
}

// A body without any symmetry: a dented ball.
TriangleMesh potato(Random& random) {
  TriangleMesh mesh = icosphereMesh(1, 2);
  for (Vector3& vertex : mesh.vertices) vertex *= random.between(0.7, 1.3);
  return mesh;
}

}  // namespace

TEST_CASE("a body that is moved keeps volume and inertia, and its centre moves with it") {
  Random random(11);
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh mesh = potato(random);
    const Vector3 offset = somePoint(random, 100);
    const TriangleMesh moved = translated(mesh, offset);
    // Moving rounds each vertex by 1e-14, which is the error allowed here.
    CHECK(relativeError(signedVolume(moved), signedVolume(mesh)) < 1e-13);
    CHECK((centerOfMass(moved) - offset - centerOfMass(mesh)).norm() < 1e-13);
    CHECK(relativeError(inertiaTensor(moved, 1), inertiaTensor(mesh, 1)) < 1e-13);
    CHECK((shellCentroid(moved) - offset - shellCentroid(mesh)).norm() < 1e-13);
    CHECK(relativeError(massProperties(moved, 1).inertia, massProperties(mesh, 1).inertia) < 1e-13);
  }
}

TEST_CASE("a body that is turned takes its inertia with it: R I Rt") {
  Random random(12);
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh mesh = potato(random);
    const Matrix3 R = someRotation(random);
    const TriangleMesh turned = transformed(mesh, R);
    CHECK(relativeError(signedVolume(turned), signedVolume(mesh)) < 1e-14);
    CHECK((centerOfMass(turned) - R * centerOfMass(mesh)).norm() < 1e-14);
    CHECK(relativeError(inertiaTensor(turned, 2), rotateInertia(inertiaTensor(mesh, 2), R)) <
          1e-14);
    CHECK(relativeError(massProperties(turned, 2).inertia,
                        rotateInertia(massProperties(mesh, 2).inertia, R)) < 1e-14);
  }
}

TEST_CASE("a body k times as large has k^3 the volume and k^5 the inertia, at any scale") {
  Random random(13);
  const TriangleMesh mesh = potato(random);
  for (const Real k : {1e-30, 1e-6, 0.5, 3.0, 1e6, 1e30}) {
    const TriangleMesh scaled = transformed(mesh, k * Matrix3::Identity());
    INFO("scale " << k);
    CHECK(relativeError(signedVolume(scaled), k * k * k * signedVolume(mesh)) < 1e-14);
    CHECK(relativeError(Vector3(centerOfMass(scaled) / k), centerOfMass(mesh)) < 1e-13);
    CHECK(relativeError(Matrix3(inertiaTensor(scaled, 1) / std::pow(k, 5)),
                        inertiaTensor(mesh, 1)) < 1e-13);
    CHECK(relativeError(Matrix3(massProperties(scaled, 1).inertia / std::pow(k, 5)),
                        massProperties(mesh, 1).inertia) < 1e-13);
  }
}

TEST_CASE("a body in the mirror keeps volume and moments and changes the sign of two products") {
  Random random(14);
  const TriangleMesh mesh = potato(random);
  const Matrix3 mirror = Vector3(-1, 1, 1).asDiagonal();
  const MassProperties body = massProperties(mesh, 1);
  const MassProperties image = massProperties(transformed(mesh, mirror), 1);
  CHECK(relativeError(image.volume, body.volume) < 1e-15);
  CHECK((image.center - mirror * body.center).norm() < 1e-15);
  CHECK(relativeError(image.inertia, Matrix3(mirror * body.inertia * mirror)) < 1e-14);
}

TEST_CASE("density scales mass and inertia and nothing else") {
  Random random(15);
  const TriangleMesh mesh = potato(random);
  const MassProperties light = massProperties(mesh, 1);
  const MassProperties heavy = massProperties(mesh, 1024);
  CHECK(heavy.volume == light.volume);
  CHECK(heavy.center == light.center);
  CHECK(heavy.mass == 1024 * light.mass);
  CHECK(heavy.inertia == 1024 * light.inertia);
  CHECK(inertiaTensor(mesh, 1024) == 1024 * inertiaTensor(mesh, 1));
}

TEST_CASE("a finer mesh of the same box is the same box") {
  const MassProperties box = solidBox({2, 2, 2}, 1);
  TriangleMesh mesh = boxMesh({-1, -1, -1}, {1, 1, 1});
  // Split every triangle at its centre of gravity, three times, one corner moved for each.
  for (int round = 0; round < 3; ++round) {
    TriangleMesh finer;
    finer.vertices = mesh.vertices;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto corners = cornersOf(mesh, {a, b, c});
      const auto middle = static_cast<std::int32_t>(finer.vertices.size());
      finer.vertices.push_back((2 * corners.a + corners.b + corners.c) / 4);
      finer.triangles.insert(finer.triangles.end(),
                             {{a, b, middle}, {b, c, middle}, {c, a, middle}});
    }
    mesh = finer;
    CHECK(relativeError(signedVolume(mesh), box.volume) < 1e-14);
    CHECK(centerOfMass(mesh).norm() < 1e-14);
    CHECK(relativeError(inertiaTensor(mesh, 1), box.inertia) < 1e-14);
    // The mean of the vertices follows the meshing; the centre of mass does not.
    Vector3 mean = Vector3::Zero();
    for (const Vector3& vertex : mesh.vertices) mean += vertex;
    mean /= static_cast<Real>(mesh.vertices.size());
    CHECK(mean.norm() > 1e-3);
  }
}

TEST_CASE("the inertia of a real body obeys the triangle inequality about every axis") {
  Random random(16);
  for (int i = 0; i < 20; ++i) {
    const Matrix3 inertia = massProperties(potato(random), 1).inertia;
    CHECK(inertia == inertia.transpose());
    for (int k = 0; k < 3; ++k) {
      CHECK(inertia(k, k) < inertia((k + 1) % 3, (k + 1) % 3) + inertia((k + 2) % 3, (k + 2) % 3));
    }
  }
}

TEST_CASE("the sign of the products of inertia: mass along the diagonal makes I_xy negative") {
  // A bar along (1, 1, 0): x and y are large together, and I_xy = -∫ x y dV.
  Matrix3 R;
  const Real h = std::sqrt(0.5);
  R << h, -h, 0, h, h, 0, 0, 0, 1;
  const TriangleMesh bar = transformed(boxMesh({-2, -0.1, -0.1}, {2, 0.1, 0.1}), R);
  CHECK(inertiaTensor(bar, 1)(0, 1) < 0);
  CHECK(massProperties(bar, 1).inertia(0, 1) < 0);
}

TEST_CASE("a density that is no positive number is refused") {
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  for (const Real density : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    CHECK_THROWS_AS(inertiaTensor(box, density), InvalidInput);
    CHECK_THROWS_AS(massProperties(box, density), InvalidInput);
    CHECK_THROWS_AS(massPropertiesOfGoodMesh(box, density), InvalidInput);
  }
}
