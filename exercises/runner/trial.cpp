#include "runner/trial.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <iostream>
#include <mutex>
#include <set>
#include <thread>

#include "runner/check.hpp"

namespace carom::runner {

namespace {

// Runs a command in the folder, showing its last lines when it fails.
bool succeeds(const std::vector<std::string>& words, const fs::path& folder, const fs::path& base,
              std::string& problem) {
  grading::Command command;
  command.words = words;
  command.directory = folder.string();
  // What was compiled in another folder of the same files is compiled already.
  command.environment = {"CCACHE_BASEDIR=" + base.string(), "CCACHE_NOHASHDIR=1"};
  command.limits = {.wallSeconds = 0, .cpuSeconds = 0, .outputKilobytes = 64 << 10};
  const auto done = grading::run(command);
  if (done.ok()) return true;
  const auto lines = splitLines(done.output);
  for (std::size_t i = lines.size() > 25 ? lines.size() - 25 : 0; i < lines.size(); ++i)
    problem += lines[i] + "\n";
  return false;
}

// Asks `question` about each exercise, on all cores; its answers are problems.
void ask(const Project& project,
         const std::function<std::string(const Project&, const Exercise&)>& question,
         Trial& trial) {
  std::atomic<std::size_t> next{0};
  std::mutex writing;
  const auto work = [&] {
    for (std::size_t i = next++; i < project.exercises.size(); i = next++) {
      std::string problem;
      try {
        problem = question(project, project.exercises[i]);
      } catch (const Failure& failure) {
        problem = failure.message;
      }
      if (problem.empty()) continue;
      const std::lock_guard lock(writing);
      trial.problems.push_back(project.exercises[i].id + ": " + problem);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();
}

std::string inWords(const ExerciseResult& result) {
  std::string text = nameOf(result.status);
  if (!result.reason.empty()) text += ": " + result.reason;
  if (!result.compiled.firstError.empty()) text += ": " + result.compiled.firstError;
  for (const auto& c : result.checks) {
    if (c.status == Status::passed) continue;
    return text + "; " + c.name + " " + nameOf(c.status) + " " + c.reason +
           (c.failure.is_object() ? " " + c.failure.dump() : "");
  }
  return text;
}

// Test cases meet versions that stay with the teacher while they would give an answer away.
bool isGradedByTeacher(const Project& project, const Exercise& e) {
  return e.isTest() && !fs::exists(project.root / Cut::versionsFile(e));
}

std::string skeletonProblem(const Project& project, const Exercise& e) {
  if (isGradedByTeacher(project, e)) return "";
  CheckOptions options;
  options.fingerprint = false;
  const auto result = checkExercise(project, e, options);
  if (result.points() > 0) return "the skeleton earns points";
  // It may stand on functions of other exercises, which are not written either.
  if (result.status == Status::notRun) return "";
  // What is to be mended runs already.
  const bool good = e.kind == "fix"
                        ? result.status == Status::wrong || result.status == Status::stopped
                        : result.status == Status::notStarted;
  return good ? "" : "the skeleton is " + inWords(result);
}

std::string answerProblem(const Project& project, const Exercise& e, const fs::path& source) {
  if (isGradedByTeacher(project, e)) return "";
  const auto result = checkExercise(project, e, CheckOptions());
  if (result.status != Status::passed) return "the worked answer is " + inWords(result);
  if (e.wrong.empty()) return "";
  const auto& wrong = e.wrong.front();
  CheckOptions options;
  options.source = source / "solutions" / e.chapter / e.name / "wrong" / (wrong.name + e.extension);
  const auto named = checkExercise(project, e, options);
  if (named.wrongName == wrong.name) return "";
  return "wrong/" + wrong.name + " is not named: " + inWords(named);
}

}  // namespace

Trial tryBranches(const Cut& cut, const SecretLines& secrets, const Git& repository,
                  const std::string& student, const std::string& solved, const fs::path& folder) {
  Trial trial;
  const auto failed = [&](const std::string& what, const std::string& how) {
    trial.problems.push_back(what + "\n" + how);
    return trial;
  };
  repository({"update-ref", "refs/heads/trial", student});
  repository({"clone", "-q", "--shared", "--no-tags", "-b", "trial", repository.folder().string(),
              folder.string()});
  const fs::path build = folder / "build/default";
  std::string how;
  std::cout << "Building the student branch in a clean folder ..." << std::endl;
  if (!succeeds({"cmake", "--preset", "default"}, folder, folder, how))
    return failed("the student branch cannot be configured", how);
  if (!succeeds({"cmake", "--build", build.string(), "--target", "course_ready"}, folder, folder,
                how))
    return failed("the student branch cannot be built", how);

  Project project = openProject(folder, build);
  for (const auto& problem : project.problems) trial.problems.push_back(problem);
  trial.exercises = static_cast<int>(project.exercises.size());
  std::set<std::string> there;
  for (const auto& e : project.exercises) {
    there.insert(e.id);
    for (const auto& authored : cut.exercises) {
      if (authored.id != e.id) continue;
      const auto policy = cut.course.policy(authored);
      for (const auto& check : e.checks) {
        if (policy.hides(check.name))
          trial.problems.push_back(e.id + ": check " + check.name + " is not hidden");
      }
    }
  }
  for (const auto& e : cut.exercises) {
    const auto standing = cut.standing(e);
    const bool wanted = standing == Standing::open || standing == Standing::shown;
    if (wanted != (there.count(e.id) > 0))
      trial.problems.push_back(e.id + (wanted ? " is missing" : " should not be there"));
  }
  ask(project, skeletonProblem, trial);

  how.clear();
  const std::string noDoxygen = succeeds({"doxygen", "--version"}, folder, folder, how) &&
                                        succeeds({"dot", "-V"}, folder, folder, how)
                                    ? ""
                                    : "it needs doxygen and graphviz";
  how.clear();
  if (!noDoxygen.empty()) {
    trial.withoutSite = noDoxygen;
  } else if (!succeeds({"cmake", "--build", build.string(), "--target", "docs"}, folder, folder,
                       how)) {
    trial.problems.push_back("the students' site cannot be built\n" + how);
  } else {
    for (const auto& file : fs::recursive_directory_iterator(build / "site/html")) {
      if (!file.is_regular_file()) continue;
      ++trial.pages;
      const std::string path = fs::relative(file.path(), build / "site").string();
      const auto found = secrets.leaksInSite(path, readFile(file.path()));
      trial.leaks.insert(trial.leaks.end(), found.begin(), found.end());
    }
  }

  std::cout << "Trying the worked answers on it ..." << std::endl;
  const Git clone(folder);
  clone({"fetch", "-q", "--no-tags", repository.folder().string(), solved});
  clone({"checkout", "-q", "--detach", solved});
  how.clear();
  if (!succeeds({"cmake", "--build", build.string(), "--target", "course_ready"}, folder, folder,
                how))
    return failed("the solution branch cannot be built", how);
  ask(
      project, [&](const Project& p, const Exercise& e) { return answerProblem(p, e, cut.source); },
      trial);
  return trial;
}

}  // namespace carom::runner
