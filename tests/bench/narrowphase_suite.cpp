// The suite `narrowphase`: what it costs to measure a pair of bodies, and how right the answer is.
//
// Boxes whose signed gap is known, from -0.1 m to 0.1 m; hulls of 8 to 128 corners, 2 cm deep in
// each other and 5 cm apart; triangles and tetrahedra on a grid, of which only the verdict is asked
// (narrowphase_verdicts.hpp). Time and error of a row come from the same run.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <string_view>

#include "bench/bench.hpp"
#include "bench/narrowphase_scenes.hpp"
#include "bench/narrowphase_verdicts.hpp"
#include "carom/core/cross.hpp"
#include "carom/detection/gjk.hpp"
#include "carom/detection/sat_boxes.hpp"
#include "carom/detection/sat_hulls.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/manifold/collide.hpp"
#include "carom_io/plot.hpp"
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
using carom::bench::Judgement;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::PairAnswer;
using carom::bench::PairMethod;
using carom::bench::Timing;
using carom::bench::VerdictRow;

namespace {

constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

PairAnswer answerOf(const carom::Separation& s) {
  return {s.separation <= 0, s.separation, s.normal, 1};
}
PairAnswer answerOf(const carom::SeparatingAxis& s) {
  return {s.verdict != carom::Verdict::separated, s.separation, s.axis, 0};
}
PairAnswer answerOf(const carom::Manifold& m) {
  PairAnswer answer{m.count > 0, kNone, m.normal, m.count};
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    if (i == 0 || m.points[i].separation < answer.separation) {
      answer.separation = m.points[i].separation;
    }
  }
  return answer;
}

// What forgetting to divide by the length of an axis makes of the fifteen.
PairAnswer axesOfAnyLength(const BodyPair& pair) {
  const Vector3 between = pair.B.p_WB - pair.A.p_WB;
  PairAnswer best;
  best.separation = -kInfinity;
  const auto attempt = [&](const Vector3& axis) {
    const Real gap = std::abs(between.dot(axis)) -
                     pair.halfA.dot((pair.A.R_WB.transpose() * axis).cwiseAbs()) -
                     pair.halfB.dot((pair.B.R_WB.transpose() * axis).cwiseAbs());
    if (gap <= best.separation) return;
    best.separation = gap;
    best.normal = between.dot(axis) < 0 ? Vector3(-axis) : axis;
  };
  for (int i = 0; i < 3; ++i) attempt(pair.A.R_WB.col(i));
  for (int i = 0; i < 3; ++i) attempt(pair.B.R_WB.col(i));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) attempt(carom::cross(pair.A.R_WB.col(i), pair.B.R_WB.col(j)));
  }
  best.normal.normalize();
  best.hit = best.separation <= 0;
  return best;
}

// What all shapes have in common. Of hulls there is one for all pairs. Pairs come in twos, and a
// memory belongs to both: it never sees the pose that it was made in.
std::vector<PairMethod> ours(const std::vector<ConvexShape>& a, const std::vector<ConvexShape>& b,
                             const std::vector<BodyPair>& pairs) {
  const auto shapeA = [&a](std::size_t i) -> const ConvexShape& { return a[i % a.size()]; };
  const auto shapeB = [&b](std::size_t i) -> const ConvexShape& { return b[i % b.size()]; };
  const auto simplices = std::make_shared<std::vector<carom::SimplexCache>>(pairs.size());
  const auto manifolds = std::make_shared<std::vector<carom::ManifoldCache>>(pairs.size());
  return {{"carom manifold",
           [=, &pairs](std::size_t i) {
             return answerOf(carom::collide(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B));
           }},
          {"carom manifold, cached",
           [=, &pairs](std::size_t i) {
             return answerOf(carom::collide(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B,
                                            &(*manifolds)[i / 2]));
           }},
          {"carom GJK+EPA",
           [=, &pairs](std::size_t i) {
             return answerOf(carom::gjk(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B));
           }},
          {"carom GJK+EPA, warm",
           [=, &pairs](std::size_t i) {
             return answerOf(
                 carom::gjk(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B, &(*simplices)[i / 2]));
           }},
          {"carom signed distance", [=, &pairs](std::size_t i) {
             return answerOf(carom::signedDistance(shapeA(i), pairs[i].A, shapeB(i), pairs[i].B));
           }}};
}

