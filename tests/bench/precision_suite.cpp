// The suite `precision`: what digits cost.
//
// Ten million terms of mixed size added in many ways, time against error. Predicates on random
// points, on a grid, and on points that were rounded onto a line. And a body that moves, with its
// position in floats, doubles and cells, at growing distances from the origin.

#include <algorithm>
#include <cmath>
#include <iostream>

#include "bench/bench.hpp"
#include "bench/precision_peers.hpp"
#include "carom/core/random.hpp"
#include "carom/precision/cell_position.hpp"
#include "carom/precision/compensated_sum.hpp"
#include "carom/precision/double_double.hpp"
#include "carom/precision/exact_determinant.hpp"
#include "carom/precision/exact_orient2d.hpp"
#include "carom/precision/exact_sum.hpp"
#include "carom/precision/in_circle.hpp"
#include "carom/precision/lane_sum.hpp"
#include "carom/precision/orient2d.hpp"
#include "carom/precision/orient2d_filtered.hpp"
#include "carom/precision/relative_to_origin.hpp"
#include "carom/precision/sums.hpp"
#include "carom_io/table.hpp"

using carom::Random;
using carom::Real;
using carom::Vector2;
using carom::Vector3;
using carom::bench::Case;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::Timing;
using carom::io::scientific;

