// The suite `accuracy`: what does an error cost?
//
// Every scene with a known answer is run by Carom in all its modes (steps of all lengths, as it comes,
// in one phase each and by soft contacts, and steps that it chooses for an error of 1e-3, 1e-6 and
// 1e-9) and by every engine that was found, each
// with its best settings, over a sweep of steps. The error is taken from poses and geometry at the
// moments that belong to the problem (scenes/problems.hpp). The cost is processor time per simulated
// second, and what it takes to read the bodies at those moments is part of it. Runs of more than a
// second are timed by the processor's clock of the process. That clock may tick as coarsely as 10
// ms, so shorter ones are repeated, warm, in pieces of a tenth of a millisecond by a clock that is
// fine enough; of each piece the median of the repeats counts, so that what other programs take of
// the processor drops out, and what is left is processor time.
//
// The table says how much dearer the best other engine is at equal error. Its rule is that of
// scenes/fronts.hpp: the comparison is made at each error that one of the others reached, between
// points of a front but never beyond its ends. Two of those errors stand in the table: the least
// that the others reach, and the one where Carom looks worst. "Not reached" is behind. `from` is the
// largest error from which on, down to the least, the ratio is what is wanted.
//
// --scene A,B --engine bullet,carom --rates 30,60 --limit SECONDS narrow it down. --json FILE keeps
// every row. --plots FOLDER draws a diagram for each question, and puts what pages draw from into
// FOLDER/accuracy.json, where problems that were not run stay as they are.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "bench/accuracy_record.hpp"
#include "bench/scenes_rows.hpp"
#include "carom_io/table.hpp"
#include "scenes/engines.hpp"

using carom::Real;
using carom::bench::compared;
using carom::bench::Curve;
using carom::bench::drawFronts;
using carom::bench::Json;
using carom::bench::SceneOptions;
using carom::scenes::Comparison;
using carom::scenes::EngineKind;
using carom::scenes::Problem;
using carom::scenes::Question;
using carom::scenes::Scene;

