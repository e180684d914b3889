#pragma once
// Asks the grader's questions of a submission and says what came of it.

#include <map>

#include "runner/build.hpp"

namespace carom::runner {

/// The words for how a check ended. "wrong", "stopped" and "not started" are different things to a
/// student.
enum class Status { passed, wrong, notStarted, stopped, notRun, refused, doesNotCompile, ourFault };
const char* nameOf(Status status);

struct CheckResult {
  std::string name;
  std::string title;
  double points = 0;
  Status status = Status::notRun;
  nlohmann::json failure;  ///< the first question that was answered wrong (see grading/grade.cpp)
  int othersWrong = 0;     ///< further wrong answers in the same check
  std::string reason;      ///< for stopped and our fault: what happened
  std::string output;      ///< what the submission printed
  bool timedOut = false;   ///< it ran into a limit on time
  bool brokeOff =
      false;  ///< through the pipe: the tests, which are ours, ended before they were over
  double seconds = 0;
};

struct ExerciseResult {
  const Exercise* exercise = nullptr;
  Status status = Status::notRun;
  std::vector<CheckResult> checks;
  std::string wrongName;  ///< the misconception that explains all answers, if exactly one does
  std::string wrongSays;
  std::string wrongRead;
  int probes = 0;  ///< number of probes on which it was compared
  Compiled compiled;
  Screening screening;
  std::string reason;
  double seconds = 0;

  int passed() const;
  double points() const;
  int exitCode() const;
};

/// What has been compiled and linked of a submission.
struct Version {
  bool compileTried = false;
  bool sourceScreened = false;
  bool objectScreened = false;
  Compiled compiled;
  Screening screening;  ///< what the screen said, where it was asked
  fs::path child;       ///< linked with the program that answers the pipe; empty: not yet
  fs::path selfCheck;   ///< linked with the tests; empty: not yet
};

/// Keeps what was compiled and linked as long as it lives, so that many checks of the same files
/// compile each file once. For one exercise; the files must not change meanwhile.
class Workbench {
 public:
  explicit Workbench(const Project& project) : folder_(project) {}
  /// \param confined a version that was compiled in a sandbox is another one than the same file compiled in the open
  Version& version(const fs::path& source, bool confined) {
    const auto path = fs::absolute(source).lexically_normal();
    // What compiles in a sandbox compiles to the same outside, and what asks too much there does so too.
    const auto inside = versions_.find({path, true});
    if (!confined && inside != versions_.end() &&
        (inside->second.compiled.ok || inside->second.compiled.limited))
      return inside->second;
    return versions_[{path, confined}];
  }
  /// A folder for the files of one version, made when it is asked for.
  fs::path newFolder() {
    const fs::path folder = folder_.path() / std::to_string(next_++);
    fs::create_directories(folder);
    return folder;
  }

 private:
  WorkFolder folder_;
  std::map<std::pair<fs::path, bool>, Version> versions_;
  int next_ = 0;
};

struct CheckOptions {
  fs::path source;              ///< the submission; empty: the student's file
  bool throughPipe = false;     ///< grading: the tests are one process, the submission another
  std::string lazy;             ///< zero, one, echo: a lazy answer instead of a submission's
  bool libraryVersion = false;  ///< ask the library's own function
  bool fingerprint = true;      ///< look for the misconception
  bool screen = true;
  std::uint64_t seed = 0;                ///< 0: the fixed seed of self-checks
  int answerSeconds = 0;                 ///< processor time for a check; 0: the usual
  int compileSeconds = 0;                ///< processor time for the compiler; 0: the usual
  std::vector<std::string> checks = {};  ///< only these, asked in this order; empty: all in theirs
  int patience = 1;     ///< checks that may run out of time before the rest is not run
  bool askAll = false;  ///< go on after a check that says not started: for grades in any order
  /// What confines compiler, linker and submission; none: they run as we do, with limits. For graders.
  const grading::Sandbox* sandbox = nullptr;
  Workbench* bench =
      nullptr;  ///< where compiled files are kept; none: they go when the check is over
};

ExerciseResult checkExercise(const Project& project, const Exercise& exercise,
                             const CheckOptions& options);

/// The answers of a version to the grader's probes; empty when it did not answer them all.
std::vector<std::vector<double>> probeAnswers(const Project& project, const Exercise& exercise,
                                              const CheckOptions& options);

/// True when two versions gave the same answers, to 1e-9 of their size.
bool sameAnswers(const std::vector<std::vector<double>>& a,
                 const std::vector<std::vector<double>>& b);

/// The file of fingerprints of an exercise, relative to the project.
fs::path fingerprintFile(const Exercise& exercise);

nlohmann::json toJson(const ExerciseResult& result);

}  // namespace carom::runner
