// Hulls whose faces are given: the links between faces, edges and corners, and what is refused.

#include <set>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/convex_hull.hpp"
#include "hull_checks.hpp"
#include "support/catch.hpp"

using namespace carom;
using carom_test::ContainsSubstring;

namespace {

using Loops = std::vector<std::vector<std::int32_t>>;
const std::vector<Vector3> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Loops kFaces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

}  // namespace

TEST_CASE("a box as a hull is a box: 8 corners, 6 faces, 12 edges, exact planes") {
  const ConvexHull box = boxHull({1, 2, 3});
  carom_test::checkHull(box);
  CHECK(box.vertices.size() == 8);
  CHECK(box.edges.size() == 12);
  REQUIRE(box.faces.size() == 6);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 axis = Vector3::Unit(static_cast<int>(k));
    CHECK(box.faces[2 * k].normal == -axis);
    CHECK(box.faces[2 * k + 1].normal == axis);
    CHECK(box.faces[2 * k].offset == static_cast<Real>(k + 1));
    CHECK(box.faces[2 * k + 1].offset == static_cast<Real>(k + 1));
  }
  CHECK(box.volume == 48);
  CHECK(box.centroid == Vector3(0, 0, 0));
  CHECK(box.boundingRadius == std::sqrt(14.0));
}

TEST_CASE("a tetrahedron as a hull has volume 1/6 and its centre at a quarter") {
  const ConvexHull hull = hullFromFaces(kCorners, kFaces);
  carom_test::checkHull(hull);
  CHECK_THAT(hull.volume, carom_test::WithinULP(1.0 / 6, 1));
  CHECK((hull.centroid - Vector3(0.25, 0.25, 0.25)).norm() <= 1e-16);
}

TEST_CASE("a solid that is not convex is refused, and the vertex outside is named") {
  // A box whose top is pressed in: vertex 8 lies below the rim.
  std::vector<Vector3> vertices = boxHull({1, 1, 1}).vertices;
  vertices.emplace_back(0, 0, 0.5);
  const Loops dented = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1},
                        {4, 5, 8},    {5, 7, 8},    {7, 6, 8},    {6, 4, 8}};
  CHECK_THROWS_WITH(hullFromFaces(vertices, dented), ContainsSubstring("not convex"));
  CHECK_THROWS_WITH(hullFromFaces(vertices, dented), ContainsSubstring("vertex = "));
}

TEST_CASE("faces that do not make a closed solid are refused") {
  const Loops open = {kFaces[0], kFaces[1], kFaces[2]};
  CHECK_THROWS_AS(hullFromFaces(kCorners, open), InvalidInput);
  Loops oneTurned = kFaces;
  std::swap(oneTurned[3][0], oneTurned[3][1]);
  CHECK_THROWS_WITH(hullFromFaces(kCorners, oneTurned), ContainsSubstring("once each way"));
  Loops insideOut = kFaces;
  for (auto& loop : insideOut) std::swap(loop[0], loop[1]);
  CHECK_THROWS_AS(hullFromFaces(kCorners, insideOut), InvalidInput);
  Loops badIndex = kFaces;
  badIndex[1][1] = 9;
  CHECK_THROWS_WITH(hullFromFaces(kCorners, badIndex), ContainsSubstring("corner 9"));
  std::vector<Vector3> spare = kCorners;
  spare.emplace_back(0.1, 0.1, 0.1);
  CHECK_THROWS_WITH(hullFromFaces(spare, kFaces), ContainsSubstring("must belong to a face"));
  std::vector<Vector3> notFinite = kCorners;
  notFinite[2].y() = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_WITH(hullFromFaces(notFinite, kFaces), ContainsSubstring("must be finite"));
}

TEST_CASE("a face whose corners are not in one plane is refused") {
  std::vector<Vector3> bent = boxHull({1, 1, 1}).vertices;
  bent[7].z() = 1.001;
  const Loops box = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                     {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  CHECK_THROWS_WITH(hullFromFaces(bent, box), ContainsSubstring("must be flat"));
}
