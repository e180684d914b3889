// What is wrong with a mesh is found, named, and refused.

#include <limits>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/mass/center_of_mass.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/inertia_tensor.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/shell_centroid.hpp"
#include "carom/mass/signed_volume.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

TriangleMesh cube() {
  return boxMesh({0, 0, 0}, {1, 1, 1});
}

// The kinds found, each once, in the order found.
std::vector<MeshProblemKind> kindsOf(const TriangleMesh& mesh) {
  std::vector<MeshProblemKind> kinds;
  for (const MeshProblem& problem : checkMesh(mesh)) {
    if (kinds.empty() || kinds.back() != problem.kind) kinds.push_back(problem.kind);
  }
  return kinds;
}

using Kinds = std::vector<MeshProblemKind>;

// Weighing says the same as the check.
void checkRefused(const TriangleMesh& mesh) {
  const auto problems = checkMesh(mesh);
  REQUIRE_FALSE(problems.empty());
  CHECK_THROWS_AS(massProperties(mesh, 1), InvalidInput);
  CHECK_THROWS_WITH(massProperties(mesh, 1), ContainsSubstring(problems.front().message));
}

}  // namespace

TEST_CASE("good meshes have no problems, whatever their shape") {
  CHECK(checkMesh(cube()).empty());
  CHECK(checkMesh(torusMesh(2, 0.5, 16, 8)).empty());
  CHECK(checkMesh(icosphereMesh(1, 3)).empty());
  CHECK(checkMesh(joined(boxMesh({-1, -1, -1}, {1, 1, 1}),
                         reversed(boxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}))))
            .empty());
  CHECK(checkMesh(translated(cube(), {1e6, 1e6, 1e6})).empty());
  CHECK(checkMesh(boxMesh({0, 0, 0}, {1, 1, 1e-9})).empty());
}

TEST_CASE("an empty mesh is called empty") {
  CHECK(kindsOf({}) == Kinds{MeshProblemKind::empty});
  TriangleMesh points = cube();
  points.triangles.clear();
  CHECK(kindsOf(points) == Kinds{MeshProblemKind::empty});
  checkRefused({});
  checkRefused(points);
}

TEST_CASE("a coordinate that is no number is found with its vertex") {
  for (const Real bad :
       {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity()}) {
    TriangleMesh mesh = cube();
    mesh.vertices[5].y() = bad;
    const auto problems = checkMesh(mesh);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].kind == MeshProblemKind::notANumber);
    CHECK(problems[0].vertex == 5);
    CHECK_THAT(problems[0].message, ContainsSubstring("vertex 5"));
    checkRefused(mesh);
  }
}

TEST_CASE("an index that names no vertex is found with its triangle, and nothing outside is read") {
  for (const std::int32_t bad : {-1, 8, std::numeric_limits<std::int32_t>::max(),
                                 std::numeric_limits<std::int32_t>::min()}) {
    TriangleMesh mesh = cube();
    mesh.triangles[3][1] = bad;
    const auto problems = checkMesh(mesh);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].kind == MeshProblemKind::indexOutOfRange);
    CHECK(problems[0].triangle == 3);
    CHECK_THAT(problems[0].message, ContainsSubstring("triangle 3"));
    CHECK_THAT(problems[0].message, ContainsSubstring(std::to_string(bad)));
    checkRefused(mesh);
    // Every other function refuses it too.
    CHECK_THROWS_AS(signedVolume(mesh), InvalidInput);
    CHECK_THROWS_AS(centerOfMass(mesh), InvalidInput);
    CHECK_THROWS_AS(inertiaTensor(mesh, 1), InvalidInput);
    CHECK_THROWS_AS(shellCentroid(mesh), InvalidInput);
    CHECK_THROWS_AS(surfaceArea(mesh), InvalidInput);
    CHECK_THROWS_AS(monteCarloMass(mesh, 1, 10, 1), InvalidInput);
    CHECK_THROWS_AS(massPropertiesOfGoodMesh(mesh, 1), InvalidInput);
  }
}

TEST_CASE("a mesh of triangles without any vertices is refused") {
  const TriangleMesh mesh{{}, {{0, 1, 2}}};
  CHECK(kindsOf(mesh) == Kinds{MeshProblemKind::indexOutOfRange});
  checkRefused(mesh);
  CHECK_THROWS_AS(massPropertiesOfGoodMesh(mesh, 1), InvalidInput);
}

TEST_CASE(
    "a triangle without area is found: a corner twice, two corners in one place, three on a line") {
  TriangleMesh twice = cube();
  twice.triangles.push_back({2, 2, 3});
  TriangleMesh samePlace = cube();
  samePlace.vertices.push_back(samePlace.vertices[0]);
  samePlace.triangles.push_back({0, 1, 8});
  TriangleMesh onALine = cube();
  onALine.vertices.emplace_back(0.1, 0.3, 0.7);
  onALine.vertices.emplace_back(0.2, 0.6, 1.4);
  onALine.triangles.push_back({0, 8, 9});
  for (const TriangleMesh& mesh : {twice, samePlace, onALine}) {
    const auto problems = checkMesh(mesh);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].kind == MeshProblemKind::degenerateTriangle);
    CHECK(problems[0].triangle == 12);
    CHECK_THAT(problems[0].message, ContainsSubstring("triangle 12"));
    checkRefused(mesh);
  }
}

