// Group C of the case book, each to the error that an excellent program reaches.

#include <cmath>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/errors.hpp"
#include "carom/manifold/clip_polygon.hpp"
#include "carom/manifold/collide_boxes.hpp"
#include "carom/manifold/collide_half_space.hpp"
#include "carom/manifold/collide_hulls.hpp"
#include "carom/manifold/contact_ids.hpp"
#include "carom/manifold/edge_contact.hpp"
#include "carom/manifold/face_contact.hpp"
#include "carom/manifold/least_displacement.hpp"
#include "carom/manifold/loop_manifold.hpp"
#include "carom/manifold/orient_normal.hpp"
#include "carom/manifold/plain_manifold.hpp"
#include "carom/manifold/polygon_centroid.hpp"
#include "carom/manifold/reduce_contacts.hpp"
#include "manifold_reference.hpp"

using namespace carom;
using namespace carom_test;

namespace {

constexpr Real kUlp = 2.220446049250313e-16;

using Points = std::vector<Vector3>;

// What a polygon and a counter-clockwise convex one at z = 0 have in common.
Points common(Points polygon, const Points& window) {
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Vector3 edge = window[(i + 1) % window.size()] - window[i];
    const Vector3 outward(edge.y(), -edge.x(), 0);
    polygon = clipPolygon(polygon, outward, outward.dot(window[i]));
  }
  return polygon;
}

