#include "bench/bench.hpp"

#include <sched.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <numeric>

namespace carom::bench {
namespace {

Real processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<Real>(now.tv_sec) + 1e-9 * static_cast<Real>(now.tv_nsec);
}

void stayOnThisCore() {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(sched_getcpu()), &set);
  sched_setaffinity(0, sizeof set, &set);
}

Real secondsOf(const Case& c, std::size_t calls) {
  const Real before = processorSeconds();
  for (std::size_t i = 0; i < calls; ++i) c.run();
  return processorSeconds() - before;
}

// How many calls a run needs to last long enough; found by doubling, which also warms the caches.
std::size_t callsFor(const Case& c, Real seconds) {
  for (std::size_t calls = 1;; calls *= 2) {
    const Real took = secondsOf(c, calls);
    if (took >= seconds) return calls;
    if (took >= seconds / 8) {
      const Real exact = static_cast<Real>(calls) * seconds / took;
      return static_cast<std::size_t>(std::ceil(1.1 * exact));
    }
  }
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "an unknown processor";
}

std::string compiler() {
#if defined(__clang__)
  return std::string("clang ") + __clang_version__;
#else
  return std::string("g++ ") + __VERSION__;
#endif
}

[[noreturn]] void wrongUse(const std::string& message) {
  std::cerr << message << "\nOptions: --json FILE, --plots FOLDER, --runs N, --seconds S\n";
  std::exit(4);
}

}  // namespace

Options readOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 == argc) wrongUse(name + " stands alone or is not known");
    const std::string value = argv[i + 1];
    if (name == "--json") {
      options.json = value;
    } else if (name == "--plots") {
      options.plots = value;
    } else if (name == "--runs") {
      options.runs = std::atoi(value.c_str());
      if (options.runs < 1) wrongUse("--runs " + value + ": must be at least 1");
    } else if (name == "--seconds") {
      options.seconds = std::atof(value.c_str());
      if (!(options.seconds > 0)) wrongUse("--seconds " + value + ": must be greater than 0");
    } else {
      wrongUse(name + " is not known");
    }
  }
  return options;
}

std::vector<Timing> measure(const std::vector<Case>& cases, const Options& options) {
  stayOnThisCore();
  std::vector<std::size_t> calls;
  for (const Case& c : cases) calls.push_back(callsFor(c, options.seconds));

  std::vector<std::vector<Real>> runs(cases.size());
  for (int run = 0; run < options.runs; ++run) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const Real items = static_cast<Real>(calls[i] * cases[i].items);
      runs[i].push_back(1e9 * secondsOf(cases[i], calls[i]) / items);
    }
  }

  std::vector<Timing> timings;
  for (auto& times : runs) {
    std::sort(times.begin(), times.end());
    timings.push_back({times[times.size() / 2], times.front(), times.back()});
  }
  return timings;
}

Json circumstances(const Options& options) {
  return {{"processor", processor()},
          {"compiler", compiler()},
          {"flags", CAROM_BENCH_FLAGS},
          {"eigen", CAROM_BENCH_EIGEN},
          {"cores", 1},
          {"clock", "processor time of the process"},
          {"runs", options.runs},
          {"seconds_per_run", options.seconds},
          {"of_runs", "median"}};
}

std::string circumstancesInALine() {
  return processor() + ", " + compiler() + ", " + CAROM_BENCH_FLAGS;
}

void sign(io::Plot& plot, Real x, Real top, Real factor) {
  plot.label({x, top}, processor());
  plot.label({x, top * factor}, compiler());
  plot.label({x, top * factor * factor}, CAROM_BENCH_FLAGS);
}

io::CurveStyle styleOf(std::size_t i, bool peer) {
  constexpr std::array<io::Color, 9> kColors{{{213, 94, 0},
                                              {0, 158, 115},
                                              {204, 121, 167},
                                              {230, 159, 0},
                                              {86, 180, 233},
                                              {120, 94, 240},
                                              {0, 90, 160},
                                              {20, 20, 20},
                                              {150, 75, 0}}};
  io::CurveStyle style{.marks = true};
  style.width = peer ? 1 : 2;
  style.color = peer ? io::Color{140, 140, 140} : kColors[i % kColors.size()];
  return style;
}

Real slopeOf(const std::vector<Real>& x, const std::vector<Real>& y) {
  const auto n = static_cast<Real>(x.size());
  Real sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Real u = std::log(x[i]), v = std::log(y[i]);
    sumX += u, sumY += v, sumXX += u * u, sumXY += u * v;
  }
  return (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
}

void writeJson(const Options& options, const Json& figures) {
  if (options.json.empty()) return;
  std::ofstream file(options.json);
  file << figures.dump(1) << '\n';
  file.close();
  if (!file) {
    std::cerr << "cannot write " << options.json.string() << '\n';
    std::exit(1);
  }
  std::cout << "wrote " << options.json.string() << '\n';
}

}  // namespace carom::bench
