// Detection in the plane, and the predicates of chapter 7, before a judge: CGAL's exact predicates,
// and distances in fractions.
//
// CAROM_ORACLE_PAIRS sets the number of pairs of each family, as in detection_oracle_test.cpp.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/planar_gjk.hpp"
#include "carom/detection/separate_polygons.hpp"
#include "carom/precision/exact_determinant.hpp"
#include "carom/precision/exact_orient2d.hpp"
#include "carom/precision/in_circle.hpp"
#include "carom/precision/orient2d_filtered.hpp"
#include "support/catch.hpp"

using carom::PlanarPose;
using carom::Random;
using carom::Real;
using carom::Vector2;
using carom::Vector3;
using carom::Verdict;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Corners = std::vector<Vector2>;  // strictly convex, counter-clockwise
using Pair = std::pair<Corners, Corners>;

constexpr Real kEpsilon = 2.220446049250313e-16;

int pairsOfEachFamily(int usual) {
  const char* text = std::getenv("CAROM_ORACLE_PAIRS");
  return text ? std::atoi(text) : usual;
}

Kernel::Point_2 exact(const Vector2& p) {
  return {p.x(), p.y()};
}

// The corners of the points' hull, no three of them in a line; fewer than three if all are.
Corners hullOf(const Corners& points) {
  std::vector<Kernel::Point_2> given, hull;
  for (const Vector2& p : points) given.push_back(exact(p));
  CGAL::convex_hull_2(given.begin(), given.end(), std::back_inserter(hull));
  Corners corners;
  for (const Kernel::Point_2& p : hull) corners.push_back({p.x(), p.y()});
  return corners;
}

Vector2 anyPoint(Random& random, Real size) {
  const Real x = random.between(-size, size);
  return {x, random.between(-size, size)};
}

Vector2 gridPoint(Random& random) {
  const int x = random.integer(0, 7);
  return {static_cast<Real>(x), static_cast<Real>(random.integer(0, 7))};
}

Corners moved(Corners corners, const Vector2& by) {
  for (Vector2& p : corners) p += by;
  return corners;
}

template <class Point>
Corners pointsLike(Random& random, const Point& point) {
  Corners points;
  const int count = random.integer(3, 8);
  for (int k = 0; k < count; ++k) points.push_back(point());
  return points;
}

Corners anyPolygon(Random& random, Real size) {
  return pointsLike(random, [&] { return anyPoint(random, size); });
}

// Half of the pairs share a corner, or have a side on the same line.
Pair onTheGrid(Random& random, const Vector2& origin) {
  const auto point = [&] { return Vector2(origin + gridPoint(random)); };
  const Corners a = hullOf(pointsLike(random, point));
  Corners b = pointsLike(random, point);
  const int shared = random.integer(0, 3);
  for (int k = 0; k < std::min(shared, 2); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (i < a.size()) b[i] = a[i];
  }
  return {a, b};
}

// A side of B lies on one of A's but for a tilt; the rest of B lies beyond it, or a little before.
Pair nearlyParallelSides(Random& random) {
  const Corners a = hullOf(anyPolygon(random, 1));
  if (a.size() < 3) return {a, a};
  const Vector2 side = a[1] - a[0];
  const Vector2 outward = Vector2(side.y(), -side.x()).normalized();
  const Real tilt = std::pow(10.0, -random.between(7, 17));
  Corners b;
  for (const Real along : {random.between(-1, 0.5), random.between(0.5, 2)}) {
    b.push_back(a[0] + along * side + tilt * random.between(-1, 1) * outward);
  }
  for (int k = 0; k < 3; ++k) {
    const Real along = random.between(-1, 2);
    b.push_back(a[0] + along * side + random.between(1e-9, 1) * outward);
  }
  return {a, b};
}

// Long and thin, in any direction.
Corners needle(Random& random) {
  const Vector2 along = anyPoint(random, 1);
  const Vector2 across = 1e-6 * Vector2(-along.y(), along.x());
  return pointsLike(random, [&] {
    const Vector2 p = anyPoint(random, 1);
    return Vector2(p.x() * along + p.y() * across);
  });
}

