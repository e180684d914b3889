// Grader of 04.face_contact: squares and rectangles whose common part can be drawn, a box that has
// tilted a little, and the regular octagon of two squares, under any turn. It does not matter with
// which corner the answer begins.

#include "carom/manifold/face_contact.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "graders/solids.hpp"
#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of coordinates of this size";

using Contact = std::vector<FacePoint>;

// The same contact, begun at the point that lies farthest in a fixed slanted direction.
Contact fromOneCorner(Contact contact) {
  const Vector3 direction(0.8, -0.35, 0.49);
  const auto first =
      std::max_element(contact.begin(), contact.end(), [&](const FacePoint& p, const FacePoint& q) {
        return direction.dot(p.position) < direction.dot(q.position);
      });
  std::rotate(contact.begin(), first, contact.end());
  return contact;
}

// The top of a box, seen from above, and the bottom of one that stands on it.
Points rectangle(Real x0, Real y0, Real x1, Real y1, Real z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

const Vector3 up = Vector3::UnitZ();
const Points table = rectangle(0, 0, 4, 3, 1);

// Area that the points enclose, seen along the normal; -1 if they are fewer than three.
Real areaOf(const Contact& contact, const Vector3& normal) {
  if (contact.size() < 3) return -1;
  Vector3 doubled = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < contact.size(); ++i) {
    doubled += cross(contact[i].position - contact[0].position,
                     contact[i + 1].position - contact[0].position);
  }
  return std::abs(doubled.dot(normal)) / 2;
}

Real deepest(const Contact& contact) {
  Real depth = 1;
  for (const FacePoint& p : contact) depth = std::min(depth, p.separation);
  return depth;
}

void ask(const Points& incident, Real margin, const Contact& expected, const char* what) {
  GRADE(fromOneCorner(faceContact(table, up, incident, margin)), fromOneCorner(expected),
        within(2e-15, kRounding), given("reference", table, "m"), given("normal", up),
        given("incident", incident, "m"), given("margin", margin, "m"), unit("m"), about(what));
}

}  // namespace

TEST_CASE("corners") {
  ask(rectangle(1, 1, 3, 2, 0.875), 0,
      {{{1, 1, 0.875}, -0.125},
       {{3, 1, 0.875}, -0.125},
       {{3, 2, 0.875}, -0.125},
       {{1, 2, 0.875}, -0.125}},
      "a small face wholly over the reference face");
  ask(rectangle(3, 1, 6, 5, 0.75), 0,
      {{{3, 1, 0.75}, -0.25}, {{4, 1, 0.75}, -0.25}, {{4, 3, 0.75}, -0.25}, {{3, 3, 0.75}, -0.25}},
      "a face that reaches over two edges");
  ask(rectangle(-1, -1, 5, 4, 1), 0,
      {{{0, 0, 1}, 0}, {{4, 0, 1}, 0}, {{4, 3, 1}, 0}, {{0, 3, 1}, 0}},
      "a large face that covers the reference face: no corner of it lies above");
}

TEST_CASE("depths") {
  ask({{1, 1, 0.75}, {3, 1, 0.75}, {3, 2, 1.25}, {1, 2, 1.25}}, 0,
      {{{1, 1, 0.75}, -0.25}, {{3, 1, 0.75}, -0.25}},
      "a tilted face: two corners are in, two stick out above and are no contact");
  ask({{1, 1, 0.75}, {3, 1, 0.75}, {3, 2, 1.25}, {1, 2, 1.25}}, 0.5,
      {{{1, 1, 0.75}, -0.25}, {{3, 1, 0.75}, -0.25}, {{3, 2, 1.25}, 0.25}, {{1, 2, 1.25}, 0.25}},
      "the same with a margin of 0.5 m: points just above count, and have a positive separation");
  ask({{1, 1, 0.5}, {3, 1, 0.75}, {3, 2, 1}, {1, 2, 0.75}}, 0,
      {{{1, 1, 0.5}, -0.5}, {{3, 1, 0.75}, -0.25}, {{3, 2, 1}, 0}, {{1, 2, 0.75}, -0.25}},
      "each corner has a depth of its own");
}

TEST_CASE("turned") {
  const Real root2 = std::sqrt(2.0);
  Random random(seed());
  for (int n = 0; n < 8; ++n) {
    const Matrix3 R = anyTurn(random, 0, 3);
    const Vector3 place = random.vector(3);
    const Points square = rectangle(-1, -1, 1, 1, 0);
    const Points eighth =
        moved(rectangle(-1, -1, 1, 1, 0), turn(up, std::acos(-1.0) / 4), {0, 0, -0.1});
    const Points reference = moved(square, R, place);
    const Points incident = moved(eighth, R, place);
    const Vector3 normal = R.col(2);
    GRADE(faceContact(reference, normal, incident, 0).size(), std::size_t{8}, within(0, "a count"),
          given("reference", reference, "m"), given("normal", normal),
          given("incident", incident, "m"),
          about("a square on a square, turned by 45 degrees: an octagon"));
    GRADE(areaOf(faceContact(reference, normal, incident, 0), normal), 8 * (root2 - 1),
          within(1e-13, kRounding), given("reference", reference, "m"), given("normal", normal),
          given("incident", incident, "m"), unit("m^2"), about("area of the octagon"));
    GRADE(deepest(faceContact(reference, normal, incident, 0)), -0.1, within(1e-14, kRounding),
          given("reference", reference, "m"), given("normal", normal),
          given("incident", incident, "m"), unit("m"), about("deepest point"));
  }
}

TEST_CASE("none") {
  GRADE(faceContact(table, up, rectangle(5, 0, 6, 2, 0.5), 0).size(), std::size_t{0},
        within(0, "a count"), given("reference", table, "m"),
        given("incident", rectangle(5, 0, 6, 2, 0.5), "m"), about("beside the reference face"));
  GRADE_REFUSES(faceContact(Points{{0, 0, 0}, {1, 0, 0}}, up, table, 0),
                about("a reference face of two corners"));
}

PROBES() {
  Random random(404);
  for (int n = 0; n < 16; ++n) {
    const Matrix3 R = anyTurn(random, 0, 0.3);
    const Real x = random.between(-1, 3), y = random.between(-1, 2);
    const Real front = -random.between(1, 2), left = -random.between(1, 2);
    const Points incident = moved(rectangle(left, front, 1.5, 1, 0), R, {x, y, 0.9});
    // Below the origin and above it.
    const Vector3 lift(0, 0, n % 2 ? -1.5 : 0);
    PROBE(faceContact(moved(table, Matrix3::Identity(), lift), up,
                      moved(incident, Matrix3::Identity(), lift), 0));
  }
}
