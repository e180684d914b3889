// The suite `integrators`: error against time of the methods of chapter 6, and the steps one by one.
//
// Bodies that turn freely (cases N7, N8, N9 and a box for 100 s), tops (N10, N11), a pendulum, a fall
// through air, a planet (N6, N2, N3, N5), and the energy of a pendulum over a million steps (N15).
// Beside them Boost.odeint, and where they are installed Bullet and ODE.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "bench/integrators_sections.hpp"
#include "carom_io/table.hpp"
#ifdef CAROM_BENCH_ODEINT
#include <boost/version.hpp>
#endif

namespace carom::bench {

Real caseNumber(const std::string& id, const std::string& key, int index, int inner) {
  static const Json cases = [] {
    std::ifstream file(std::string(CAROM_CASES_DIR) + "/motion.json");
    return Json::parse(file);
  }();
  Json value = cases.at(id).at(key);
  if (index >= 0) value = value.at(static_cast<std::size_t>(index));
  if (inner >= 0) value = value.at(static_cast<std::size_t>(inner));
  return std::strtod(value.get<std::string>().c_str(), nullptr);
}

void judge(Figures& figures, const char* diagram, const Race& race, const std::string& scene,
           Real level, Real closedForms, Real steps) {
  // What is known in closed form is compared by that, and by the best of the steps too.
  for (const bool closed : {true, false}) {
    if (closed && !race.hasClosedForm()) continue;
    const Comparison c = race.compare(level, closed);
    Json target = {{"diagram", diagram},
                   {"scene", scene},
                   {"by", closed ? "any method" : "steps"},
                   {"error", level},
                   {"ours", c.ours},
                   {"us_per_s", c.ourTime},
                   {"peer", c.peer},
                   {"peer_us_per_s", c.peerTime}};
    const Real wanted = closed ? closedForms : steps;
    const bool both = c.ourTime > 0 && c.peerTime > 0;
    if (both) target["ratio"] = c.peerTime / c.ourTime;
    if (wanted > 0) {
      target["target"] = wanted;
      // If no other library comes so near, to get there is enough.
      target["met"] = both ? c.peerTime / c.ourTime >= wanted : c.ourTime > 0;
    }
    Json all = Json::object();
    for (const RaceCurve& curve : race.curves()) {
      const Real t = timeFor(curve, level);
      if (t == 0) continue;
      all[curve.name] = {{"us_per_s", t}};
      if (c.peerTime > 0) all[curve.name]["times_faster_than_best_peer"] = c.peerTime / t;
    }
    target["all"] = all;
    figures.targets.push_back(target);
  }
}

}  // namespace carom::bench

int main(int argc, char** argv) {
  using namespace carom::bench;
  const Options options = readOptions(argc, argv);
  Json json{{"suite", "integrators"}, {"circumstances", circumstances(options)}};
#ifdef CAROM_BENCH_ODEINT
  json["circumstances"]["boost"] = BOOST_LIB_VERSION;
#else
  std::cout << "Boost.odeint is left out: install libboost-dev\n";
#endif
  std::cout << circumstancesInALine() << '\n';
  if (!options.plots.empty()) std::filesystem::create_directories(options.plots);

  Figures figures;
  measuredOrders(figures);
  singleSteps(options, figures);
  freeRotors(options, figures);
  heavyTops(options, figures);
  translations(options, figures);
  energyDrift(options, figures);

  carom::io::Table table;
  table.column("diagram").column("error", carom::io::scientific(0)).column("ours");
  table.column("us/s").column("best peer").column("us/s ").column("times faster").column("wanted");
  const auto text = [](const char* format, double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, format, value);
    return std::string(buffer);
  };
  for (const Json& t : figures.targets) {
    if (!t.contains("peer")) continue;
    table.row({t["diagram"].get<std::string>() + ", " + t["scene"].get<std::string>(),
               t["error"].get<double>(), t["ours"].get<std::string>(),
               text("%.3g", t["us_per_s"].get<double>()), t["peer"].get<std::string>(),
               text("%.3g", t["peer_us_per_s"].get<double>()),
               t.contains("ratio") ? text("%.3g", t["ratio"].get<double>()) : std::string("-"),
               t.contains("target") ? text("%.3g", t["target"].get<double>()) : std::string("-")});
  }
  std::cout << "\nAt equal error\n\n" << table << '\n';
  for (const Json& t : figures.targets) {
    if (t.contains("what")) std::cout << t.dump() << '\n';
  }
  json["targets"] = figures.targets;
  json["rows"] = figures.rows;
  writeJson(options, json);
}
