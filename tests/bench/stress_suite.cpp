// The suite `stress`: is the world still sound after hours, with a million times the mass, far from
// the origin, in a hundred thousand scenes made at random, under random calls, and when it is told
// nonsense?
//
//   --scenes N     random scenes (100,000), the first with --seed S (1)
//   --calls N      random calls (100,000)
//   --hours X      share of the full length of the scenes built to be hard (1); 0: none of them
//   --only NAME    one of these
//   --json FILE    counts and faults
// A fault names its seed; `--scenes 1 --calls 0 --hours 0 --seed S` runs that scene alone and says what it is.

#include <signal.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>

#include "bench/bench.hpp"
#include "carom_io/table.hpp"
#include "scenes/stress.hpp"
#include "support/random_player.hpp"

using carom::Real;
using carom::bench::Json;
using carom::stress::Outcome;
using carom::stress::Tally;

namespace {

struct StressOptions {
  carom::bench::Options common;
  long scenes = 100'000;
  long calls = 100'000;
  std::uint64_t seed = 1;
  Real hours = 1;
  std::string only;
};

StressOptions readStressOptions(int argc, char** argv) {
  StressOptions options;
  std::vector<char*> rest{argv[0]};
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (name == "--scenes") {
      options.scenes = std::atol(value);
    } else if (name == "--calls") {
      options.calls = std::atol(value);
    } else if (name == "--seed") {
      options.seed = std::strtoull(value, nullptr, 10);
    } else if (name == "--hours") {
      options.hours = std::atof(value);
    } else if (name == "--only") {
      options.only = value;
      options.scenes = options.calls = 0;
    } else {
      rest.push_back(argv[i]);
      if (i + 1 < argc) rest.push_back(argv[i + 1]);
    }
  }
  options.common = carom::bench::readOptions(static_cast<int>(rest.size()), rest.data());
  return options;
}

// --- What hangs or crashes

// What is being tried, for the words of the watchdog.
char trying[200];

void sayAndEnd(const char* what) {
  const auto say = [](const char* text) {
    if (write(2, text, std::strlen(text)) < 0) return;
  };
  say("\nFAULT: ");
  say(trying);
  say(what);
}

extern "C" void onSignal(int signal) {
  sayAndEnd(signal == SIGVTALRM ? " takes too long: a step without an end?\n" : " crashes\n");
  _exit(1);
}

// Gives the next trial so many seconds of processor time.
void watch(const std::string& what, long seconds) {
  std::snprintf(trying, sizeof trying, "%s", what.c_str());
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  setitimer(ITIMER_VIRTUAL, &timer, nullptr);
}

Real processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<Real>(now.tv_sec) + 1e-9 * static_cast<Real>(now.tv_nsec);
}

// --- Results

Json toJson(const Tally& tally) {
  return {
      {"scenes", tally.scenes},     {"bodies", tally.bodies},   {"steps", tally.steps},
      {"contacts", tally.contacts}, {"impacts", tally.impacts}, {"searches", tally.searches},
      {"refused", tally.refused},   {"gain", tally.gain},       {"gain_of_step", tally.gainOfStep},
      {"depth", tally.depth}};
}

class Report {
 public:
  Report() {
    using carom::io::significant;
    table_.column("what").column("scenes").column("bodies").column("steps").column("contacts");
    table_.column("impacts")
        .column("refused")
        .column("gained", significant(2))
        .column("in a step", significant(2));
    table_.column("depth", significant(2)).column("cpu s", significant(3)).column("faults");
    figures_ = {{"suite", "stress"}, {"rows", Json::array()}, {"faults", Json::array()}};
  }

  void row(const std::string& name, const Tally& t, Real seconds, long faults) {
    table_.row({name, t.scenes, t.bodies, t.steps, t.contacts, t.impacts, t.refused,
                std::max(Real(0), t.gain), std::max(Real(0), t.gainOfStep), t.depth, seconds,
                faults});
    Json row{{"name", name}, {"cpu_s", seconds}, {"faults", faults}};
    row.update(toJson(t));
    figures_["rows"].push_back(row);
  }

  void fault(const std::string& where, const std::string& what, const std::string& repeat) {
    constexpr long kMost = 50;
    if (++faults_ <= kMost) {
      std::cout << "FAULT: " << where << ": " << what << "\n       ./course bench --suite stress "
                << repeat << '\n'
                << std::flush;
    }
    figures_["faults"].push_back({{"where", where}, {"what", what}, {"repeat", repeat}});
  }

