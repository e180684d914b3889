// Surfaces that cut or touch themselves are found, others are not, however close.

#include "carom/mass/self_intersections.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/meshes.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

// Every pair, without boxes and without a tree.
std::vector<TrianglePair> allPairs(const TriangleMesh& mesh) {
  std::vector<TrianglePair> pairs;
  const auto n = static_cast<std::int32_t>(mesh.triangles.size());
  for (std::int32_t i = 0; i < n; ++i) {
    for (std::int32_t j = i + 1; j < n; ++j) {
      if (trianglesMeet(mesh, i, j)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

// Triangles that snapping has left without an area.
TriangleMesh withoutFlatTriangles(TriangleMesh mesh) {
  std::erase_if(mesh.triangles, [&mesh](const auto& triangle) {
    const auto [a, b, c] = cornersOf(mesh, triangle);
    return cross(b - a, c - a).isZero(0);
  });
  return mesh;
}

constexpr std::size_t kAll = 1000000;

Matrix3 thirdTurn() {
  Matrix3 R;
  R << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  return R / 3;
}

// Two triangles; corners in one place become one vertex.
bool meet(const std::array<Vector3, 3>& p, const std::array<Vector3, 3>& q) {
  TriangleMesh mesh;
  for (const auto& corners : {p, q}) {
    std::array<std::int32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::size_t v = 0;
      while (v < mesh.vertices.size() && mesh.vertices[v] != corners[k]) ++v;
      if (v == mesh.vertices.size()) mesh.vertices.push_back(corners[k]);
      triangle[k] = static_cast<std::int32_t>(v);
    }
    mesh.triangles.push_back(triangle);
  }
  return trianglesMeet(mesh, 0, 1) && trianglesMeet(mesh, 1, 0);
}

const std::array<Vector3, 3> kFloor = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

}  // namespace

TEST_CASE("meshes that neither cut nor touch themselves are left in peace") {
  for (const TriangleMesh& mesh : {boxMesh({0, 0, 0}, {1, 2, 3}), torusMesh(2, 0.5, 20, 12),
                                   icosphereMesh(1, 3), ellipsoidMesh({3, 2, 1}, 10),
                                   joined(icosphereMesh(1, 2), reversed(icosphereMesh(0.99, 2)))}) {
    CHECK(selfIntersections(mesh).empty());
    CHECK(selfIntersections(transformed(mesh, thirdTurn())).empty());
    CHECK(selfIntersections(translated(mesh, {1e6, 1e6, -1e6})).empty());
    CHECK(checkSelfIntersections(mesh).empty());
  }
}

TEST_CASE("two boxes that cut each other are found, though every edge is in order") {
  const TriangleMesh mesh =
      joined(boxMesh({0, 0, 0}, {2, 2, 2}), boxMesh({1.25, 1.5, 0.75}, {3, 3, 1.75}));
  const auto pairs = selfIntersections(mesh);
  REQUIRE_FALSE(pairs.empty());
  for (const auto& [first, second] : pairs) CHECK((first < 12 && second >= 12));
  CHECK(pairs == allPairs(mesh));
  const auto problems = checkSelfIntersections(mesh);
  REQUIRE(problems.size() == pairs.size());
  CHECK(problems[0].kind == MeshProblemKind::selfIntersection);
  CHECK(problems[0].triangle == pairs[0].first);
  CHECK_THAT(problems[0].message, ContainsSubstring(std::to_string(pairs[0].second)));
}

TEST_CASE("a gap of one unit in the last place is a gap, and touching is touching") {
  const TriangleMesh left = boxMesh({0, 0, 0}, {1, 1, 1});
  const auto right = [](Real x) { return boxMesh({x, 0.25, 0.25}, {2, 0.75, 0.75}); };
  CHECK(selfIntersections(joined(left, right(1 + 0x1p-52))).empty());
  CHECK_FALSE(selfIntersections(joined(left, right(1))).empty());
  CHECK_FALSE(selfIntersections(joined(left, right(1 - 0x1p-53))).empty());
}

TEST_CASE("a torus whose tube is thicker than its hole cuts itself") {
  // Radius of the ring 1, of the tube 1.2: the tube passes through the axis.
  TriangleMesh mesh = torusMesh(2, 0.5, 24, 16);
  for (Vector3& v : mesh.vertices) {
    const Real ring = std::hypot(v.x(), v.y());
    const Real across = 2.4 * (ring - 2);  // from the middle of the tube, outwards
    v = {v.x() / ring * (1 + across), v.y() / ring * (1 + across), 2.4 * v.z()};
  }
  CHECK(checkMesh(mesh).empty());
  const auto pairs = selfIntersections(mesh, kAll);
  CHECK(pairs.size() > 100);
  CHECK(pairs == allPairs(mesh));
}

TEST_CASE("the tree finds what the comparison of all pairs finds") {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    TriangleMesh mesh = icosphereMesh(1, 2);
    // Vertices pushed about, on a coarse grid in every other round: many exact coincidences.
    for (Vector3& v : mesh.vertices) v += random.vector(0.3);
    if (round % 2 == 0) mesh = withoutFlatTriangles(snapToGrid(mesh, 0.125));
    INFO("round " << round << " (seed 5)");
    CHECK(selfIntersections(mesh, kAll) == allPairs(mesh));
  }
}

TEST_CASE("two triangles without a common corner: through, at a corner, at an edge, in the plane") {
  CHECK(meet(kFloor, {{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}}));         // an edge through the inside
  CHECK(meet(kFloor, {{{1, 1, 0}, {1, 1, 5}, {2, 1, 5}}}));          // a corner on the face
  CHECK(meet(kFloor, {{{2, 0, 0}, {2, -1, 1}, {2, -1, -1}}}));       // a corner on an edge
  CHECK(meet(kFloor, {{{2, -1, -1}, {2, 1, 1}, {2, -5, 0}}}));       // edge through edge
  CHECK(meet(kFloor, {{{1, 0, 0}, {2, 0, 0}, {1, 0, 3}}}));          // edge along edge
  CHECK(meet(kFloor, {{{0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0}}}));  // one inside the other
  CHECK(meet(kFloor, {{{-9, -9, 0}, {30, -9, 0}, {-9, 30, 0}}}));
  CHECK(meet(kFloor, {{{1, -1, 0}, {3, -1, 0}, {2, 1, 0}}}));  // overlapping in the plane
  CHECK(meet(kFloor, {{{2, 2, 0}, {3, 3, 0}, {3, 2, 0}}}));    // touching in the plane
  CHECK_FALSE(meet(kFloor, {{{1, 1, 1e-100}, {1, 2, 1}, {2, 1, 1}}}));
  CHECK_FALSE(meet(kFloor, {{{2.5, 2.5, -1}, {2.5, 2.5, 1}, {9, 9, 0}}}));  // beside it
  CHECK_FALSE(meet(kFloor, {{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}}));
  CHECK_FALSE(meet(kFloor, {{{4.0000001, 0, -1}, {4.0000001, 0, 1}, {9, 9, 0}}}));
}

TEST_CASE("two triangles with one common corner may meet there and nowhere else") {
  CHECK_FALSE(meet(kFloor, {{{0, 0, 0}, {-4, 0, 0}, {0, -4, 0}}}));
  CHECK_FALSE(meet(kFloor, {{{0, 0, 0}, {1, 1, 1}, {1, 2, 1}}}));
  CHECK_FALSE(meet(kFloor, {{{0, 0, 0}, {-1, -1, 1}, {-1, -1, -1}}}));  // passes the plane outside
  CHECK(meet(kFloor, {{{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}}));            // passes through the face
  CHECK(meet(kFloor, {{{0, 0, 0}, {9, 9, 1}, {9, 9, -1}}}));            // and over its far side
  CHECK(meet(kFloor, {{{0, 0, 0}, {1, 1, 0}, {1, 1, 1}}}));             // an edge lies in the face
  CHECK(meet(kFloor, {{{0, 0, 0}, {2, 0, 0}, {0, 0, 3}}}));             // an edge along an edge
  CHECK(meet(kFloor, {{{0, 0, 0}, {3, 1, 0}, {1, 3, 0}}}));             // overlap in the plane
  CHECK(meet(kFloor, {{{0, 0, 0}, {8, 0, 0}, {0, -8, 0}}}));            // touch along an edge
  CHECK_FALSE(meet(kFloor, {{{0, 0, 0}, {8, -1e-9, 0}, {0, -8, 0}}}));
}

TEST_CASE("two triangles with a common edge meet elsewhere only if folded flat") {
  CHECK_FALSE(meet(kFloor, {{{0, 0, 0}, {4, 0, 0}, {0, -4, 0}}}));
  CHECK_FALSE(meet(kFloor, {{{0, 0, 0}, {4, 0, 0}, {0, 4, 1e-100}}}));
  CHECK(meet(kFloor, {{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}}}));
  CHECK(meet(kFloor, {{{4, 0, 0}, {0, 0, 0}, {-7, 9, 0}}}));
  CHECK(meet(kFloor, {{{4, 0, 0}, {0, 0, 0}, {0, 4, 0}}}));  // the same one
}

TEST_CASE("a mesh of any size has the same pairs") {
  Random random(6);
  TriangleMesh mesh = icosphereMesh(1, 2);
  for (Vector3& v : mesh.vertices) v += random.vector(0.3);
  for (const TriangleMesh& given : {mesh, withoutFlatTriangles(snapToGrid(mesh, 0.125))}) {
    const auto pairs = selfIntersections(given, kAll);
    CHECK(pairs.size() > 20);
    for (const int power : {-900, -400, 400, 900, 1022}) {
      INFO("times 2^" << power);
      // Powers of two change no digit, but squares and products leave the range of a double.
      const TriangleMesh scaled = transformed(given, std::ldexp(1.0, power) * Matrix3::Identity());
      CHECK(selfIntersections(scaled, kAll) == pairs);
    }
  }
}

TEST_CASE("the list of pairs is bounded") {
  const TriangleMesh twice = joined(icosphereMesh(1, 3), icosphereMesh(1, 3));
  CHECK(selfIntersections(twice).size() == kMaxMeshProblems);
  CHECK(selfIntersections(twice, 7).size() == 7);
  CHECK(selfIntersections(twice, kAll).size() > 1280);
}

TEST_CASE("a mesh that cannot be looped over is refused") {
  TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
  mesh.triangles[0][0] = 8;
  CHECK_THROWS_AS(selfIntersections(mesh), InvalidInput);
  CHECK_THROWS_AS(selfIntersections({}), InvalidInput);
}
