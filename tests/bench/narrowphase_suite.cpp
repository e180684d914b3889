// The suite `narrowphase`: what it costs to measure a pair of bodies, and how right the answer is.
//
// Time: boxes and hulls of 20 corners, 2 cm deep in each other and 5 cm apart, by this library and
// by those of Debian that are found. Error: boxes whose signed gap is known, from -0.1 m to 1e-9 m,
// found by bisection on fifteen axes in long double, which neither side uses.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "bench/bench.hpp"
#include "bench/narrowphase_peers.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/manifold/collide.hpp"
#include "carom_io/table.hpp"

using carom::Box;
using carom::ConvexHull;
using carom::ConvexShape;
using carom::Pose;
using carom::Real;
using carom::Vector3;
using carom::bench::BodyPair;
using carom::bench::Case;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::PairAnswer;
using carom::bench::PairMethod;
using carom::bench::Timing;

namespace {

Vector3 direction(carom::Random& random) {
  while (true) {
    Vector3 v;
    for (Real& x : v) x = random.between(-1, 1);
    if (v.squaredNorm() < 1 && v.squaredNorm() > 0.01) return v.normalized();
  }
}

Pose anyPose(carom::Random& random) {
  while (true) {
    std::array<Real, 4> q{};
    Real squared = 0;
    for (Real& x : q) {
      x = random.between(-1, 1);
      squared += x * x;
    }
    if (squared > 1 || squared < 0.01) continue;
    Vector3 p;
    for (Real& x : p) x = random.between(-1, 1);
    return carom::poseOf({q[0], q[1], q[2], q[3]}, p);
  }
}

// The judge: the best of the fifteen axes, in long double, and how much better it is than the next
// that is not the same to a part in a million.
struct Judgement {
  long double gap = -1e30L, second = -1e30L;
  Vector3 axis = Vector3::Zero();
};

Judgement judge(const BodyPair& pair) {
  using Long3 = std::array<long double, 3>;
  const auto column = [](const Pose& pose, int k) {
    return Long3{pose.R_WB(0, k), pose.R_WB(1, k), pose.R_WB(2, k)};
  };
  const auto dot = [](const Long3& a, const Long3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  Long3 p{};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    p[k] = static_cast<long double>(pair.B.p_WB(i)) - pair.A.p_WB(i);
  }
  std::vector<Long3> axes;
  for (int k = 0; k < 3; ++k) axes.push_back(column(pair.A, k));
  for (int k = 0; k < 3; ++k) axes.push_back(column(pair.B, k));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Long3 a = column(pair.A, i), b = column(pair.B, j);
      axes.push_back(
          {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
    }
  }
  Judgement best;
  for (Long3& axis : axes) {
    const long double whole = std::sqrt(dot(axis, axis));
    if (whole < 1e-6L) continue;
    for (long double& x : axis) x /= whole;
    long double gap = std::abs(dot(axis, p));
    for (int k = 0; k < 3; ++k) {
      gap -= std::abs(dot(axis, column(pair.A, k))) * pair.halfA(k);
      gap -= std::abs(dot(axis, column(pair.B, k))) * pair.halfB(k);
    }
    if (gap > best.gap) {
      best.second = best.gap;
      best.gap = gap;
      const Real sign = dot(axis, p) < 0 ? -1 : 1;
      for (int i = 0; i < 3; ++i) {
        best.axis(i) = sign * static_cast<Real>(axis[static_cast<std::size_t>(i)]);
      }
    } else {
      best.second = std::max(best.second, gap);
    }
  }
  return best;
}

// Moves B along a direction until a signed distance is `gap`.
template <class Distance>
BodyPair placed(BodyPair pair, const Vector3& way, Real gap, const Distance& distance) {
  Real low = 0, high = 16;
  const Vector3 from = pair.A.p_WB;
  for (int k = 0; k < 90; ++k) {
    const Real middle = (low + high) / 2;
    pair.B.p_WB = from + middle * way;
    (distance(pair) < gap ? low : high) = middle;
  }
  return pair;
}

std::vector<BodyPair> boxPairs(std::size_t count, Real gap, std::uint64_t seed) {
  carom::Random random(seed);
  std::vector<BodyPair> pairs;
  while (pairs.size() < count) {
    BodyPair pair{anyPose(random), anyPose(random), Vector3::Ones(), Vector3::Ones()};
    for (Real& x : pair.halfA) x = random.between(0.2, 1);
    for (Real& x : pair.halfB) x = random.between(0.2, 1);
    pairs.push_back(placed(pair, direction(random), gap,
                           [](const BodyPair& p) { return static_cast<Real>(judge(p).gap); }));
  }
  return pairs;
}

ConvexHull cloud(int count, std::uint64_t seed) {
  carom::Random random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.push_back(direction(random));
  return carom::hullOfPoints(points);
}

PairAnswer answerOf(const carom::Separation& s) {
  return {s.separation <= 0, s.separation, s.normal, 1};
}
PairAnswer answerOf(const carom::SeparatingAxis& s) {
  return {s.verdict != carom::Verdict::separated, s.separation, s.axis, 0};
}
PairAnswer answerOf(const carom::Manifold& m) {
  PairAnswer answer{m.count > 0, 0, m.normal, m.count};
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    answer.separation = std::min(answer.separation, m.points[i].separation);
  }
  return answer;
}

