// The box around a mesh, whichever vertex is the outermost one and however many there are.

#include "carom/mass/mesh_bounds.hpp"

#include <limits>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "support/catch.hpp"

using namespace carom;

TEST_CASE("any vertex may be the outermost one, in meshes of any size") {
  Random random(9);
  for (std::size_t count = 1; count <= 19; ++count) {
    for (std::size_t outer = 0; outer < count; ++outer) {
      TriangleMesh mesh;
      for (std::size_t v = 0; v < count; ++v) mesh.vertices.push_back(random.vector());
      mesh.vertices[outer] = {5, -6, 7};
      Vector3 low = mesh.vertices[0], high = low;
      for (const Vector3& v : mesh.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
      }
      INFO(count << " vertices, the outermost is " << outer << " (seed 9)");
      const MeshBounds bounds = boundsOf(mesh);
      CHECK(bounds.low == low);
      CHECK(bounds.high == high);
      CHECK(bounds.high.x() == 5);
    }
  }
}

TEST_CASE("what is not a number is passed over, wherever it stands") {
  for (std::size_t bad = 0; bad < 10; ++bad) {
    TriangleMesh mesh;
    for (int v = 0; v < 10; ++v) mesh.vertices.emplace_back(v, 2 * v, -v);
    mesh.vertices[bad].y() = std::numeric_limits<Real>::quiet_NaN();
    const MeshBounds bounds = boundsOf(mesh);
    CHECK(bounds.low == Vector3(0, bad == 0 ? 2 : 0, -9));
    CHECK(bounds.high == Vector3(9, bad == 9 ? 16 : 18, 0));
  }
}

TEST_CASE("without vertices there is no box") {
  CHECK_THROWS_AS(boundsOf({}), InvalidInput);
}
