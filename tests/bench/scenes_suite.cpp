// The suite `scenes`: the same scenes in Carom and in every engine that was found, each with its
// best settings: processor time, and how wrong the motion is.
//
// Errors come from poses and geometry, never from what an engine says of itself. Every run has a
// process of its own. With --rates 30,60,...,960 and --plots it draws diagrams of error against
// time for the scenes that have an answer.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "bench/bench.hpp"
#include "bench/scenes_rows.hpp"
#include "carom_io/plot.hpp"

using carom::Real;
using carom::bench::Json;
using carom::bench::SceneOptions;

namespace {

// A diagram: scenes and the figure that is drawn of each.
struct Diagram {
  const char* file;
  const char* title;
  const char* scene;
  const char* figure;
  const char* axis;
  Real accepted;  ///< the error that the case book calls excellent
};

const std::vector<Diagram> kDiagrams{
    {"bouncing.svg", "49 balls bounce without loss (S2)", "S2_bouncing", "energy rms [1]",
     "rms error of the energy [1]", 1e-13},
    {"elastic_216.svg", "216 elastic balls (S3)", "S3_elastic", "energy rms [1]",
     "rms error of the energy [1]", 1e-12},
    {"inelastic_216.svg", "216 balls that do not bounce (S3)", "S3_inelastic",
     "mean sum of squares [m^2]", "sum of squared penetration [m^2]", 1e-12},
    {"elastic_666.svg", "666 elastic balls in a room (E)", "E_elastic666", "energy rms [1]",
     "rms error of the energy [1]", 1e-9},
    {"gas.svg", "Eight hard balls in a box after 2 s (S8)", "S8_gas", "position 2.0 s [m]",
     "largest error of a position [m]", 5e-13},
    {"break.svg", "A break of 314 impacts (T13)", "T13_break314", "velocity [m/s]",
     "error of the velocities at the end [m/s]", 1e-12}};

constexpr Real kFloor = 1e-17;  // errors of zero have a place too

struct Curve {
  std::vector<Real> x, y, failed;
};

// Error over time of each engine, and the time of each run that failed.
std::map<std::string, Curve> curvesOf(const Diagram& diagram, const Json& rows, Real limit) {
  std::map<std::string, Curve> curves;
  for (const Json& row : rows) {
    if (row["scene"] != diagram.scene) continue;
    Curve& curve = curves[row["engine"].get<std::string>()];
    const Json error = row.contains("error") ? row["error"][diagram.figure] : Json();
    if (row.contains("failed") || !error.is_number()) {
      // What took too long says no more than the limit.
      curve.failed.push_back(row.value("ms_per_sim_s", 1000 * limit / row["duration"].get<Real>()));
      continue;
    }
    curve.x.push_back(row["ms_per_sim_s"].get<Real>());
    curve.y.push_back(std::max(kFloor, std::abs(error.get<Real>())));
  }
  return curves;
}

void draw(const Diagram& diagram, const Json& rows, Real limit,
          const std::filesystem::path& folder) {
  const std::map<std::string, Curve> curves = curvesOf(diagram, rows, limit);
  if (curves.empty()) return;
  carom::io::Plot plot(diagram.title);
  plot.describe(
      "Error against processor time per simulated second, both axes logarithmic; a mark "
      "for each length of step. Lower and further left is better; marks on the upper edge are runs "
      "that failed.");
  plot.size(980, 560).xAxis("processor time per simulated second [ms]",
                            carom::io::Scale::Logarithmic);
  plot.yAxis(diagram.axis, carom::io::Scale::Logarithmic);
  std::size_t number = 0;
  Real left = 1e300, right = 0, low = diagram.accepted, high = diagram.accepted;
  for (const auto& [name, curve] : curves) {
    for (const Real x : curve.x) left = std::min(left, x), right = std::max(right, x);
    for (const Real x : curve.failed) left = std::min(left, x), right = std::max(right, x);
    for (const Real y : curve.y) low = std::min(low, y), high = std::max(high, y);
  }
  // Room for those that failed, and for the lines that say where this was measured.
  const Real edge = 100 * high;
  for (const auto& [name, curve] : curves) {
    const bool peer = !name.starts_with("carom");
    carom::io::CurveStyle style = carom::bench::styleOf(number++, false);
    style.width = peer ? 1 : 3;
    if (!curve.x.empty()) plot.curve(name, curve.x, curve.y, style);
    if (curve.failed.empty()) continue;
    style.line = false;
    plot.curve(name + " fails", curve.failed, std::vector<Real>(curve.failed.size(), edge), style);
  }
  if (right <= left) right = 2 * left;
  plot.curve("excellent", {left, right}, {diagram.accepted, diagram.accepted},
             {.dashed = true, .width = 1, .color = carom::io::Color{30, 30, 30}});
  plot.xRange(left / 2, 2 * right).yRange(low / 1e5, 3 * edge);
  carom::bench::sign(plot, left / 1.5, low / 30, 0.05);
  plot.writeSvg(folder / diagram.file);
  std::cout << "wrote " << (folder / diagram.file).string() << '\n';
}

bool asked(const SceneOptions& options, const std::string& scene) {
  if (options.scenes.empty()) return true;
  return std::any_of(options.scenes.begin(), options.scenes.end(),
                     [&](const std::string& beginning) { return scene.starts_with(beginning); });
}

}  // namespace

int main(int argc, char** argv) {
  const SceneOptions options = carom::bench::readSceneOptions(argc, argv);
  const std::vector<carom::scenes::EngineKind> kinds = carom::bench::enginesOf(options);
  carom::bench::printEngines(kinds);
  const std::vector<carom::scenes::SceneEntry> entries = carom::scenes::allScenes();
  if (options.list) {
    for (const auto& entry : entries) std::cout << entry.name << ": " << entry.make().title << '\n';
    return 0;
  }
  Json figures{{"suite", "scenes"}, {"circumstances", carom::bench::circumstances(options.common)}};
  for (const auto& kind : kinds) figures["settings"][kind.name] = kind.settings;
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  Json rows = Json::array();
  for (const auto& entry : entries) {
    if (!asked(options, entry.name)) continue;
    const carom::scenes::Scene scene = entry.make();
    Json ofScene = Json::array();
    for (const auto& kind : kinds) {
      if (!carom::bench::runs(options, kind, scene)) continue;
      for (const Real rate : options.rates) {
        ofScene.push_back(carom::bench::rowOf("scenes", kind, scene, rate, options));
      }
    }
    std::cout << scene.name << ": " << scene.title << "\n\n";
    carom::bench::printRows(ofScene);
    for (Json& row : ofScene) rows.push_back(std::move(row));
  }
  figures["rows"] = rows;
  carom::bench::writeJson(options.common, figures);
  if (!options.common.plots.empty()) {
    std::filesystem::create_directories(options.common.plots);
    for (const Diagram& diagram : kDiagrams) {
      draw(diagram, rows, options.limit, options.common.plots);
    }
  }
}