TEST_CASE("a long thin triangle is not degenerate, and a tiny one is not either") {
  CHECK(checkMesh(tetrahedronMesh({0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}, {0.5, 0, 1e-12})).empty());
  CHECK(checkMesh(tetrahedronMesh({0, 0, 0}, {1e-90, 0, 0}, {0, 1e-90, 0}, {0, 0, 1e-90})).empty());
}

TEST_CASE("a hole is found with the edges around it") {
  TriangleMesh mesh = cube();
  mesh.triangles.erase(mesh.triangles.begin() + 4);  // (0, 1, 5)
  const auto problems = checkMesh(mesh);
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].kind == MeshProblemKind::openEdge);
  CHECK(problems[0].edge == std::array<std::int32_t, 2>{0, 1});
  CHECK(problems[1].edge == std::array<std::int32_t, 2>{0, 5});
  CHECK(problems[2].edge == std::array<std::int32_t, 2>{1, 5});
  CHECK_THAT(problems[0].message, ContainsSubstring("edge 0-1"));
  checkRefused(mesh);
}

TEST_CASE("an edge with a fin or with four triangles is not manifold") {
  TriangleMesh fin = cube();
  fin.vertices.emplace_back(0.5, -1, -1);
  fin.triangles.push_back({0, 1, 8});
  const auto problems = checkMesh(fin);
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].kind == MeshProblemKind::nonManifoldEdge);
  CHECK(problems[0].edge == std::array<std::int32_t, 2>{0, 1});
  CHECK(problems[1].kind == MeshProblemKind::openEdge);
  checkRefused(fin);

  // Two cubes that share the edge 3-7 and its two vertices.
  TriangleMesh two = cube();
  for (const auto& [a, b, c] : boxMesh({1, 1, 0}, {2, 2, 1}).triangles) {
    const auto shared = [](std::int32_t v) { return v == 0 ? 3 : v == 4 ? 7 : v + 8; };
    two.triangles.push_back({shared(a), shared(b), shared(c)});
  }
  const TriangleMesh second = boxMesh({1, 1, 0}, {2, 2, 1});
  two.vertices.insert(two.vertices.end(), second.vertices.begin(), second.vertices.end());
  CHECK(kindsOf(two) == Kinds{MeshProblemKind::nonManifoldEdge});
  CHECK(checkMesh(two).front().edge == std::array<std::int32_t, 2>{3, 7});
  checkRefused(two);
}

TEST_CASE("one flipped triangle is found by its neighbours") {
  TriangleMesh mesh = cube();
  std::swap(mesh.triangles[7][1], mesh.triangles[7][2]);
  const auto problems = checkMesh(mesh);
  REQUIRE(problems.size() == 3);
  for (const MeshProblem& problem : problems) {
    CHECK(problem.kind == MeshProblemKind::partlyFlipped);
    CHECK_THAT(problem.message, ContainsSubstring("triangle 7"));
  }
  checkRefused(mesh);
}

TEST_CASE("a mesh that is inside out is called flipped, and its reverse is good") {
  const TriangleMesh mesh = reversed(torusMesh(2, 0.5, 16, 8));
  CHECK(kindsOf(mesh) == Kinds{MeshProblemKind::flipped});
  checkRefused(mesh);
  CHECK(checkMesh(reversed(mesh)).empty());
}

TEST_CASE("a closed mesh without volume is refused") {
  TriangleMesh leaf{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  CHECK(kindsOf(leaf) == Kinds{MeshProblemKind::flipped});
  checkRefused(leaf);
  CHECK_THROWS_AS(massPropertiesOfGoodMesh(leaf, 1), InvalidInput);
  CHECK_THROWS_AS(centerOfMass(leaf), InvalidInput);
}

TEST_CASE("any single fault in a good mesh is found, wherever it is") {
  Random random(3);
  const TriangleMesh good = icosphereMesh(1, 1);
  const auto some = [&random](std::size_t n) { return random.bits() % n; };
  for (int i = 0; i < 200; ++i) {
    TriangleMesh mesh = good;
    const std::size_t t = some(mesh.triangles.size());
    const int fault = static_cast<int>(some(4));
    if (fault == 0) mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    if (fault == 1) std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
    if (fault == 2) mesh.triangles.push_back(mesh.triangles[t]);
    if (fault == 3) mesh.triangles[t][some(3)] = static_cast<std::int32_t>(some(42));
    if (mesh.triangles == good.triangles) continue;
    INFO("round " << i << " (seed 3), fault " << fault << ", triangle " << t);
    CHECK_FALSE(checkMesh(mesh).empty());
  }
}

TEST_CASE("a hopeless mesh is reported with a bounded list") {
  TriangleMesh soup;
  Random random(4);
  for (int i = 0; i < 3000; ++i) {
    soup.vertices.emplace_back(random.between(0, 1), random.between(0, 1), random.between(0, 1));
  }
  for (std::int32_t i = 0; i < 1000; ++i) soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  CHECK(checkMesh(soup).size() == kMaxMeshProblems);
  checkRefused(soup);
}

TEST_CASE("every kind of problem has its own name") {
  std::vector<std::string> names;
  for (int k = 0; k <= static_cast<int>(MeshProblemKind::selfIntersection); ++k) {
    names.emplace_back(nameOf(static_cast<MeshProblemKind>(k)));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK(names[i] != names[j]);
  }
}
