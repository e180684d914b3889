#include "bench/toi_features.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>

#include "bench/toi_methods.hpp"
#include "bench/toi_peers.hpp"
#include "carom/toi/exact_contact.hpp"
#include "carom/toi/feature_impact.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "support/ccd_queries.hpp"

namespace carom::bench {
namespace {

using carom_test::CcdQuery;
using Answer = std::optional<Real>;

struct Method {
  std::string name;
  std::function<Answer(const CcdQuery&)> answer;
  bool peer = false;
  bool isDrawn = true;  // in the diagram; the table has all
};

struct Result {
  std::string name;
  bool peer = false;
  bool isDrawn = true;
  Real mean = 0, median = 0, p99 = 0, most = 0;  // of a query [us]
  int falsePositives = 0, falseNegatives = 0, late = 0;
  Real medianError = 0, latest = 0, earliest = 0;  // of the time, unit: the motion
};

std::vector<CcdQuery> queries() {
  const std::string folder = CAROM_CCD_QUERIES_DIR;
  if (!folder.empty()) return carom_test::publicQueries(folder);
  return carom_test::ownQueries(CAROM_CASES_DIR "/toi_queries.json");
}

#if defined(CAROM_BENCH_FCL) || defined(CAROM_BENCH_TIGHT_INCLUSION)
Method peer(const std::string& name, std::function<PeerImpact(bool, const double*)> ask) {
  return {name,
          [ask](const CcdQuery& q) -> Answer {
            // Both arrays of points are twelve doubles in a row.
            static_assert(sizeof(MovingPoints) == 24 * sizeof(double));
            const PeerImpact found =
                ask(q.pair == FeaturePair::kVertexFace, q.points.start[0].data());
            return found.hit ? Answer(found.time) : std::nullopt;
          },
          true};
}
#endif

std::vector<Method> methods() {
  std::vector<Method> all;
  all.push_back({"carom", [](const CcdQuery& q) -> Answer {
                   const FeatureImpact found = q.pair == FeaturePair::kVertexFace
                                                   ? vertexFaceImpact(q.points)
                                                   : edgeEdgeImpact(q.points);
                   if (found.impact.status != ImpactStatus::kHit) return std::nullopt;
                   return found.impact.time;
                 }});
  all.push_back(
      {"carom, exact only", [](const CcdQuery& q) { return exactFirstContact(q.pair, q.points); }});
  for (const Real tolerance : {0.0, 1e-10, 1e-6}) {
    all.push_back(
        {"cubic with " + io::Cell(tolerance).text(io::significant(1)),
         [tolerance](const CcdQuery& q) { return cubicWithTolerance(q.pair, q.points, tolerance); },
         false, tolerance != 1e-10});
  }
  for (const Real tolerance : {1e-6, 1e-9}) {
    all.push_back({"advancing to " + io::Cell(tolerance).text(io::significant(1)),
                   [tolerance](const CcdQuery& q) {
                     return advanceFeatures(q.pair, q.points, tolerance, 1000);
                   },
                   false, tolerance != 1e-6});
  }
#ifdef CAROM_BENCH_FCL
  all.push_back(peer("FCL", featuresInFcl));
#endif
#ifdef CAROM_BENCH_TIGHT_INCLUSION
  for (const Real tolerance : {1e-3, 1e-6}) {
    all.push_back(peer("Tight-Inclusion " + io::Cell(tolerance).text(io::significant(1)),
                       [tolerance](bool face, const double* points) {
                         return featuresInTightInclusion(face, points, tolerance);
                       }));
  }
#endif
  return all;
}

Real processorMicroseconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e6 * static_cast<Real>(now.tv_sec) + 1e-3 * static_cast<Real>(now.tv_nsec);
}

Real microseconds(const Method& method, const CcdQuery& q, int repetitions) {
  const Real before = processorMicroseconds();
  for (int i = 0; i < repetitions; ++i) {
    const Answer answer = method.answer(q);
    keep(answer);
  }
  return (processorMicroseconds() - before) / repetitions;
}

// One query alone: the least of a few runs, each long enough for the clock. A query of more than a
// millisecond is timed twice.
Real timeOf(const Method& method, const CcdQuery& q, int runs) {
  Real least = microseconds(method, q, 1);
  if (least > 1000) return std::min(least, microseconds(method, q, 1));
  const int repetitions = 1 + static_cast<int>(20 / std::max(least, 0.1));
  for (int i = 0; i < runs; ++i) least = std::min(least, microseconds(method, q, repetitions));
  return least;
}

Result race(const Method& method, const std::vector<CcdQuery>& all, const Options& options) {
  Result result;
  result.name = method.name, result.peer = method.peer, result.isDrawn = method.isDrawn;
  std::vector<Real> times, errors;
  for (const CcdQuery& q : all) {
    const Answer answer = method.answer(q);
    result.falsePositives += !q.isHit && answer;
    result.falseNegatives += q.isHit && !answer;
    if (answer && q.time) {
      const auto ahead = static_cast<Real>(*q.time - static_cast<long double>(*answer));
      // The reference itself is known to 19 digits.
      const bool late = ahead < -1e-18;
      result.late += late;
      if (late) result.latest = std::max(result.latest, -ahead);
      result.earliest = std::max(result.earliest, ahead);
      errors.push_back(std::abs(ahead));
    }
    times.push_back(timeOf(method, q, options.runs));
  }
  for (const Real t : times) result.mean += t / static_cast<Real>(times.size());
  std::sort(times.begin(), times.end());
  std::sort(errors.begin(), errors.end());
  result.median = times[times.size() / 2];
  result.p99 = times[times.size() * 99 / 100];
  result.most = times.back();
  if (!errors.empty()) result.medianError = errors[errors.size() / 2];
  return result;
}

void draw(const std::vector<Result>& results, std::size_t count, const Options& options) {
  io::Plot plot("First contact of features: " + std::to_string(count) +
                " queries (+ false hits, - missed hits)");
  plot.describe(
      "One curve per method, from the median over the mean to the slowest hundredth of the "
      "queries, at the height of its worst error in time. The legend counts false hits, missed "
      "hits "
      "and late times.");
  plot.size(980, 620).xAxis("time of a query: median, mean, 99 % [us]", io::Scale::Logarithmic);
  plot.yAxis("worst error of the time, in motions", io::Scale::Logarithmic).yRange(1e-20, 10);
  Real left = 1, right = 1;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Result& r = results[i];
    if (!r.isDrawn) continue;
    std::vector<Real> x = {r.median, r.mean, r.p99};
    std::sort(x.begin(), x.end());
    left = std::min(left, x.front()), right = std::max(right, x.back());
    const Real error = std::clamp(std::max(r.latest, r.earliest), 1e-17, 1.0);
    io::CurveStyle style = styleOf(i, r.peer);
    style.marks = true;
    plot.curve(r.name + ": +" + std::to_string(r.falsePositives) + " -" +
                   std::to_string(r.falseNegatives) + ", " + std::to_string(r.late) + " late",
               x, {error, error, error}, style);
  }
  const Real edge = std::pow(10, std::floor(std::log10(left)));
  plot.xRange(edge, std::pow(10, std::ceil(std::log10(right))));
  sign(plot, edge * 1.3, 5e-18, 0.15);
  const auto file = options.plots / "vertex_face.svg";
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

}  // namespace

