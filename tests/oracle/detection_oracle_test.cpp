// Detection before a judge: CGAL's exact predicates and exact quadratic programs on the same pairs.
//
// CAROM_ORACLE_PAIRS sets the number of pairs of each family; 200000 takes minutes, the default
// seconds.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/intersections.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "support/catch.hpp"

using carom::ConvexHull;
using carom::Pose;
using carom::Random;
using carom::Real;
using carom::Vector3;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tetrahedron = std::array<Vector3, 4>;
using Cloud = std::vector<Vector3>;

constexpr Real kEpsilon = 2.220446049250313e-16;

int pairsOfEachFamily(int usual) {
  const char* text = std::getenv("CAROM_ORACLE_PAIRS");
  return text ? std::atoi(text) : usual;
}

Kernel::Point_3 exact(const Vector3& p) {
  return {p.x(), p.y(), p.z()};
}

Vector3 anyPoint(Random& random, Real size) {
  return {random.between(-size, size), random.between(-size, size), random.between(-size, size)};
}

Vector3 gridPoint(Random& random) {
  auto whole = [&] { return static_cast<Real>(random.bits() % 8); };
  const Real x = whole();
  const Real y = whole();
  return {x, y, whole()};
}

Tetrahedron anyTetrahedron(Random& random, Real size) {
  Tetrahedron t;
  for (Vector3& p : t) p = anyPoint(random, size);
  return t;
}

Tetrahedron moved(Tetrahedron t, const Vector3& by) {
  for (Vector3& p : t) p += by;
  return t;
}

Real largest(const Tetrahedron& t) {
  Real all = 0;
  for (const Vector3& p : t) all = std::max(all, p.cwiseAbs().maxCoeff());
  return all;
}

// A hull, unless the points are flat to rounding: such a body has no inside, and is refused.
std::optional<ConvexHull> hullOf(const Tetrahedron& t) {
  try {
    return carom::hullOfPoints(t);
  } catch (const carom::InvalidInput&) {
    return std::nullopt;
  }
}

bool cgalSaysApart(const Tetrahedron& a, const Tetrahedron& b) {
  using Solid = Kernel::Tetrahedron_3;
  return !CGAL::do_intersect(Solid(exact(a[0]), exact(a[1]), exact(a[2]), exact(a[3])),
                             Solid(exact(b[0]), exact(b[1]), exact(b[2]), exact(b[3])));
}

struct Family {
  const char* name;
  std::function<std::pair<Tetrahedron, Tetrahedron>(Random&)> make;
  Real leastShare;  ///< of apart and of not apart: a family of one kind only would prove little
};

// The nearest point to p of the line through q along d stays where it is; b's edge is nearly that
// line.
std::pair<Tetrahedron, Tetrahedron> nearlyParallelEdges(Random& random) {
  const Tetrahedron a = anyTetrahedron(random, 1);
  Tetrahedron b = anyTetrahedron(random, 1);
  const Real tilt = std::pow(10.0, -random.between(7, 16));
  const Vector3 shift = 0.5 * anyPoint(random, 1);
  b[0] = a[0] + shift;
  b[1] = b[0] + random.between(0.5, 1.5) * (a[1] - a[0]) + tilt * anyPoint(random, 1);
  return {a, b};
}