namespace {

const std::vector<Real> kRates{30, 60, 120, 240, 480, 960, 1920, 3840};
constexpr int kLimit = 10;     // of a run [s]
constexpr Real kBatch = 1e-4;  // around which the clock is read: much less than a turn [s]
constexpr int kFew = 100;      // bodies
const std::string kAdvance = "carom advance ";

// The engines of the suite: the best settings of each, and those modes of Carom that trade error for
// time.
bool isCoarse(const std::string& engine) {
  constexpr std::array<const char*, 3> kCoarse{"carom soft", "carom soft 1", "carom one phase"};
  return std::find(kCoarse.begin(), kCoarse.end(), engine) != kCoarse.end();
}

bool takesPart(const SceneOptions& options, const EngineKind& kind, const Scene& scene) {
  return kind.name.starts_with(kAdvance) || isCoarse(kind.name) ||
         carom::bench::runs(options, kind, scene);
}

// Where nothing rests or tips the coarse modes are what Carom does anyway, bit by bit. The faster of
// several measurements of the same would be luck.
void leaveOutSame(Json& rows) {
  const auto isSame = [&](const Json& row) {
    return std::any_of(rows.begin(), rows.end(), [&](const Json& usual) {
      return usual["engine"] == "carom" && usual["dt"] == row["dt"] && usual.contains("hash") &&
             row.contains("hash") && usual["hash"] == row["hash"];
    });
  };
  Json kept = Json::array();
  for (const Json& row : rows) {
    if (!isCoarse(row["engine"].get<std::string>()) || !isSame(row)) kept.push_back(row);
  }
  rows = kept;
}

// Steps per second. Carom also goes from one moment to the next in one step, or a few, where not
// everybody meets everybody in such a step.
std::vector<Real> ratesFor(const SceneOptions& options, const EngineKind& kind,
                           const Scene& scene) {
  const Real coarsest = 1 / scene.lookEvery;
  if (kind.name.starts_with(kAdvance)) return {coarsest};
  std::vector<Real> rates;
  if (kind.name.starts_with("carom") && carom::scenes::movingCount(scene) <= kFew) {
    for (Real rate = coarsest; rate < options.rates.front(); rate *= 2) rates.push_back(rate);
  }
  rates.insert(rates.end(), options.rates.begin(), options.rates.end());
  // A step longer than the scene is none.
  std::erase_if(rates, [&](Real rate) { return std::lround(rate * scene.duration) < 1; });
  return rates;
}

// What is repeated takes less than a second each time; the limit is for a run.
SceneOptions withRepeats(SceneOptions options) {
  options.limit += options.common.runs + 1;
  return options;
}

// Rows of one problem. An engine for which a run would take too long is not asked for finer ones.
Json rowsOf(const Problem& problem, const std::vector<EngineKind>& kinds,
            const SceneOptions& options) {
  const Scene scene = problem.make();
  Json rows = Json::array();
  for (const EngineKind& kind : kinds) {
    if (!takesPart(options, kind, scene)) continue;
    Real before = 0, rateBefore = 0;
    for (const Real rate : ratesFor(options, kind, scene)) {
      // A crowd in which everybody waits for others is cheaper for Carom in shorter steps.
      const Real growth = kind.name.starts_with("carom") ? 1 : rate / std::max(rateBefore, 1e-9);
      const Real expected = before * growth;
      Json row{{"problem", problem.name}, {"engine", kind.name}, {"dt", 1 / rate}};
      if (expected > options.limit) {
        row["failed"] = "left out: would take " + std::to_string(std::lround(expected)) + " s";
      } else {
        row.update(carom::bench::rowOf("accuracy", kind, scene, rate, withRepeats(options)));
        // Steps so long that they fail say nothing of shorter ones.
        if (!row.contains("failed") || rate >= options.rates.front()) {
          before = row.value("cpu_s", static_cast<Real>(options.limit)), rateBefore = rate;
        }
      }
      if (kind.name.starts_with(kAdvance)) {
        row["tolerance"] = std::strtod(kind.name.c_str() + kAdvance.size(), nullptr);
      }
      rows.push_back(std::move(row));
    }
  }
  leaveOutSame(rows);
  return rows;
}

std::string written(const char* format, Real number) {
  char text[32];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string ratioText(const Comparison& c) {
  return c.ours ? written("%.3g", c.ratio()) : "not reached";
}

// The largest error from which on, down to the least, ours is as far ahead as is wanted.
std::string fromWhere(const std::vector<Comparison>& all, Real wanted) {
  auto last = all.rbegin();
  while (last != all.rend() && last->ratio() >= wanted) ++last;
  if (last == all.rbegin()) return "nowhere";
  return written("%.2g", std::prev(last)->error);
}

carom::io::Table summaryTable() {
  carom::io::Table table;
  table.column("question").column("least error").column("by").column("us/s").column("ours us/s");
  table.column("ratio")
      .column("worst ratio")
      .column("at")
      .column("beside")
      .column("wanted")
      .column("from");
  return table;
}

void addSummary(carom::io::Table& table, const Problem& problem, const Question& question,
                const std::vector<Curve>& curves) {
  const std::vector<Comparison> all = compared(question, curves);
  const std::string name = problem.name + ", " + question.figure;
  if (all.empty()) {
    table.row({name, "no other engine", "", "", "", "", "", "", "", "", ""});
    return;
  }
  const Comparison& finest = all.back();
  const Comparison& worst = *std::min_element(
      all.begin(), all.end(),
      [](const Comparison& a, const Comparison& b) { return a.ratio() < b.ratio(); });
  table.row({name, written("%.2g", finest.error), finest.theirs.name,
             written("%.3g", finest.theirs.cost),
             finest.ours ? written("%.3g", finest.ours->cost) : "-", ratioText(finest),
             ratioText(worst), written("%.2g", worst.error), worst.theirs.name,
             written("%.3g", question.wanted), fromWhere(all, question.wanted)});
}

// The tolerances that were asked for, and the errors that came of them.
void addTolerances(carom::io::Table& table, const Problem& problem, const Question& question,
                   const Json& rows) {
  if (!question.length) return;
  for (const Json& row : rows) {
    if (!row.contains("tolerance")) continue;
    const Real asked = row["tolerance"].get<Real>();
    const std::string name = problem.name + ", " + question.figure;
    if (row.contains("failed")) {
      table.row({name, written("%.0e", asked), row["failed"].get<std::string>(), "", ""});
      continue;
    }
    const Json found = row["error"].value(question.figure, Json());
    if (!found.is_number()) continue;
    const Real error = std::abs(found.get<Real>());
    table.row({name, written("%.0e", asked), written("%.2g", error), written("%.3g", error / asked),
               written("%.3g", 1000 * row["ms_per_sim_s"].get<Real>())});
  }
}

// For people: what each run cost and gave.
void printRows(const Problem& problem, const Json& rows) {
  carom::io::Table table;
  table.column("engine").column("1/dt").column("us/s");
  for (const Question& question : problem.questions) table.column(question.figure);
  for (const Json& row : rows) {
    std::vector<carom::io::Cell> cells{row["engine"].get<std::string>(),
                                       written("%.4g", 1 / row["dt"].get<Real>())};
    const bool failed = row.contains("failed");
    cells.emplace_back(failed ? row["failed"].get<std::string>()
                              : written("%.4g", 1000 * row["ms_per_sim_s"].get<Real>()));
    for (const Question& question : problem.questions) {
      const Json error = failed ? Json() : row["error"].value(question.figure, Json());
      cells.emplace_back(error.is_number() ? written("%.3g", error.get<Real>()) : std::string());
    }
    table.row(cells);
  }
  std::cout << problem.name << ": " << problem.title << "\n\n" << table << '\n' << std::flush;
}

bool asked(const SceneOptions& options, const std::string& name) {
  if (options.scenes.empty()) return true;
  return std::any_of(options.scenes.begin(), options.scenes.end(),
                     [&](const std::string& beginning) { return name.starts_with(beginning); });
}

// "height rms [m]" as part of a file's name: "height_rms".
std::string wordOf(const std::string& figure) {
  std::string word = figure.substr(0, figure.find(" ["));
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

}  // namespace

int main(int argc, char** argv) {
  SceneOptions options = carom::bench::readSceneOptions(argc, argv);
  // What other suites begin with is too little here, and too long.
  const auto said = [&](const std::string& word) {
    return std::find(argv + 1, argv + argc, word) != argv + argc;
  };
  if (!said("--rates")) options.rates = kRates;
  if (!said("--limit")) options.limit = kLimit;
  std::sort(options.rates.begin(), options.rates.end());
  options.batch = kBatch;
  if (options.list) {
    for (const Problem& problem : carom::scenes::allProblems()) {
      std::cout << problem.name << ": " << problem.title << '\n';
    }
    return 0;
  }
  const std::vector<EngineKind> kinds = carom::bench::enginesOf(options);
  carom::bench::printEngines(kinds);
  const std::string where = carom::bench::circumstancesInALine();
  std::cout << where << "\n\n";
  Json figures{{"suite", "accuracy"},
               {"circumstances", carom::bench::circumstances(options.common)}};
  for (const EngineKind& kind : kinds) figures["settings"][kind.name] = kind.settings;
  const std::filesystem::path& folder = options.common.plots;
  if (!folder.empty()) std::filesystem::create_directories(folder);

  carom::io::Table summary = summaryTable(), tolerances;
  tolerances.column("question").column("asked").column("error").column("of what was asked");
  tolerances.column("us/s");
  Json allRows = Json::array(), records = Json::object();
  for (const Problem& problem : carom::scenes::allProblems()) {
    if (!asked(options, problem.name)) continue;
    const Json rows = rowsOf(problem, kinds, options);
    printRows(problem, rows);
    for (const Question& question : problem.questions) {
      const std::vector<Curve> curves = carom::bench::curvesOf(problem, question, rows);
      addSummary(summary, problem, question, curves);
      addTolerances(tolerances, problem, question, rows);
      if (folder.empty()) continue;
      const std::string file = problem.name + "_" + wordOf(question.figure) + ".svg";
      drawFronts(folder / file, problem, question, curves);
    }
    records[problem.name] = carom::bench::recordOf(problem, rows, where);
    for (const Json& row : rows) allRows.push_back(row);
  }
  std::cout << "Processor time at equal error: best other engine over Carom\n\n"
            << summary << "\nErrors beside the tolerances that were asked for\n\n"
            << tolerances << '\n';
  figures["problems"] = records;
  figures["rows"] = allRows;
  carom::bench::writeJson(options.common, figures);
  if (!folder.empty()) carom::bench::keepRecords(folder / "accuracy.json", records);
}
