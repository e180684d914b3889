#pragma once
// How do several threads share a loop, again and again within a millisecond?
//
// Method: threads are started once and kept. A loop is cut into equal runs, one per thread, always
// the same ones for the same count; the caller does the first and waits until all are done. Waiting
// is a short spin, then a sleep in the kernel: a step has dozens of loops of some microseconds.
// Why no queue of tasks: runs that are fixed need no lock, and who does what does not depend on who
// is fast.
// Where turns take unlike times threads take pieces instead, by a number that all count up.
// Not handled: calls from within a loop.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace carom {

/// Threads that are kept. \ingroup core
class KeptThreads {
 public:
  /// Starts threads. \param count in all, the caller included; positive
  explicit KeptThreads(int count = 1);
  /// Ends the threads.
  ~KeptThreads();
  KeptThreads(const KeptThreads&) = delete;
  KeptThreads& operator=(const KeptThreads&) = delete;

  /// How many work. \return the caller included
  int count() const;

  /// Runs a loop. \param count its turns \param grain a run has a multiple of so many turns, but
  /// for the last; positive \param run called as run(begin, end), in each thread at most once
  template <class Run>
  void loop(std::size_t count, std::size_t grain, Run&& run) {
    if (count == 0) return;
    if (this->count() == 1 || count <= grain) {
      run(std::size_t(0), count);
      return;
    }
    share(
        count, grain,
        [](void* what, std::size_t begin, std::size_t end) {
          (*static_cast<std::remove_reference_t<Run>*>(what))(begin, end);
        },
        &run);
  }

  /// Runs a loop whose turns take unlike times: each thread takes piece after piece. Who does what
  /// depends on who is fast. \param count its turns \param grain turns of a piece; positive
  /// \param run called as run(begin, end), in each thread any number of times
  template <class Run>
  void pieces(std::size_t count, std::size_t grain, Run&& run) {
    if (this->count() == 1 || count <= grain) {
      if (count > 0) run(std::size_t(0), count);
      return;
    }
    std::atomic<std::size_t> next{0};
    loop(static_cast<std::size_t>(this->count()), 1, [&](std::size_t, std::size_t) {
      for (;;) {
        const std::size_t begin = next.fetch_add(grain, std::memory_order_relaxed);
        if (begin >= count) return;
        run(begin, std::min(count, begin + grain));
      }
    });
  }

 private:
  using Work = void (*)(void* what, std::size_t begin, std::size_t end);
  void share(std::size_t count, std::size_t grain, Work work, void* what);

  struct Crew;
  std::unique_ptr<Crew> crew_;
};

}  // namespace carom
