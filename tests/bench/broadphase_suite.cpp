// The suite `broadphase`: time of a step's broad phase against the number of bodies, beside those
// of Bullet and ODE (diagram W10), and pairs that were missed.
//
// All engines see the same boxes, step by step, and take turns. A step is: every body that is awake
// says where it is, and the pairs are brought up to date. Bodies are put in, and some steps taken,
// before the clock runs. Every engine keeps to its own idea of room around a body: a pair is missed
// if the bodies' own boxes meet and it is not reported; pairs reported beyond those are counted as
// spare. What is true comes from a sweep that shares no line with the trees.

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "bench/broadphase_engines.hpp"
#include "bench/broadphase_scenes.hpp"
#include "carom/broadphase/all_pairs.hpp"
#include "carom/broadphase/broad_phase.hpp"
#include "carom/broadphase/pair_grid.hpp"
#include "carom/broadphase/sorted_sweep.hpp"
#include "carom/broadphase/sweep_and_prune.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Aabb;
using carom::BroadPhase;
using carom::IndexPair;
using carom::Real;
using carom::Vector3;
using carom::bench::BroadEngine;
using carom::bench::BroadScene;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::MovingBoxes;

namespace {

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

Aabb<3> boxAt(const double* boxes, std::int32_t i) {
  const double* at = boxes + 6 * i;
  return {Vector3(at[0], at[1], at[2]), Vector3(at[3], at[4], at[5])};
}

// Ours, behind the same door.
struct Carom : BroadEngine {
  BroadPhase phase;
  std::vector<Vector3> before;
  void add(const std::vector<double>& boxes, const std::vector<char>& immovable) override {
    const auto count = static_cast<std::int32_t>(immovable.size());
    before.resize(count);
    for (std::int32_t i = 0; i < count; ++i) {
      before[i] = boxAt(boxes.data(), i).low;
      phase.add(i, boxAt(boxes.data(), i),
                immovable[i] ? carom::Mobility::immovable : carom::Mobility::moving);
    }
    phase.update();
  }
  void step(const double* boxes, const std::vector<std::int32_t>& awake) override {
    for (const std::int32_t i : awake) {
      // A world knows the velocities; here they are what has changed.
      const Aabb<3> box = boxAt(boxes, i);
      phase.move(i, box, box.low - before[i]);
      before[i] = box.low;
    }
    phase.update();
  }
  void pairs(Pairs& out) override {
    for (const IndexPair& pair : phase.pairs().sorted()) out.emplace_back(pair.first, pair.second);
  }
};

// What finds all pairs anew in every step.
template <class Finder>
struct Anew : BroadEngine {
  Finder finder;
  std::vector<Aabb<3>> now;
  std::vector<char> rests;
  Pairs found;
  void add(const std::vector<double>& boxes, const std::vector<char>& immovable) override {
    rests = immovable;
    now.resize(immovable.size());
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = boxAt(boxes.data(), static_cast<int>(i));
    step(boxes.data(), {});
  }
  void step(const double* boxes, const std::vector<std::int32_t>& awake) override {
    for (const std::int32_t i : awake) now[i] = boxAt(boxes, i);
    found.clear();
    finder.update(now);
    finder.pairs([&](std::int32_t a, std::int32_t b) {
      if (!rests[a] || !rests[b]) found.emplace_back(a, b);
    });
  }
  void pairs(Pairs& out) override {
    out = found;
  }
};

struct AllOfThem {
  std::span<const Aabb<3>> boxes;
  void update(std::span<const Aabb<3>> now) {
    boxes = now;
  }
  template <class Visit>
  void pairs(Visit&& visit) {
    for (const IndexPair& pair : carom::allPairs(boxes)) visit(pair.first, pair.second);
  }
};

struct Contender {
  std::string name;
  bool peer = false;
  int most = 1 << 30;  // bodies beyond which it takes too long to wait for
  std::function<std::unique_ptr<BroadEngine>(const MovingBoxes&)> make;
};

int countOf(const MovingBoxes& scene) {
  return static_cast<int>(scene.immovable.size());
}

std::vector<Contender> contenders() {
  std::vector<Contender> all = {
      {"Carom", false, 1 << 30, [](const MovingBoxes&) { return std::make_unique<Carom>(); }},
      {"all pairs", false, 1000,
       [](const MovingBoxes&) { return std::make_unique<Anew<AllOfThem>>(); }},
      {"sorted sweep", false, 3000,
       [](const MovingBoxes&) { return std::make_unique<Anew<carom::SortedSweep>>(); }},
      {"grid", false, 1 << 30,
       [](const MovingBoxes&) { return std::make_unique<Anew<carom::PairGrid>>(); }},
  };
#ifdef CAROM_BENCH_BULLET
  all.push_back({"Bullet dbvt", true, 1 << 30,
                 [](const MovingBoxes&) { return carom::bench::bulletTree(); }});
  // A body that is put in passes half of the others, one by one: minutes for 100,000.
  all.push_back({"Bullet sweep", true, 10000, [](const MovingBoxes& scene) {
                   return carom::bench::bulletSweep(scene.size + 1100, countOf(scene));
                 }});
#endif
#ifdef CAROM_BENCH_ODE
  all.push_back(
      {"ODE hash", true, 1 << 30, [](const MovingBoxes&) { return carom::bench::odeHash(-2, 5); }});
  all.push_back(
      {"ODE sweep", true, 1 << 30, [](const MovingBoxes&) { return carom::bench::odeSweep(); }});
#endif
  return all;
}

// Processor time of this process [s].
double now() {
  timespec at;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &at);
  return static_cast<double>(at.tv_sec) + 1e-9 * static_cast<double>(at.tv_nsec);
}

