// Grader of 04.least_displacement: boxes along the axes, whose ways out can be read off, axes of
// all lengths, and clouds that have been given a known way out.

#include "carom/manifold/least_displacement.hpp"

#include <cmath>

#include "graders/solids.hpp"
#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kRounding = "a few roundings of coordinates of this size";

const Points world = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Points cube = boxBetween({-1, -1, -1}, {1, 1, 1});

// What must come out for boxes along the axes, by comparing the six ways.
LeastDisplacement byHand(const Vector3& lowB, const Vector3& highB) {
  LeastDisplacement best{{0, 0, 0}, -1e300, -1};
  for (int k = 0; k < 3; ++k) {
    const Real up = lowB[k] - 1, down = -1 - highB[k];
    if (std::max(up, down) > best.separation) {
      best.separation = std::max(up, down);
      best.normal = Vector3::Zero();
      best.normal[k] = up >= down ? 1 : -1;
      best.axis = k;
    }
  }
  return best;
}

void askBox(const Points& axes, const Vector3& low, const Vector3& high, const char* what) {
  const LeastDisplacement expected = byHand(low, high);
  const Points b = boxBetween(low, high);
  GRADE(leastDisplacement(axes, cube, b).separation, expected.separation, within(4e-15, kRounding),
        given("axes", axes), given("a", "the cube [-1,1]^3"), given("low corner of b", low, "m"),
        given("high corner of b", high, "m"), unit("m"), about(what));
  GRADE(leastDisplacement(axes, cube, b).normal, expected.normal, within(4e-15, kRounding),
        given("axes", axes), given("a", "the cube [-1,1]^3"), given("low corner of b", low, "m"),
        given("high corner of b", high, "m"), about(what));
  GRADE(leastDisplacement(axes, cube, b).axis, expected.axis, within(0, "the number of an axis"),
        given("axes", axes), given("a", "the cube [-1,1]^3"), given("low corner of b", low, "m"),
        given("high corner of b", high, "m"), about(what));
}

Points anyAxes(Random& random, int count) {
  Points all;
  for (int k = 0; k < count; ++k) all.push_back(anyVector(random, 0.2, 4));
  return all;
}

Points cloud(Random& random, const Vector3& center) {
  Points all;
  for (int k = 0; k < 6; ++k) all.push_back(center + random.vector());
  return all;
}

Points pushed(const Points& points, const Vector3& by) {
  Points all;
  for (const Vector3& p : points) all.push_back(p + by);
  return all;
}

// After the push of an answer no axis may show a shorter way than before, and its own axis shows
// none at all. Written as the separation that the same function finds then.
LeastDisplacement afterPush(const Points& axes, const Points& a, const Points& b) {
  const LeastDisplacement d = leastDisplacement(axes, a, b);
  return leastDisplacement(axes, a, pushed(b, -d.separation * d.normal));
}

}  // namespace

TEST_CASE("boxes") {
  askBox(world, {0.5, -3, -3}, {4, 3, 3}, "0.5 m to the right, and nothing else is shorter");
  askBox(world, {-3, -4, -3}, {3, -0.75, 3},
         "downwards along y: the normal is the way B has to go");
  askBox(world, {-0.5, -0.5, 1.25}, {0.5, 0.5, 2}, "they are apart");
}

TEST_CASE("lengths") {
  const Points axes = {{4, 0, 0}, {0, 0.25, 0}, {0, 0, 3}};
  askBox(axes, {0.5, 0.25, -3}, {4, 4, 3}, "axes of other lengths, but the bodies are the same");
  askBox(axes, {-3, -3, -3}, {3, -0.875, 3}, "axes of other lengths, but the bodies are the same");
  askBox(axes, {-3, -3, -3}, {-0.375, 3, 3}, "axes of other lengths, but the bodies are the same");
}

TEST_CASE("inside") {
  askBox(world, {-0.25, -0.5, -0.25}, {0.25, 0.75, 0.25},
         "b lies wholly inside a: it has to come out with its far side");
  askBox(world, {-4, -0.25, -0.25}, {4, 0.5, 0.25}, "a beam through the cube");
  askBox(world, {0, 0.125, 0.25}, {0.5, 0.25, 0.5}, "b lies wholly inside a, near a corner");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 15; ++n) {
    const Points axes = anyAxes(random, 7);
    const Points a = cloud(random, {0, 0, 0}), b = cloud(random, random.vector());
    // Along one of the axes the bodies are given a way out of known length, shorter than any other.
    const int chosen = random.integer(0, 6);
    const Vector3 way = axes[static_cast<std::size_t>(chosen)].normalized();
    const Real depth = random.between(0.001, 0.01);
    Real highA = -1e300, lowB = 1e300;
    for (const Vector3& p : a) highA = std::max(highA, way.dot(p));
    for (const Vector3& p : b) lowB = std::min(lowB, way.dot(p));
    const Points placed = pushed(b, (highA - depth - lowB) * way);
    bool shortest = true;
    for (const Vector3& axis : axes) {
      Real low1 = 1e300, high1 = -1e300, low2 = 1e300, high2 = -1e300;
      for (const Vector3& p : a) {
        low1 = std::min(low1, axis.normalized().dot(p));
        high1 = std::max(high1, axis.normalized().dot(p));
      }
      for (const Vector3& p : placed) {
        low2 = std::min(low2, axis.normalized().dot(p));
        high2 = std::max(high2, axis.normalized().dot(p));
      }
      const bool isChosen = &axis == &axes[static_cast<std::size_t>(chosen)];
      shortest = shortest && (isChosen || std::max(low2 - high1, low1 - high2) < -2 * depth);
    }
    if (!shortest) continue;
    GRADE(leastDisplacement(axes, a, placed).separation, -depth, within(1e-14, kRounding),
          given("axes", axes), given("a", a, "m"), given("b", placed, "m"), unit("m"));
    GRADE(leastDisplacement(axes, a, placed).normal, way, within(1e-14, kRounding),
          given("axes", axes), given("a", a, "m"), given("b", placed, "m"));
  }
  for (int n = 0; n < 8; ++n) {
    const Points axes = anyAxes(random, 5);
    const Points a = cloud(random, {0, 0, 0}), b = cloud(random, 0.3 * random.vector());
    GRADE(std::abs(afterPush(axes, a, b).separation) < 1e-14, true, within(0, "yes or no"),
          given("axes", axes), given("a", a, "m"), given("b", b, "m"),
          about("after B has gone its way they just touch"));
  }
}

TEST_CASE("refuses") {
  GRADE_REFUSES(leastDisplacement(Points{}, cube, cube), about("no axis at all"));
  GRADE_REFUSES(leastDisplacement(Points{{0, 0, 0}}, cube, cube), given("axis", Vector3(0, 0, 0)));
}

PROBES() {
  Random random(401);
  for (int n = 0; n < 20; ++n) {
    const Points axes = anyAxes(random, 4);
    const Points a = cloud(random, {0, 0, 0});
    PROBE(leastDisplacement(axes, a, cloud(random, 0.7 * random.vector())));
  }
  PROBE(leastDisplacement(world, cube, boxBetween({-0.25, -0.5, -0.25}, {0.25, 0.75, 0.25})));
}