void append(std::vector<PairMethod>& methods, std::vector<PairMethod> more) {
  for (PairMethod& method : more) methods.push_back(std::move(method));
}

std::vector<PairMethod> boxMethods(const std::vector<ConvexShape>& a,
                                   const std::vector<ConvexShape>& b,
                                   const std::vector<BodyPair>& pairs) {
  const auto box = [](const ConvexShape& shape) -> const Box& { return std::get<Box>(shape); };
  const auto witnesses = std::make_shared<std::vector<carom::WitnessAxis>>(pairs.size());
  std::vector<PairMethod> methods = {
      {"fifteen axes of any length", [&pairs](std::size_t i) { return axesOfAnyLength(pairs[i]); }},
      {"fifteen axes, as in the chapter",
       [&, box](std::size_t i) {
         return answerOf(carom::satBoxes(box(a[i]), pairs[i].A, box(b[i]), pairs[i].B));
       }},
      {"carom separating axes",
       [&, box](std::size_t i) {
         return answerOf(carom::separateBoxes(box(a[i]), pairs[i].A, box(b[i]), pairs[i].B));
       }},
      {"carom apart?, axis kept", [&, box, witnesses](std::size_t i) {
         PairAnswer answer;
         answer.hit = !carom::boxesAreApart(box(a[i]), pairs[i].A, box(b[i]), pairs[i].B, 0,
                                            (*witnesses)[i / 2]);
         return answer;
       }}};
  append(methods, ours(a, b, pairs));
#ifdef CAROM_BENCH_ODE
  append(methods, carom::bench::odeBoxes(pairs));
#endif
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
  const ConvexHull &hullA = std::get<ConvexHull>(a[0]), &hullB = std::get<ConvexHull>(b[0]);
  constexpr std::size_t kMostOfAllAxes = 24;  // a pair of 128 corners takes a twentieth of a second
  std::vector<PairMethod> methods = {
      {"all axes, as in the chapter",
       [&](std::size_t i) {
         return answerOf(carom::satHulls(hullA, pairs[i].A, hullB, pairs[i].B));
       },
       kMostOfAllAxes},
      {"carom separating axes", [&](std::size_t i) {
         return answerOf(carom::separateHulls(hullA, pairs[i].A, hullB, pairs[i].B));
       }}};
  append(methods, ours(a, b, pairs));
#ifdef CAROM_BENCH_BULLET
  append(methods, carom::bench::bulletHulls(hullA, hullB, pairs));
#endif
#ifdef CAROM_BENCH_FCL
  append(methods, carom::bench::fclHulls(hullA, hullB, pairs));
#endif
#ifdef CAROM_BENCH_CCD
  append(methods, carom::bench::ccdHulls(hullA, hullB, pairs));
#endif
  return methods;
}

bool isPeer(std::string_view name) {
  return std::ranges::any_of(
      std::array<std::string_view, 5>{"ODE", "Bullet", "FCL", "libccd", "CGAL"},
      [name](std::string_view peer) { return name.starts_with(peer); });
}

// How right a method is on a scene. An answer with the wrong verdict is infinitely wrong.
struct Outcome {
  std::size_t asked = 0;
  std::size_t wrong = 0;   // verdicts
  std::size_t unique = 0;  // pairs that have one best axis, and an answer with a normal
  std::size_t turned = 0;  // of these, normals off by more than a millionth of a degree
  std::size_t astray = 0;  // and by more than a degree
  Real median = kNone;     // error of depth or distance [m]; not a number if it gives none
  Real nearlyAll = kNone;  // 99 of 100 are no larger [m]
  Real largest = kNone;    // [m]
  Real points = 0;         // of contact, on average
};

struct Row {
  std::string method;
  Timing time;
  Outcome outcome;
};

struct Scene {
  std::string name;
  Real gap = 0;     // wanted [m]
  int corners = 8;  // of each body
  std::vector<Row> rows;
};