Json raceFeatures(const Options& options) {
  const std::vector<CcdQuery> all = queries();
  const std::string folder = CAROM_CCD_QUERIES_DIR;
  const std::string scene = folder.empty() ? "own queries" : "public sample queries";
  std::cout << "features: " << all.size() << " of the " << scene << "\n\n";
  std::vector<Result> results;
  for (const Method& method : methods()) results.push_back(race(method, all, options));

  io::Table table;
  table.column("method").column("mean us", io::significant(3)).column("median", io::significant(3));
  table.column("99 %", io::significant(3)).column("most", io::significant(3));
  table.column("false +").column("false -").column("late").column("by", io::scientific(1));
  table.column("early by", io::scientific(1));
  Json rows = Json::array();
  for (const Result& r : results) {
    table.row({r.name, r.mean, r.median, r.p99, r.most, r.falsePositives, r.falseNegatives, r.late,
               r.latest, r.earliest});
    rows.push_back(
        {{"suite", "toi"},
         {"scene", scene},
         {"engine", r.name},
         {"version", CAROM_VERSION},
         {"threads", 1},
         {"queries", all.size()},
         {"us", {{"mean", r.mean}, {"median", r.median}, {"p99", r.p99}, {"most", r.most}}},
         {"false_positives", r.falsePositives},
         {"false_negatives", r.falseNegatives},
         {"late", r.late},
         {"error", {{"latest", r.latest}, {"earliest", r.earliest}, {"median", r.medianError}}}});
  }
  std::cout << table << '\n';
  if (!options.plots.empty()) draw(results, all.size(), options);
  return rows;
}

}  // namespace carom::bench
