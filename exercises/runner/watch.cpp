#include "runner/watch.hpp"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>

#include "runner/file_watch.hpp"

namespace carom::runner {

namespace {

volatile std::sig_atomic_t interrupted = 0;

// Single keys without Enter, put back whatever happens.
class RawKeys {
 public:
  RawKeys() {
    if (!isatty(0) || tcgetattr(0, &before_) != 0) return;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(0, TCSANOW, &raw);
    active_ = true;
  }
  ~RawKeys() {
    if (active_) tcsetattr(0, TCSANOW, &before_);
  }

 private:
  termios before_{};
  bool active_ = false;
};

}  // namespace

const Exercise* nextExercise(const Project& project, const State& state) {
  for (const auto& e : project.exercises) {
    if (state.statusOf(project, e) != Status::passed) return &e;
  }
  return nullptr;
}

std::string hintText(const Exercise& exercise, int number) {
  const auto index = static_cast<std::size_t>(number) - 1;
  if (index >= exercise.hints.size()) return "There are no more hints.\n";
  return "Hint " + std::to_string(number) + " of " + std::to_string(exercise.hints.size()) + "\n" +
         wrapped(exercise.hints[index], 100, "  ") + "\n";
}

std::string resetExercise(const Project& project, const Exercise& exercise) {
  const fs::path file = project.root / exercise.studentFile();
  const auto skeleton = skeletonOf(exercise);
  if (!skeleton) throw Failure{ourFault, "there is no skeleton of " + exercise.id};
  std::string backup;
  if (const auto content = readIfThere(file); content && *content != *skeleton) {
    const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char stamp[32];
    std::tm local{};
    localtime_r(&now, &local);
    std::strftime(stamp, sizeof stamp, "%Y%m%d-%H%M%S", &local);
    fs::path copy =
        project.root / ".carom" / "backup" / (exercise.id + "-" + stamp + exercise.extension);
    for (int i = 2; fs::exists(copy); ++i) {
      copy = project.root / ".carom" / "backup" /
             (exercise.id + "-" + stamp + "-" + std::to_string(i) + exercise.extension);
    }
    writeFile(copy, *content);
    backup = fs::relative(copy, project.root).string();
  }
  writeFile(file, *skeleton);
  return backup;
}

int watch(Project& project, const Exercise* exercise, const View& view) {
  State state(project.root);
  if (!exercise) exercise = nextExercise(project, state);
  if (!exercise) {
    std::cout << "Every exercise is done.\n";
    return Exit::pass;
  }
  std::signal(SIGINT, [](int) { interrupted = 1; });
  const RawKeys keys;
  int exitCode = Exit::pass;
  std::optional<FileWatch> saved;
  bool again = true;
  bool input = true;
  buildTargets(project, {project.entry(*exercise).at("target").get<std::string>()}, true);
  while (!interrupted) {
    using Clock = FileWatch::Clock;
    const auto begin = Clock::now();
    const auto content = readIfThere(project.root / exercise->studentFile());
    const auto now = Clock::now();
    if (again) saved.emplace(content, now);
    const auto seen =
        saved->look(content, now, std::chrono::duration_cast<FileWatch::Milliseconds>(now - begin));
    if (seen == FileWatch::Seen::gone) {
      std::cout << exercise->studentFile().string() << " is gone: x brings the skeleton back\n"
                << std::flush;
    }
    if (again || seen == FileWatch::Seen::changed) {
      again = false;
      if (view.colour) std::cout << "\033[2J\033[H";
      std::cout << "checking " << exercise->id << " ...\n" << std::flush;
      try {
        const auto result = checkExercise(project, *exercise, {});
        state.remember(project, result);
        state.save();
        exitCode = result.exitCode();
        const int left = static_cast<int>(exercise->hints.size()) - state.hintsSeen(exercise->id);
        std::cout << describe(result, project, view, left);
      } catch (const Failure& failure) {
        std::cout << failure.message << "\n";
        exitCode = failure.exitCode;
      }
      int done = 0;
      for (const auto& e : project.exercises) done += state.statusOf(project, e) == Status::passed;
      if (view.plain) {
        std::cout
            << done << " of " << project.exercises.size() << " exercises are done.\n"
            << "Keys: n for next, h for hint, s for show, l for list, x for reset, r to check "
               "again, q to quit.\n";
      } else {
        std::cout << "[" << done << "/" << project.exercises.size()
                  << "]  n next  h hint  s show  l list  x reset  r check again  q quit\n";
      }
      std::cout << std::flush;
    }
    pollfd fd{0, POLLIN, 0};
    const int wait = static_cast<int>(saved->wait(now).count());
    if (!input) {
      usleep(static_cast<useconds_t>(1000 * wait));
      continue;
    }
    if (poll(&fd, 1, wait) <= 0) continue;
    char key = 0;
    if (read(0, &key, 1) <= 0) {
      // End of input: without a terminal there is nobody to press q, so stop here.
      if (!isatty(0)) break;
      input = false;
      continue;
    }
    switch (key) {
      case 'q':
        return exitCode;
      case 'r':
        again = true;
        break;
      case 's':
        std::cout << statement(*exercise, view) << std::flush;
        break;
      case 'l': {
        std::vector<const Exercise*> all;
        for (const auto& e : project.exercises) all.push_back(&e);
        std::cout << listing(project, state, all, view) << std::flush;
        break;
      }
      case 'h': {
        const int number =
            std::min(state.hintsSeen(exercise->id) + 1, static_cast<int>(exercise->hints.size()));
        std::cout << hintText(*exercise, std::max(number, 1)) << std::flush;
        state.sawHint(exercise->id, number);
        state.save();
        break;
      }
      case 'x': {
        std::cout << "Put the skeleton of " << exercise->id
                  << " back? Your file is kept as a copy. y/n " << std::flush;
        char sure = 0;
        if (read(0, &sure, 1) == 1 && sure == 'y') {
          const auto backup = resetExercise(project, *exercise);
          std::cout << "\n"
                    << (backup.empty() ? "It is the skeleton." : "Your file is kept as " + backup)
                    << "\n";
        }
        std::cout << "\n" << std::flush;
        break;
      }
      case 'n': {
        const Exercise* next = nextExercise(project, state);
        if (next == exercise) {
          // The current one is not done: go on to the one behind it.
          const auto at = exercise - project.exercises.data() + 1;
          next = static_cast<std::size_t>(at) < project.exercises.size() ? exercise + 1 : exercise;
        }
        if (!next) {
          std::cout << "Every exercise is done.\n";
          return Exit::pass;
        }
        exercise = next;
        std::cout << statement(*exercise, view) << std::flush;
        buildTargets(project, {project.entry(*exercise).at("target").get<std::string>()}, true);
        again = true;
        break;
      }
      default:
        break;
    }
  }
  return exitCode;
}

}  // namespace carom::runner