  int end(const carom::bench::Options& options) {
    std::cout << '\n' << table_ << '\n';
    std::cout << (faults_ == 0 ? "No fault.\n" : std::to_string(faults_) + " faults.\n");
    figures_["circumstances"] = carom::bench::circumstances(options);
    carom::bench::writeJson(options, figures_);
    return faults_ == 0 ? 0 : 1;
  }

 private:
  carom::io::Table table_;
  Json figures_;
  long faults_ = 0;
};

void runTrials(const StressOptions& options, Report& report) {
  for (const carom::stress::Trial& trial : carom::stress::trials()) {
    if (!options.only.empty() && options.only != trial.name) continue;
    watch("trial " + trial.name, 3600);
    const Real start = processorSeconds();
    const Outcome outcome = trial.run(options.hours);
    if (!outcome.failure.empty()) {
      report.fault(trial.name, outcome.failure,
                   "--only " + trial.name + " --hours " + std::to_string(options.hours));
    }
    report.row(trial.name, outcome.tally, processorSeconds() - start, !outcome.failure.empty());
  }
}

void runScenes(const StressOptions& options, Report& report) {
  Tally sum;
  long faults = 0;
  Real slowest = 0;
  std::uint64_t slowestSeed = 0;
  const Real start = processorSeconds();
  for (long i = 0; i < options.scenes; ++i) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(i);
    const std::string repeat = "--scenes 1 --calls 0 --hours 0 --seed " + std::to_string(seed);
    watch("random scene, " + repeat, 60);
    const Real before = processorSeconds();
    const Outcome outcome = carom::stress::runRandomScene(seed);
    const Real took = processorSeconds() - before;
    if (took > slowest) slowest = took, slowestSeed = seed;
    sum.add(outcome.tally);
    if (!outcome.failure.empty()) {
      ++faults;
      const std::string kind = outcome.isPlain ? "random scene, plain, " : "random scene ";
      report.fault(kind + std::to_string(seed), outcome.failure, repeat);
    }
    if (options.scenes == 1) {
      std::cout << carom::stress::describeRandomScene(seed) << '\n';
    }
    constexpr long kTell = 10'000;
    if ((i + 1) % kTell == 0) {
      std::cout << i + 1 << " scenes, " << sum.steps << " steps, " << faults << " faults, "
                << processorSeconds() - start << " s\n"
                << std::flush;
    }
  }
  std::cout << "Slowest random scene: seed " << slowestSeed << ", " << slowest << " s\n";
  report.row("random scenes", sum, processorSeconds() - start, faults);
}

void runCalls(const StressOptions& options, Report& report) {
  constexpr long kEach = 500;
  Tally sum;
  long faults = 0;
  const Real start = processorSeconds();
  std::uint64_t seed = options.seed;
  for (long done = 0; done < options.calls; done += kEach, ++seed) {
    const std::string repeat =
        "--scenes 0 --hours 0 --calls " + std::to_string(kEach) + " --seed " + std::to_string(seed);
    watch("random calls, " + repeat, 60);
    carom_test::Player player(seed);
    ++sum.scenes;
    try {
      for (long i = 0; i < std::min(kEach, options.calls - done); ++i) player.call();
      player.sane();
    } catch (const std::exception& problem) {
      ++faults;
      report.fault("random calls " + std::to_string(seed), problem.what(), repeat);
    }
    sum.steps += player.steps;
    sum.refused += player.refused;
  }
  report.row("random calls", sum, processorSeconds() - start, faults);
}

void runRefusals(Report& report) {
  watch("refused input", 60);
  const Real start = processorSeconds();
  const Outcome outcome = carom::stress::refuseAll();
  if (!outcome.failure.empty()) report.fault("refused input", outcome.failure, "--only refused");
  report.row("refused", outcome.tally, processorSeconds() - start, !outcome.failure.empty());
}

}  // namespace

int main(int argc, char** argv) {
  const StressOptions options = readStressOptions(argc, argv);
  for (const int number : {SIGVTALRM, SIGSEGV, SIGFPE, SIGABRT, SIGBUS}) signal(number, onSignal);
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  Report report;
  if (options.only.empty() || options.only == "refused") runRefusals(report);
  if (options.calls > 0) runCalls(options, report);
  if (options.hours > 0) runTrials(options, report);
  if (options.scenes > 0) runScenes(options, report);
  return report.end(options.common);
}
