// Grader of 03.sat_hulls: cubes whose edges cross, tetrahedra beside a cube, and any tetrahedra,
// judged by all differences of their corners.

#include "carom/detection/sat_hulls.hpp"

#include <cmath>

#include "graders/03_detection/differences.hpp"
#include "graders/03_detection/roofs.hpp"
#include "grading/fields_detection.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kYesNo = "a word";
constexpr const char* kRounding = "a few roundings of coordinates of this size";

const ConvexHull cube = boxHull({1, 1, 1});

// Four corners in any order; faces turned so that they look outwards.
ConvexHull tetrahedron(const Points& p) {
  const bool outwards = cross(p[1] - p[0], p[2] - p[0]).dot(p[3] - p[0]) < 0;
  std::vector<std::vector<std::int32_t>> faces = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  if (!outwards) {
    for (auto& face : faces) std::swap(face[1], face[2]);
  }
  return hullFromFaces(p, faces);
}

Points fourPoints(Random& random) {
  for (;;) {
    Points p;
    for (int k = 0; k < 4; ++k) p.push_back(random.vector());
    const Real sixfold = cross(p[1] - p[0], p[2] - p[0]).dot(p[3] - p[0]);
    if (std::abs(sixfold) > 0.5) return p;  // no slivers
  }
}

Points placed(const Points& points, const Pose& pose) {
  Points all;
  for (const Vector3& p : points) all.push_back(pose.R_WB * p + pose.p_WB);
  return all;
}

}  // namespace

TEST_CASE("crossing") {
  const Real root8 = 2 * std::sqrt(2.0);
  for (const Real gap : {-0.1, 0.1}) {
    const Pose B = roofAbove(root8 + gap);
    GRADE(satHulls(cube, roof, cube, B).separation, gap, within(4e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin, turned 45 degrees about y"),
          given("B", "a cube of edge 2 m, turned 45 degrees about x"),
          given("centre of B", B.p_WB, "m"), unit("m"),
          about("edge lies across edge, and only their cross product shows how far they are"));
    GRADE(satHulls(cube, roof, cube, B).axis, Vector3(0, 0, 1), within(1e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin, turned 45 degrees about y"),
          given("B", "a cube of edge 2 m, turned 45 degrees about x"),
          given("centre of B", B.p_WB, "m"), about("a unit vector from A to B"));
  }
}

TEST_CASE("cube") {
  struct Case {
    const char* what;
    Points corners;
    const char* verdict;
    Real separation;
    Vector3 axis;
  };
  const Case cases[] = {
      {"a corner on a face",
       {{1, 0.25, 0.2}, {2, 0, 0}, {2.5, 1, 0}, {2, 0, 1}},
       "touching",
       0,
       {1, 0, 0}},
      {"a gap of 0.5 m below",
       {{0, 0, -1.5}, {1, 0, -2}, {0, 1, -2.5}, {-1, -1, -2}},
       "separated",
       0.5,
       {0, 0, -1}},
      {"a corner 0.25 m inside",
       {{-0.75, 0.25, 0}, {-2, 0, 0.5}, {-2.5, 1, -0.5}, {-2, -1, -0.5}},
       "overlapping",
       -0.25,
       {-1, 0, 0}},
  };
  for (const Case& c : cases) {
    const ConvexHull b = tetrahedron(c.corners);
    GRADE(inWords(satHulls(cube, at({0, 0, 0}), b, at({0, 0, 0})).verdict), c.verdict,
          within(0, kYesNo), given("a", "a cube of edge 2 m at the origin"),
          given("b, a tetrahedron", c.corners, "m"), about(c.what));
    GRADE(satHulls(cube, at({0, 0, 0}), b, at({0, 0, 0})).separation, c.separation,
          within(1e-15, kRounding), given("a", "a cube of edge 2 m at the origin"),
          given("b, a tetrahedron", c.corners, "m"), unit("m"), about(c.what));
    GRADE(satHulls(b, at({0, 0, 0}), cube, at({0, 0, 0})).axis, Vector3(-c.axis),
          within(1e-15, kRounding), given("a, a tetrahedron", c.corners, "m"),
          given("b", "a cube of edge 2 m at the origin"), about("a unit vector from A to B"));
    GRADE(inWords(satHulls(b, at({0, 0, 0}), cube, at({0, 0, 0})).kind), "a face of B",
          within(0, kYesNo), given("a, a tetrahedron", c.corners, "m"),
          given("b", "a cube of edge 2 m at the origin"), about("what the axis is made of"));
  }
}

TEST_CASE("flat") {
  for (const Vector3& place : {Vector3(0.5, 0.25, 1.75), Vector3(-0.25, 0.5, 2.5)}) {
    const Real gap = place.z() - 2;
    GRADE(satHulls(cube, at({0, 0, 0}), cube, at(place)).separation, gap, within(1e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin"), given("B", "the same cube, not turned"),
          given("centre of B", place, "m"), unit("m"),
          about("many edges are parallel, and have no cross product"));
    GRADE(inWords(satHulls(cube, at({0, 0, 0}), cube, at(place)).kind), "a face of A",
          within(0, kYesNo), given("A", "a cube of edge 2 m at the origin"),
          given("B", "the same cube, not turned"), given("centre of B", place, "m"),
          about("a face wins over edges that are no better"));
  }
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 24; ++n) {
    const Points a = fourPoints(random), b = fourPoints(random);
    const Matrix3 R = anyTurn(random, 0, 3);
    const Pose A = at(random.vector(2), R);
    const Vector3 place = A.p_WB + random.vector(0.7);
    const Pose B = at(place, anyTurn(random, 0, 3));
    const BestGap best = bestGap(placed(a, A), placed(b, B));
    const ConvexHull hullA = tetrahedron(a), hullB = tetrahedron(b);
    GRADE(inWords(satHulls(hullA, A, hullB, B).verdict), best.gap > 0 ? "separated" : "overlapping",
          within(0, kYesNo), given("a, a tetrahedron", a, "m"), given("A", A),
          given("b, a tetrahedron", b, "m"), given("B", B));
    if (best.gap > 0) continue;
    GRADE(satHulls(hullA, A, hullB, B).separation, best.gap,
          within(1e-9, "how finely the expected value was searched"),
          given("a, a tetrahedron", a, "m"), given("A", A), given("b, a tetrahedron", b, "m"),
          given("B", B), unit("m"));
    if (!best.isUnique()) continue;
    GRADE(satHulls(hullA, A, hullB, B).axis, best.axis,
          within(1e-7, "how finely the expected value was searched"),
          given("a, a tetrahedron", a, "m"), given("A", A), given("b, a tetrahedron", b, "m"),
          given("B", B), about("a unit vector from A to B"));
  }
}

PROBES() {
  Random random(308);
  for (int n = 0; n < 18; ++n) {
    const ConvexHull a = tetrahedron(fourPoints(random)), b = tetrahedron(fourPoints(random));
    const Matrix3 R = anyTurn(random, 0, 3);
    const Pose A = at(random.vector(), R);
    const Vector3 place = A.p_WB + random.vector(0.8);
    PROBE(satHulls(a, A, b, at(place, anyTurn(random, 0, 3))));
  }
  PROBE(satHulls(cube, at({0, 0, 0}), cube, at({-1.5, 0.25, 0.5})));
  PROBE(satHulls(cube, roof, cube, roofAbove(2.7)));
}
