// Grader of 02.center_of_mass: pyramids, boxes with hollows, and one box meshed in two ways.

#include "carom/mass/center_of_mass.hpp"

#include "carom/mass/meshes.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few dozen roundings of numbers of this size";

// A pyramid over a regular outline, base at z = 0, tip on the axis.
TriangleMesh pyramid(Real height, int sides) {
  const std::vector<Vector2> profile = {{0, 0}, {1.5, 0}, {0, height}};
  return latheMesh(profile, sides);
}

// A box whose top is split into four triangles around its middle, each of them split in three again
// and again.
TriangleMesh boxWithFineTop(const Vector3& high, int splits) {
  TriangleMesh mesh = boxMesh({0, 0, 0}, high);
  for (int n = 0; n < splits; ++n) {
    const std::size_t count = mesh.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
      const auto [a, b, c] = cornersOf(mesh, mesh.triangles[t]);
      if (a.z() != high.z() || b.z() != high.z() || c.z() != high.z()) continue;
      const auto middle = static_cast<std::int32_t>(mesh.vertices.size());
      mesh.vertices.push_back((a + b + c) / 3);
      const auto [i, j, k] = mesh.triangles[t];
      mesh.triangles[t] = {i, j, middle};
      mesh.triangles.push_back({j, k, middle});
      mesh.triangles.push_back({k, i, middle});
    }
  }
  return mesh;
}

// A box [0,4]x[0,2]x[0,2] with a hollow cube of edge 1 whose centre is (x, 1, 1).
TriangleMesh hollowBox(Real x) {
  return joined(boxMesh({0, 0, 0}, {4, 2, 2}),
                reversed(boxMesh({x - 0.5, 0.5, 0.5}, {x + 0.5, 1.5, 1.5})));
}

}  // namespace

TEST_CASE("solid") {
  const TriangleMesh tetrahedron = tetrahedronMesh({0, 0, 0}, {5, 0, 0}, {0, 4, 0}, {0, 0, 3});
  GRADE(centerOfMass(tetrahedron), Vector3(1.25, 1, 0.75), within(1e-14, kRounding),
        given("mesh", "the tetrahedron (0,0,0), (5,0,0), (0,4,0), (0,0,3)"), unit("m"));
  for (const int sides : {3, 4, 12}) {
    GRADE(centerOfMass(pyramid(2, sides)), Vector3(0, 0, 0.5), within(1e-14, kRounding),
          given("mesh", "a pyramid, base at z = 0, height 2 m"), given("sides", sides), unit("m"));
  }
}

TEST_CASE("meshing") {
  for (const int splits : {0, 1, 3}) {
    GRADE(centerOfMass(boxWithFineTop({1, 2, 3}, splits)), Vector3(0.5, 1, 1.5),
          within(1e-14, kRounding), given("mesh", "the box [0,1]x[0,2]x[0,3]"),
          given("how often the triangles of its top are split in three", splits), unit("m"));
  }
}

TEST_CASE("hollow") {
  // 16 m³ at x = 2 without 1 m³ at the hollow: (32 - x)/15.
  for (const Real x : {1.0, 2.0, 3.25}) {
    GRADE(centerOfMass(hollowBox(x)), Vector3((32 - x) / 15, 1, 1), within(1e-14, kRounding),
          given("mesh", "a box [0,4]x[0,2]x[0,2] with a hollow cube of edge 1"),
          given("centre of the hollow", Vector3(x, 1, 1), "m"), unit("m"));
  }
}

TEST_CASE("moved") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vector3 a = random.vector(2);
    const Vector3 b = a + random.vector();
    const Vector3 c = a + random.vector();
    const Vector3 d = a + random.vector();
    const TriangleMesh mesh = tetrahedronMesh(a, b, c, d);
    const Vector3 expected = (a + b + c + d) / 4;
    GRADE(centerOfMass(mesh), expected, within(1e-12, kRounding),
          given("a tetrahedron with vertices", mesh.vertices, "m"), unit("m"));
    GRADE(centerOfMass(reversed(mesh)), expected, within(1e-12, kRounding),
          given("turned inside out, a tetrahedron with vertices", mesh.vertices, "m"), unit("m"));
  }
  const Vector3 far(1.0e6, -0.75e6, 2.0e6);
  GRADE(centerOfMass(translated(hollowBox(1), far)), Vector3(far + Vector3(31.0 / 15, 1, 1)),
        within(1e-9, "coordinates of millions are known to about 2e-10"),
        given("mesh", "a box [0,4]x[0,2]x[0,2] with a hollow cube of edge 1 at (1,1,1)"),
        given("moved by", far, "m"), unit("m"));
}

TEST_CASE("refuses") {
  // A square taken twice, once for each side: closed, but nothing inside.
  TriangleMesh flat;
  flat.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  flat.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  GRADE_REFUSES(centerOfMass(flat),
                given("mesh", "a sheet with two sides and nothing between them"));
  GRADE_REFUSES(centerOfMass({}), given("mesh", "no triangles at all"));
}

PROBES() {
  Random random(22);
  for (int n = 0; n < 8; ++n) {
    const Vector3 place = random.vector(3);
    PROBE(centerOfMass(translated(hollowBox(random.between(0.6, 3.4)), place)));
    PROBE(centerOfMass(translated(pyramid(random.between(1, 3), 5), place)));
    PROBE(centerOfMass(translated(boxWithFineTop({1, 2, 3}, 2), place)));
  }
}
