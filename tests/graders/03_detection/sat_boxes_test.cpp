// Grader of 03.sat_boxes: two cubes whose edges cross, with closed forms; boxes that lie parallel;
// and any boxes, judged by all differences of their corners.

#include "carom/detection/sat_boxes.hpp"

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

const Box cube{Vector3(1, 1, 1)};

std::vector<Vector3> corners(const Box& box, const Pose& pose) {
  std::vector<Vector3> all;
  for (int n = 0; n < 8; ++n) {
    all.push_back(pose.R_WB * box.halfExtents.cwiseProduct(cubeCorner(n)) + pose.p_WB);
  }
  return all;
}

Box anyBox(Random& random) {
  Box box;
  for (int k = 2; k >= 0; --k) box.halfExtents[k] = random.between(0.2, 1.5);
  return box;
}
Pose anyPose(Random& random, Real away) {
  const Vector3 place = random.vector(away);
  return at(place, anyTurn(random, 0, 3));
}

}  // namespace

TEST_CASE("crossing") {
  const Real root8 = 2 * std::sqrt(2.0);
  for (const Real gap : {-0.1, 0.1, -0.25}) {
    const Pose B = roofAbove(root8 + gap);
    GRADE(satBoxes(cube, roof, cube, B).separation, gap, within(4e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin, turned 45 degrees about y"),
          given("B", "a cube of edge 2 m, turned 45 degrees about x"),
          given("centre of B", B.p_WB, "m"), unit("m"),
          about("edge lies across edge, and only their cross product shows how far they are"));
    GRADE(satBoxes(cube, roof, cube, B).axis, Vector3(0, 0, 1), within(1e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin, turned 45 degrees about y"),
          given("B", "a cube of edge 2 m, turned 45 degrees about x"),
          given("centre of B", B.p_WB, "m"), about("a unit vector from A to B"));
    GRADE(inWords(satBoxes(cube, roof, cube, B).verdict), gap > 0 ? "separated" : "overlapping",
          within(0, kYesNo),
          given("A", "a cube of edge 2 m at the origin, turned 45 degrees about y"),
          given("B", "a cube of edge 2 m, turned 45 degrees about x"),
          given("centre of B", B.p_WB, "m"));
  }
  // The same with any place and turn of both: nothing but the axis changes.
  Random random(seed());
  const Pose common = anyPose(random, 5);
  const Pose above = roofAbove(root8 - 0.1);
  const Pose A = at(common.p_WB, common.R_WB * roof.R_WB);
  const Pose B = at(common.R_WB * above.p_WB + common.p_WB, common.R_WB * above.R_WB);
  GRADE(inWords(satBoxes(cube, A, cube, B).kind), "a pair of edges", within(0, kYesNo),
        given("A and B", "the same two cubes, moved and turned together"),
        about("what the axis is made of"));
  GRADE(satBoxes(cube, A, cube, B).axis, Vector3(common.R_WB.col(2)), within(1e-14, kRounding),
        given("A and B", "the same two cubes, moved and turned together"),
        about("a unit vector from A to B"));
}

TEST_CASE("flat") {
  struct Case {
    Vector3 place;
    Real separation;
    Vector3 axis;
  };
  const Case cases[] = {{{0, 0, 1.75}, -0.25, {0, 0, 1}},
                        {{-1.5, 0.25, 0.5}, -0.5, {-1, 0, 0}},
                        {{0.5, 3, 0.25}, 1, {0, 1, 0}},
                        {{0.25, -1.875, -0.5}, -0.125, {0, -1, 0}}};
  for (const Case& c : cases) {
    GRADE(satBoxes(cube, at({0, 0, 0}), cube, at(c.place)).separation, c.separation,
          within(1e-15, kRounding), given("A", "a cube of edge 2 m at the origin"),
          given("B", "the same cube, not turned"), given("centre of B", c.place, "m"), unit("m"));
    GRADE(satBoxes(cube, at({0, 0, 0}), cube, at(c.place)).axis, c.axis, within(1e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin"), given("B", "the same cube, not turned"),
          given("centre of B", c.place, "m"), about("a unit vector from A to B"));
    GRADE(inWords(satBoxes(cube, at({0, 0, 0}), cube, at(c.place)).kind), "a face of A",
          within(0, kYesNo), given("A", "a cube of edge 2 m at the origin"),
          given("B", "the same cube, not turned"), given("centre of B", c.place, "m"),
          about("a face wins over a pair of edges that is no better"));
  }
  GRADE(inWords(satBoxes(cube, at({0, 0, 0}), cube, at({2, 0.5, 0})).verdict), "touching",
        within(0, kYesNo), given("A", "a cube of edge 2 m at the origin"),
        given("centre of B", Vector3(2, 0.5, 0), "m"));
}

TEST_CASE("nearly") {
  for (const Real angle : {1e-4, 1e-8, 1e-10}) {
    const Pose B = at({1.9, 0.3, 0.2}, turn(Vector3::UnitX(), angle));
    GRADE(satBoxes(cube, at({0, 0, 0}), cube, B).separation, -0.1, within(1e-15, kRounding),
          given("A", "a cube of edge 2 m at the origin"), given("centre of B", B.p_WB, "m"),
          given("B is turned about x by", angle, "rad"), unit("m"),
          about("edges that are nearly parallel have a very short cross product"));
  }
}

TEST_CASE("any") {
  Random random(seed() + 1);
  for (int n = 0; n < 16; ++n) {
    const Box a = anyBox(random), b = anyBox(random);
    const Pose A = anyPose(random, 1), B = anyPose(random, 2);
    const BestGap best = bestGap(corners(a, A), corners(b, B));
    GRADE(inWords(satBoxes(a, A, b, B).verdict), best.gap > 0 ? "separated" : "overlapping",
          within(0, kYesNo), given("half extents of a", a.halfExtents, "m"), given("A", A),
          given("half extents of b", b.halfExtents, "m"), given("B", B));
    // Of boxes that are apart corner to corner many axes show a gap, and the best is a matter of
    // which are tried.
    if (best.gap > 0) continue;
    GRADE(satBoxes(a, A, b, B).separation, best.gap,
          within(1e-9, "how finely the expected value was searched"),
          given("half extents of a", a.halfExtents, "m"), given("A", A),
          given("half extents of b", b.halfExtents, "m"), given("B", B), unit("m"));
    if (!best.isUnique()) continue;
    GRADE(satBoxes(a, A, b, B).axis, best.axis,
          within(1e-8, "how finely the expected value was searched"),
          given("half extents of a", a.halfExtents, "m"), given("A", A),
          given("half extents of b", b.halfExtents, "m"), given("B", B),
          about("a unit vector from A to B"));
  }
}

PROBES() {
  Random random(307);
  for (int n = 0; n < 20; ++n) {
    const Box a = anyBox(random), b = anyBox(random);
    const Pose A = anyPose(random, 1);
    PROBE(satBoxes(a, A, b, anyPose(random, 1.5)));
  }
  PROBE(satBoxes(cube, at({0, 0, 0}), cube, at({-1.5, 0.25, 0.5})));
  PROBE(satBoxes(cube, roof, cube, roofAbove(2.7)));
}
