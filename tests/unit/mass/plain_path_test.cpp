// A program built with a student's functions takes the plain way: massProperties() must then be
// made of the
// replaceable functions. This program is linked with the object that says so.

#include "carom/core/variant.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/signed_volume.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

TEST_CASE("on the plain path mass properties are those of the chapter's functions, bit for bit") {
  REQUIRE(takesPlainPath());
  // A thin turned plate: the fast way would give other digits.
  Matrix3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  R /= 3;
  const TriangleMesh plate = translated(
      transformed(boxMesh({0, 0, 0}, {1, 1, std::ldexp(1.0, -30)}), R), {1.4, -0.4, 1.2});
  const MassProperties body = massProperties(plate, 3);
  CHECK(body.volume == signedVolume(plate));
  CHECK(body.mass == 3 * signedVolume(plate));
  CHECK(body.center == centerOfMass(plate));
  CHECK(body.inertia == inertiaTensor(plate, 3));
}
