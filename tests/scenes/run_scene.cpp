#include "scenes/run_scene.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace carom::scenes {
namespace {

constexpr Real kLongEnough = 1;  // of processor time: its clock may tick in steps of 10 ms [s]
constexpr long kBlocks = 100;    // of a repeated run, so that reading a clock costs little

Real secondsOf(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<Real>(now.tv_sec) + 1e-9 * static_cast<Real>(now.tv_nsec);
}

// Threads that work at the same time share the time of a watch; that of processors adds up.
Real secondsFor(const EngineKind& kind) {
  return secondsOf(kind.threads > 1 ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID);
}

void readStates(const Engine& engine, std::vector<State>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) states[i] = engine.state(static_cast<int>(i));
}

bool allFinite(const std::vector<State>& states) {
  return std::all_of(states.begin(), states.end(), [](const State& s) {
    const Quaternion& q = s.orientation;
    return s.position.allFinite() && s.velocity.allFinite() && s.angularVelocity.allFinite() &&
           std::isfinite(q.w + q.x + q.y + q.z);
  });
}

void addCounters(const std::vector<Figure>& now, std::vector<Figure>& sum, long& looks) {
  if (sum.empty()) {
    sum = now;
  } else {
    for (std::size_t i = 0; i < now.size(); ++i) sum[i].value += now[i].value;
  }
  ++looks;
}

// How a scene is divided into steps.
struct Division {
  long steps, untimed, block;
};

Division divide(const Scene& scene, Real dt) {
  const auto count = [dt](Real time) { return std::lround(time / dt); };
  return {count(scene.duration), count(scene.untimed), std::max(1L, count(scene.lookEvery))};
}

Real medianOf(std::vector<Real> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Goes through the whole scene, with nobody but a reader.
void goThrough(Engine& engine, const Division& division, Real dt, std::vector<State>& states) {
  for (long done = 0; done < division.steps;) {
    const long now = std::min(division.block, division.steps - done);
    for (long i = 0; i < now; ++i) engine.step(dt);
    readStates(engine, states);
    done += now;
  }
}

// Whole runs in batches that a clock can read: the median of the batches [s per run].
// The first batch warms caches and memory, and does not count.
Real secondsInBatches(const EngineKind& kind, const Scene& scene, Real dt,
                      const RunOptions& options, Real once, Run& run) {
  constexpr long kMostWorlds = 64;  // of a batch: they are all in memory
  constexpr int kRepeats = 20;      // for each that was asked for: they take next to nothing
  const Division division = divide(scene, dt);
  const long worlds = std::clamp(static_cast<long>(options.batch / once), 1L, kMostWorlds);
  std::vector<State> states = startOf(scene);
  std::vector<Real> batches;
  for (int repeat = 0; repeat <= kRepeats * options.repeats; ++repeat) {
    std::vector<std::unique_ptr<Engine>> engines;
    for (long i = 0; i < worlds; ++i) {
      engines.push_back(kind.make());
      engines.back()->build(scene);
    }
    const Real before = secondsOf(CLOCK_MONOTONIC);
    for (const auto& engine : engines) goThrough(*engine, division, dt, states);
    const Real took = secondsOf(CLOCK_MONOTONIC) - before;
    if (repeat > 0) batches.push_back(took / static_cast<Real>(worlds));
    run.repeats = run.repeats && hashOf(scene, states) == run.hash;
  }
  return medianOf(batches);
}

}  // namespace

Run runScene(const EngineKind& kind, const Scene& scene, Real dt, const RunOptions& options) {
  const int repeats = options.repeats;
  const Division division = divide(scene, dt);
  Run run;
  std::vector<State> states = startOf(scene);
  const std::unique_ptr<Judge> judge = scene.judge(scene);
  const Real bytesBefore = options.bytes ? options.bytes() : 0;
  const std::unique_ptr<Engine> engine = kind.make();
  engine->build(scene);
  judge->see(0, states);
  long looks = 0;
  Real onWall = 0;
  for (long done = 0; done < division.steps;) {
    long now = std::min(division.block, division.steps - done);
    if (done < division.untimed) now = std::min(now, division.untimed - done);
    const long asked = options.allocations ? options.allocations() : 0;
    const Real before = secondsFor(kind), beforeOnWall = secondsOf(CLOCK_MONOTONIC);
    for (long i = 0; i < now; ++i) engine->step(dt);
    const Real took = secondsFor(kind) - before;
    onWall += secondsOf(CLOCK_MONOTONIC) - beforeOnWall;
    if (done >= division.untimed) {
      if (options.allocations) run.allocations += options.allocations() - asked;
      run.seconds += took;
      run.steps += now;
    }
    done += now;
    readStates(*engine, states);
    if (!allFinite(states)) {
      run.finite = false;
      break;
    }
    judge->see(static_cast<Real>(done) * dt, states);
    if (done > division.untimed) addCounters(engine->counters(), run.counters, looks);
  }
  run.simulated = static_cast<Real>(run.steps) * dt;
  run.figures = judge->figures();
  for (Figure& counter : run.counters) counter.value /= static_cast<Real>(looks);
  run.hash = hashOf(scene, states);
  if (options.bytes) run.bytes = options.bytes() - bytesBefore;
  if (!run.finite || repeats == 0 || run.seconds > kLongEnough) return run;
  const bool inBatches = options.batch > 0;
  if (inBatches && division.untimed == 0 && onWall < options.batch) {
    run.seconds = secondsInBatches(kind, scene, dt, options, onWall, run);
    return run;
  }

  const long timed = division.steps - division.untimed;
  const long pieces = inBatches ? std::lround(onWall / options.batch) : kBlocks;
  const long block = std::max(1L, timed / pieces);
  std::vector<std::vector<Real>> times;  // of each block, in each repeat
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const std::unique_ptr<Engine> again = kind.make();
    again->build(scene);
    for (long i = 0; i < division.untimed; ++i) again->step(dt);
    std::size_t number = 0;
    for (long done = 0; done < timed; done += block) {
      const long now = std::min(block, timed - done);
      const Real before = secondsOf(CLOCK_MONOTONIC);
      for (long i = 0; i < now; ++i) {
        again->step(dt);
        if (inBatches && (done + i + 1) % division.block == 0) readStates(*again, states);
      }
      if (number == times.size()) times.emplace_back();
      times[number++].push_back(secondsOf(CLOCK_MONOTONIC) - before);
    }
    readStates(*again, states);
    run.repeats = run.repeats && hashOf(scene, states) == run.hash;
  }
  run.seconds = 0;
  for (const std::vector<Real>& ofBlock : times) run.seconds += medianOf(ofBlock);
  return run;
}

}  // namespace carom::scenes
