// The suite `growth`: what a step costs when there are more bodies, from a hundred to a hundred
// thousand, spread over a floor and in a heap.
//
// Counters beside the time: where the time grows faster than the work, the machine's caches are to
// blame; where the work grows faster than n log n, the program is. Memory and allocations too: a
// step that asks for memory in its hundredth frame will do so in its millionth.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "bench/scenes_rows.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::bench::Json;
using carom::bench::SceneOptions;

namespace {

Real nLogN(Real n) {
  return n * std::log2(n);
}

Real counterOf(const Json& row, const char* name) {
  const auto found = row["counters"].find(name);
  return found == row["counters"].end() ? 0 : found->get<Real>();
}

// How much faster than n log n something grows between the first row and this one.
Real beyond(Real first, Real firstCount, Real now, Real count) {
  return first > 0 ? now / first / (nLogN(count) / nLogN(firstCount)) : 0;
}

// One engine, one kind of crowd; rows of rising count.
void printGrowth(std::vector<Json>& rows) {
  carom::io::Table table;
  using carom::io::significant;
  table.column("engine").column("bodies").column("ms a step", significant(3));
  table.column("time / n log n", significant(3)).column("pairs / n log n", significant(3));
  table.column("rows / n log n", significant(3)).column("contact points");
  table.column("bytes a body", significant(4)).column("allocations a step", significant(3));
  const Json* first = nullptr;
  for (Json& row : rows) {
    const std::string engine = row["engine"].get<std::string>();
    const auto bodies = static_cast<Real>(row["bodies"].get<int>() - 1);
    if (row.contains("failed")) {
      table.row({engine, static_cast<long>(bodies), row["failed"].get<std::string>(), "", "", "",
                 "", "", ""});
      continue;
    }
    if (first == nullptr) first = &row;
    const auto firstBodies = static_cast<Real>((*first)["bodies"].get<int>() - 1);
    const auto growth = [&](Real before, Real now) {
      return beyond(before, firstBodies, now, bodies);
    };
    const Real time = growth((*first)["ms_per_step"].get<Real>(), row["ms_per_step"].get<Real>());
    const Real pairs = growth(counterOf(*first, "pairs tested"), counterOf(row, "pairs tested"));
    const Real solved = growth(counterOf(*first, "rows solved"), counterOf(row, "rows solved"));
    const Real asked = static_cast<Real>(row["allocations"].get<long>()) /
                       static_cast<Real>(row["steps"].get<long>());
    row["growth"] = {{"time", time}, {"pairs", pairs}, {"rows", solved}};
    row["bytes_per_body"] = row["bytes"].get<Real>() / bodies;
    row["allocations_per_step"] = asked;
    table.row({engine, static_cast<long>(bodies), row["ms_per_step"].get<Real>(), time, pairs,
               solved, static_cast<long>(counterOf(row, "contact points")),
               row["bytes_per_body"].get<Real>(), asked});
  }
  std::cout << table << '\n' << std::flush;
}

void draw(const Json& rows, const std::string& crowd, const std::filesystem::path& folder) {
  std::map<std::string, std::pair<std::vector<Real>, std::vector<Real>>> curves;
  for (const Json& row : rows) {
    if (row.contains("failed") || !row["scene"].get<std::string>().starts_with(crowd)) continue;
    auto& [x, y] = curves[row["engine"].get<std::string>()];
    x.push_back(row["bodies"].get<Real>());
    y.push_back(std::max(1e-6, row["ms_per_step"].get<Real>()));
  }
  if (curves.empty()) return;
  carom::io::Plot plot("Cost of a step: bodies " + crowd);
  plot.describe("Time of a step against the number of bodies, both axes logarithmic.");
  plot.size(980, 560).xAxis("bodies", carom::io::Scale::Logarithmic);
  plot.yAxis("time of a step [ms]", carom::io::Scale::Logarithmic);
  std::size_t number = 0;
  for (const auto& [name, points] : curves) {
    plot.curve(name, points.first, points.second, carom::bench::styleOf(number++, false));
  }
  plot.writeSvg(folder / ("growth_" + crowd + ".svg"));
}

}  // namespace

int main(int argc, char** argv) {
  const SceneOptions options = carom::bench::readSceneOptions(argc, argv);
  const auto kinds = carom::bench::enginesOf(options);
  carom::bench::printEngines(kinds);
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  Json figures{{"suite", "growth"}, {"circumstances", carom::bench::circumstances(options.common)}};
  figures["rows"] = Json::array();
  for (const bool pile : {false, true}) {
    for (const auto& kind : kinds) {
      std::vector<Json> rows;
      bool tooSlow = false;  // for one count: then for all larger ones
      for (int count = 100; count <= options.most && !tooSlow; count *= 10) {
        const auto scene =
            pile ? carom::scenes::pileScene(count) : carom::scenes::spreadScene(count);
        if (!carom::bench::runs(options, kind, scene)) continue;
        rows.push_back(carom::bench::rowOf("growth", kind, scene, options.rates.front(), options));
        tooSlow = rows.back().contains("failed");
      }
      if (rows.empty()) continue;
      std::cout << (pile ? "In a heap\n\n" : "Spread over a floor\n\n");
      printGrowth(rows);
      for (const Json& row : rows) figures["rows"].push_back(row);
    }
  }
  carom::bench::writeJson(options.common, figures);
  if (!options.common.plots.empty()) {
    std::filesystem::create_directories(options.common.plots);
    for (const char* crowd : {"spread", "pile"}) draw(figures["rows"], crowd, options.common.plots);
  }
}