namespace {

constexpr std::size_t kTerms = 10000000;

Real doubleDoubleSum(std::span<const Real> terms) {
  carom::DoubleDouble sum;
  for (const Real term : terms) sum += term;
  return sum.value();
}

template <class Number>
Number exactSum(std::span<const Number> terms) {
  carom::ExactSum sum;
  for (const Number term : terms) sum.add(Real(term));
  return static_cast<Number>(sum.value());
}

template <class Number>
struct Adder {
  const char* name;
  std::function<Number(std::span<const Number>)> add;
  bool peer = false;
};

std::vector<Adder<Real>> doubleAdders() {
  using carom::bench::eigenSum, carom::bench::reduceSum;
  return {{"plain loop", carom::plainSum<Real>},
          {"std::reduce", [](auto t) { return reduceSum(t); }, true},
          {"Eigen sum", [](auto t) { return eigenSum(t); }, true},
          {"pairwise", carom::pairwiseSum<Real>},
          {"Kahan", carom::kahanSum<Real>},
          {"Neumaier (carom)", carom::compensatedSum},
          {"in lanes (carom)", carom::compensatedSumInLanes},
          {"double-double", doubleDoubleSum},
          {"exact", exactSum<Real>}};
}

std::vector<Adder<float>> floatAdders() {
  using carom::bench::eigenSum, carom::bench::reduceSum;
  return {{"plain loop", carom::plainSum<float>},
          {"std::reduce", [](auto t) { return reduceSum(t); }, true},
          {"Eigen sum", [](auto t) { return eigenSum(t); }, true},
          {"pairwise", carom::pairwiseSum<float>},
          {"Kahan", carom::kahanSum<float>},
          {"Neumaier", carom::neumaierSum<float>}};
}

struct Point {
  std::string name;
  bool peer = false;
  Real error = 0;
  Timing time;
};

// Of sizes from 1e-9 to 1e9 and both signs.
template <class Number>
std::vector<Number> mixedTerms() {
  Random random(17);
  std::vector<Number> terms(kTerms);
  for (Number& t : terms) {
    t = static_cast<Number>(std::ldexp(random.between(-1, 1), random.integer(-30, 30)));
  }
  return terms;
}

template <class Number>
std::vector<Point> sums(const std::vector<Adder<Number>>& adders, const Options& options) {
  const std::vector<Number> terms = mixedTerms<Number>();
  const std::span<const Number> view = terms;
  carom::ExactSum exact;
  for (const Number t : terms) exact.add(Real(t));
  std::vector<Point> points;
  std::vector<Case> cases;
  for (const Adder<Number>& a : adders) {
    points.push_back({a.name, a.peer, std::abs(Real(a.add(view)) / exact.value() - 1), {}});
    cases.push_back({a.name, kTerms, [&a, view] { keep(a.add(view)); }});
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].time = timings[i];
  return points;
}

void print(const char* title, const std::vector<Point>& points) {
  carom::io::Table table;
  table.column(title).column("ns per term", carom::io::significant(3));
  table.column("over plain", carom::io::fixed(2)).column("relative error", scientific(1));
  for (const Point& p : points) {
    table.row({p.name, p.time.median, p.time.median / points[0].time.median, p.error});
  }
  std::cout << '\n' << table;
}

// W17: time against error. An error of 0 stands at the lower edge.
void drawSums(const std::vector<Point>& doubles, const std::vector<Point>& floats,
              const std::filesystem::path& file) {
  carom::io::Plot plot("Ten million terms of mixed size: time against error");
  plot.describe("One mark per method and type. Plain sums are the least exact.");
  plot.size(980, 560).xAxis("time per term [ns]", carom::io::Scale::Logarithmic);
  plot.yAxis("relative error", carom::io::Scale::Logarithmic).yRange(1e-22, 1);
  std::size_t i = 0;
  Real left = 1e300, right = 0;
  for (const auto& [type, points] :
       {std::pair("double, ", &doubles), std::pair("float, ", &floats)}) {
    for (const Point& p : *points) {
      auto style = carom::bench::styleOf(i++, p.peer);
      style.marks = true;
      plot.curve(type + p.name, {p.time.median}, {std::max(p.error, 1e-17)}, style);
      left = std::min(left, p.time.median), right = std::max(right, p.time.median);
    }
  }
  const Real edge = std::pow(10, std::floor(std::log10(left)));
  plot.xRange(edge, std::pow(10, std::ceil(std::log10(right))));
  carom::bench::sign(plot, edge * 1.2, 1e-19, 0.1);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

Json rowsOf(const std::vector<Point>& points, const char* type) {
  Json rows = Json::array();
  for (const Point& p : points) {
    rows.push_back({{"suite", "precision"},
                    {"scene", std::string("W17, sum of 1e7 terms, ") + type},
                    {"engine", p.name},
                    {"ns_per_term", p.time.median},
                    {"least", p.time.least},
                    {"most", p.time.most},
                    {"over_plain", p.time.median / points[0].time.median},
                    {"error", {{"relative", p.error}}}});
  }
  return rows;
}

// --- Predicates ----------------------------------------------------------------------------------

constexpr std::size_t kQuestions = 4096;

struct Family {
  const char* name;
  std::vector<Vector2> threes, fours;
  std::vector<Vector3> inSpace;
};

Vector2 flat(const Vector3& p) {
  return p.head<2>();
}

Family randomFamily() {
  Random random(18);
  Family f{"random", {}, {}, {}};
  for (std::size_t i = 0; i < 4 * kQuestions; ++i) {
    const Vector3 p = random.vector();
    if (i < 3 * kQuestions) f.threes.push_back(flat(p));
    f.fours.push_back(flat(p));
    f.inSpace.push_back(p);
  }
  return f;
}

// Whole coordinates up to 7: a good part of the questions has the answer 0.
Family gridFamily() {
  Random random(19);
  Family f{"grid", {}, {}, {}};
  for (std::size_t i = 0; i < 4 * kQuestions; ++i) {
    const Vector3 p(random.integer(0, 7), random.integer(0, 7), random.integer(0, 7));
    if (i < 3 * kQuestions) f.threes.push_back(flat(p));
    f.fours.push_back(flat(p));
    f.inSpace.push_back(p);
  }
  return f;
}

// The last point of each is computed to lie on the line, circle or plane, and rounded.
Family roundedFamily() {
  Random random(20);
  Family f{"rounded", {}, {}, {}};
  for (std::size_t i = 0; i < kQuestions; ++i) {
    const Vector3 a = random.vector(), b = random.vector(), c = random.vector();
    const Vector2 center = flat(random.vector());
    for (const Vector2& p : {flat(a), flat(b), flat(Vector3(a + 2.5 * (b - a)))}) {
      f.threes.push_back(p);
    }
    for (int k = 0; k < 4; ++k) {
      const Real angle = 2 * k + random.between(0, 1);
      f.fours.push_back(center + Vector2(std::cos(angle), std::sin(angle)));
    }
    for (const Vector3& p : {a, b, c, Vector3(a + 1.5 * (b - a) + 0.75 * (c - a))}) {
      f.inSpace.push_back(p);
    }
  }
  return f;
}

template <class Real>
int signOf(Real x) {
  return (x > 0) - (x < 0);
}

template <class Point, class Ask>
Case threes(const char* name, const std::vector<Point>& points, Ask ask) {
  return {name, points.size() / 3, [&points, ask] {
            int sum = 0;
            for (std::size_t i = 0; i < points.size(); i += 3) {
              sum += ask(points[i], points[i + 1], points[i + 2]);
            }
            keep(sum);
          }};
}

template <class Point, class Ask>
Case fours(const char* name, const std::vector<Point>& points, Ask ask) {
  return {name, points.size() / 4, [&points, ask] {
            int sum = 0;
            for (std::size_t i = 0; i < points.size(); i += 4) {
              sum += ask(points[i], points[i + 1], points[i + 2], points[i + 3]);
            }
            keep(sum);
          }};
}

// As a function of a library, which the compiler does not see into.
[[gnu::noinline]] int calledLine(const Vector2& a, const Vector2& b, const Vector2& c) {
  return signOf(carom::orient2d<Real>(a, b, c));
}

[[gnu::noinline]] int calledCircle(const Vector2& a, const Vector2& b, const Vector2& c,
                                   const Vector2& d) {
  return signOf(carom::inCircleDeterminant<Real>(a, b, c, d));
}

[[gnu::noinline]] int plainPlane(const Vector3& o, const Vector3& a, const Vector3& b,
                                 const Vector3& c) {
  const Vector3 u = a - o, v = b - o, w = c - o;
  return signOf(u.x() * (v.y() * w.z() - v.z() * w.y()) + u.y() * (v.z() * w.x() - v.x() * w.z()) +
                u.z() * (v.x() * w.y() - v.y() * w.x()));
}

Json predicates(const Options& options) {
  const std::vector<Family> families = {randomFamily(), gridFamily(), roundedFamily()};
  std::vector<Case> cases;
  for (const Family& f : families) {
    cases.push_back(threes("line, plain", f.threes, [](auto& a, auto& b, auto& c) {
      return signOf(carom::orient2d<Real>(a, b, c));
    }));
    cases.push_back(threes("line, plain, called", f.threes, calledLine));
    cases.push_back(threes("line, filtered (carom)", f.threes, [](auto& a, auto& b, auto& c) {
      return carom::orient2dFiltered(a, b, c).sign;
    }));
    cases.push_back(threes("line, always exact", f.threes, carom::exactOrient2d));
    cases.push_back(fours("circle, plain, called", f.fours, calledCircle));
    cases.push_back(
        fours("circle, filtered (carom)", f.fours,
              [](auto& a, auto& b, auto& c, auto& d) { return carom::inCircle(a, b, c, d).sign; }));
    cases.push_back(fours("plane, plain, called", f.inSpace, plainPlane));
    cases.push_back(fours("plane, filtered (carom)", f.inSpace, carom::orientation));
#ifdef CAROM_BENCH_CGAL
    cases.push_back({"line, CGAL Epick", kQuestions,
                     [ask = carom::bench::cgalSides(f.threes)] { keep(ask()); }});
    cases.push_back({"circle, CGAL Epick", kQuestions,
                     [ask = carom::bench::cgalCircles(f.fours)] { keep(ask()); }});
    cases.push_back({"plane, CGAL Epick", kQuestions,
                     [ask = carom::bench::cgalPlanes(f.inSpace)] { keep(ask()); }});
#endif
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  const std::size_t kinds = cases.size() / families.size();
  carom::io::Table table;
  table.column("ns per question");
  for (const Family& f : families) table.column(f.name, carom::io::significant(3));
  Json rows = Json::array();
  for (std::size_t k = 0; k < kinds; ++k) {
    std::vector<carom::io::Cell> row = {cases[k].name};
    for (std::size_t f = 0; f < families.size(); ++f) {
      const Timing& t = timings[f * kinds + k];
      row.emplace_back(t.median);
      rows.push_back({{"suite", "precision"},
                      {"scene", std::string("predicates, ") + families[f].name},
                      {"engine", cases[k].name},
                      {"ns", t.median},
                      {"least", t.least},
                      {"most", t.most}});
    }
    table.row(row);
  }
  std::cout << '\n' << table;
  return rows;
}

// --- Far from the origin -------------------------------------------------------------------------

constexpr int kSteps = 600;

// Ten seconds at 0.6 m/s along x.
template <class Position, class Move>
Position drifted(Position p, Move move) {
  for (int i = 0; i < kSteps; ++i) p = move(p);
  return p;
}

struct Ways {
  Eigen::Vector3f floatStep{0.01f, 0, 0};
  Vector3 step{0.01, 0, 0};
  Eigen::Vector3f floats(const Vector3& from) const {
    return drifted(Eigen::Vector3f(from.cast<float>()),
                   [this](const Eigen::Vector3f& p) { return Eigen::Vector3f(p + floatStep); });
  }
  Vector3 doubles(const Vector3& from) const {
    return drifted(from, [this](const Vector3& p) { return Vector3(p + step); });
  }
  carom::FloatCellPosition floatCells(const carom::CellPosition& from) const {
    return drifted(carom::FloatCellPosition{from.cell, from.offset.cast<float>()},
                   [this](const auto& p) { return carom::moved(p, floatStep); });
  }
  carom::CellPosition cells(const carom::CellPosition& from) const {
    return drifted(from, [this](const auto& p) { return carom::moved(p, step); });
  }
};

const std::vector<std::string> kWays = {"floats", "doubles", "cells, floats", "cells, doubles"};

std::vector<Real> errorsAt(Real distance) {
  const Ways ways;
  const Vector3 from(distance, 0, 0);
  const carom::CellPosition home = carom::cellPosition(from);
  const auto off = [](Real moved) { return std::abs(moved - kSteps * 0.01); };
  return {off(Real(ways.floats(from).x()) - Real(static_cast<float>(distance))),
          off(ways.doubles(from).x() - distance),
          off(carom::relativeToOrigin(carom::inDoubles(ways.floatCells(home)), home).x()),
          off(carom::relativeToOrigin(ways.cells(home), home).x())};
}

Json farAway(const Options& options) {
  const Ways ways;
  Vector3 from(1e7, 0, 0);
  carom::CellPosition home = carom::cellPosition(from);
  const std::vector<Timing> timings =
      carom::bench::measure({{kWays[0], kSteps, [&] { keep(from), keep(ways.floats(from)); }},
                             {kWays[1], kSteps, [&] { keep(from), keep(ways.doubles(from)); }},
                             {kWays[2], kSteps, [&] { keep(home), keep(ways.floatCells(home)); }},
                             {kWays[3], kSteps, [&] { keep(home), keep(ways.cells(home)); }}},
                            options);
  carom::io::Table table;
  table.column("position in").column("ns per step", carom::io::significant(3));
  table.column("error at 1e3 m [m]", scientific(1)).column("at 1e7 m", scientific(1));
  Json rows = Json::array();
  const std::vector<Real> near = errorsAt(1e3), far = errorsAt(1e7);
  for (std::size_t i = 0; i < kWays.size(); ++i) {
    table.row({kWays[i], timings[i].median, near[i], far[i]});
    rows.push_back({{"suite", "precision"},
                    {"scene", "W17, 6 m in 600 steps"},
                    {"engine", kWays[i]},
                    {"ns", timings[i].median},
                    {"error", {{"at_1e3_m", near[i]}, {"at_1e7_m", far[i]}}}});
  }
  std::cout << '\n' << table;
  if (options.plots.empty()) return rows;

  carom::io::Plot plot("Six metres in 600 steps: error against distance from the origin");
  plot.describe("Errors of floats and doubles rise with the distance; those in cells do not.");
  plot.size(980, 560).xAxis("distance from the origin [m]", carom::io::Scale::Logarithmic);
  plot.yAxis("error [m]", carom::io::Scale::Logarithmic).yRange(1e-17, 100).xRange(1, 1e13);
  for (std::size_t way = 0; way < kWays.size(); ++way) {
    std::vector<Real> x, y;
    for (Real power = 0; power <= 12; power += 0.25) {
      x.push_back(std::pow(10, power));
      y.push_back(std::clamp(errorsAt(x.back())[way], 1e-16, 10.0));
    }
    plot.curve(kWays[way], x, y, {.marks = true});
  }
  plot.curve("accepted: 1e-9 m", {1, 1e12}, {1e-9, 1e-9}, {.dashed = true, .width = 1});
  const std::filesystem::path file = options.plots / "cells.svg";
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "precision"}, {"circumstances", carom::bench::circumstances(options)}};
  figures["circumstances"]["peer_sums"] = CAROM_BENCH_SUMS;
#ifdef CAROM_BENCH_CGAL
  figures["circumstances"]["cgal"] = CAROM_BENCH_CGAL;
#else
  std::cout << "CGAL is left out: install libcgal-dev\n";
#endif
  std::cout << carom::bench::circumstancesInALine() << '\n';
  if (!options.plots.empty()) std::filesystem::create_directories(options.plots);

  const std::vector<Point> doubles = sums(doubleAdders(), options);
  print("doubles", doubles);
  const std::vector<Point> floats = sums(floatAdders(), options);
  print("floats", floats);
  if (!options.plots.empty()) drawSums(doubles, floats, options.plots / "sums_time.svg");
  figures["sums"] = rowsOf(doubles, "double");
  for (const Json& row : rowsOf(floats, "float")) figures["sums"].push_back(row);
  figures["predicates"] = predicates(options);
  figures["far"] = farAway(options);
  carom::bench::writeJson(options, figures);
}
