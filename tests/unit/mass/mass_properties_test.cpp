// The fast pass against the plain functions and against the exact pass.

#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom/mass/tetrahedron_sums.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// The largest relative error of the ten sums, against the exact pass; first and second moments
// relative to what the volume would make of them at the distance of the farthest vertex.
Real errorOfSums(const TriangleMesh& mesh, const Vector3& origin) {
  const TetrahedronSums<Real> fast = sumTetrahedra(mesh, origin);
  const TetrahedronSums<DoubleDouble> exact = sumTetrahedraExactly(mesh, origin);
  Real far = 0;
  for (const Vector3& vertex : mesh.vertices) far = std::max(far, (vertex - origin).norm());
  const Real v = exact.v.value();
  const auto error = [](Real got, const DoubleDouble& expected, Real scale) {
    return std::abs((DoubleDouble(got) - expected).value()) / scale;
  };
  return std::max(
      {error(fast.v, exact.v, v), error(fast.x, exact.x, 4 * v * far),
       error(fast.y, exact.y, 4 * v * far), error(fast.z, exact.z, 4 * v * far),
       error(fast.xx, exact.xx, 20 * v * far * far), error(fast.yy, exact.yy, 20 * v * far * far),
       error(fast.zz, exact.zz, 20 * v * far * far), error(fast.xy, exact.xy, 20 * v * far * far),
       error(fast.yz, exact.yz, 20 * v * far * far), error(fast.zx, exact.zx, 20 * v * far * far)});
}

}  // namespace

TEST_CASE("the fast pass agrees with the plain functions on every number of triangles") {
  // Lanes of four and blocks of sixteen fours: 4 to 260 triangles cross every edge case.
  for (int rings = 2; rings <= 9; ++rings) {
    const TriangleMesh mesh = translated(ellipsoidMesh({1, 2, 3}, rings), {0.1, -0.7, 0.3});
    const MassProperties body = massProperties(mesh, 3);
    CHECK(relativeError(body.volume, signedVolume(mesh)) < 2e-15);
    CHECK(relativeError(body.mass, 3 * signedVolume(mesh)) < 2e-15);
    CHECK((body.center - centerOfMass(mesh)).norm() < 1e-14);
    CHECK(relativeError(body.inertia, inertiaTensor(mesh, 3)) < 5e-15);
  }
  for (int corners = 3; corners < 70; ++corners) {
    const std::vector<Vector2> profile{{0, -1}, {1, 0}, {0, 2}};
    const TriangleMesh mesh = latheMesh(profile, corners);  // 2 · corners triangles
    CHECK(relativeError(massProperties(mesh, 1).volume, signedVolume(mesh)) < 2e-15);
    CHECK(relativeError(massProperties(mesh, 1).inertia, inertiaTensor(mesh, 1)) < 5e-15);
  }
}

TEST_CASE("sums over many small triangles stay exact to fifteen digits") {
  const TriangleMesh torus = torusMesh(2, 0.5, 400, 200);
  CHECK(errorOfSums(torus, {0, 0, 0}) < 2e-15);
  CHECK(errorOfSums(translated(torus, {1, 2, 3}), {1, 2, 3}) < 2e-15);
}

TEST_CASE("a large mesh a million metres away is weighed to the digits that its vertices have") {
  // The vertices are on a grid of 2^-20, so that moving them by 2^20 is exact and so is the answer.
  const TriangleMesh near = snapToGrid(torusMesh(2, 0.5, 200, 100), 1.0 / (1 << 20));
  const Vector3 offset = Vector3::Constant(1 << 20);
  const TriangleMesh far = translated(near, offset);
  const MassProperties here = massProperties(near, 1);
  const MassProperties there = massProperties(far, 1);
  CHECK(relativeError(there.volume, here.volume) < 1e-13);
  CHECK((there.center - offset - here.center).norm() < 1e-9);  // an ulp of 2^20 is 2.3e-10
  CHECK(relativeError(there.inertia, here.inertia) < 1e-12);
  CHECK(relativeError(weighAboutWorldOrigin(far).inertia, here.inertia) > 1);
}

TEST_CASE(
    "thin bodies are weighed exactly, from the threshold down to the rounding of their vertices") {
  Random random(21);
  for (int power = 0; power <= 40; power += 2) {
    // A plate turned by a third of a turn about (1, 1, 1) and a bit, so that no face is along an
    // axis.
    const Real thickness = std::ldexp(1.0, -power);
    Matrix3 R;
    R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
    R /= 3;
    const TriangleMesh plate = transformed(boxMesh({0, 0, 0}, {1, 1, thickness}), R);
    INFO("thickness 2^-" << power);
    // The same through the exact sums, by hand.
    const TetrahedronSums<DoubleDouble> sums = sumTetrahedraExactly(plate, {0.3, 0.2, 0.1});
    const Real volume = sums.v.value() / 6;
    const MassProperties body = massProperties(plate, 1);
    CHECK(relativeError(body.volume, volume) < 1e-13);
    const DoubleDouble cx = sums.x / (DoubleDouble(4) * sums.v);
    const DoubleDouble cy = sums.y / (DoubleDouble(4) * sums.v);
    const DoubleDouble cz = sums.z / (DoubleDouble(4) * sums.v);
    const Vector3 center((DoubleDouble(0.3) + cx).value(), (DoubleDouble(0.2) + cy).value(),
                         (DoubleDouble(0.1) + cz).value());
    CHECK((body.center - center).norm() < 1e-13);
    const DoubleDouble v20 = DoubleDouble(20) * sums.v;
    const DoubleDouble xx = sums.xx - v20 * cx * cx;
    const DoubleDouble yy = sums.yy - v20 * cy * cy;
    const DoubleDouble zz = sums.zz - v20 * cz * cz;
    const Vector3 diagonal((yy + zz).value(), (xx + zz).value(), (xx + yy).value());
    CHECK(relativeError(Vector3(120 * body.inertia.diagonal()), diagonal) < 1e-12);
  }
}

TEST_CASE("a vertex that no triangle uses changes nothing") {
  TriangleMesh mesh = icosphereMesh(1, 2);
  const MassProperties before = massProperties(mesh, 1);
  mesh.vertices.emplace_back(1e6, 1e6, 1e6);
  const MassProperties after = massProperties(mesh, 1);
  CHECK(relativeError(after.volume, before.volume) < 1e-14);
  CHECK(relativeError(after.inertia, before.inertia) < 1e-14);
}

TEST_CASE("a body too large for its numbers is refused rather than weighed as infinite") {
  const TriangleMesh huge = boxMesh({0, 0, 0}, {1e150, 1e150, 1e150});
  CHECK_THROWS_AS(massProperties(huge, 1), InvalidInput);
}

TEST_CASE("weighing twice gives the same bits") {
  const TriangleMesh mesh = torusMesh(2, 0.5, 33, 17);
  CHECK(massProperties(mesh, 1).inertia == massProperties(mesh, 1).inertia);
}