std::vector<Family> families() {
  return {
      {"random",
       [](Random& random) {
         const Tetrahedron a = anyTetrahedron(random, 1);
         return std::pair(a, moved(anyTetrahedron(random, 1), anyPoint(random, 0.8)));
       },
       0.2},
      {"on a grid, often touching exactly",
       [](Random& random) {
         Tetrahedron a;
         Tetrahedron b;
         for (Vector3& p : a) p = gridPoint(random);
         for (Vector3& p : b) p = gridPoint(random);
         // Half of the pairs share a corner, an edge or a face.
         const auto shared = random.bits() % 8;
         for (std::size_t i = 0; i < std::min<std::size_t>(shared, 3); ++i) b[i] = a[i];
         return std::pair(a, b);
       },
       0.02},
      {"one ulp from touching",
       [](Random& random) {
         Tetrahedron a;
         Tetrahedron b;
         for (Vector3& p : a) p = Vector3(8, 8, 8) + gridPoint(random);
         for (Vector3& p : b) p = Vector3(8, 8, 8) + gridPoint(random);
         for (std::size_t i = 0; i < random.bits() % 4; ++i) b[i] = a[i];
         const Real ulp = std::ldexp(1.0, -49);  // of the numbers from 8 to 16
         auto step = [&] { return ulp * (static_cast<Real>(random.bits() % 3) - 1); };
         const Real x = step();
         const Real y = step();
         return std::pair(a, moved(b, {x, y, step()}));
       },
       0.05},
      {"nearly parallel edges", nearlyParallelEdges, 0.05},
      {"one inside the other",
       [](Random& random) {
         const Tetrahedron a = anyTetrahedron(random, 1);
         const Vector3 center = (a[0] + a[1] + a[2] + a[3]) / 4;
         // From well inside to well outside.
         const Vector3 goal = center + random.between(0, 3) * (a[random.bits() % 4] - center);
         return std::pair(a, moved(anyTetrahedron(random, 0.02), goal));
       },
       0.1},
      {"needles and plates",
       [](Random& random) {
         auto flattened = [&](int axes) {
           Tetrahedron t = anyTetrahedron(random, 1);
           const auto first = random.bits() % 3;
           for (int k = 0; k < axes; ++k) {
             for (Vector3& p : t)
               p[static_cast<int>((first + static_cast<unsigned>(k)) % 3)] *= 1e-6;
           }
           return t;
         };
         const Tetrahedron a = flattened(random.bits() % 2 ? 1 : 2);
         return std::pair(a, moved(flattened(random.bits() % 2 ? 1 : 2), anyPoint(random, 1e-6)));
       },
       0.02},
      {"a million metres away",
       [](Random& random) {
         const Vector3 far = {1e6, -1e6, 1e6};
         const Tetrahedron a = moved(anyTetrahedron(random, 1), far);
         return std::pair(a, moved(moved(anyTetrahedron(random, 1), anyPoint(random, 0.8)), far));
       },
       0.2},
  };
}

// The exact squared distance of two clouds' hulls, as a double; 0 exactly if they meet.
Real exactDistance(const Cloud& a, const Cloud& b) {
  using Traits = CGAL::Polytope_distance_d_traits_3<Kernel, CGAL::Gmpzf, double>;
  std::vector<Kernel::Point_3> p;
  std::vector<Kernel::Point_3> q;
  for (const Vector3& v : a) p.push_back(exact(v));
  for (const Vector3& v : b) q.push_back(exact(v));
  const CGAL::Polytope_distance_d<Traits> distance(p.begin(), p.end(), q.begin(), q.end());
  if (CGAL::is_zero(distance.squared_distance_numerator())) return 0;
  // The quotient of two whole numbers with many digits; each becomes a double with its exponent.
  const auto n = CGAL::to_interval(distance.squared_distance_numerator());
  const auto d = CGAL::to_interval(distance.squared_distance_denominator());
  return std::sqrt((n.first + n.second) / (d.first + d.second));
}

}  // namespace