Points square(Real half) {
  return {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
}

Points rectangle(Real x0, Real x1, Real y0, Real y1) {
  return {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
}

// Every expected corner is there, and nothing else.
void checkCorners(const Points& got, const Points& expected, Real tolerance) {
  REQUIRE(got.size() == expected.size());
  for (const Vector3& corner : expected) {
    Real nearest = 1e300;
    for (const Vector3& other : got) nearest = std::min(nearest, (other - corner).norm());
    CHECK(nearest <= tolerance);
  }
}

Vector3 meanOf(const Points& points) {
  Vector3 sum = Vector3::Zero();
  for (const Vector3& point : points) sum += point;
  return sum / static_cast<Real>(points.size());
}

Pose turnedAboutZ(Real angle, const Vector3& place) {
  return poseOf({std::cos(angle / 2), 0, 0, std::sin(angle / 2)}, place);
}

}  // namespace

TEST_CASE("C1: a square turned by 45 degrees leaves an octagon") {
  const json expected = manifoldCase("C1");
  const Real s = std::sqrt(0.5);
  const Points turned = {{0, -2 * s, 0}, {2 * s, 0, 0}, {0, 2 * s, 0}, {-2 * s, 0, 0}};
  const Points octagon = common(turned, square(1));
  CHECK(octagon.size() == 8);
  const PolygonArea area = polygonCentroid(octagon);
  CHECK(std::abs(area.area / readNumber(expected["area"]) - 1) <= 1e-15);
  CHECK(area.centroid.norm() <= 1e-16);
  for (std::size_t i = 0; i < 8; ++i) {
    const Real side = (octagon[(i + 1) % 8] - octagon[i]).norm();
    CHECK(std::abs(side - readNumber(expected["side"])) <= 1e-15);
  }
}

TEST_CASE("C1: the same with cubes on each other: area of the whole, four points at its corners") {
  const json expected = manifoldCase("C1");
  const Box cube{{1, 1, 1}};
  const Pose A;
  const Pose B = turnedAboutZ(std::atan(1.0), {0, 0, 2});
  const ConvexHull hull = boxHull(cube.halfExtents);
  for (const Manifold& manifold :
       {collideBoxes(cube, A, cube, B), collideHulls(hull, A, hull, B),
        collideBoxAndHull(cube, A, hull, B), plainManifold(hull, A, hull, B)}) {
    CHECK(manifold.normal == Vector3(0, 0, 1));
    REQUIRE(manifold.count == 4);
    CHECK(std::abs(manifold.area / readNumber(expected["area"]) - 1) <= 2e-15);
    CHECK((manifold.areaCentroid - Vector3(0, 0, 1)).norm() <= 3e-16);
    for (const ManifoldPoint& point : manifold.points) {
      CHECK(point.separation == 0);
      // On a corner of the octagon.
      const Real x = std::abs(point.position.x()), y = std::abs(point.position.y());
      CHECK(std::abs(std::max(x, y) - 1) <= 1e-15);
      CHECK(std::abs(std::min(x, y) - (std::sqrt(2.0) - 1)) <= 1e-15);
    }
    CHECK(namesDiffer(manifold));
  }
}

TEST_CASE("C2: offset rectangles") {
  const json expected = manifoldCase("C2");
  const Points both = common(rectangle(1.5, 4, 1.0 / 3, 3), rectangle(0, 2, 0, 1));
  const PolygonArea area = polygonCentroid(both);
  CHECK(both.size() == 4);
  CHECK(std::abs(area.area - readNumber(expected["area"])) <= kUlp / 2);
  CHECK((area.centroid - flat(expected["centroid"])).cwiseAbs().maxCoeff() <= kUlp);
}

TEST_CASE("C3: the centroid is not the mean of the corners") {
  const json expected = manifoldCase("C3");
  const Points triangle = {{0, 0, 0}, {3, 1, 0}, {1, 3, 0}};
  const Points both = common(triangle, square(1));
  checkCorners(both, flatCorners(expected["corners"]), 2e-16);
  const PolygonArea area = polygonCentroid(both);
  CHECK(std::abs(area.area - readNumber(expected["area"])) <= 2e-16);
  CHECK((area.centroid - flat(expected["centroid"])).norm() <= 2e-16);
  CHECK((meanOf(both) - flat(expected["wrong"]["vertex mean"])).norm() <= 2e-16);
}

TEST_CASE("C4: two quadrilaterals in general position") {
  const json expected = manifoldCase("C4");
  const Points other = {{1, -1, 0}, {5, 1, 0}, {4, 4, 0}, {-1, 2, 0}};
  const Points both = common(other, rectangle(0, 4, 0, 3));
  checkCorners(both, flatCorners(expected["corners"]), 1e-15);
  const PolygonArea area = polygonCentroid(both);
  CHECK(std::abs(area.area / readNumber(expected["area"]) - 1) <= 4e-16);
  const Vector3 centroid = flat(expected["centroid"]);
  CHECK((area.centroid - centroid).norm() <= 4e-16 * centroid.norm());
  CHECK((meanOf(both) - flat(expected["wrong"]["vertex mean"])).norm() <= 1e-15);
}

TEST_CASE("C5: a box that tilts by a billionth keeps its four points") {
  const json expected = manifoldCase("C5");
  const HalfSpace floor{{0, 1, 0}, 0};
  const Box box{{1, 0.5, 1}};
  const Pose here;
  std::set<std::uint32_t> names[2];
  for (const int side : {0, 1}) {
    const Real angle = side == 0 ? 1e-9 : -1e-9;
    const Pose B = turnedAboutZ(angle, {0, 0.5 - 1e-6, 0});
    const Manifold manifold = collideHalfSpace(floor, here, box, B);
    CHECK(manifold.normal == Vector3(0, 1, 0));
    REQUIRE(manifold.count == 4);
    for (const ManifoldPoint& point : manifold.points) {
      const bool left = point.position.x() < 0;
      const char* name = left == (side == 0) ? "left depth" : "right depth";
      CHECK(std::abs(point.separation + readNumber(expected[name])) <= 1e-15);
      if (left && side == 0) {
        CHECK(std::abs(point.position.x() - readNumber(expected["left x"])) <= 1e-15);
      }
      names[side].insert(point.id);
    }
    CHECK(std::abs(manifold.area - 4) <= 4e-15);
  }
  CHECK(names[0] == names[1]);
  CHECK(names[0].size() == 4);
}

TEST_CASE(
    "C6: the contact lies beside the axis through the centre, or it could not turn the body") {
  const json expected = manifoldCase("C6");
  const Box cube{{1, 1, 1}};
  const Pose A;
  Pose B;
  B.p_WB = {1.9, 1.5, 0};
  const ConvexHull hull = boxHull(cube.halfExtents);
  for (const Manifold& manifold : {collideBoxes(cube, A, cube, B), collideHulls(hull, A, hull, B),
                                   plainManifold(hull, A, hull, B)}) {
    CHECK(manifold.normal == Vector3(1, 0, 0));
    CHECK(manifold.count == 4);
    CHECK((manifold.areaCentroid - readVector(expected["centroid"])).norm() <= 1e-15);
    const Vector3 lever = cross(manifold.areaCentroid, manifold.normal);
    CHECK((lever - readVector(expected["r x n"])).norm() <= 1e-15);
    CHECK(std::abs(manifold.area - 1) <= 2e-15);
  }
}

TEST_CASE("C7: two crossing edges") {
  const json expected = manifoldCase("C7");
  const Vector3 a0(0, 0, 0), a1(4, 2, 1), b0(3, -1, 1.2), b1(1, 3, 0.7);
  const EdgeContact contact = edgeContact(a0, a1, b0, b1, {0, 0, 1});
  CHECK(std::abs(contact.s - readNumber(expected["s"])) <= 1e-15);
  CHECK(std::abs(contact.t - readNumber(expected["t"])) <= 1e-15);
  CHECK((contact.pointA - readVector(expected["point A"])).norm() <= 1e-15);
  CHECK((contact.pointB - readVector(expected["point B"])).norm() <= 1e-15);
  CHECK((contact.normal - readVector(expected["normal"])).norm() <= 1e-15);
  CHECK(std::abs(contact.separation - readNumber(expected["distance"])) <= 1e-15);
  // With the axis reversed the bodies overlap by as much as they were apart.
  const EdgeContact other = edgeContact(a0, a1, b0, b1, {0, 0, -1});
  CHECK(other.normal == -contact.normal);
  CHECK(other.separation == -contact.separation);
}

TEST_CASE("C7: parallel edges touch amid their common part") {
  const EdgeContact contact =
      edgeContact({0, 0, 0}, {4, 0, 0}, {3, 0, 0.5}, {9, 0, 0.5}, {0, 0, 1});
  CHECK(contact.normal == Vector3(0, 0, 1));
  CHECK((contact.pointA - Vector3(3.5, 0, 0)).norm() <= 1e-15);
  CHECK((contact.pointB - Vector3(3.5, 0, 0.5)).norm() <= 1e-15);
  CHECK(contact.separation == 0.5);
  CHECK_THROWS_AS(edgeContact({1, 1, 1}, {1, 1, 1}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}), InvalidInput);
}