// The library's ways for two shapes in many poses; shapes and pairs must outlive them.
std::vector<PairMethod> ours(const std::vector<ConvexShape>& a, const std::vector<ConvexShape>& b,
                             const std::vector<BodyPair>& pairs) {
  const auto shapeA = [&a](std::size_t i) -> const ConvexShape& { return a[i % a.size()]; };
  const auto shapeB = [&b](std::size_t i) -> const ConvexShape& { return b[i % b.size()]; };
  const auto simplices = std::make_shared<std::vector<carom::SimplexCache>>(pairs.size());
  const auto manifolds = std::make_shared<std::vector<carom::ManifoldCache>>(pairs.size());
  return {{"carom separating axes",
           [=, &pairs](std::size_t i) {
             const BodyPair& p = pairs[i];
             if (const Box* boxA = std::get_if<Box>(&shapeA(i))) {
               return answerOf(carom::separateBoxes(*boxA, p.A, std::get<Box>(shapeB(i)), p.B));
             }
             return answerOf(carom::separateHulls(std::get<ConvexHull>(shapeA(i)), p.A,
                                                  std::get<ConvexHull>(shapeB(i)), p.B));
           }},
          {"carom manifold",
           [=, &pairs](std::size_t i) {
             return answerOf(carom::collide(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B));
           }},
          {"carom manifold, cached",
           [=, &pairs](std::size_t i) {
             return answerOf(
                 carom::collide(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B, &(*manifolds)[i]));
           }},
          {"carom GJK+EPA",
           [=, &pairs](std::size_t i) {
             return answerOf(carom::gjk(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B));
           }},
          {"carom GJK+EPA, warm",
           [=, &pairs](std::size_t i) {
             return answerOf(
                 carom::gjk(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B, &(*simplices)[i]));
           }},
          {"carom signed distance", [=, &pairs](std::size_t i) {
             return answerOf(carom::signedDistance(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B));
           }}};
}

[[maybe_unused]] void append(std::vector<PairMethod>& methods, std::vector<PairMethod> more) {
  for (PairMethod& method : more) methods.push_back(std::move(method));
}

std::vector<PairMethod> boxMethods(const std::vector<ConvexShape>& a,
                                   const std::vector<ConvexShape>& b,
                                   const std::vector<BodyPair>& pairs) {
  std::vector<PairMethod> methods = ours(a, b, pairs);
#ifdef CAROM_BENCH_BULLET
  append(methods, carom::bench::bulletBoxes(pairs));
#endif
#ifdef CAROM_BENCH_FCL
  append(methods, carom::bench::fclBoxes(pairs));
#endif
#ifdef CAROM_BENCH_CCD
  append(methods, carom::bench::ccdBoxes(pairs));
#endif
  return methods;
}

std::vector<PairMethod> hullMethods(const std::vector<ConvexShape>& a,
                                    const std::vector<ConvexShape>& b,
                                    const std::vector<BodyPair>& pairs) {
  std::vector<PairMethod> methods = ours(a, b, pairs);
  [[maybe_unused]] const ConvexHull& hullA = std::get<ConvexHull>(a[0]);
  [[maybe_unused]] const ConvexHull& hullB = std::get<ConvexHull>(b[0]);
#ifdef CAROM_BENCH_BULLET
  append(methods, carom::bench::bulletHulls(hullA, hullB, pairs));
#endif
#ifdef CAROM_BENCH_CCD
  append(methods, carom::bench::ccdHulls(hullA, hullB, pairs));
#endif
  return methods;
}

Json rowOf(const std::string& scene, const std::string& engine, std::size_t items) {
  return {{"suite", "narrowphase"},   {"scene", scene}, {"engine", engine},
          {"version", CAROM_VERSION}, {"threads", 1},   {"items", items}};
}

