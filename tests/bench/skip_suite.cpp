// The suite `skip`: what bodies cost that do nothing interesting.
//
// Ten balls collide in a corner. Beside them lies a crowd that rests, flies, cannot turn, has no
// friction or does not move at all. First the time against the size of the crowd, with Carom's
// ideas of skipping and beside other engines with their sleeping on. Then each idea is switched off
// by itself: the counts must grow, and the hash of the final state must stay, or the idea changes
// what it should only skip.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "bench/scenes_rows.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#if defined(CAROM_SCENES_WORLD)
#include "scenes/engine_carom.hpp"
#endif

using carom::Real;
using carom::bench::Json;
using carom::bench::SceneOptions;
using carom::scenes::Quiet;

namespace {

constexpr Quiet kQuiet[] = {Quiet::immovable, Quiet::resting, Quiet::flying, Quiet::unturned,
                            Quiet::frictionless};

void race(const SceneOptions& options, Json& rows) {
  for (const Quiet quiet : kQuiet) {
    carom::io::Table table;
    using carom::io::significant;
    table.column("engine").column("crowd").column("us per simulated second", significant(4));
    table.column("times ten alone", significant(3));
    for (const auto& kind : carom::bench::enginesOf(options)) {
      Real alone = 0;
      bool tooSlow = false;
      for (int count = 0; count <= options.most && !tooSlow; count = std::max(100, 10 * count)) {
        const auto scene = carom::scenes::quietScene(quiet, count);
        if (!carom::bench::runs(options, kind, scene)) continue;
        Json row = carom::bench::rowOf("skip", kind, scene, options.rates.front(), options);
        row["crowd"] = carom::scenes::nameOf(quiet);
        row["others"] = count;
        tooSlow = row.contains("failed");
        if (tooSlow) {
          table.row({kind.name, count, row["failed"].get<std::string>(), ""});
        } else {
          const Real micro = 1000 * row["ms_per_sim_s"].get<Real>();
          if (count == 0) alone = micro;
          row["times_alone"] = alone > 0 ? micro / alone : 0;
          table.row({kind.name, count, micro, row["times_alone"].get<Real>()});
        }
        rows.push_back(row);
      }
    }
    std::cout << "Crowd: " << carom::scenes::nameOf(quiet) << "\n\n" << table << '\n' << std::flush;
  }
}

void draw(const Json& rows, const std::filesystem::path& folder) {
  for (const Quiet quiet : kQuiet) {
    const std::string crowd = carom::scenes::nameOf(quiet);
    std::map<std::string, std::pair<std::vector<Real>, std::vector<Real>>> curves;
    for (const Json& row : rows) {
      if (row.contains("failed") || row.value("crowd", "") != crowd) continue;
      auto& [x, y] = curves[row["engine"].get<std::string>()];
      x.push_back(std::max(10.0, row["others"].get<Real>()));
      y.push_back(std::max(1e-3, 1000 * row["ms_per_sim_s"].get<Real>()));
    }
    if (curves.empty()) continue;
    carom::io::Plot plot("Ten balls that collide, beside a crowd: " + crowd);
    plot.describe(
        "Processor time per simulated second against the size of the crowd, both axes "
        "logarithmic; the first mark of each curve is the ten balls alone.");
    plot.size(980, 560).xAxis("bodies beside the ten", carom::io::Scale::Logarithmic);
    plot.yAxis("processor time per simulated second [us]", carom::io::Scale::Logarithmic);
    std::size_t number = 0;
    for (const auto& [name, points] : curves) {
      plot.curve(name, points.first, points.second, carom::bench::styleOf(number++, false));
    }
    plot.writeSvg(folder / ("skip_" + crowd + ".svg"));
  }
}

#if defined(CAROM_SCENES_WORLD)

// An idea that is switched off, the crowd on which it must change nothing but the work, and the
// counter of that work.
struct Idea {
  const char* name;
  Quiet crowd;
  const char* counter;
  void (*switchOff)(carom::world::WorldSettings&);
};

const std::vector<Idea> kIdeas{
    {"pairs by a tree", Quiet::immovable, "pairs tested",
     [](carom::world::WorldSettings& s) { s.pairFinding = carom::world::PairFinding::allPairs; }},
    {"pairs by a tree", Quiet::resting, "pairs tested",
     [](carom::world::WorldSettings& s) { s.pairFinding = carom::world::PairFinding::allPairs; }},
    {"sleeping", Quiet::resting, "rows solved",
     [](carom::world::WorldSettings& s) { s.sleeping = false; }},
    {"no gyroscopic term for balls", Quiet::unturned, "exact rotations",
     [](carom::world::WorldSettings& s) { s.exactRotation = false; }},
    {"no friction rows without friction", Quiet::frictionless, "friction rows",
     [](carom::world::WorldSettings& s) { s.friction = false; }},
    {"no first contacts of the slow", Quiet::frictionless, "first contacts",
     [](carom::world::WorldSettings& s) { s.continuous = false; }}};

void ideas(const SceneOptions& options, Json& rows) {
  carom::io::Table table;
  table.column("idea").column("crowd").column("counter").column("with").column("without");
  table.column("same hash");
  for (const Idea& idea : kIdeas) {
    const auto scene = carom::scenes::quietScene(idea.crowd, std::min(1000, options.most));
    carom::world::WorldSettings off;
    idea.switchOff(off);
    Json both[2];
    for (int without = 0; without < 2; ++without) {
      const auto kind = without == 1 ? carom::scenes::caromWith(
                                           std::string("carom without ") + idea.name, "", off)
                                     : carom::scenes::caromWith("carom", "", {});
      both[without] = carom::bench::rowOf("skip", kind, scene, options.rates.front(), options);
      both[without]["idea"] = idea.name;
      rows.push_back(both[without]);
    }
    if (both[0].contains("failed") || both[1].contains("failed")) {
      table.row({idea.name, carom::scenes::nameOf(idea.crowd), idea.counter, "failed", "", ""});
      continue;
    }
    const auto count = [&](int without) {
      return static_cast<long>(both[without]["counters"][idea.counter].get<Real>());
    };
    table.row({idea.name, carom::scenes::nameOf(idea.crowd), idea.counter, count(0), count(1),
               both[0]["hash"] == both[1]["hash"] ? "yes" : "no"});
  }
  std::cout << "Each idea by itself, 1000 bodies beside the ten\n\n" << table << '\n';
}

#endif

}  // namespace

int main(int argc, char** argv) {
  const SceneOptions options = carom::bench::readSceneOptions(argc, argv);
  carom::bench::printEngines(carom::bench::enginesOf(options));
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  Json figures{{"suite", "skip"}, {"circumstances", carom::bench::circumstances(options.common)}};
  Json rows = Json::array();
#if defined(CAROM_SCENES_WORLD)
  ideas(options, rows);
#endif
  race(options, rows);
  figures["rows"] = rows;
  carom::bench::writeJson(options.common, figures);
  if (!options.common.plots.empty()) {
    std::filesystem::create_directories(options.common.plots);
    draw(rows, options.common.plots);
  }
}
