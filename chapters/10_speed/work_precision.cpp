// What does a digit cost?
//
// Two scenes with a known end, each by every mode of the world: fixed steps with and without the
// times of events, and steps that fit an error with and without extrapolation. Each mode runs with
// finer and finer settings. Work is counted in rows set up, so that the diagram is the same on
// every machine.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "known_scenes.hpp"

constexpr Real kTime = 0.45;       // of the motion [s]
constexpr Real kSmallest = 1e-15;  // errors below are drawn here: a logarithm has no zero

struct Point {
  Real work = 0, error = 0;
};

struct Mode {
  const char* name;
  bool chosen;    // by the error, not of one length
  bool events;    // their times are found
  bool together;  // tries are put together
};

constexpr Mode kModes[] = {{"steps, events at their start", false, false, true},
                           {"steps", false, true, true},
                           {"by error, one try", true, true, false},
                           {"by error", true, true, true}};

// One run: in 27 * 2^setting steps, or with a tolerance of 10^-setting.
Point runOnce(const Known& known, const Mode& mode, int setting) {
  carom::world::WorldSettings settings;
  settings.sleeping = false;
  settings.locateEvents = mode.events;
  settings.extrapolation = mode.together;
  World world(settings);
  addGround(world);
  const BodyId body = known.add(world);
  Point point;
  if (mode.chosen) {
    Real tolerance = 1;
    for (int i = 0; i < setting; ++i) tolerance /= 10;
    world.advance(kTime, tolerance);
    point.work = static_cast<Real>(rowsOf(world));
  } else {
    const int count = 27 << setting;
    for (int k = 0; k < count; ++k) {
      world.step(kTime / count);
      point.work += static_cast<Real>(rowsOf(world));
    }
  }
  point.error = std::max(known.error(world, body, kTime), kSmallest);
  return point;
}

std::vector<Point> curveOf(const Known& known, const Mode& mode) {
  std::vector<Point> points;
  const int most = !mode.chosen ? 9 : mode.together ? 11 : 7;
  for (int setting = mode.chosen ? 2 : 0; setting <= most; ++setting) {
    points.push_back(runOnce(known, mode, setting));
  }
  return points;
}

// Rows for an error, between the two points around it; none: too few.
std::string rowsFor(const std::vector<Point>& points, Real error) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].error <= error) return std::to_string(static_cast<long>(points[i].work));
  }
  return "-";
}

void draw(const Known& known, const std::vector<std::vector<Point>>& curves,
          const std::filesystem::path& file) {
  carom::io::Plot plot("What a digit costs: " + known.name);
  plot.describe(
      "Error over work, both logarithmic. The curves of fixed steps fall slowly, those of steps "
      "that fit an error steeply.");
  plot.xAxis("rows set up", carom::io::Scale::Logarithmic);
  plot.yAxis("error at the end [m, rad]", carom::io::Scale::Logarithmic).size(760, 480);
  for (std::size_t m = 0; m < curves.size(); ++m) {
    std::vector<Real> x, y;
    for (const Point& point : curves[m]) {
      x.push_back(point.work);
      y.push_back(point.error);
    }
    plot.curve(kModes[m].name, x, y, {.marks = true});
  }
  plot.writeSvg(file);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::cout << "Rows set up until the error is below\n\n";
  for (const Known& known : knownScenes()) {
    if (known.add == addBouncing) continue;  // nothing to choose: it is exact in any mode
    carom::io::Table table;
    table.column(known.name).column("1e-3").column("1e-6").column("1e-9");
    std::vector<std::vector<Point>> curves;
    for (const Mode& mode : kModes) {
      curves.push_back(curveOf(known, mode));
      const std::vector<Point>& points = curves.back();
      table.row({mode.name, rowsFor(points, 1e-3), rowsFor(points, 1e-6), rowsFor(points, 1e-9)});
    }
    std::cout << table << '\n';
    const bool tips = known.add == addTipping;
    draw(known, curves, folder / (tips ? "work_precision.svg" : "work_precision_shot.svg"));
  }
}