struct Family {
  const char* name;
  std::function<Pair(Random&)> make;
  Real leastApart, leastMeeting;  // shares: a family of one kind only would prove little
  Real leastTouching;
};

std::vector<Family> families() {
  return {
      {"random",
       [](Random& random) {
         const Corners a = anyPolygon(random, 1);
         const Corners b = anyPolygon(random, 1);
         return Pair(a, moved(b, anyPoint(random, 1.5)));
       },
       0.2, 0.2, 0},
      {"on a grid, often touching exactly",
       [](Random& random) {
         return onTheGrid(random, {0, 0});
       },
       0.005, 0.2, 0.02},
      {"one ulp from touching",
       [](Random& random) {
         const Real ulp = std::ldexp(1.0, -49);  // of the numbers from 8 to 16
         auto [a, b] = onTheGrid(random, {8, 8});
         const int x = random.integer(-1, 1);
         return Pair(a, moved(b, ulp * Vector2(x, random.integer(-1, 1))));
       },
       0.02, 0.2, 0.005},
      {"nearly parallel sides", nearlyParallelSides, 0.05, 0.2, 0},
      {"one inside the other",
       [](Random& random) {
         const Corners a = anyPolygon(random, 1);
         const Corners b = anyPolygon(random, 0.05);
         const Vector2 center = (a[0] + a[1] + a[2]) / 3;
         return Pair(a, moved(b, center + random.between(0, 2) * (a[0] - center)));
       },
       0.1, 0.1, 0},
      {"needles",
       [](Random& random) {
         const Corners a = needle(random);
         const Corners b = needle(random);
         return Pair(a, moved(b, anyPoint(random, 0.2)));
       },
       0.1, 0.1, 0},
      {"a million metres away",
       [](Random& random) {
         const Vector2 far(1e6, -1e6);
         const Corners a = moved(anyPolygon(random, 1), far);
         const Corners b = anyPolygon(random, 1);
         return Pair(a, moved(moved(b, anyPoint(random, 1.5)), far));
       },
       0.2, 0.2, 0},
  };
}

// All corners of `other` on the far side of a side of `owner`, or on its line if `closed` is false.
bool sideParts(const Corners& owner, const Corners& other, bool closed) {
  for (std::size_t i = 0; i < owner.size(); ++i) {
    const auto from = exact(owner[i]), to = exact(owner[(i + 1) % owner.size()]);
    const bool all = std::all_of(other.begin(), other.end(), [&](const Vector2& p) {
      const auto turn = CGAL::orientation(from, to, exact(p));
      return turn == CGAL::RIGHT_TURN || (!closed && turn == CGAL::COLLINEAR);
    });
    if (all) return true;
  }
  return false;
}

// By the triangles that each polygon falls into; no separating axes.
bool haveCommonPoint(const Corners& a, const Corners& b) {
  using Triangle = Kernel::Triangle_2;
  for (std::size_t i = 1; i + 1 < a.size(); ++i) {
    const Triangle ofA(exact(a[0]), exact(a[i]), exact(a[i + 1]));
    for (std::size_t j = 1; j + 1 < b.size(); ++j) {
      if (CGAL::do_intersect(ofA, Triangle(exact(b[0]), exact(b[j]), exact(b[j + 1])))) return true;
    }
  }
  return false;
}

Verdict truthOf(const Corners& a, const Corners& b) {
  if (!haveCommonPoint(a, b)) return Verdict::separated;
  return sideParts(a, b, false) || sideParts(b, a, false) ? Verdict::touching
                                                          : Verdict::overlapping;
}

// Polygons that are apart are nearest at a corner of one of them.
Real exactDistance(const Corners& a, const Corners& b) {
  const auto point = [](const Vector2& p) { return Exact::Point_2(p.x(), p.y()); };
  Exact::FT least = -1;
  for (const auto& [corners, sides] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (std::size_t i = 0; i < sides->size(); ++i) {
      const Exact::Segment_2 side(point((*sides)[i]), point((*sides)[(i + 1) % sides->size()]));
      for (const Vector2& corner : *corners) {
        const Exact::FT square = CGAL::squared_distance(point(corner), side);
        if (least < 0 || square < least) least = square;
      }
    }
  }
  return std::sqrt(CGAL::to_double(CGAL::exact(least)));
}