TEST_CASE("C8: the points of a box on a plane can hold a load beside its centre") {
  const json expected = manifoldCase("C8");
  const HalfSpace floor{{0, 1, 0}, 0};
  const Box box{{1, 0.5, 1}};
  Pose B;
  B.p_WB = {0, 0.5, 0};
  const Manifold manifold = collideHalfSpace(floor, Pose(), box, B);
  REQUIRE(manifold.count == 4);
  // Statics: the two sides share the weight at x = 0 and the load at x = d by their levers.
  Real left = 0, right = 0;
  for (const ManifoldPoint& point : manifold.points) {
    left = std::min(left, point.position.x());
    right = std::max(right, point.position.x());
  }
  const Real d = readNumber(expected["load x"]);
  const Real onRight = ((0 - left) + (d - left)) / (right - left);
  CHECK(std::abs(onRight - readNumber(expected["force at +1"])) <= 1e-14);
  CHECK(std::abs(2 - onRight - readNumber(expected["force at -1"])) <= 1e-14);
}

TEST_CASE("C9: clips that leave a square, a line, a point, or nothing") {
  const json expected = manifoldCase("C9");
  const Points window = rectangle(0, 2, 0, 2);
  const Points whole = common(window, window);
  CHECK(whole.size() == 4);
  CHECK(polygonCentroid(whole).area == 4);

  const Points line = common(flatCorners(expected["b"]["other"]), window);
  checkCorners(line, flatCorners(expected["b"]["points"]), 0);
  CHECK(polygonCentroid(line).area == 0);
  CHECK(polygonCentroid(line).centroid == flat(expected["b"]["centroid"]));

  const Points point = common(flatCorners(expected["c"]["other"]), window);
  REQUIRE(point.size() == 1);
  CHECK(point[0] == flat(expected["c"]["point"]));
  CHECK(polygonCentroid(point).centroid == point[0]);

  CHECK(common(rectangle(3, 4, 3, 4), window).empty());
  CHECK(clipPolygon({}, {1, 0, 0}, 0).empty());
  CHECK_THROWS_AS(polygonCentroid({}), InvalidInput);
}

