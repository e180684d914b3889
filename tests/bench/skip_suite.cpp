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
      carom::io::CurveStyle style = carom::bench::styleOf(number++, false);
      style.width = name.starts_with("carom") ? 3 : 1;
      plot.curve(name, points.first, points.second, style);
    }
    plot.yRange(1, 3e8);
    carom::bench::sign(plot, 12, 1.5e8, 0.35);
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

void allPairs(carom::world::WorldSettings& settings) {
  settings.pairFinding = carom::world::PairFinding::allPairs;
}

void noSleep(carom::world::WorldSettings& settings) {
  settings.sleeping = false;
}

const std::vector<Idea> kIdeas{{"pairs by a tree", Quiet::immovable, "pairs tested", allPairs},
                               {"pairs by a tree", Quiet::resting, "pairs tested", allPairs},
                               {"pairs by a tree", Quiet::flying, "pairs tested", allPairs},
                               {"pairs by a tree", Quiet::frictionless, "pairs tested", allPairs},
                               {"sleeping", Quiet::resting, "bodies awake", noSleep},
                               {"sleeping", Quiet::resting, "rows solved", noSleep}};

// Work that a crowd gives no reason for: must not have been done once.
struct Needless {
  Quiet crowd;
  const char* counter;
};

const std::vector<Needless> kNeedless{
    {Quiet::unturned, "axes searches"},     {Quiet::unturned, "exact rotations"},
    {Quiet::unturned, "friction rows"},     {Quiet::frictionless, "axes searches"},
    {Quiet::frictionless, "friction rows"}, {Quiet::flying, "axes searches"},
    {Quiet::flying, "manifolds made"}};

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
  std::cout << "Each idea by itself, 1000 bodies beside the ten; counts are means of a step\n\n"
            << table << '\n';
}

void needless(const SceneOptions& options, Json& rows) {
  carom::io::Table table;
  table.column("crowd").column("counter").column("a step", carom::io::significant(4));
  table.column("ten alone", carom::io::significant(4));
  for (const Needless& work : kNeedless) {
    Json both[2];
    for (int crowd = 0; crowd < 2; ++crowd) {
      const auto scene =
          carom::scenes::quietScene(work.crowd, crowd == 0 ? 0 : std::min(1000, options.most));
      both[crowd] = carom::bench::rowOf("skip", carom::scenes::caromWith("carom", "", {}), scene,
                                        options.rates.front(), options);
    }
    rows.push_back(both[1]);
    if (both[0].contains("failed") || both[1].contains("failed")) {
      table.row({carom::scenes::nameOf(work.crowd), work.counter, "failed", ""});
    } else {
      table.row({carom::scenes::nameOf(work.crowd), work.counter,
                 both[1]["counters"][work.counter].get<Real>(),
                 both[0]["counters"][work.counter].get<Real>()});
    }
  }
  std::cout << "Work that the crowd gives no reason for: no more than ten alone\n\n"
            << table << '\n'
            << std::flush;
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
  needless(options, rows);
#endif
  race(options, rows);
  figures["rows"] = rows;
  carom::bench::writeJson(options.common, figures);
  if (!options.common.plots.empty()) {
    std::filesystem::create_directories(options.common.plots);
    draw(rows, options.common.plots);
  }
}
