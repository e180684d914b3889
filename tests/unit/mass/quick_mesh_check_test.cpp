// The quick check may say "not clearly", but never "good" of a mesh in which the plain check finds
// something.

#include "carom/mass/quick_mesh_check.hpp"

#include <algorithm>
#include <limits>

#include "carom/core/random.hpp"
#include "carom/mass/check_mesh.hpp"
#include "carom/mass/meshes.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {

std::vector<TriangleMesh> goodMeshes() {
  std::vector<TriangleMesh> meshes = {
      boxMesh({0, 0, 0}, {1, 2, 3}),
      torusMesh(2, 0.5, 30, 20),
      icosphereMesh(1, 3),
      ellipsoidMesh({3, 2, 1}, 12),
      boxMesh({0, 0, 0}, {1, 1, 1e-9}),
      translated(icosphereMesh(1, 2), {1e6, 1e6, -1e6}),
      transformed(icosphereMesh(1, 2), 1e-40 * Matrix3::Identity())};
  // Triangles and vertices in any order.
  Random random(7);
  TriangleMesh shuffled = icosphereMesh(1, 3);
  for (std::size_t i = shuffled.triangles.size(); i > 1; --i) {
    std::swap(shuffled.triangles[i - 1], shuffled.triangles[random.bits() % i]);
  }
  for (auto& t : shuffled.triangles) {
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.bits() % 3), t.end());
  }
  meshes.push_back(shuffled);
  return meshes;
}

}  // namespace

TEST_CASE("good meshes of one piece are clearly good") {
  for (const TriangleMesh& mesh : goodMeshes()) {
    CHECK(isClearlyGood(mesh));
    CHECK(checkMesh(mesh).empty());
  }
}

TEST_CASE("what is only good after a closer look is not clearly good") {
  const TriangleMesh hollow =
      joined(boxMesh({-2, -2, -2}, {2, 2, 2}), reversed(boxMesh({-1, -1, -1}, {1, 1, 1})));
  TriangleMesh spare = icosphereMesh(1, 1);
  spare.vertices.emplace_back(9, 9, 9);  // used by no triangle
  const TriangleMesh thin = tetrahedronMesh({0, 0, 0}, {1, 0, 0}, {0.5, 5e-15, 0}, {0.5, 0, 5e-15});
  for (const TriangleMesh& mesh : {hollow, spare, thin}) {
    CHECK(checkMesh(mesh).empty());
    CHECK_FALSE(isClearlyGood(mesh));
  }
}

TEST_CASE("no broken mesh is clearly good") {
  std::vector<TriangleMesh> broken(1);
  broken.push_back({{}, {{0, 1, 2}}});
  broken.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}});
  broken.push_back(reversed(torusMesh(2, 0.5, 16, 8)));
  broken.push_back(joined(boxMesh({-2, -2, -2}, {2, 2, 2}), boxMesh({-1, -1, -1}, {1, 1, 1})));
  TriangleMesh twice = icosphereMesh(1, 1);  // every edge four times, twice in each direction
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  broken.push_back(twice);
  for (const Real bad :
       {std::numeric_limits<Real>::quiet_NaN(), -std::numeric_limits<Real>::infinity()}) {
    broken.push_back(icosphereMesh(1, 1));
    broken.back().vertices[17].z() = bad;
  }
  for (const std::int32_t bad : {-1, 42, std::numeric_limits<std::int32_t>::max(),
                                 std::numeric_limits<std::int32_t>::min()}) {
    broken.push_back(icosphereMesh(1, 1));
    broken.back().triangles[79][2] = bad;
  }
  for (const TriangleMesh& mesh : broken) {
    CHECK_FALSE(isClearlyGood(mesh));
    CHECK_FALSE(checkMesh(mesh).empty());
  }
}

TEST_CASE("the quick check never says good where the plain one finds something") {
  Random random(11);
  const auto some = [&random](std::size_t n) { return random.bits() % n; };
  const std::vector<TriangleMesh> good = goodMeshes();
  int stillGood = 0;
  for (int round = 0; round < 1000; ++round) {
    TriangleMesh mesh = good[some(good.size())];
    // One to three faults, so that one may hide another.
    for (std::size_t faults = 1 + some(3); faults > 0; --faults) {
      const std::size_t t = some(mesh.triangles.size());
      switch (some(6)) {
        case 0:
          mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
          break;
        case 1:
          std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
          break;
        case 2:
          mesh.triangles.push_back(mesh.triangles[t]);
          break;
        case 3:
          mesh.triangles[t][some(3)] = static_cast<std::int32_t>(some(mesh.vertices.size() + 1));
          break;
        case 4:
          mesh.triangles.push_back(
              {mesh.triangles[t][0], mesh.triangles[t][2], mesh.triangles[t][1]});
          break;
        default:  // two vertices in one place
          mesh.vertices[some(mesh.vertices.size())] = mesh.vertices[some(mesh.vertices.size())];
      }
      if (mesh.triangles.empty()) break;
    }
    INFO("round " << round << " (seed 11)");
    const bool quick = isClearlyGood(mesh);
    if (quick) CHECK(checkMesh(mesh).empty());
    stillGood += quick;
  }
  CHECK(stillGood < 200);
}
