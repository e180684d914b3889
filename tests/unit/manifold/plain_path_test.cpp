// A program built with a student's functions takes the plain way: the manifold of two polyhedra
// must then be made of the replaceable functions. This program is linked with the object that says
// so.

#include "carom/core/variant.hpp"
#include "carom/manifold/collide.hpp"
#include "carom/manifold/plain_manifold.hpp"
#include "manifold_reference.hpp"

using namespace carom;
using namespace carom_test;

TEST_CASE("on the plain path boxes and hulls have the manifold of the chapter's functions") {
  REQUIRE(takesPlainPath());
  Random random(61);
  int different = 0, contacts = 0;
  for (int n = 0; n < 60; ++n) {
    const Box box = randomBox(random);
    const ConvexHull hull = randomHull(random, 8), other = randomHull(random, 9);
    const Pose A = randomPose(random, 0.4), B = randomPose(random, 0.4);
    const ConvexHull boxAsHull = boxHull(box.halfExtents);
    const Manifold plain = plainManifold(boxAsHull, A, hull, B);
    contacts += plain.count > 0 ? 1 : 0;
    different += same(collide(box, A, hull, B), plain) ? 0 : 1;
    different += same(collide(other, A, hull, B), plainManifold(other, A, hull, B)) ? 0 : 1;
    different += same(collide(box, A, box, B), plainManifold(boxAsHull, A, boxAsHull, B)) ? 0 : 1;
  }
  CHECK(different == 0);
  CHECK(contacts > 20);
}