// Depths of bodies that overlap are compared, and distances where the judge knows them.
Outcome examine(const PairMethod& method, const std::vector<Judgement>& truth) {
  Outcome outcome;
  outcome.asked = std::min(truth.size(), method.most);
  std::vector<Real> errors;
  bool silent = false;  // right, but without a number
  for (std::size_t i = 0; i < outcome.asked; ++i) {
    const PairAnswer answer = method.run(i);
    const Judgement& t = truth[i];
    outcome.points += answer.points / static_cast<Real>(outcome.asked);
    const bool apart = t.gap > 0;
    if (answer.hit == apart) {
      ++outcome.wrong;
      errors.push_back(kInfinity);
      continue;
    }
    if (std::isnan(answer.separation) || (apart && t.distance == 0)) {
      silent = true;
    } else {
      const long double right = apart ? t.distance : t.gap;
      errors.push_back(static_cast<Real>(std::abs(answer.separation - right)));
    }
    if (apart || answer.normal.isZero(0) || t.gap - t.second <= 1e-9L) continue;
    constexpr Real kDegree = 3.14159265358979 / 180;
    const Real sine = carom::cross(answer.normal, t.axis).norm();
    const bool backwards = answer.normal.dot(t.axis) < 0;
    ++outcome.unique;
    outcome.turned += backwards || sine > 1e-6 * kDegree;
    outcome.astray += backwards || sine > std::sin(kDegree);
  }
  // What only says yes or no has no error to show.
  if (silent) return outcome;
  std::sort(errors.begin(), errors.end());
  outcome.median = errors[errors.size() / 2];
  outcome.nearlyAll = errors[errors.size() * 99 / 100];
  outcome.largest = errors.back();
  return outcome;
}

// Not timed if `timed` is zero; otherwise so many of the pairs are.
Scene run(Scene scene, const std::vector<PairMethod>& methods, const std::vector<Judgement>& truth,
          std::size_t timed, const Options& options) {
  std::vector<Timing> timings(methods.size());
  if (timed > 0) {
    std::vector<Case> cases;
    for (const PairMethod& method : methods) {
      const std::size_t count = std::min(timed, method.most);
      cases.push_back({method.name, count, [&method, count] {
                         for (std::size_t i = 0; i < count; ++i) keep(method.run(i));
                       }});
    }
    timings = carom::bench::measure(cases, options);
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    scene.rows.push_back({methods[m].name, timings[m], examine(methods[m], truth)});
  }
  return scene;
}

Scene boxScene(const char* name, Real gap, const std::vector<BodyPair>& pairs, std::size_t timed,
               const Options& options) {
  std::vector<ConvexShape> a, b;
  std::vector<Judgement> truth;
  for (const BodyPair& pair : pairs) {
    a.emplace_back(Box{pair.halfA});
    b.emplace_back(Box{pair.halfB});
    truth.push_back(carom::bench::judgeBoxes(pair));
  }
  return run({name, gap, 8, {}}, boxMethods(a, b, pairs), truth, timed, options);
}

Scene hullScene(int corners, Real gap, const Options& options) {
  constexpr std::size_t kPairs = 100;
  const std::vector<ConvexShape> a = {carom::bench::cloud(corners, 1)};
  const std::vector<ConvexShape> b = {carom::bench::cloud(corners, 2)};
  const ConvexHull &hullA = std::get<ConvexHull>(a[0]), &hullB = std::get<ConvexHull>(b[0]);
  const std::vector<BodyPair> pairs = carom::bench::hullPairs(hullA, hullB, kPairs, gap, 6);
  std::vector<Judgement> truth;
  for (const BodyPair& pair : pairs) truth.push_back(carom::bench::judgeHulls(hullA, hullB, pair));
  return run({"hulls", gap, corners, {}}, hullMethods(a, b, pairs), truth, kPairs, options);
}

