// A surface in several pieces: cavities, solids in cavities, and pieces that look the wrong way.

#include "carom/mass/check_pieces.hpp"

#include "carom/core/errors.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/signed_volume.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

TriangleMesh cube(Real halfEdge, const Vector3& middle = Vector3::Zero()) {
  const Vector3 corner(halfEdge, halfEdge, halfEdge);
  return boxMesh(middle - corner, middle + corner);
}

}  // namespace

TEST_CASE("pieces are numbered in the order of their first triangles") {
  const MeshPieces one = piecesOf(icosphereMesh(1, 2));
  CHECK(one.count == 1);
  const MeshPieces two = piecesOf(joined(cube(1), icosphereMesh(3, 0)));
  REQUIRE(two.count == 2);
  for (std::size_t t = 0; t < two.pieceOf.size(); ++t) CHECK(two.pieceOf[t] == (t < 12 ? 0 : 1));
}

TEST_CASE("a cavity must look into itself") {
  for (const TriangleMesh& cavity :
       {cube(0.5), icosphereMesh(0.5, 2), torusMesh(0.4, 0.1, 12, 8)}) {
    const TriangleMesh right = joined(cube(1), reversed(cavity));
    CHECK(checkMesh(right).empty());
    CHECK_THAT(massProperties(right, 1).volume, WithinRel(8 - signedVolume(cavity), 1e-14));

    const TriangleMesh wrong = joined(cube(1), cavity);
    const auto problems = checkMesh(wrong);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].kind == MeshProblemKind::flippedPiece);
    CHECK(problems[0].triangle == 12);
    CHECK_THAT(problems[0].message, ContainsSubstring("triangle 12"));
    CHECK_THROWS_AS(massProperties(wrong, 1), InvalidInput);
    CHECK_THROWS_WITH(massProperties(wrong, 1), ContainsSubstring(problems[0].message));
  }
}

TEST_CASE("the order of the pieces does not matter, nor where the mesh is") {
  const TriangleMesh wrong =
      translated(joined(icosphereMesh(0.5, 1), icosphereMesh(1, 1)), {1e6, -1e6, 1e6});
  const auto problems = checkMesh(wrong);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].triangle == 0);  // the inner one comes first here
}

TEST_CASE("a solid in a cavity looks outwards again, and so on inwards") {
  const TriangleMesh dolls =
      joined(joined(cube(4), reversed(cube(3))), joined(cube(2), reversed(cube(1))));
  CHECK(checkMesh(dolls).empty());
  CHECK_THAT(massProperties(dolls, 1).volume, WithinRel(512.0 - 216 + 64 - 8, 1e-14));
  const TriangleMesh wrong = joined(joined(cube(4), reversed(cube(3))), joined(cube(2), cube(1)));
  const auto problems = checkMesh(wrong);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].triangle == 36);
}

TEST_CASE("two solids side by side must both look outwards") {
  const TriangleMesh good = joined(cube(2), cube(1, {5, 0, 0}));
  CHECK(checkMesh(good).empty());
  const auto problems = checkMesh(joined(cube(2), reversed(cube(1, {5, 0, 0}))));
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].kind == MeshProblemKind::flippedPiece);
  CHECK(problems[0].triangle == 12);
  CHECK_THAT(problems[0].message, ContainsSubstring("flipped"));
}

TEST_CASE("solids that touch in a whole face are judged by the vertices that are free") {
  CHECK(checkMesh(joined(boxMesh({0, 0, 0}, {1, 1, 1}), boxMesh({1, 0, 0}, {2, 1, 1}))).empty());
  CHECK(checkMesh(joined(boxMesh({0, 0, 0}, {4, 4, 4}), boxMesh({4, 1, 1}, {6, 2, 2}))).empty());
}

TEST_CASE("pieces that cut each other are left to the search for self-intersections") {
  CHECK(checkMesh(joined(cube(2), cube(1, {2, 2, 2}))).empty());
  CHECK(checkMesh(joined(cube(2), reversed(cube(1, {2, 2, 2})))).empty());
}

TEST_CASE("many pieces are found and the list is bounded") {
  TriangleMesh mesh = cube(1000);
  for (int i = 0; i < 150; ++i) mesh = joined(mesh, cube(1, {Real(5 * i - 400), 0, 0}));
  CHECK(piecesOf(mesh).count == 151);
  CHECK(checkMesh(mesh).size() == kMaxMeshProblems);
}