// The pairs whose boxes meet, by the sweep of the chapter.
Pairs truth(const MovingBoxes& scene) {
  std::vector<Aabb<3>> boxes;
  for (int i = 0; i < countOf(scene); ++i) boxes.push_back(boxAt(scene.boxes.data(), i));
  Pairs pairs;
  for (const IndexPair& pair : carom::sweepAndPrune(boxes)) {
    if (scene.immovable[pair.first] && scene.immovable[pair.second]) continue;
    pairs.emplace_back(pair.first, pair.second);
  }
  return pairs;
}

struct Result {
  std::string engine;
  bool peer = false;
  int bodies = 0;
  int steps = 0;
  double microseconds = 0;  // a step, on average
  double worst = 0;         // the slowest stretch of steps
  int unclocked = 0;        // stretches before the clock ran
  double spent = 0;         // in all [s]
  std::size_t pairs = 0, missed = 0, spare = 0;
  Json counters;
};

std::vector<Result> race(BroadScene which, int count, double seconds) {
  MovingBoxes scene(which, count);
  std::vector<Contender> all = contenders();
  std::erase_if(all, [&](const Contender& one) { return count > one.most; });
  std::vector<std::unique_ptr<BroadEngine>> engines;
  std::vector<Result> results;
  for (const Contender& one : all) {
    engines.push_back(one.make(scene));
    engines.back()->add(scene.boxes, scene.immovable);
    results.push_back({.engine = one.name, .peer = one.peer, .bodies = count, .counters = {}});
  }
  // The same stretch of motion for each in turn, long enough for the clock; each from its own copy
  // of the boxes, so that none finds them in the cache because of another.
  const int stretch = std::clamp(100000 / count, 2, 64);
  std::vector<std::vector<double>> frames(stretch);
  const int warm = count < 20000 ? 60 / stretch + 1 : 4;
  const int least = count < 20000 ? 6 : 4;
  constexpr double kPatience = 5;  // [s]
  for (int round = 0; round < 4000; ++round) {
    for (std::vector<double>& frame : frames) {
      scene.step();
      frame = scene.boxes;
    }
    bool isAnyoneLeft = false;
    for (std::size_t e = 0; e < engines.size(); ++e) {
      Result& result = results[e];
      // Who has had its time waits; all have seen some stretches at least, or taken very long.
      const bool tooLong = result.spent > kPatience;
      const bool clocked = result.unclocked >= (tooLong ? 1 : warm);
      const bool seen = result.steps >= (tooLong ? 1 : least * stretch);
      if (seen && result.microseconds > seconds) continue;
      isAnyoneLeft = true;
      const double start = now();
      for (const std::vector<double>& frame : frames) engines[e]->step(frame.data(), scene.awake);
      const double took = now() - start;
      result.spent += took;
      if (!clocked) {
        ++result.unclocked;
        continue;
      }
      result.microseconds += took;
      result.worst = std::max(result.worst, took / stretch);
      result.steps += stretch;
    }
    if (!isAnyoneLeft) break;
  }
  // All once more, so that each has the last boxes.
  Pairs right = truth(scene);
  for (std::size_t e = 0; e < engines.size(); ++e) {
    Result& result = results[e];
    result.microseconds *= 1e6 / result.steps;
    result.worst *= 1e6;
    // Twice: bodies may have moved far since its last turn, and rest in the second.
    for (int n = 0; n < 2; ++n) engines[e]->step(scene.boxes.data(), scene.awake);
    Pairs found;
    engines[e]->pairs(found);
    std::sort(found.begin(), found.end());
    result.pairs = found.size();
    Pairs both;
    std::set_intersection(found.begin(), found.end(), right.begin(), right.end(),
                          std::back_inserter(both));
    result.missed = right.size() - both.size();
    result.spare = found.size() - both.size();
    if (const auto* ours = dynamic_cast<const Carom*>(engines[e].get())) {
      const carom::BroadPhaseCounters& c = ours->phase.counters();
      result.counters = {{"updates", c.updates}, {"left", c.left},       {"visited", c.visited},
                         {"tested", c.tested},   {"begun", c.begun},     {"ended", c.ended},
                         {"rebuilt", c.rebuilt}, {"byTrees", c.byTrees}, {"bySweep", c.bySweep},
                         {"byGrid", c.byGrid}};
    }
  }
  return results;
}