TEST_CASE("D18: no point of two boxes face on face is deeper than the boxes are") {
  // Another engine found a point one box width deep here, and threw the boxes apart.
  std::ifstream file(std::string(CAROM_CASES_DIR) + "/detection.json");
  const json expected = json::parse(file).at("D18").at("c");
  const Real depth = readNumber(expected["depth"]);
  const Real shift = std::ldexp(1.0, expected["shift pow2"].get<int>());
  const Real angle = std::ldexp(1.0, expected["angle pow2"].get<int>());
  const Box box{{0.5, 0.5, 0.5}};
  const ConvexHull hull = boxHull(box.halfExtents);
  const Pose A;
  const Pose B = poseOf({std::cos(angle / 2), 0, std::sin(angle / 2), 0}, {shift, 1 - depth, 0});
  for (const Manifold& manifold :
       {collideBoxes(box, A, box, B), collideHulls(hull, A, hull, B),
        collideBoxAndHull(box, A, hull, B), plainManifold(hull, A, hull, B, 0)}) {
    CHECK((manifold.normal - Vector3(0, 1, 0)).norm() <= 1e-15);
    CHECK(manifold.count == 4);
    for (std::size_t k = 0; k < static_cast<std::size_t>(manifold.count); ++k) {
      CHECK(std::abs(manifold.points[k].separation + depth) <= 1e-15);
    }
    // What two unit squares have in common that are a thousandth of an edge off each other.
    CHECK(manifold.area < 1 - shift / 2);
    CHECK(manifold.area > 1 - 2 * shift);
  }
}

TEST_CASE("C10: two 60-gons turned and shifted") {
  const json expected = manifoldCase("C10");
  Points first, second;
  for (int k = 0; k < 60; ++k) {
    const Real angle = k * (std::acos(-1.0) / 30);
    first.emplace_back(std::cos(angle), std::sin(angle), 0);
    const Real turned = angle + std::acos(-1.0) / 60;
    second.emplace_back(std::cos(turned) + 0.3, std::sin(turned) + 0.1, 0);
  }
  const Points both = common(second, first);
  CHECK(both.size() == expected["corners"].get<std::size_t>());
  const PolygonArea area = polygonCentroid(both);
  CHECK(std::abs(area.area - readNumber(expected["area"])) <= 1e-14);
  CHECK((area.centroid - flat(expected["centroid"])).norm() <= 1e-14);
  CHECK(area.area < readNumber(expected["lens"]));
}