void timeAll(const std::string& scene, const std::vector<PairMethod>& methods, std::size_t count,
             const Options& options, Json& rows) {
  std::vector<Case> cases;
  for (const PairMethod& method : methods) {
    cases.push_back({method.name, count, [&method, count] {
                       for (std::size_t i = 0; i < count; ++i) keep(method.run(i));
                     }});
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  carom::io::Table table;
  table.column("what").column("ns per pair", carom::io::fixed(0));
  table.column("least", carom::io::fixed(0)).column("most", carom::io::fixed(0));
  table.column("points", carom::io::fixed(1));
  for (std::size_t m = 0; m < methods.size(); ++m) {
    Real points = 0;
    for (std::size_t i = 0; i < count; ++i) points += methods[m].run(i).points;
    const Timing& t = timings[m];
    table.row({methods[m].name, t.median, t.least, t.most, points / static_cast<Real>(count)});
    Json row = rowOf(scene, methods[m].name, count);
    row.update({{"ns_per_item", t.median}, {"least", t.least}, {"most", t.most}});
    row["counters"] = {{"points", points / static_cast<Real>(count)}};
    rows.push_back(row);
  }
  std::cout << "\n" << scene << "\n\n" << table << std::flush;
}

// Verdicts, depths and normals of boxes at one gap.
void judgeAll(Real gap, std::size_t count, Json& rows) {
  const std::vector<BodyPair> pairs = boxPairs(count, gap, 77);
  std::vector<ConvexShape> a, b;
  std::vector<Judgement> truth;
  for (const BodyPair& pair : pairs) {
    a.emplace_back(Box{pair.halfA});
    b.emplace_back(Box{pair.halfB});
    truth.push_back(judge(pair));
  }
  carom::io::Table table;
  table.column("what").column("wrong verdicts", carom::io::fixed(0));
  table.column("depth error, median", carom::io::scientific(1));
  table.column("largest", carom::io::scientific(1));
  table.column("normals off by 1e-6 deg", carom::io::fixed(0));
  for (const PairMethod& method : boxMethods(a, b, pairs)) {
    int wrong = 0, turned = 0;
    std::vector<Real> errors;
    for (std::size_t i = 0; i < count; ++i) {
      const PairAnswer answer = method.run(i);
      if (answer.hit != (truth[i].gap <= 0)) {
        ++wrong;
        continue;
      }
      if (!answer.hit || answer.normal.isZero(0)) continue;
      errors.push_back(std::abs(answer.separation - static_cast<Real>(truth[i].gap)));
      // The sine of the angle, where the best axis is the best by 1e-9 m.
      constexpr Real kLimit = 1e-6 * 3.14159265358979 / 180;
      const bool unique = truth[i].gap - truth[i].second > 1e-9L;
      const Real sine = carom::cross(answer.normal, truth[i].axis).norm();
      turned += unique && (sine > kLimit || answer.normal.dot(truth[i].axis) < 0);
    }
    std::sort(errors.begin(), errors.end());
    const Real median = errors.empty() ? 0 : errors[errors.size() / 2];
    const Real largest = errors.empty() ? 0 : errors.back();
    table.row({method.name, static_cast<Real>(wrong), median, largest, static_cast<Real>(turned)});
    Json row = rowOf("boxes, known gap", method.name, count);
    row["gap"] = gap;
    row["error"] = {{"wrong_verdicts", wrong},
                    {"depth_median", median},
                    {"depth_largest", largest},
                    {"normals_turned", turned},
                    {"answers", errors.size()}};
    rows.push_back(row);
  }
  std::cout << "\nboxes with a gap of " << gap << " m, " << count << " pairs\n\n"
            << table << std::flush;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "narrowphase"}, {"circumstances", carom::bench::circumstances(options)}};
  std::cout << carom::bench::circumstancesInALine() << '\n';
  Json rows = Json::array();

  constexpr std::size_t kPairs = 400;
  for (const Real gap : {-0.02, 0.05}) {
    const char* where = gap < 0 ? ", 2 cm deep" : ", 5 cm apart";
    const std::vector<BodyPair> boxes = boxPairs(kPairs, gap, 5);
    std::vector<ConvexShape> a, b;
    for (const BodyPair& pair : boxes) {
      a.emplace_back(Box{pair.halfA});
      b.emplace_back(Box{pair.halfB});
    }
    timeAll(std::string("boxes") + where, boxMethods(a, b, boxes), kPairs, options, rows);

    const std::vector<ConvexShape> hullA = {cloud(20, 1)}, hullB = {cloud(20, 2)};
    std::vector<BodyPair> hulls;
    carom::Random random(6);
    while (hulls.size() < kPairs) {
      const BodyPair pair{anyPose(random), anyPose(random), Vector3::Ones(), Vector3::Ones()};
      hulls.push_back(placed(pair, direction(random), gap, [&](const BodyPair& p) {
        return carom::signedDistance(hullA[0], p.A, hullB[0], p.B).separation;
      }));
    }
    timeAll(std::string("hulls of 20 corners") + where, hullMethods(hullA, hullB, hulls), kPairs,
            options, rows);
  }
  for (const Real gap : {-0.1, -1e-3, -1e-6, -1e-9, -1e-12, 1e-12, 1e-9, 1e-6}) {
    judgeAll(gap, 4000, rows);
  }
  figures["rows"] = rows;
  carom::bench::writeJson(options, figures);
}
