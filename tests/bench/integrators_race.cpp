#include "bench/integrators_race.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "carom_io/table.hpp"

namespace carom::bench {

void Race::time(const Options& options) {
  const std::vector<Timing> timings = measure(cases_, options);
  std::size_t next = 0;
  for (RaceCurve& curve : curves_) {
    for (RacePoint& point : curve.points) point.time = timings[next++];
  }
}

Real timeFor(const RaceCurve& curve, Real level) {
  Real best = std::numeric_limits<Real>::infinity();
  const auto cost = [](const RacePoint& p) { return p.time.median / 1000; };
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const RacePoint& b = curve.points[i];
    if (!(b.error <= level)) continue;
    best = std::min(best, cost(b));
    if (i == 0) continue;
    const RacePoint& a = curve.points[i - 1];
    if (!(a.error > level) || !std::isfinite(a.error)) continue;
    // An error of zero by chance is not taken at its word.
    const Real fine = std::max(b.error, level / 1e4);
    const Real part = std::log(a.error / level) / std::log(a.error / fine);
    best = std::min(best, cost(a) * std::pow(cost(b) / cost(a), part));
  }
  return std::isfinite(best) ? best : 0;
}

bool Race::hasClosedForm() const {
  return std::any_of(curves_.begin(), curves_.end(),
                     [](const RaceCurve& c) { return std::string(c.kind) == "query"; });
}

Comparison Race::compare(Real level, bool closedForms) const {
  Comparison c;
  for (const RaceCurve& curve : curves_) {
    if (!closedForms && std::string(curve.kind) == "query") continue;
    const Real t = timeFor(curve, level);
    if (t == 0) continue;
    Real& best = curve.peer ? c.peerTime : c.ourTime;
    if (best != 0 && t >= best) continue;
    best = t;
    (curve.peer ? c.peer : c.ours) = curve.name;
  }
  return c;
}

void Race::print(const std::vector<Real>& levels) const {
  io::Table table;
  table.column("method").column("least error", io::scientific(1));
  for (const Real level : levels) {
    const int power = static_cast<int>(std::lround(std::log10(level)));
    table.column("us/s at 1e" + std::to_string(power));
  }
  for (const RaceCurve& curve : curves_) {
    Real least = std::numeric_limits<Real>::infinity();
    for (const RacePoint& p : curve.points) {
      if (p.error < least) least = p.error;
    }
    std::vector<io::Cell> cells = {curve.name, least};
    for (const Real level : levels) {
      const Real t = timeFor(curve, level);
      char text[32];
      std::snprintf(text, sizeof text, "%.3g", t);
      cells.emplace_back(t > 0 ? std::string(text) : std::string("-"));
    }
    table.row(cells);
  }
  std::cout << '\n' << scene_ << ", error in " << unit_ << "\n\n" << table;
}

void Race::write(Json& rows) const {
  for (const RaceCurve& curve : curves_) {
    for (const RacePoint& p : curve.points) {
      Json row = {{"suite", "integrators"},
                  {"scene", scene_},
                  {"engine", curve.name},
                  {"version", CAROM_VERSION},
                  {curve.kind, p.setting},
                  {"threads", 1},
                  {"sim_s", duration_},
                  {"cpu_s", p.time.median * 1e-9 * duration_},
                  {"least", p.time.least * 1e-9 * duration_},
                  {"most", p.time.most * 1e-9 * duration_}};
      // JSON has no infinity: a run that failed says so.
      if (std::isfinite(p.error)) {
        row["error"] = {{unit_, p.error}};
      } else {
        row["failed"] = true;
      }
      rows.push_back(row);
    }
  }
}

void Race::draw(const std::filesystem::path& file, const std::string& title,
                const std::string& text, Real level, Real low) const {
  constexpr Real kTop = 10;  // what failed stands here
  io::Plot plot(title);
  plot.describe(text);
  // As high as its list of names: gnuplot would put a longer one beside itself.
  const int height = std::max(640, 160 + 21 * static_cast<int>(curves_.size() + 1));
  plot.size(1000, height).xAxis("time per simulated second [us]", io::Scale::Logarithmic);
  plot.yAxis("error [" + unit_ + "]", io::Scale::Logarithmic).yRange(low / 1000, kTop);
  Real left = std::numeric_limits<Real>::infinity(), right = 0;
  std::size_t i = 0, peers = 0;
  std::vector<Real> failedX, failedY;
  for (const RaceCurve& curve : curves_) {
    std::vector<Real> x, y;
    for (const RacePoint& p : curve.points) {
      const Real t = p.time.median / 1000;
      left = std::min(left, t), right = std::max(right, t);
      if (!(p.error < kTop)) {
        failedX.push_back(t), failedY.push_back(kTop);
        continue;
      }
      x.push_back(t), y.push_back(std::max(p.error, low));
    }
    // Nine colours; the second nine are dashed. Peers are grey, every other one dashed.
    io::CurveStyle style = styleOf(i, curve.peer);
    style.dashed = curve.peer ? peers % 2 == 1 : i >= 9;
    if (!x.empty()) plot.curve(curve.name, x, y, style);
    ++(curve.peer ? peers : i);
  }
  if (!failedX.empty()) plot.points("off the axis", failedX, failedY);
  const Real edge = std::pow(10, std::floor(std::log10(left)));
  plot.xRange(edge, std::pow(10, std::ceil(std::log10(right))));
  plot.curve("", {edge, right}, {level, level},
             {.dashed = true, .width = 1, .color = io::Color{90, 90, 90}});
  sign(plot, edge * 1.3, low / 4, 0.2);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

}  // namespace carom::bench