Real largest(const Corners& corners) {
  Real all = 0;
  for (const Vector2& p : corners) all = std::max(all, p.cwiseAbs().maxCoeff());
  return all;
}

// How far a point is from a polygon, in doubles; zero inside.
Real distanceTo(const Corners& corners, const Vector2& p) {
  bool inside = true;
  Real least = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 from = corners[i], side = corners[(i + 1) % corners.size()] - from;
    inside =
        inside && CGAL::orientation(exact(from), exact(from + side), exact(p)) != CGAL::RIGHT_TURN;
    const Real t = std::clamp((p - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - from - t * side).norm());
  }
  return inside ? 0 : least;
}

}  // namespace

TEST_CASE("no verdict on two polygons differs from CGAL's") {
  const int pairs = pairsOfEachFamily(4000);
  for (const Family& family : families()) {
    DYNAMIC_SECTION(family.name) {
      Random random(20210314);
      int counts[3] = {0, 0, 0};
      int wrong = 0;
      int notSwapped = 0;
      for (int i = 0; i < pairs; ++i) {
        const auto [pointsOfA, pointsOfB] = family.make(random);
        const Corners a = hullOf(pointsOfA), b = hullOf(pointsOfB);
        if (a.size() < 3 || b.size() < 3) continue;
        const Verdict truth = truthOf(a, b);
        ++counts[static_cast<int>(truth)];
        const auto said = carom::separatePolygons(a, b);
        if (said.verdict != truth && ++wrong <= 3) {
          UNSCOPED_INFO("pair " << i << ": separation " << said.separation << ", CGAL says "
                                << static_cast<int>(truth));
        }
        notSwapped += carom::separatePolygons(b, a).verdict != truth;
      }
      CHECK(wrong == 0);
      CHECK(notSwapped == 0);
      const int all = counts[0] + counts[1] + counts[2];
      CHECK(all > 0.5 * pairs);
      CHECK(counts[static_cast<int>(Verdict::separated)] > family.leastApart * all);
      CHECK(counts[static_cast<int>(Verdict::overlapping)] > family.leastMeeting * all);
      CHECK(counts[static_cast<int>(Verdict::touching)] >= family.leastTouching * all);
    }
  }
}

TEST_CASE("the distance of two polygons is the exact one, and its points show it") {
  const int pairs = pairsOfEachFamily(1000);
  for (const Family& family : families()) {
    DYNAMIC_SECTION(family.name) {
      Random random(12);
      int apart = 0;
      int wrongSign = 0;
      Real worst = 0;        // relative, but for what a few ulp of the coordinates allow
      Real worstPoints = 0;  // the same for the distance of the two points
      Real worstOff = 0;     // how far a point lies off its polygon, in ulp of the coordinates
      for (int i = 0; i < pairs; ++i) {
        const auto [pointsOfA, pointsOfB] = family.make(random);
        const Corners a = hullOf(pointsOfA), b = hullOf(pointsOfB);
        if (a.size() < 3 || b.size() < 3) continue;
        const auto said = carom::planarGjk(carom::makePolygon(a), PlanarPose(),
                                           carom::makePolygon(b), PlanarPose());
        const Verdict truth = truthOf(a, b);
        const Real sign = truth == Verdict::separated ? 1 : truth == Verdict::touching ? 0 : -1;
        wrongSign += (said.separation > 0 ? 1 : said.separation < 0 ? -1 : 0) != sign;
        const Real ulp = kEpsilon * std::max(largest(a), largest(b));
        worstOff = std::max(worstOff, distanceTo(a, said.pointA) / ulp);
        worstOff = std::max(worstOff, distanceTo(b, said.pointB) / ulp);
        if (truth != Verdict::separated) continue;
        ++apart;
        const Real distance = exactDistance(a, b);
        const auto relative = [&](Real value) {
          return std::max(0.0, std::abs(value - distance) - 4 * ulp) / distance;
        };
        worst = std::max(worst, relative(said.separation));
        worstPoints = std::max(worstPoints, relative((said.pointB - said.pointA).norm()));
      }
      INFO("worst relative error of the distance " << worst << ", of the points " << worstPoints
                                                   << ", points off by ulp " << worstOff);
      CHECK(apart > 0);
      CHECK(wrongSign == 0);
      CHECK(worst <= 1e-12);
      CHECK(worstPoints <= 1e-12);
      CHECK(worstOff <= 64);
    }
  }
}

