// Grader of 04.polygon_centroid: polygons with fractions for answers, in the plane and under any
// turn, and what clipping leaves when it leaves no area.

#include "carom/manifold/polygon_centroid.hpp"

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

struct Known {
  const char* what;
  Points corners;
  Real area;
  Vector3 centroid;
};

const Known known[] = {
    {"a square with a triangle's corner in it",
     {{1, 1.0 / 3, 0}, {1, 1, 0}, {1.0 / 3, 1, 0}, {0, 0, 0}},
     2.0 / 3,
     {5.0 / 9, 5.0 / 9, 0}},
    {"two quadrilaterals, clipped: seven corners",
     {{1.0 / 3, 0, 0}, {3, 0, 0}, {4, 0.5, 0}, {4, 3, 0}, {1.5, 3, 0}, {0, 2.4, 0}, {0, 0.5, 0}},
     673.0 / 60,
     {24677.0 / 12114, 15016.0 / 10095, 0}},
    {"an L of three squares",
     {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
     3,
     {5.0 / 6, 5.0 / 6, 0}},
    {"a square with one edge cut up by two more corners",
     {{1, 1, 5}, {3, 1, 5}, {3, 3, 5}, {1.5, 3, 5}, {1.25, 3, 5}, {1, 3, 5}},
     4,
     {2, 2, 5}},
};

}  // namespace

TEST_CASE("known") {
  for (const Known& k : known) {
    for (const bool backwards : {false, true}) {
      Points corners = k.corners;
      if (backwards) std::reverse(corners.begin(), corners.end());
      GRADE(polygonCentroid(corners).centroid, k.centroid, within(2e-15, kRounding),
            given("polygon", corners, "m"), unit("m"), about(k.what));
    }
  }
}

TEST_CASE("area") {
  for (const Known& k : known) {
    GRADE(polygonCentroid(k.corners).area, k.area, within(4e-15, kRounding),
          given("polygon", k.corners, "m"), unit("m^2"), about(k.what));
  }
}

TEST_CASE("turned") {
  Random random(seed());
  for (int n = 0; n < 12; ++n) {
    const Known& k = known[n % 4];
    const Matrix3 R = anyTurn(random, 0.3, 3);
    const Vector3 place = random.vector(4);
    Points corners = moved(k.corners, R, place);
    GRADE(polygonCentroid(corners).centroid, Vector3(R * k.centroid + place),
          within(2e-14, kRounding), given("polygon", corners, "m"), unit("m"), about(k.what));
    GRADE(polygonCentroid(corners).area, k.area, within(4e-14, kRounding),
          given("polygon", corners, "m"), unit("m^2"), about(k.what));
  }
}

TEST_CASE("squeezed") {
  const Points segment = {{2, 1, 0}, {2, 2, 0}};
  GRADE(polygonCentroid(segment).centroid, Vector3(2, 1.5, 0), within(1e-15, kRounding),
        given("polygon", segment, "m"), unit("m"), about("two squares that share an edge"));
  const Points line = {{0, 0, 1}, {6, 3, 1}, {4, 2, 1}, {2, 1, 1}};
  GRADE(polygonCentroid(line).centroid, Vector3(3, 1.5, 1), within(2e-15, kRounding),
        given("polygon", line, "m"), unit("m"), about("there and back along one line"));
  const Points point = {{3, -1, 2}};
  GRADE(polygonCentroid(point).centroid, Vector3(3, -1, 2), within(0, "a copy"),
        given("polygon", point, "m"), unit("m"), about("two squares that share a corner"));
  const Points twice = {{3, -1, 2}, {3, -1, 2}, {3, -1, 2}};
  GRADE(polygonCentroid(twice).centroid, Vector3(3, -1, 2), within(0, "a copy"),
        given("polygon", twice, "m"), unit("m"), about("one point three times"));
}

TEST_CASE("refuses") {
  GRADE_REFUSES(polygonCentroid(Points{}), about("no corners at all"));
}

PROBES() {
  Random random(406);
  for (int n = 0; n < 16; ++n) {
    const Matrix3 R = anyTurn(random, 0.3, 3);
    const Vector3 place = random.vector(4);
    PROBE(polygonCentroid(moved(known[n % 2].corners, R, place)));
  }
  PROBE(polygonCentroid(Points{{2, 1, 0}, {2, 2, 0}}));
}