void print(const Scene& scene) {
  carom::io::Table table;
  table.column("what").column("pairs", carom::io::fixed(0));
  table.column("ns per pair", carom::io::fixed(0));
  table.column("least", carom::io::fixed(0)).column("most", carom::io::fixed(0));
  table.column("points", carom::io::fixed(1)).column("wrong verdicts", carom::io::fixed(0));
  table.column("error, median", carom::io::scientific(1));
  table.column("of 99 in 100", carom::io::scientific(1));
  table.column("largest", carom::io::scientific(1));
  table.column("normals off by 1e-6 deg", carom::io::fixed(0));
  table.column("by 1 deg", carom::io::fixed(0));
  for (const Row& row : scene.rows) {
    const Outcome& o = row.outcome;
    const auto number = [](std::size_t n) { return static_cast<Real>(n); };
    const auto error = [](Real e) {
      return std::isnan(e) ? carom::io::Cell("-") : carom::io::Cell(e);
    };
    const auto time = [](Real ns) { return ns > 0 ? carom::io::Cell(ns) : carom::io::Cell("-"); };
    table.row({row.method, number(o.asked), time(row.time.median), time(row.time.least),
               time(row.time.most), o.points, number(o.wrong), error(o.median), error(o.nearlyAll),
               error(o.largest), number(o.turned), number(o.astray)});
  }
  std::cout << "\n"
            << scene.name << " of " << scene.corners << " corners, gap " << scene.gap << " m\n\n"
            << table << std::flush;
}