namespace {

// Questions to the predicates: points at random, on a grid, and rounded onto what they are asked
// about, near the origin and far from it, tiny and large.
struct Question {
  std::array<Vector2, 4> inPlane;
  std::array<Vector3, 4> inSpace;
};

Question anyQuestion(Random& random) {
  Question q;
  const int kind = random.integer(0, 5);
  if (kind == 5) {  // coordinates of very different sizes
    const auto any = [&] { return std::ldexp(random.between(-1, 1), random.integer(-100, 100)); };
    for (std::size_t i = 0; i < 4; ++i) {
      for (Real& x : q.inSpace[i]) x = random.integer(0, 3) == 0 ? 0 : any();
      q.inPlane[i] = q.inSpace[i].head<2>();
    }
    return q;
  }
  const Real size = std::ldexp(1.0, random.integer(-100, 100));
  const Vector3 far = kind == 4 ? Vector3(1e3 * random.vector(size)) : Vector3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    q.inSpace[i] = kind == 0 || kind >= 3
                       ? Vector3(far + random.vector(size))
                       : Vector3(random.integer(0, 7), random.integer(0, 7), random.integer(0, 7));
    q.inPlane[i] = q.inSpace[i].head<2>();
  }
  if (kind == 2) {  // a grid that is not on whole numbers
    for (auto& p : q.inSpace) p *= 0.1;
    for (auto& p : q.inPlane) p *= 0.1;
  }
  if (kind < 3) return q;
  const auto& [o, a, b, c] = q.inSpace;
  q.inSpace[3] = o + random.between(-3, 3) * (a - o) + random.between(-3, 3) * (b - o);
  q.inPlane[2] = q.inPlane[0] + random.between(-3, 3) * (q.inPlane[1] - q.inPlane[0]);
  if (kind == 4) {  // on a circle instead of a line
    const Vector2 center = far.head<2>();
    for (std::size_t i = 0; i < 4; ++i) {
      const Real angle = random.between(0, 6.3);
      q.inPlane[i] = center + size * Vector2(std::cos(angle), std::sin(angle));
    }
  }
  return q;
}

}  // namespace

TEST_CASE("the predicates are CGAL's, on easy points and on degenerate ones") {
  Random random(15);
  const int count = 100 * pairsOfEachFamily(2000);
  int wrong = 0, zeros = 0, exactOnes = 0;
  for (int i = 0; i < count; ++i) {
    const Question q = anyQuestion(random);
    const auto& [a, b, c, d] = q.inPlane;
    const auto& [o, u, v, w] = q.inSpace;
    const auto space = [](const Vector3& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
    const int side = CGAL::orientation(exact(a), exact(b), exact(c));
    const int circle = CGAL::side_of_oriented_circle(exact(a), exact(b), exact(c), exact(d));
    const int plane = CGAL::orientation(space(o), space(u), space(v), space(w));
    const carom::FilteredSign line = carom::orient2dFiltered(a, b, c);
    wrong += line.sign != side;
    wrong += carom::exactOrient2d(a, b, c) != side;
    wrong += carom::inCircle(a, b, c, d).sign != circle;
    wrong += carom::orientation(o, u, v, w) != plane;
    zeros += (side == 0) + (circle == 0) + (plane == 0);
    exactOnes += !line.filtered;
  }
  CHECK(wrong == 0);
  CHECK(zeros > count / 20);
  CHECK(exactOnes > count / 20);
}
