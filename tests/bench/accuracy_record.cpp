#include "bench/accuracy_record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>

#include "carom_io/plot.hpp"

namespace carom::bench {
namespace {

using scenes::Comparison;
using scenes::CostAndError;
using scenes::NamedFront;
using scenes::Problem;
using scenes::Question;

std::vector<NamedFront> frontsOf(const std::vector<Curve>& curves, bool ours, Real rounding) {
  std::vector<NamedFront> fronts;
  for (const Curve& curve : curves) {
    if (curve.ours == ours) fronts.push_back({curve.name, frontOf(curve.runs, rounding)});
  }
  return fronts;
}

// The color of an engine is the same in all diagrams.
io::Color colorOf(const std::string& name) {
  constexpr std::array<std::pair<const char*, io::Color>, 6> kColors{{{"carom", {213, 94, 0}},
                                                                      {"box3d", {0, 158, 115}},
                                                                      {"bullet", {86, 180, 233}},
                                                                      {"jolt", {204, 121, 167}},
                                                                      {"mujoco", {120, 94, 240}},
                                                                      {"ode", {150, 120, 0}}}};
  for (const auto& [beginning, color] : kColors) {
    if (name.starts_with(beginning)) return color;
  }
  return {140, 140, 140};
}

// Five digits are more than a time is worth, and errors keep more than a picture shows.
Real rounded(Real number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", number);
  return std::strtod(text, nullptr);
}

// The tolerances of one engine are points of one curve.
std::string curveName(const std::string& engine) {
  const std::string advance = "carom advance";
  return engine.starts_with(advance) ? advance : engine;
}

Real powerOfTen(Real number, bool up) {
  const Real power = std::log10(number);
  return std::pow(10, up ? std::ceil(power) : std::floor(power));
}

}  // namespace

std::vector<Curve> curvesOf(const Problem& problem, const Question& question, const Json& rows) {
  std::vector<Curve> curves;
  for (const Json& row : rows) {
    const std::string name = curveName(row["engine"].get<std::string>());
    auto found = std::find_if(curves.begin(), curves.end(),
                              [&](const Curve& curve) { return curve.name == name; });
    if (found == curves.end()) {
      curves.push_back({name, name.starts_with("carom"), {}, {}});
      found = curves.end() - 1;
    }
    if (!row.contains("ms_per_sim_s") || !row["ms_per_sim_s"].is_number()) continue;
    const Real cost = 1000 * row["ms_per_sim_s"].get<Real>();
    const Json& errors = row["error"];
    const Json error = errors.value(question.figure, Json());
    const bool stands =
        problem.condition.empty() || errors.value(problem.condition, Json()) == Json(1.0);
    if (row.contains("failed") || !error.is_number() || !stands) {
      found->failed.push_back(cost);
    } else {
      found->runs.push_back({cost, std::abs(error.get<Real>())});
    }
  }
  return curves;
}

std::vector<Comparison> compared(const Question& question, const std::vector<Curve>& curves) {
  return compareFronts(frontsOf(curves, true, question.rounding),
                       frontsOf(curves, false, question.rounding));
}

Json recordOf(const Problem& problem, const Json& rows, const std::string& where) {
  Json record{{"title", problem.title}, {"where", where}};
  for (const Question& question : problem.questions) {
    const std::vector<Curve> curves = curvesOf(problem, question, rows);
    Json ofQuestion{{"axis", question.axis}, {"rounding", question.rounding}};
    ofQuestion["wanted"] = question.wanted;
    for (const Curve& curve : curves) {
      Json points = Json::array();
      for (const CostAndError& run : curve.runs) {
        points.push_back({rounded(run.cost), rounded(std::max(run.error, question.rounding))});
      }
      for (const Real cost : curve.failed) points.push_back({rounded(cost), nullptr});
      ofQuestion["engines"][curve.name] = points;
    }
    for (const Comparison& c : compared(question, curves)) {
      Json one{{"error", rounded(c.error)},
               {"best", c.theirs.name},
               {"us_per_s", rounded(c.theirs.cost)}};
      if (c.ours) {
        one["ours"] = c.ours->name;
        one["ours_us_per_s"] = rounded(c.ours->cost);
        one["ratio"] = rounded(c.ratio());
      }
      ofQuestion["compared"].push_back(one);
    }
    record["questions"][question.figure] = ofQuestion;
  }
  return record;
}

void keepRecords(const std::filesystem::path& file, const Json& records) {
  Json all = Json::object();
  if (std::ifstream old(file); old) all = Json::parse(old);
  for (const auto& item : records.items()) all[item.key()] = item.value();
  // In the order of the problems, whenever each of them was run; a line for each.
  std::ofstream text(file);
  const char* before = "{\n";
  for (const Problem& problem : scenes::allProblems()) {
    if (!all.contains(problem.name)) continue;
    text << before << Json(problem.name) << ": " << all[problem.name];
    before = ",\n";
  }
  text << "\n}\n";
  std::cout << "wrote " << file.string() << '\n';
}

void drawFronts(const std::filesystem::path& file, const Problem& problem, const Question& question,
                const std::vector<Curve>& curves) {
  Real left = 1e300, right = 0, low = question.rounding, high = 10 * question.rounding;
  for (const Curve& curve : curves) {
    for (const CostAndError& run : curve.runs) {
      left = std::min(left, run.cost), right = std::max(right, run.cost);
      high = std::max(high, run.error);
    }
    for (const Real cost : curve.failed) left = std::min(left, cost), right = std::max(right, cost);
  }
  if (right <= left) return;
  left = powerOfTen(left, false), right = powerOfTen(right, true);
  const Real top = 10 * powerOfTen(high, true), bottom = powerOfTen(low, false) / 1e3;

  io::Plot plot(problem.name + ": " + problem.title);
  plot.describe(
      "Error over processor time per simulated second, both logarithmic, one curve for each engine "
      "and a mark for each length of step or tolerance. Lower and further left is better. The "
      "dashed line is the front of all engines but Carom; marks on the upper edge are runs that "
      "failed; errors that rounding makes lie on one level.");
  plot.size(980, 620).xAxis("processor time per simulated second [us]", io::Scale::Logarithmic);
  plot.yAxis(question.axis, io::Scale::Logarithmic).xRange(left, right).yRange(bottom, 2 * top);
  std::vector<CostAndError> theirs;
  for (const bool ours : {false, true}) {
    for (const Curve& curve : curves) {
      if (curve.ours != ours) continue;
      io::CurveStyle style{.marks = true};
      style.width = ours ? 3 : 1;
      style.color = colorOf(curve.name);
      std::vector<Real> x, y;
      for (const CostAndError& run : curve.runs) {
        x.push_back(run.cost), y.push_back(std::max(run.error, question.rounding));
        if (!ours) theirs.push_back(run);
      }
      // What goes by tolerances is dashed beside what goes by steps.
      style.dashed = curve.name.find("advance") != std::string::npos;
      if (!x.empty()) plot.curve(curve.name, x, y, style);
      if (curve.failed.empty()) continue;
      style.line = false;
      plot.curve(x.empty() ? curve.name + " fails" : "", curve.failed,
                 std::vector<Real>(curve.failed.size(), top), style);
    }
  }
  const scenes::Front front = frontOf(theirs, question.rounding);
  if (!front.empty()) {
    // Steps: up to the next point nobody of them is better.
    std::vector<Real> x, y;
    for (std::size_t i = 0; i < front.size(); ++i) {
      if (i > 0) x.push_back(front[i].cost), y.push_back(front[i - 1].error);
      x.push_back(front[i].cost), y.push_back(front[i].error);
    }
    x.push_back(right), y.push_back(front.back().error);
    plot.curve("front of the others", x, y,
               {.dashed = true, .width = 2, .color = io::Color{60, 60, 60}});
  }
  sign(plot, left * 1.3, low / 5, 0.2);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

}  // namespace carom::bench