void draw(const std::filesystem::path& folder, BroadScene scene,
          const std::vector<Result>& results) {
  carom::io::Plot plot(std::string("Broad phase: ") + carom::bench::nameOf(scene));
  plot.describe("Time of a step's broad phase over the number of bodies, both logarithmic.");
  plot.xAxis("bodies", carom::io::Scale::Logarithmic);
  plot.yAxis("processor time of a step [us]", carom::io::Scale::Logarithmic);
  // The same axis for all scenes.
  plot.yRange(0.03, 1e6);
  std::vector<std::string> names;
  for (const Result& result : results) {
    if (std::find(names.begin(), names.end(), result.engine) == names.end()) {
      names.push_back(result.engine);
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<Real> x, y;
    bool peer = false;
    for (const Result& result : results) {
      if (result.engine != names[k]) continue;
      peer = result.peer;
      x.push_back(result.bodies);
      y.push_back(result.microseconds);
    }
    plot.curve(names[k], x, y, carom::bench::styleOf(k, peer));
  }
  carom::bench::sign(plot, 110, 4e5, 0.4);
  plot.writeSvg(folder / (std::string("broadphase_") + carom::bench::nameOf(scene) + ".svg"));
}

}  // namespace

int main(int argc, char** argv) {
  const carom::bench::Options options = carom::bench::readOptions(argc, argv);
  std::cout << carom::bench::circumstancesInALine() << "\n";
  Json rows = Json::array();
  for (const BroadScene scene :
       {BroadScene::gas, BroadScene::pile, BroadScene::mixed, BroadScene::resting}) {
    std::vector<Result> results;
    carom::io::Table table;
    table.column("engine").column("bodies", carom::io::fixed(0));
    table.column("us a step", carom::io::significant(3));
    table.column("worst", carom::io::significant(3)).column("pairs", carom::io::fixed(0));
    table.column("missed", carom::io::fixed(0)).column("spare", carom::io::fixed(0));
    for (const int count : {100, 300, 1000, 3000, 10000, 100000}) {
      for (const Result& result : race(scene, count, options.seconds)) {
        results.push_back(result);
        table.row({result.engine, Real(result.bodies), result.microseconds, result.worst,
                   Real(result.pairs), Real(result.missed), Real(result.spare)});
        Json row = {{"suite", "broadphase"},
                    {"scene", carom::bench::nameOf(scene)},
                    {"engine", result.engine},
                    {"bodies", result.bodies},
                    {"us_per_step", result.microseconds},
                    {"us_worst", result.worst},
                    {"steps", result.steps},
                    {"pairs", result.pairs},
                    {"missed", result.missed},
                    {"spare", result.spare}};
        if (!result.counters.empty()) row["counters"] = result.counters;
        rows.push_back(row);
      }
    }
    std::cout << "\n" << carom::bench::nameOf(scene) << "\n\n" << table << std::flush;
    if (!options.plots.empty()) draw(options.plots, scene, results);
  }
  carom::bench::writeJson(
      options, {{"circumstances", carom::bench::circumstances(options)}, {"rows", rows}});
}