TEST_CASE("least displacement: the push that frees, on axes of any length") {
  // A small square inside a large one: it shares its own width only, and has farther to go.
  const Points large = square(2), small = square(0.5);
  const Points axes = {{1, 0, 0}, {0, 3, 0}};
  const LeastDisplacement inside = leastDisplacement(axes, large, small);
  CHECK(inside.separation == -2.5);
  CHECK(inside.axis == 0);
  // On its second axis, three units long, the pair overlaps least: metres count, not the product.
  const Points shifted = rectangle(1.2, 3, -1, 1.6);
  const LeastDisplacement least = leastDisplacement(axes, large, shifted);
  CHECK(std::abs(least.separation + 0.8) <= kUlp);
  CHECK(least.normal == Vector3(1, 0, 0));
  const Points low = rectangle(-3, 3, -3, -1.5);
  CHECK(leastDisplacement(axes, large, low).normal == Vector3(0, -1, 0));
  CHECK(leastDisplacement(axes, large, rectangle(5, 6, 0, 1)).separation == 3);
  const Points none = {Vector3::Zero()};
  CHECK_THROWS_AS(leastDisplacement(none, large, small), InvalidInput);
  CHECK_THROWS_AS(leastDisplacement({}, large, small), InvalidInput);
}

TEST_CASE("the normal points to the shorter way out, not from centre to centre") {
  const Points beam = rectangle(-10, 1, 0, 1), post = rectangle(0.8, 3, -5, 5);
  CHECK(orientNormal({1, 0, 0}, beam, post) == Vector3(1, 0, 0));
  CHECK(orientNormal({-1, 0, 0}, beam, post) == Vector3(1, 0, 0));
  CHECK(orientNormal({-1, 0, 0}, post, beam) == Vector3(-1, 0, 0));
  // The centre of a wedge lies towards its thick end; a block left of it is nearer to that end all
  // the same.
  const Points wedge = {{0, 0, 0}, {10, -1, 0}, {10, 1, 0}}, block = rectangle(4, 8, -1, 1);
  CHECK(meanOf(block).x() < meanOf(wedge).x());
  CHECK(orientNormal({1, 0, 0}, wedge, block) == Vector3(1, 0, 0));
  CHECK_THROWS_AS(orientNormal({1, 0, 0}, {}, wedge), InvalidInput);
}

TEST_CASE("face contact: what lies over a face, with its heights") {
  const Points reference = square(1);
  // Tilted: at x = -1 it dips 0.2 below the face, at x = 1 it is 0.2 above.
  const Points incident = {{-2, -2, -0.4}, {2, -2, 0.4}, {2, 2, 0.4}, {-2, 2, -0.4}};
  const std::vector<FacePoint> points = faceContact(reference, {0, 0, 1}, incident);
  REQUIRE(points.size() == 2);
  for (const FacePoint& point : points) {
    CHECK(std::abs(point.position.x() + 1) <= kUlp);
    CHECK(std::abs(std::abs(point.position.y()) - 1) <= kUlp);
    CHECK(std::abs(point.separation + 0.2) <= kUlp);
  }
  CHECK(faceContact(reference, {0, 0, 1}, incident, 0.3).size() == 4);
  CHECK(faceContact(reference, {0, 0, 1}, Points{{5, 5, -1}, {6, 5, -1}, {5, 6, -1}}).empty());
  CHECK_THROWS_AS(faceContact(Points{{0, 0, 0}, {1, 0, 0}}, {0, 0, 1}, incident), InvalidInput);
}

