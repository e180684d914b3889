#include "bench/narrowphase_verdicts.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "bench/narrowphase_peers.hpp"
#include "carom/core/cross.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/sat_hulls.hpp"
#include "carom/detection/sat_polygons.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/detection/separate_polygons.hpp"
#include "chapters/03_detection/grid_bodies.hpp"

namespace carom::bench {
namespace {

constexpr Real kTolerance = 1e-9;  // what many programs would take for zero [m]

// Whether an axis of any length shows a gap between two sets of corners.
template <class Point>
bool separates(const Point& axis, std::span<const Point> a, std::span<const Point> b) {
  Real lowA = axis.dot(a[0]), highA = lowA, lowB = axis.dot(b[0]), highB = lowB;
  for (const Point& p : a) {
    lowA = std::min(lowA, axis.dot(p));
    highA = std::max(highA, axis.dot(p));
  }
  for (const Point& p : b) {
    lowB = std::min(lowB, axis.dot(p));
    highB = std::max(highB, axis.dot(p));
  }
  return lowB > highA || lowA > highB;
}

// Separating axes as a beginner writes them for speed: not of length one, and the first gap ends
// it.
bool meetPlainly(std::span<const Vector2> a, std::span<const Vector2> b) {
  for (const auto& owner : {a, b}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector2 edge = owner[(i + 1) % 3] - owner[i];
      if (separates<Vector2>({edge.y(), -edge.x()}, a, b)) return false;
    }
  }
  return true;
}

bool meetPlainly(std::span<const Vector3> a, std::span<const Vector3> b) {
  constexpr std::array<std::array<std::size_t, 2>, 6> kEdges{
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{
      {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  for (const auto& owner : {a, b}) {
    for (const auto& [i, j, k] : kFaces) {
      if (separates<Vector3>(cross(owner[j] - owner[i], owner[k] - owner[i]), a, b)) return false;
    }
  }
  for (const auto& [i, j] : kEdges) {
    for (const auto& [k, l] : kEdges) {
      if (separates<Vector3>(cross(a[j] - a[i], b[l] - b[k]), a, b)) return false;
    }
  }
  return true;
}

// The next pairs of a set; both bodies of a pair have an inside.
template <class Point>
SimplexPairs<Point> batch(grid_bodies::Draws& draws, std::size_t count, bool tenths) {
  constexpr bool kPlane = std::is_same_v<Point, Vector2>;
  constexpr std::size_t kCorners = kPlane ? 3 : 4;
  SimplexPairs<Point> pairs;
  const auto add = [&](const grid_bodies::Body& body, std::vector<Point>& to) {
    for (const Vector3& c : body.corners) {
      Point p = c.head < kPlane ? 2 : 3 > ();
      if (tenths) p /= 10;
      to.push_back(p);
    }
    // Polygons are counter-clockwise.
    if (kPlane && cross(body.edges[0], body.edges[1]).z() < 0) {
      std::swap(to[to.size() - 1], to[to.size() - 2]);
    }
  };
  while (pairs.a.size() < kCorners * count) {
    const auto one = [&] {
      return kPlane ? grid_bodies::triangle(draws) : grid_bodies::tetrahedron(draws);
    };
    const grid_bodies::Body a = one();
    const grid_bodies::Body b = one();
    if (!solid(a) || !solid(b)) continue;
    add(a, pairs.a);
    add(b, pairs.b);
  }
  return pairs;
}

[[maybe_unused]] std::vector<MeetMethod> methods(const SimplexPairs<Vector2>& pairs) {
  const auto a = [&pairs](std::size_t i) { return std::span(pairs.a).subspan(3 * i, 3); };
  const auto b = [&pairs](std::size_t i) { return std::span(pairs.b).subspan(3 * i, 3); };
  return {{"doubles, any length", [=](std::size_t i) { return meetPlainly(a(i), b(i)); }},
          {"doubles, length one",
           [=](std::size_t i) { return satPolygons(a(i), b(i)).separation <= 0; }},
          {"doubles, tolerance 1e-9",
           [=](std::size_t i) { return satPolygons(a(i), b(i)).separation <= kTolerance; }},
          {"carom, filter and exact", [=](std::size_t i) {
             return separatePolygons(a(i), b(i)).verdict != Verdict::separated;
           }}};
}

[[maybe_unused]] std::vector<MeetMethod> methods(const SimplexPairs<Vector3>& pairs) {
  const auto a = [&pairs](std::size_t i) { return std::span(pairs.a).subspan(4 * i, 4); };
  const auto b = [&pairs](std::size_t i) { return std::span(pairs.b).subspan(4 * i, 4); };
  struct Hulls {
    std::vector<ConvexHull> a, b;
  };
  const auto hulls = std::make_shared<Hulls>();
  for (std::size_t i = 0; 4 * i < pairs.a.size(); ++i) {
    hulls->a.push_back(hullOfPoints(a(i)));
    hulls->b.push_back(hullOfPoints(b(i)));
  }
  const auto plain = [hulls](std::size_t i) {
    return satHulls(hulls->a[i], Pose(), hulls->b[i], Pose()).separation;
  };
  return {{"doubles, any length", [=](std::size_t i) { return meetPlainly(a(i), b(i)); }},
          {"doubles, length one", [=](std::size_t i) { return plain(i) <= 0; }},
          {"doubles, tolerance 1e-9", [=](std::size_t i) { return plain(i) <= kTolerance; }},
          {"carom, filter and exact", [hulls](std::size_t i) {
             return separateHulls(hulls->a[i], Pose(), hulls->b[i], Pose()).verdict !=
                    Verdict::separated;
           }}};
}

#ifdef CAROM_BENCH_CGAL
template <class Point>
std::vector<MeetMethod> withJudge(const SimplexPairs<Point>& pairs) {
  std::vector<MeetMethod> all = methods(pairs);
  for (MeetMethod& method : cgalMeet(pairs)) all.push_back(std::move(method));
  return all;
}

// The first batch is timed, all are judged; the last method is the judge.
template <class Point>
void race(std::uint64_t seed, bool tenths, std::size_t count, int batches, const Options& options,
          std::vector<VerdictRow>& rows) {
  constexpr bool kPlane = std::is_same_v<Point, Vector2>;
  grid_bodies::Draws draws(seed);
  const std::size_t first = rows.size();
  for (int n = 0; n < batches; ++n) {
    const SimplexPairs<Point> pairs = batch<Point>(draws, count, tenths);
    const std::vector<MeetMethod> all = withJudge(pairs);
    if (n == 0) {
      std::vector<Case> cases;
      for (const MeetMethod& method : all) {
        rows.push_back({method.name, kPlane, tenths, {}, 0, 0, 0});
        cases.push_back({method.name, count, [&method, count] {
                           for (std::size_t i = 0; i < count; ++i) keep(method.meet(i));
                         }});
      }
      const std::vector<Timing> timings = measure(cases, options);
      for (std::size_t m = 0; m < all.size(); ++m) rows[first + m].time = timings[m];
    }
    for (std::size_t i = 0; i < count; ++i) {
      const bool truth = all.back().meet(i);
      for (std::size_t m = 0; m < all.size(); ++m) {
        VerdictRow& row = rows[first + m];
        const bool said = all[m].meet(i);
        ++row.asked;
        row.wrong += said != truth;
        row.common += said;
      }
    }
  }
}
#endif

}  // namespace

std::vector<VerdictRow> raceOfVerdicts([[maybe_unused]] const Options& options) {
  std::vector<VerdictRow> rows;
#ifdef CAROM_BENCH_CGAL
  // The first batches are the sets of cases D4 and D7.
  race<Vector2>(1, false, 20000, 20, options, rows);
  race<Vector2>(2, true, 20000, 20, options, rows);
  race<Vector3>(11, false, 4000, 20, options, rows);
  race<Vector3>(12, true, 4000, 20, options, rows);
#endif
  return rows;
}

}  // namespace carom::bench
