// Grader of 02.signed_volume: volumes that are known without a mesh, by length times width times
// height, and what moving, turning inside out and hollowing out must do to them.

#include "carom/mass/signed_volume.hpp"

#include <cmath>
#include <limits>

#include "carom/mass/meshes.hpp"
#include "grading/fields_mass.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kExact = "small whole numbers are exact, up to the last division";
constexpr const char* kRounding = "every triangle adds a few roundings of numbers of this size";

// A square frame like a picture's: outer edge 4, inner edge 2, height 1.
TriangleMesh frame() {
  const std::vector<Vector2> outer = {{2, -2}, {2, 2}, {-2, 2}, {-2, -2}};
  const std::vector<Vector2> inner = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  return hollowPrismMesh(outer, inner, 1);
}

// A star with four points: a square of corners at 1 with its sides pushed in to 1/4.
TriangleMesh star() {
  std::vector<Vector2> outline;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vector2 tips[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const Vector2 dents[] = {{0.25, 0.25}, {-0.25, 0.25}, {-0.25, -0.25}, {0.25, -0.25}};
    outline.push_back(tips[quarter]);
    outline.push_back(dents[quarter]);
  }
  return prismMesh(outline, 3);
}

// A tetrahedron whose volume is a b c / 6: one corner with three square edges.
TriangleMesh cornerOfBox(Real a, Real b, Real c) {
  return tetrahedronMesh({0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, c});
}

}  // namespace

TEST_CASE("box") {
  const TriangleMesh box = boxMesh({0, 0, 0}, {1, 2, 3});
  GRADE(signedVolume(box), 6.0, within(1e-14, kExact), given("mesh", "the box [0,1]x[0,2]x[0,3]"),
        unit("m^3"));
  const TriangleMesh tetrahedron = cornerOfBox(5, 4, 3);
  GRADE(signedVolume(tetrahedron), 10.0, within(1e-14, kExact),
        given("mesh", "the tetrahedron (0,0,0), (5,0,0), (0,4,0), (0,0,3)"), unit("m^3"));
}

TEST_CASE("away") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Vector3 size = Vector3(1.1, 1.1, 1.1) + random.vector();
    const Vector3 corner = random.vector(5);
    const TriangleMesh box = boxMesh(corner, corner + size);
    GRADE(signedVolume(box), size.x() * size.y() * size.z(),
          within(1e-12, "coordinates up to 8, products up to 500"),
          given("low corner of a box", corner, "m"), given("its edges", size, "m"), unit("m^3"));
  }
}

TEST_CASE("hollow") {
  GRADE(signedVolume(frame()), 12.0, within(1e-13, kExact),
        given("mesh", "a square frame, outer edge 4 m, inner edge 2 m, height 1 m"), unit("m^3"));
  GRADE(signedVolume(star()), 3.0, within(1e-13, kExact),
        given("mesh", "a star with four points and eight corners, area 1 m^2, height 3 m"),
        unit("m^3"));
  const TriangleMesh shell = joined(boxMesh({-1, -1, -1}, {1, 1, 1}),
                                    reversed(boxMesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5})));
  GRADE(signedVolume(shell), 7.0, within(1e-13, kExact),
        given("mesh", "a cube of edge 2 m with a cubic hollow of edge 1 m"), unit("m^3"));
  Random random(seed());
  for (int n = 0; n < 10; ++n) {
    const Vector3 place = random.vector(4);
    GRADE(signedVolume(translated(frame(), place)), 12.0, within(1e-11, kRounding),
          given("mesh", "the same frame"), given("moved by", place, "m"), unit("m^3"));
  }
}

TEST_CASE("inside_out") {
  const TriangleMesh box = reversed(boxMesh({0, 0, 0}, {1, 2, 3}));
  GRADE(signedVolume(box), -6.0, within(1e-14, kExact),
        given("mesh", "the box [0,1]x[0,2]x[0,3] with every triangle reversed"), unit("m^3"));
  GRADE(signedVolume(translated(reversed(frame()), {-3, 2, 7})), -12.0, within(1e-12, kRounding),
        given("mesh", "a square frame with every triangle reversed, moved by (-3, 2, 7) m"),
        unit("m^3"));
}

TEST_CASE("far") {
  // All coordinates are multiples of 1/1024, so that the moved mesh is exactly as large as before.
  Random random(seed());
  for (int n = 0; n < 5; ++n) {
    const auto edge = [&random] { return Real(random.integer(512, 4096)) / 1024; };
    const Real a = edge();
    const Real b = edge();
    const Real c = edge();
    const auto place = [&random] { return Real(random.integer(900000, 1100000)) + 0.25; };
    const Vector3 offset(place(), place(), place());
    GRADE(signedVolume(translated(cornerOfBox(a, b, c), offset)), a * b * c / 6,
          withinRelative(1e-12, "differences of these coordinates are exact"),
          given("mesh", "a tetrahedron with three edges along the axes"),
          given("its edges", Vector3(a, b, c), "m"), given("moved by", offset, "m"), unit("m^3"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(signedVolume({}), given("mesh", "no triangles at all"));
  TriangleMesh bad = boxMesh({0, 0, 0}, {1, 1, 1});
  bad.triangles[3][1] = 8;
  GRADE_REFUSES(signedVolume(bad),
                given("mesh", "a box, 8 vertices, whose triangle 3 names vertex 8"));
  bad = boxMesh({0, 0, 0}, {1, 1, 1});
  bad.vertices[2].y() = std::numeric_limits<Real>::quiet_NaN();
  GRADE_REFUSES(signedVolume(bad), given("mesh", "a box whose vertex 2 is not a number"));
}

PROBES() {
  Random random(21);
  for (int n = 0; n < 12; ++n) {
    const Vector3 a = random.vector(2);
    const Vector3 b = random.vector(2);
    const Vector3 c = random.vector(2);
    const Vector3 d = random.vector(2);
    PROBE(signedVolume(tetrahedronMesh(a, b, c, d)));
    PROBE(signedVolume(translated(reversed(frame()), a)));
  }
  PROBE(signedVolume(translated(cornerOfBox(1.25, 2.5, 0.75), {1.1e6 + 0.1, 0.7e6 + 0.3, 1.3e6 + 0.7})));
}