TEST_CASE("four points keep the largest area, and the deepest stays") {
  Points octagon;
  std::vector<Real> separations(8, -0.01);
  for (int k = 0; k < 8; ++k) {
    const Real angle = (k + 0.5) * std::acos(-1.0) / 4;
    octagon.emplace_back(2 * std::cos(angle), std::sin(angle), 0);
  }
  const auto areaOf = [&](const std::vector<int>& chosen) {
    Points four;
    for (const int i : chosen) four.push_back(octagon[static_cast<std::size_t>(i)]);
    return polygonCentroid(four).area;
  };
  const std::vector<int> chosen = reduceContacts(octagon, separations);
  REQUIRE(chosen.size() == 4);
  Real largest = 0;
  for (int a = 0; a < 8; ++a) {
    for (int b = a + 1; b < 8; ++b) {
      for (int c = b + 1; c < 8; ++c) {
        for (int d = c + 1; d < 8; ++d) largest = std::max(largest, areaOf({a, b, c, d}));
      }
    }
  }
  CHECK(std::abs(areaOf(chosen) - largest) <= 1e-15);

  for (int deepest = 0; deepest < 8; ++deepest) {
    std::vector<Real> deep = separations;
    deep[static_cast<std::size_t>(deepest)] = -0.02;
    const std::vector<int> with = reduceContacts(octagon, deep);
    CHECK(with.size() == 4);
    CHECK(std::count(with.begin(), with.end(), deepest) == 1);
    CHECK(std::is_sorted(with.begin(), with.end()));
    CHECK(areaOf(with) >= 0.6 * largest);
  }
  CHECK(reduceContacts(Points(3, Vector3::Zero()), std::vector<Real>(3, 0)).size() == 3);
  CHECK_THROWS_AS(reduceContacts(octagon, std::vector<Real>(3, 0)), InvalidInput);
}

TEST_CASE("names of contacts: different features, different names, swapped with the bodies") {
  std::vector<FeaturePair> pairs;
  for (const FeatureKind kind :
       {FeatureKind::surface, FeatureKind::vertex, FeatureKind::edge, FeatureKind::face}) {
    for (const std::uint32_t i : {0u, 1u, 16383u}) {
      for (const std::uint32_t j : {0u, 2u, 16383u}) {
        pairs.push_back({{kind, i}, {FeatureKind::face, j}});
      }
    }
  }
  const std::vector<std::uint32_t> ids = contactIds(pairs);
  CHECK(std::set<std::uint32_t>(ids.begin(), ids.end()).size() == pairs.size());
  std::vector<FeaturePair> swapped;
  for (const FeaturePair& pair : pairs) swapped.push_back({pair.onB, pair.onA});
  const std::vector<std::uint32_t> other = contactIds(swapped);
  for (std::size_t k = 0; k < ids.size(); ++k) CHECK(other[k] == swappedId(ids[k]));
  const std::vector<FeaturePair> large = {{{FeatureKind::vertex, 16384}, {}}};
  CHECK_THROWS_WITH(contactIds(large), ContainsSubstring("16384"));
}

TEST_CASE("the fast choice of four corners spans what the plain one spans") {
  Random random(71);
  Real worst = 0;
  int dropsDeepest = 0;
  for (int n = 0; n < 500; ++n) {
    // Corners on an ellipse, counter-clockwise.
    const Real a = random.between(0.3, 1), b = random.between(0.3, 1);
    detail::ClipCorner loop[32];
    Points corners;
    std::vector<Real> separations;
    int index[32];
    int count = 0;
    for (Real angle = random.between(0, 0.5); angle < 6.2 && count < 32;
         angle += random.between(0.1, 0.9)) {
      loop[count] = {a * std::cos(angle), b * std::sin(angle), random.between(-1, 0), 0};
      corners.emplace_back(loop[count].x, loop[count].y, 0);
      separations.push_back(loop[count].height);
      index[count] = count;
      ++count;
    }
    int chosen[4];
    detail::reduceLoop(loop, index, count, chosen);
    Points fast, plain;
    bool deepestThere = false;
    const Real deepest = *std::min_element(separations.begin(), separations.end());
    for (const int i : chosen) {
      fast.push_back(corners[static_cast<std::size_t>(i)]);
      deepestThere |= separations[static_cast<std::size_t>(i)] == deepest;
    }
    for (const int i : reduceContacts(corners, separations)) {
      plain.push_back(corners[static_cast<std::size_t>(i)]);
    }
    worst = std::max(worst, std::abs(polygonCentroid(fast).area / polygonCentroid(plain).area - 1));
    dropsDeepest += deepestThere ? 0 : 1;
  }
  CHECK(worst <= 2e-6);
  CHECK(dropsDeepest == 0);
}
