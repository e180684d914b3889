// The mesh makers: closed, outward, of the size they promise.

#include <cmath>
#include <numbers>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/shell_centroid.hpp"
#include "carom/mass/signed_volume.hpp"
#include "reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

std::vector<Vector2> polygon(int corners, Real radius) {
  std::vector<Vector2> outline;
  for (int i = 0; i < corners; ++i) {
    const Real angle = 2 * std::numbers::pi * i / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

}  // namespace

TEST_CASE("every maker makes a closed mesh that looks outwards") {
  const std::vector<Vector2> bottle{{0, 0}, {1, 0}, {1, 2}, {0.3, 3}, {0, 3}};
  const std::vector<TriangleMesh> meshes{
      boxMesh({-1, 0, 1}, {0, 3, 5}),
      tetrahedronMesh({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}),
      tetrahedronMesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}),
      ellipsoidMesh({1, 2, 3}, 2),
      ellipsoidMesh({1, 2, 3}, 9),
      icosphereMesh(2, 0),
      icosphereMesh(2, 3),
      torusMesh(2, 1, 3, 3),
      torusMesh(2, 1, 20, 10),
      latheMesh(bottle, 3),
      latheMesh(bottle, 40),
      prismMesh(polygon(3, 1), 2),
      prismMesh(polygon(17, 1), 2),
      hollowPrismMesh(polygon(6, 2), polygon(6, 1), 0.5)};
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    INFO("mesh " << i);
    const auto problems = checkMesh(meshes[i]);
    CHECK(problems.empty());
    if (!problems.empty()) WARN(problems.front().message);
    // Euler: vertices - edges + triangles = 2 - 2 genus.
    const auto v = static_cast<int>(meshes[i].vertices.size());
    const auto f = static_cast<int>(meshes[i].triangles.size());
    const bool ring = i == 7 || i == 8 || i == 13;
    CHECK(v - 3 * f / 2 + f == (ring ? 0 : 2));
  }
}

TEST_CASE("prisms have the volume of their outline times their height") {
  const Real hexagon = 1.5 * std::sqrt(3.0);
  CHECK_THAT(signedVolume(prismMesh(polygon(6, 1), 4)), WithinRel(4 * hexagon, 1e-15));
  CHECK_THAT(signedVolume(hollowPrismMesh(polygon(6, 2), polygon(6, 1), 4)),
             WithinRel(4 * 3 * hexagon, 1e-15));
}

TEST_CASE("round meshes lie on their surface and tend to its area and volume") {
  const TriangleMesh ball = icosphereMesh(2, 4);
  for (const Vector3& vertex : ball.vertices) CHECK_THAT(vertex.norm(), WithinRel(2, 1e-15));
  CHECK(ball.triangles.size() == 20 * 256);
  CHECK_THAT(surfaceArea(ball), WithinRel(16 * std::numbers::pi, 2e-3));
  CHECK_THAT(signedVolume(ball), WithinRel(32 * std::numbers::pi / 3, 4e-3));
  CHECK_THAT(surfaceArea(torusMesh(2, 0.5, 200, 100)),
             WithinRel(4 * std::numbers::pi * std::numbers::pi, 1e-3));
}

TEST_CASE("joining, reversing, moving and snapping do what they say") {
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  const TriangleMesh two = joined(box, translated(box, {5, 0, 0}));
  CHECK(two.vertices.size() == 16);
  CHECK(signedVolume(two) == 2);
  CHECK(signedVolume(reversed(two)) == -2);
  CHECK(signedVolume(transformed(box, Vector3(2, 3, -4).asDiagonal())) == 24);
  const TriangleMesh snapped = snapToGrid(icosphereMesh(1, 1), 0.25);
  for (const Vector3& vertex : snapped.vertices) {
    for (const Real x : vertex) CHECK(4 * x == std::nearbyint(4 * x));
  }
}

TEST_CASE("makers refuse sizes and numbers that make no solid") {
  CHECK_THROWS_AS(boxMesh({0, 0, 0}, {1, 0, 1}), InvalidInput);
  CHECK_THROWS_AS(boxMesh({0, 0, 0}, {1, std::nan(""), 1}), InvalidInput);
  CHECK_THROWS_AS(ellipsoidMesh({1, 1, 0}, 8), InvalidInput);
  CHECK_THROWS_AS(ellipsoidMesh({1, 1, 1}, 1), InvalidInput);
  CHECK_THROWS_AS(icosphereMesh(-1, 2), InvalidInput);
  CHECK_THROWS_AS(icosphereMesh(1, 10), InvalidInput);
  CHECK_THROWS_AS(icosphereMesh(1, -1), InvalidInput);
  CHECK_THROWS_AS(torusMesh(1, 2, 8, 8), InvalidInput);
  CHECK_THROWS_AS(torusMesh(2, 1, 2, 8), InvalidInput);
  const std::vector<Vector2> noAxis{{1, 0}, {1, 1}, {0, 2}};
  CHECK_THROWS_AS(latheMesh(noAxis, 8), InvalidInput);
  const std::vector<Vector2> crossing{{0, 0}, {-1, 1}, {0, 2}};
  CHECK_THROWS_AS(latheMesh(crossing, 8), InvalidInput);
  CHECK_THROWS_AS(prismMesh(std::vector<Vector2>{{1, 0}, {0, 1}}, 1), InvalidInput);
  CHECK_THROWS_AS(prismMesh(std::vector<Vector2>{{1, 0}, {0, -1}, {-1, 0}}, 1), InvalidInput);
  CHECK_THROWS_AS(prismMesh(polygon(5, 1), 0), InvalidInput);
  CHECK_THROWS_AS(hollowPrismMesh(polygon(6, 2), polygon(5, 1), 1), InvalidInput);
  CHECK_THROWS_AS(snapToGrid(boxMesh({0, 0, 0}, {1, 1, 1}), 0), InvalidInput);
}
