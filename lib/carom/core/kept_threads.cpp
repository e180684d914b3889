#include "carom/core/kept_threads.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "carom/core/checks.hpp"

namespace carom {

namespace {

// About so many looks at a variable before a thread goes to sleep: some 20 microseconds.
constexpr int kLooks = 2000;

void breathe() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

struct KeptThreads::Crew {
  // Each on a line of its own: they are written by different threads.
  alignas(64) std::atomic<std::uint32_t> round{0};  // odd: the end
  alignas(64) std::atomic<std::uint32_t> working{0};
  alignas(64) std::size_t count = 0;
  std::size_t grain = 1;
  Work work = nullptr;
  void* what = nullptr;
  std::vector<std::thread> threads;

  void runPart(std::size_t part) const {
    const std::size_t parts = threads.size() + 1;
    const std::size_t grains = (count + grain - 1) / grain;
    const std::size_t begin = std::min(count, grains * part / parts * grain);
    const std::size_t end = std::min(count, grains * (part + 1) / parts * grain);
    if (begin < end) work(what, begin, end);
  }

  void live(std::size_t part) {
    std::uint32_t seen = 0;
    for (;;) {
      std::uint32_t now = round.load(std::memory_order_acquire);
      for (int i = 0; now == seen && i < kLooks; ++i) {
        breathe();
        now = round.load(std::memory_order_acquire);
      }
      while (now == seen) {
        round.wait(seen, std::memory_order_acquire);
        now = round.load(std::memory_order_acquire);
      }
      if ((now & 1u) != 0) return;
      seen = now;
      runPart(part);
      // The last one wakes the caller, should that have gone to sleep.
      if (working.fetch_sub(1, std::memory_order_acq_rel) == 1) working.notify_one();
    }
  }
};

KeptThreads::KeptThreads(int count) : crew_(std::make_unique<Crew>()) {
  if (count < 1) reject("threads", std::to_string(count), "must be positive");
  Crew* crew = crew_.get();
  // All places first: the threads read how many there are.
  crew->threads.resize(static_cast<std::size_t>(count - 1));
  for (std::size_t i = 0; i < crew->threads.size(); ++i) {
    crew->threads[i] = std::thread([crew, i] { crew->live(i + 1); });
  }
}

KeptThreads::~KeptThreads() {
  crew_->round.fetch_or(1, std::memory_order_release);
  crew_->round.notify_all();
  for (std::thread& thread : crew_->threads) thread.join();
}

int KeptThreads::count() const {
  return static_cast<int>(crew_->threads.size()) + 1;
}

void KeptThreads::share(std::size_t count, std::size_t grain, Work work, void* what) {
  Crew& crew = *crew_;
  crew.count = count;
  crew.grain = grain;
  crew.work = work;
  crew.what = what;
  crew.working.store(static_cast<std::uint32_t>(crew.threads.size()), std::memory_order_relaxed);
  crew.round.fetch_add(2, std::memory_order_release);
  crew.round.notify_all();
  crew.runPart(0);
  std::uint32_t left = crew.working.load(std::memory_order_acquire);
  for (int i = 0; left != 0 && i < kLooks; ++i) {
    breathe();
    left = crew.working.load(std::memory_order_acquire);
  }
  // Who is late may wait for a processor: then it had better get this one.
  while (left != 0) {
    crew.working.wait(left, std::memory_order_acquire);
    left = crew.working.load(std::memory_order_acquire);
  }
}

}  // namespace carom
