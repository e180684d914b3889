// Grader of 04.edge_contact: edges of which the common perpendicular is known, parallel edges, and
// edges that have been made around a perpendicular.

#include "carom/manifold/edge_contact.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of coordinates of this size";

struct Edges {
  Vector3 a0, a1, b0, b1, axis;
};

// Given: two edges whose nearest points are halfway or so along each, `gap` apart along a normal.
struct Made {
  Edges edges;
  EdgeContact contact;
};

Made madeEdges(Random& random) {
  const Vector3 n = random.direction();
  const Vector3 u =
      cross(n, std::abs(n.x()) < 0.7 ? Vector3::UnitX() : Vector3::UnitY()).normalized();
  const Vector3 w = cross(n, u);
  const Real angle = random.between(0.3, 2.8);
  const Vector3 v = (random.integer(0, 1) ? 1 : -1) * (std::cos(angle) * u + std::sin(angle) * w);
  Made made;
  EdgeContact& c = made.contact;
  c.normal = n;
  c.separation = random.between(-0.4, 0.4);
  c.pointA = random.vector(2);
  c.pointB = c.pointA + c.separation * n;
  c.s = random.between(0.1, 0.9);
  c.t = random.between(0.1, 0.9);
  const Real lengthA = random.between(0.5, 3), lengthB = random.between(0.5, 3);
  Edges& e = made.edges;
  e.a0 = c.pointA - c.s * lengthA * u;
  e.a1 = e.a0 + lengthA * u;
  e.b0 = c.pointB - c.t * lengthB * v;
  e.b1 = e.b0 + lengthB * v;
  // Roughly from A to B: a mean of normals of faces, tilted by up to half a right angle.
  e.axis = (n + 0.7 * random.direction()).normalized();
  return made;
}

EdgeContact contactOf(const Edges& e) {
  return edgeContact(e.a0, e.a1, e.b0, e.b1, e.axis);
}

}  // namespace

TEST_CASE("crossing") {
  // Lengths of 4.58 m and 4.50 m, 0.4366 m apart.
  const Edges e = {{0, 0, 0}, {4, 2, 1}, {3, -1, 1.2}, {1, 3, 0.7}, {0, 0.6, 0.8}};
  const Vector3 pointA(2.084705882352941, 1.0423529411764705, 0.5211764705882352);
  const Vector3 pointB(1.9788235294117646, 1.0423529411764705, 0.9447058823529412);
  GRADE(contactOf(e).pointA, pointA, within(2e-15, kRounding), given("a0", e.a0, "m"),
        given("a1", e.a1, "m"), given("b0", e.b0, "m"), given("b1", e.b1, "m"),
        given("axis", e.axis), unit("m"));
  GRADE(contactOf(e).pointB, pointB, within(2e-15, kRounding), given("a0", e.a0, "m"),
        given("a1", e.a1, "m"), given("b0", e.b0, "m"), given("b1", e.b1, "m"),
        given("axis", e.axis), unit("m"));
  GRADE(contactOf(e).normal, Vector3(-0.24253562503633297, 0, 0.9701425001453319),
        within(2e-15, kRounding), given("a0", e.a0, "m"), given("a1", e.a1, "m"),
        given("b0", e.b0, "m"), given("b1", e.b1, "m"), given("axis", e.axis),
        about("unit, square to both edges, from A to B"));
  GRADE(contactOf(e).separation, 0.43656412506539935, within(2e-15, kRounding),
        given("a0", e.a0, "m"), given("a1", e.a1, "m"), given("b0", e.b0, "m"),
        given("b1", e.b1, "m"), given("axis", e.axis), unit("m"));
}