TEST_CASE("no verdict on two tetrahedra differs from CGAL's") {
  const int pairs = pairsOfEachFamily(4000);
  for (const auto& family : families()) {
    DYNAMIC_SECTION(family.name) {
      Random random(20210313);
      int apart = 0;
      int met = 0;
      int wrong = 0;
      int notSwapped = 0;
      for (int i = 0; i < pairs; ++i) {
        const auto [a, b] = family.make(random);
        const auto hullA = hullOf(a);
        const auto hullB = hullOf(b);
        if (!hullA || !hullB) continue;
        const bool truth = cgalSaysApart(a, b);
        const auto said = carom::separateHulls(*hullA, Pose(), *hullB, Pose());
        ++(truth ? apart : met);
        if ((said.verdict == carom::Verdict::separated) != truth) {
          if (++wrong <= 3)
            UNSCOPED_INFO("pair " << i << ": separation " << said.separation << ", CGAL says "
                                  << (truth ? "apart" : "not apart"));
        }
        // A body that lies in its own place has no side to be pushed to.
        if (a == b) continue;
        const auto other = carom::separateHulls(*hullB, Pose(), *hullA, Pose());
        notSwapped += other.verdict != said.verdict || other.axis != -said.axis ||
                      other.separation != said.separation;
      }
      CHECK(wrong == 0);
      CHECK(notSwapped == 0);
      const Real all = apart + met;
      CHECK(all > 0.5 * pairs);
      CHECK(apart > family.leastShare * all);
      CHECK(met > family.leastShare * all);
    }
  }
}

TEST_CASE("the least displacement separates, and a little less does not") {
  const int pairs = pairsOfEachFamily(2000);
  for (const auto& family : families()) {
    DYNAMIC_SECTION(family.name) {
      Random random(7);
      int tried = 0;
      int stuck = 0;
      int wasteful = 0;
      for (int i = 0; i < pairs; ++i) {
        const auto [a, b] = family.make(random);
        const auto hullA = hullOf(a);
        const auto hullB = hullOf(b);
        if (!hullA || !hullB) continue;
        const auto said = carom::separateHulls(*hullA, Pose(), *hullB, Pose());
        const Real band = 64 * kEpsilon * std::max(largest(a), largest(b));
        // Among equally good axes a face wins (kAxisTie), so the way may be longer by a few of
        // these.
        const Real tie = 4 * carom::kAxisTie * (hullA->boundingRadius + hullB->boundingRadius);
        if (said.separation > -4 * (band + tie)) continue;
        ++tried;
        stuck += !cgalSaysApart(a, moved(b, (-said.separation + band) * said.axis));
        wasteful += cgalSaysApart(a, moved(b, (-said.separation - band - tie) * said.axis));
      }
      CHECK(tried > 0);
      CHECK(stuck == 0);
      CHECK(wasteful == 0);
    }
  }
}

TEST_CASE("the distance by GJK is the exact one, and its points show it") {
  const int pairs = pairsOfEachFamily(600);
  struct Size {
    const char* name;
    int points;
    Real offset;
  };
  for (const Size& size : {Size{"tetrahedra", 4, 0}, Size{"hulls of twelve points", 12, 0},
                           Size{"hulls a million metres away", 12, 1e6}}) {
    DYNAMIC_SECTION(size.name) {
      Random random(11);
      int apart = 0;
      Real worst = 0;
      Real worstPoints = 0;
      int wrong = 0;
      for (int i = 0; i < pairs; ++i) {
        Cloud a;
        Cloud b;
        const Vector3 far = Vector3::Constant(size.offset);
        const Vector3 shift = far + anyPoint(random, 1) + Vector3(1.2, 0, 0);
        for (int k = 0; k < size.points; ++k) {
          a.push_back(far + anyPoint(random, 1));
          b.push_back(shift + anyPoint(random, 1));
        }
        const Real band = 64 * kEpsilon * (2 + size.offset);
        const Real truth = exactDistance(a, b);
        const auto said =
            carom::gjk(carom::hullOfPoints(a), Pose(), carom::hullOfPoints(b), Pose());
        if (truth == 0) {
          wrong += said.separation > band;
          continue;
        }
        ++apart;
        worst = std::max(worst, std::abs(said.separation - truth));
        worstPoints = std::max(worstPoints, std::abs((said.pointB - said.pointA).norm() - truth));
      }
      CHECK(apart > pairs / 4);
      CHECK(apart < pairs);
      CHECK(wrong == 0);
      INFO("worst error of the distance " << worst << ", of the points " << worstPoints);
      CHECK(worst <= 1e-12 * (1 + size.offset * 1e-3));
      CHECK(worstPoints <= 1e-12 * (1 + size.offset * 1e-3));
    }
  }
}
