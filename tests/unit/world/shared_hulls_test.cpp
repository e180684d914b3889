// Equal hulls are kept once, and nobody can tell.

#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/world/shared_hulls.hpp"
#include "scene_parts.hpp"
#include "support/catch.hpp"

using namespace carom_test;
using carom::world::sharedHull;
using carom::world::WorldState;

namespace {

ConvexHull someHull(Random& random) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 12; ++i) corners.push_back(random.direction());
  return hullOfPoints(corners);
}

}  // namespace

TEST_CASE("equal hulls have one copy, and a hull that differs by one bit its own") {
  Random random(5);
  WorldState state;
  const ConvexHull one = someHull(random), two = someHull(random);
  const auto first = sharedHull(state, one);
  CHECK(sharedHull(state, ConvexHull(one)) == first);
  CHECK(sharedHull(state, two) != first);
  ConvexHull turned = one;
  turned.vertices[3].z() = std::nextafter(turned.vertices[3].z(), Real(2));
  CHECK(sharedHull(state, turned) != first);
  // The same corners may have other faces.
  ConvexHull other = one;
  other.faces[0].offset = std::nextafter(other.faces[0].offset, Real(2));
  const auto third = sharedHull(state, other);
  CHECK(third != first);
  CHECK(sharedHull(state, other) == third);
  CHECK(sharedHull(state, one) == first);
}

TEST_CASE("hulls that no shape has any more are forgotten") {
  Random random(6);
  WorldState state;
  const ConvexHull kept = someHull(random);
  const auto data = sharedHull(state, kept);
  for (int i = 0; i < 1000; ++i) sharedHull(state, someHull(random));
  CHECK(state.hulls.size() < 200);
  CHECK(sharedHull(state, kept) == data);
}