// Infinite and unknown are not numbers of JSON.
Json numberOrNull(Real number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

Json rowOf(const std::string& scene, const std::string& engine, std::size_t items) {
  return {{"suite", "narrowphase"},   {"scene", scene}, {"engine", engine},
          {"version", CAROM_VERSION}, {"threads", 1},   {"items", items}};
}

void addTime(Json& row, const Timing& t) {
  if (t.median > 0) row.update({{"ns_per_item", t.median}, {"least", t.least}, {"most", t.most}});
}

void addRows(const Scene& scene, Json& rows) {
  for (const Row& r : scene.rows) {
    Json row = rowOf(scene.name, r.method, r.outcome.asked);
    row["gap"] = scene.gap;
    row["corners"] = scene.corners;
    addTime(row, r.time);
    row["counters"] = {{"points", r.outcome.points}};
    row["error"] = {
        {"wrong_verdicts", r.outcome.wrong},        {"median", numberOrNull(r.outcome.median)},
        {"p99", numberOrNull(r.outcome.nearlyAll)}, {"largest", numberOrNull(r.outcome.largest)},
        {"unique_normals", r.outcome.unique},       {"normals_off_1e-6_deg", r.outcome.turned},
        {"normals_off_1_deg", r.outcome.astray}};
    rows.push_back(row);
  }
}

// The edges of the diagrams: at the top nothing is right, at the bottom nothing is wrong.
constexpr Real kTop = 10;
constexpr Real kBottom = 1e-18;

// Peers are grey, and each of another grey.
carom::io::CurveStyle styleOf(std::size_t i, const std::string& name) {
  carom::io::CurveStyle style = carom::bench::styleOf(i, isPeer(name));
  if (isPeer(name)) {
    const auto grey = static_cast<std::uint8_t>(70 + 40 * (i % 3));
    style.color = carom::io::Color{grey, grey, grey};
  }
  return style;
}

bool isDrawn(const std::string& name) {
  // These lie on others: their figures are in the table.
  return name != "carom signed distance" && name != "carom apart?, axis kept" &&
         name != "libccd intersect";
}

void finish(carom::io::Plot& plot, const std::filesystem::path& file) {
  plot.size(980, 620).writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

// W7 and W8: one curve per method, one mark per scene.
void drawTimeAgainstError(const std::vector<Scene>& scenes, const std::string& title,
                          const std::string& shows, Real left, Real right, Real accepted,
                          Real Outcome::*error, const std::filesystem::path& file) {
  carom::io::Plot plot(title);
  plot.describe(shows);
  plot.xAxis("time [ns per pair]", carom::io::Scale::Logarithmic).xRange(left, right);
  plot.yAxis("error [m]", carom::io::Scale::Logarithmic).yRange(1e-22, kTop);
  for (std::size_t m = 0; m < scenes.front().rows.size(); ++m) {
    const std::string& name = scenes.front().rows[m].method;
    std::vector<Real> x, y;
    for (const Scene& scene : scenes) {
      const Row& row = scene.rows[m];
      if (std::isnan(row.outcome.*error)) continue;
      x.push_back(std::min(row.time.median, right));
      y.push_back(std::clamp(row.outcome.*error, kBottom, kTop));
    }
    if (!x.empty() && isDrawn(name)) plot.curve(name, x, y, styleOf(m, name));
  }
  plot.curve("accepted", {left, right}, {accepted, accepted},
             {.dashed = true, .width = 1, .color = carom::io::Color{90, 90, 90}});
  carom::bench::sign(plot, left * 1.15, 1e-19, 0.1);
  finish(plot, file);
}

// W7, second panel: how many verdicts are wrong, of both signs of a gap. Of methods that are always
// right only the names are shown.
void drawVerdicts(const std::vector<Scene>& scenes, const std::filesystem::path& file) {
  constexpr Real kLeast = 1e-5;  // drawn for none
  carom::io::Plot plot("Two boxes: how many verdicts are wrong");
  plot.describe(
      "Share of wrong verdicts against the gap or depth, both logarithmic. The curves of four "
      "methods rise from none towards small gaps. All others have no wrong verdict at any gap; "
      "their names stand in the picture.");
  plot.xAxis("gap or depth [m]", carom::io::Scale::Logarithmic).xRange(1e-13, 1);
  plot.yAxis("share of wrong verdicts", carom::io::Scale::Logarithmic).yRange(1e-11, 2);
  Real line = 2e-6;
  plot.label({1.5e-13, line}, "none of 8000, at no gap:");
  for (std::size_t m = 0; m < scenes.front().rows.size(); ++m) {
    const std::string& name = scenes.front().rows[m].method;
    std::vector<Real> x, y;
    std::size_t ever = 0;
    for (const Scene& scene : scenes) {
      if (scene.gap < 0) continue;
      for (const Scene& other : scenes) {
        if (other.gap != -scene.gap) continue;
        const Outcome &apart = scene.rows[m].outcome, &deep = other.rows[m].outcome;
        const std::size_t wrong = apart.wrong + deep.wrong, asked = apart.asked + deep.asked;
        ever += wrong;
        x.push_back(scene.gap);
        y.push_back(std::max(static_cast<Real>(wrong) / static_cast<Real>(asked), kLeast));
      }
    }
    if (ever > 0) {
      plot.curve(name, x, y, styleOf(m, name));
    } else {
      plot.label({3e-13, line *= 0.4}, name);
    }
  }
  carom::bench::sign(plot, 1e-7, 3e-10, 0.25);
  finish(plot, file);
}

// W9: wrong answers per million, for whole numbers and for tenths.
void drawGrid(const std::vector<VerdictRow>& rows, bool plane, const std::string& title,
              const std::filesystem::path& file) {
  constexpr Real kLeast = 1;  // drawn for none
  carom::io::Plot plot(title);
  plot.describe(
      "Wrong answers per million against time per pair, both logarithmic. Methods with doubles "
      "stand at thousands; Carom's filter with exact numbers and CGAL's exact kernels stand at the "
      "lower edge, which means none.");
  plot.xAxis("time [ns per pair]", carom::io::Scale::Logarithmic).xRange(10, 100000);
  plot.yAxis("wrong answers per million", carom::io::Scale::Logarithmic).yRange(0.003, 100000);
  std::size_t m = 0;
  for (const VerdictRow& whole : rows) {
    // The judge is slower than its kernel with inexact constructions, and would cover it.
    if (whole.plane != plane || whole.tenths || whole.method == "CGAL Epeck") continue;
    std::vector<Real> x, y;
    for (const VerdictRow& row : rows) {
      if (row.plane != plane || row.method != whole.method) continue;
      x.push_back(row.time.median);
      const Real perMillion = 1e6 * static_cast<Real>(row.wrong) / static_cast<Real>(row.asked);
      // Not all on one line, where they would hide each other.
      y.push_back(row.wrong > 0 ? perMillion : kLeast * std::pow(0.7, m));
    }
    plot.curve(whole.method, x, y, styleOf(m, whole.method));
    ++m;
  }
  plot.label({1.2e4, 0.3 * kLeast}, "below 1: none");
  carom::bench::sign(plot, 11, 0.05, 0.35);
  finish(plot, file);
}

void print(const std::vector<VerdictRow>& rows, Json& json) {
  carom::io::Table table;
  table.column("bodies").column("what").column("ns per pair", carom::io::fixed(0));
  table.column("least", carom::io::fixed(0)).column("most", carom::io::fixed(0));
  table.column("pairs", carom::io::fixed(0)).column("that meet", carom::io::fixed(0));
  table.column("wrong", carom::io::fixed(0)).column("per million", carom::io::fixed(0));
  for (const VerdictRow& row : rows) {
    const std::string bodies = std::string(row.plane ? "triangles" : "tetrahedra") +
                               (row.tenths ? ", tenths" : ", whole numbers");
    const Real asked = static_cast<Real>(row.asked), wrong = static_cast<Real>(row.wrong);
    table.row({bodies, row.method, row.time.median, row.time.least, row.time.most, asked,
               static_cast<Real>(row.common), wrong, 1e6 * wrong / asked});
    Json entry = rowOf(bodies, row.method, row.asked);
    addTime(entry, row.time);
    entry["counters"] = {{"meet", row.common}};
    entry["error"] = {{"wrong_verdicts", row.wrong}, {"per_million", 1e6 * wrong / asked}};
    json.push_back(entry);
  }
  std::cout << "\nDo they have a point in common?\n\n" << table << std::flush;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "narrowphase"}, {"circumstances", carom::bench::circumstances(options)}};
  std::cout << carom::bench::circumstancesInALine() << '\n';
  Json rows = Json::array();
  const auto add = [&rows](Scene scene, std::vector<Scene>& to) {
    print(scene);
    addRows(scene, rows);
    to.push_back(std::move(scene));
  };

  constexpr std::size_t kPairs = 4000, kTimed = 400;
  std::vector<Scene> deep, all, others;
  const auto anyBoxes = [&](Real gap, std::size_t timed) {
    return boxScene("boxes", gap, carom::bench::boxPairs(kPairs, gap, 77), timed, options);
  };
  for (const Real gap : {-0.1, -0.02, -1e-3, -1e-6, -1e-9, -1e-12}) {
    add(anyBoxes(gap, kTimed), deep);
    all.push_back(deep.back());
  }
  for (const Real gap : {1e-12, 1e-9, 1e-6, 1e-3, 0.1}) add(anyBoxes(gap, 0), all);
  add(anyBoxes(0.05, kTimed), others);
  constexpr Real kSunk = 1e-3;
  add(boxScene("standing boxes", -kSunk, carom::bench::standingBoxes(kPairs, kSunk, 9), kTimed,
               options),
      others);

  std::vector<Scene> hullsDeep, hullsApart;
  for (const int corners : {8, 16, 20, 32, 64, 128}) {
    add(hullScene(corners, -0.02, options), hullsDeep);
    add(hullScene(corners, 0.05, options), hullsApart);
  }

  const std::vector<VerdictRow> verdicts = carom::bench::raceOfVerdicts(options);
  if (verdicts.empty()) {
    std::cout << "\nCGAL is left out, and with it the exact verdicts: install libcgal-dev\n";
  } else {
    print(verdicts, rows);
  }
  figures["rows"] = rows;
  carom::bench::writeJson(options, figures);
  if (options.plots.empty()) return 0;

  std::filesystem::create_directories(options.plots);
  drawTimeAgainstError(
      deep, "Two boxes that overlap: time against error of the depth",
      "One curve per method, one mark per depth from 0.1 m to 1e-12 m; the error that 99 of 100 "
      "pairs stay below. At the top edge more than one verdict in a hundred is wrong.",
      50, 20000, 1e-14, &Outcome::nearlyAll, options.plots / "box_time_error.svg");
  drawVerdicts(all, options.plots / "box_verdicts.svg");
  const std::string marks = "One curve per method, one mark per number of corners from 8 to 128.";
  drawTimeAgainstError(hullsDeep, "Two hulls that overlap by 2 cm: time against error of the depth",
                       marks, 100, 1e8, 1e-14, &Outcome::largest, options.plots / "hull_depth.svg");
  drawTimeAgainstError(hullsApart, "Two hulls 5 cm apart: time against error of the distance",
                       marks, 100, 1e8, 1e-14, &Outcome::largest,
                       options.plots / "hull_distance.svg");
  if (verdicts.empty()) return 0;
  drawGrid(verdicts, true, "Do two triangles meet? First mark: whole numbers; second: tenths",
           options.plots / "verdicts_plane.svg");
  drawGrid(verdicts, false, "Do two tetrahedra meet? First mark: whole numbers; second: tenths",
           options.plots / "verdicts_space.svg");
}