TEST_CASE("parallel") {
  const Vector3 up(0, 0, 1);
  const Edges side = {{0, 0, 0}, {4, 0, 0}, {1, 0, -0.25}, {7, 0, -0.25}, up};
  GRADE(contactOf(side).pointA, Vector3(2.5, 0, 0), within(1e-15, kRounding),
        given("a0", side.a0, "m"), given("a1", side.a1, "m"), given("b0", side.b0, "m"),
        given("b1", side.b1, "m"), given("axis", up), unit("m"),
        about("side by side from x = 1 m to x = 4 m: the middle of that"));
  GRADE(contactOf(side).pointB, Vector3(2.5, 0, -0.25), within(1e-15, kRounding),
        given("a0", side.a0, "m"), given("a1", side.a1, "m"), given("b0", side.b0, "m"),
        given("b1", side.b1, "m"), given("axis", up), unit("m"), about("opposite the point on A"));
  GRADE(contactOf(side).separation, -0.25, within(1e-15, kRounding), given("a0", side.a0, "m"),
        given("a1", side.a1, "m"), given("b0", side.b0, "m"), given("b1", side.b1, "m"),
        given("axis", up), unit("m"));
  // The same with B's edge the other way round, and any turn of the axis square to the edges.
  const Edges back = {{0, 0, 0}, {4, 0, 0}, {7, 0.3, 0.4}, {1, 0.3, 0.4}, {0, 0.6, 0.8}};
  GRADE(contactOf(back).pointB, Vector3(2.5, 0.3, 0.4), within(1e-15, kRounding),
        given("a0", back.a0, "m"), given("a1", back.a1, "m"), given("b0", back.b0, "m"),
        given("b1", back.b1, "m"), given("axis", back.axis), unit("m"));
  GRADE(contactOf(back).normal, back.axis, within(1e-15, kRounding), given("a0", back.a0, "m"),
        given("a1", back.a1, "m"), given("b0", back.b0, "m"), given("b1", back.b1, "m"),
        given("axis", back.axis),
        about("parallel edges have no cross product: the axis is the normal"));
}

TEST_CASE("ends") {
  // Square to each other, so that where one edge ends does not move the point on the other.
  const Edges e = {{0, 0, 0}, {2, 0, 0}, {3, -1, 0.5}, {3, 1, 0.5}, {0, 0, 1}};
  GRADE(contactOf(e).pointA, Vector3(2, 0, 0), within(1e-15, kRounding), given("a0", e.a0, "m"),
        given("a1", e.a1, "m"), given("b0", e.b0, "m"), given("b1", e.b1, "m"),
        given("axis", e.axis), unit("m"),
        about("the lines come nearest beyond the end of A's edge: the point stays at the end"));
  GRADE(contactOf(e).pointB, Vector3(3, 0, 0.5), within(1e-15, kRounding), given("a0", e.a0, "m"),
        given("a1", e.a1, "m"), given("b0", e.b0, "m"), given("b1", e.b1, "m"),
        given("axis", e.axis), unit("m"));
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 20; ++n) {
    const Made made = madeEdges(random);
    const Edges& e = made.edges;
    GRADE(contactOf(e).normal, made.contact.normal, within(1e-13, kRounding),
          given("a0", e.a0, "m"), given("a1", e.a1, "m"), given("b0", e.b0, "m"),
          given("b1", e.b1, "m"), given("axis", e.axis),
          about("unit, square to both edges, from A to B"));
    GRADE(contactOf(e).separation, made.contact.separation, within(1e-13, kRounding),
          given("a0", e.a0, "m"), given("a1", e.a1, "m"), given("b0", e.b0, "m"),
          given("b1", e.b1, "m"), given("axis", e.axis), unit("m"));
    GRADE(contactOf(e).pointA, made.contact.pointA, within(1e-13, kRounding),
          given("a0", e.a0, "m"), given("a1", e.a1, "m"), given("b0", e.b0, "m"),
          given("b1", e.b1, "m"), given("axis", e.axis), unit("m"));
    GRADE(contactOf(e).t, made.contact.t, within(1e-12, kRounding), given("a0", e.a0, "m"),
          given("a1", e.a1, "m"), given("b0", e.b0, "m"), given("b1", e.b1, "m"),
          given("axis", e.axis), about("how far along B's edge its point lies, from 0 to 1"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(edgeContact({1, 2, 3}, {1, 2, 3}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}),
                about("A's edge has no length"));
}

PROBES() {
  Random random(405);
  for (int n = 0; n < 16; ++n) PROBE(contactOf(madeEdges(random).edges));
  PROBE(contactOf({{0, 0, 0}, {4, 0, 0}, {1, 0, -0.25}, {7, 0, -0.25}, {0, 0, 1}}));
  PROBE(contactOf({{0, 0, 0}, {2, 0, 0}, {3, -1, 0.5}, {3, 1, 0.5}, {0, 0, 1}}));
}
