#pragma once
// How do several threads share a loop, again and again within a millisecond?
//
// Method: threads are started once and kept. A loop is cut into equal runs, one per thread, always
// the same ones for the same count; the caller does the first and waits until all are done. Waiting
// is a short spin, then a sleep in the kernel: a step has dozens of loops of some microseconds.
// Why no queue of tasks: runs that are fixed need no lock, and who does what does not depend on who
// is fast.
// Not handled: loops whose turns take unlike times, and calls from within a loop.

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

 private:
  using Work = void (*)(void* what, std::size_t begin, std::size_t end);
  void share(std::size_t count, std::size_t grain, Work work, void* what);

  struct Crew;
  std::unique_ptr<Crew> crew_;
};

}  // namespace carom
