#include "runner/check.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "runner/confine.hpp"
#include "runner/missing.hpp"
#include "runner/versions.hpp"

namespace carom::runner {

using nlohmann::json;

const char* nameOf(Status status) {
  switch (status) {
    case Status::passed:
      return "passed";
    case Status::wrong:
      return "wrong";
    case Status::notStarted:
      return "not started";
    case Status::stopped:
      return "stopped";
    case Status::notRun:
      return "not run";
    case Status::refused:
      return "refused";
    case Status::doesNotCompile:
      return "does not compile";
    case Status::ourFault:
      return "our fault";
  }
  return "";
}

int ExerciseResult::passed() const {
  int count = 0;
  for (const auto& check : checks) count += check.status == Status::passed;
  return count;
}

double ExerciseResult::points() const {
  double sum = 0;
  bool guards = true;
  for (const auto& check : checks) {
    if (check.points == 0) guards &= check.status == Status::passed;
    if (check.status == Status::passed) sum += check.points;
  }
  return guards ? sum : 0;
}

int ExerciseResult::exitCode() const {
  switch (status) {
    case Status::passed:
      return Exit::pass;
    case Status::doesNotCompile:
      return Exit::doesNotCompile;
    case Status::stopped:
      return Exit::stopped;
    case Status::ourFault:
      return Exit::ourFault;
    default:
      return Exit::checkFailed;
  }
}

fs::path fingerprintFile(const Exercise& exercise) {
  return exercise.graderFolder() / (exercise.name + ".fingerprints.json");
}

namespace {

// A program that can be asked: the tests with the submission in them, or the tests and a child behind a pipe.
struct Runnable {
  fs::path program;
  std::vector<std::string> environment;
  int answerSeconds = 0;
};

std::string newNonce() {
  std::random_device device;
  return std::to_string(device()) + std::to_string(device());
}

// What failed in a sandbox that does not work any more is nobody's fault but ours.
void blameSandbox(const CheckOptions& options, ExerciseResult& result) {
  if (!options.sandbox || grading::works(*options.sandbox)) return;
  result.status = Status::ourFault;
  result.reason = std::string("The sandbox (") + nameOf(options.sandbox->tier) +
                  ") does not work any more. " + result.compiled.firstError;
}

// Does what has not been done with this version yet.
void compileAndScreen(const Project& project, const Exercise& exercise, const CheckOptions& options,
                      const fs::path& source, const fs::path& folder, Version& version) {
  if (options.screen && !version.sourceScreened) {
    version.sourceScreened = true;
    screenSource(readFile(source), version.screening, exercise.isTest());
  }
  if (options.screen && !version.screening.refused.empty()) return;
  if (!version.compileTried) {
    version.compileTried = true;
    version.compiled = compileSubmission(project, exercise, source,
                                         options.bench ? options.bench->newFolder() : folder,
                                         options.compileSeconds, options.sandbox);
  }
  if (!options.screen || version.objectScreened || !version.compiled.ok) return;
  version.objectScreened = true;
  const auto& entry = project.entry(exercise);
  screenIncludes(project, exercise, version.compiled.included, source, version.screening);
  screenObject(project, exercise, version.compiled.object,
               entry.at("library_object").get<std::string>(), entry.at("stage").get<std::string>(),
               version.screening, options.sandbox);
}

Runnable prepare(const Project& project, const Exercise& exercise, const CheckOptions& options,
                 const fs::path& folder, const fs::path& source, ExerciseResult& result) {
  Runnable runnable;
  const auto& entry = project.entry(exercise);
  const fs::path trusted = entry.at("trusted").get<std::string>();
  runnable.answerSeconds = options.answerSeconds;
  if (options.answerSeconds) {
    // The child behind the pipe has its limits from the grader, which has them from here.
    runnable.environment.push_back("CAROM_CPU_S=" + std::to_string(options.answerSeconds));
    runnable.environment.push_back("CAROM_WALL_S=" + std::to_string(options.answerSeconds));
  }
  if (options.seed) runnable.environment.push_back("CAROM_SEED=" + std::to_string(options.seed));
  if (exercise.isPrediction()) {
    runnable.program = trusted;
    runnable.environment.push_back("CAROM_ANSWERS=" + source.string());
    if (!readIfThere(source)) {
      result.status = Status::ourFault;
      result.reason = "cannot read " + source.string();
    }
    return runnable;
  }
  if (!options.lazy.empty()) {
    runnable.program = trusted;
    runnable.environment.push_back("CAROM_LAZY=" + options.lazy);
    return runnable;
  }
  Version unshared;
  Version& version = !options.bench || options.libraryVersion
                         ? unshared
                         : options.bench->version(source, options.sandbox != nullptr);
  if (options.libraryVersion) {
    version.compiled.object = entry.at("library_object").get<std::string>();
  } else {
    compileAndScreen(project, exercise, options, source, folder, version);
    result.compiled = version.compiled;
    if (options.screen) result.screening = version.screening;
    if (!result.screening.refused.empty()) {
      result.status = Status::refused;
      result.reason = result.screening.refused.front();
      return runnable;
    }
    if (!result.compiled.ok) {
      result.status = Status::doesNotCompile;
      blameSandbox(options, result);
      return runnable;
    }
  }
  const fs::path& object = version.compiled.object;
  const fs::path beside = options.libraryVersion ? folder : object.parent_path();
  try {
    if (exercise.isTest()) {
      if (version.selfCheck.empty())
        version.selfCheck = linkTester(project, exercise, object, beside, options.sandbox);
      runnable.program = version.selfCheck;
    } else if (options.throughPipe || options.libraryVersion) {
      if (version.child.empty())
        version.child = linkChild(project, exercise, object, beside, options.sandbox);
      runnable.program = trusted;
      runnable.environment.push_back("CAROM_CHILD=" + version.child.string());
      if (options.sandbox) {
        grading::Command child;
        child.words = {version.child.string()};
        child.files = {-1, -1};  // the grader has the pipes
        child = confinedProgram(std::move(child), trusted, *options.sandbox);
        runnable.environment.push_back("CAROM_CONFINED=" + grading::toText(child));
      }
    } else {
      if (version.selfCheck.empty())
        version.selfCheck = linkSelfCheck(project, exercise, object, beside);
      runnable.program = version.selfCheck;
    }
  } catch (const Failure& failure) {
    // Without the screen a submission may collide with the grader; that is its doing, not ours.
    result.status = Status::doesNotCompile;
    result.compiled.firstError = failure.message;
    blameSandbox(options, result);
  }
  return runnable;
}

struct Report {
  std::vector<json> events;
  json last;  // what was asked when a linked submission broke off
  bool complete = false;
  long asked = 0;
  long wrong = 0;
  int exitCode = 0;
};

Report readReport(const fs::path& file, const std::string& nonce) {
  Report report;
  const std::string content = readIfThere(file).value_or("");
  for (const auto& line : splitLines(content)) {
    json event = json::parse(line, nullptr, false);
    if (!event.is_object() || !event.contains("event")) continue;
    // The words of a submission's exception are in it.
    for (auto& value : event) {
      if (value.is_string()) value = printable(value.get_ref<const std::string&>());
    }
    if (event["event"] == "end" && event.value("nonce", "") == nonce) {
      report.complete = true;
      report.asked = event.value("asked", 0L);
      report.wrong = event.value("wrong", 0L);
      report.exitCode = event.value("exit", -1);
    }
    report.events.push_back(std::move(event));
  }
  fs::path last = file;
  last += ".last";
  report.last = json::parse(readIfThere(last).value_or(""), nullptr, false);
  return report;
}

grading::Finished runTests(const Runnable& runnable, const std::string& test,
                           const fs::path& folder, const std::string& nonce, const fs::path& report,
                           bool linked) {
  grading::Command command;
  command.words = {runnable.program.string(), test};
  command.environment = runnable.environment;
  command.environment.push_back("CAROM_REPORT=" + report.string());
  command.environment.push_back("CAROM_NONCE=" + nonce);
  command.directory = folder.string();
  const int seconds = runnable.answerSeconds;
  command.limits = {.wallSeconds = seconds ? 5.0 * seconds : 20,
                    .cpuSeconds = !linked   ? 20
                                  : seconds ? seconds
                                            : 10,
                    .memoryMegabytes = linked ? 1024 : 0,
                    .fileKilobytes = 16 << 10,
                    .outputKilobytes = linked ? 256 : 4096};
  return grading::run(command);
}

bool outOfTime(const std::string& reason) {
  return reason.find("did not answer within") != std::string::npos ||
         reason.find("used up its processor time") != std::string::npos;
}

CheckResult runCheck(const Check& check, const Runnable& runnable, const fs::path& folder,
                     bool linked) {
  CheckResult result{.name = check.name,
                     .title = check.title,
                     .points = check.points,
                     .failure = {},
                     .reason = {},
                     .output = {}};
  const fs::path reportFile = folder / ("report-" + check.name);
  const std::string nonce = newNonce();
  const auto done = runTests(runnable, check.name, folder, nonce, reportFile, linked);
  const Report report = readReport(reportFile, nonce);
  result.seconds = done.seconds;
  result.output = done.output;
  for (const auto& event : report.events) {
    const std::string kind = event["event"];
    if (kind == "not attempted") result.status = Status::notStarted;
    if (kind == "stopped") {
      result.status = Status::stopped;
      result.reason = "It " + event.value("got", "") + ".";
      result.timedOut = outOfTime(result.reason);
      result.failure = event;
    }
    if (kind == "wrong" && result.failure.is_null()) result.failure = event;
  }
  if (result.status == Status::notStarted || result.status == Status::stopped) return result;
  if (!report.complete) {
    result.status = Status::stopped;
    result.reason = done.exitCode == 0 ? "The program ended by itself before the check was over "
                                         "(with exit code 0). Only an answer that is "
                                         "returned counts."
                                       : "The program " + done.end + " before the check was over.";
    result.timedOut = done.timedOut || outOfTime(done.end);
    result.brokeOff = !linked && !result.timedOut;
    if (report.last.is_object()) result.failure = report.last;
  } else if (report.asked == 0) {
    result.status = Status::ourFault;
    result.reason = "The grader has no test case '" + check.name + "', or it asks nothing.";
  } else if (report.wrong > 0) {
    result.status = Status::wrong;
    result.othersWrong = static_cast<int>(report.wrong) - 1;
  } else if (report.exitCode != 0 || done.exitCode != 0) {
    result.status = Status::stopped;
    result.brokeOff = !linked;
    result.reason = "The grader answered with exit code " + std::to_string(report.exitCode) +
                    " and the program " + done.end + ":\n" +
                    printable(std::string_view(done.output).substr(0, 2000));
  } else {
    result.status = Status::passed;
  }
  return result;
}

std::vector<std::vector<double>> askProbes(const Runnable& runnable, const fs::path& folder,
                                           bool linked) {
  const fs::path reportFile = folder / "report-probes";
  const std::string nonce = newNonce();
  runTests(runnable, "probes", folder, nonce, reportFile, linked);
  const Report report = readReport(reportFile, nonce);
  std::vector<std::vector<double>> answers;
  if (!report.complete) return answers;
  for (const auto& event : report.events) {
    if (event["event"] != "probe") continue;
    auto& numbers = answers.emplace_back();
    for (const auto& number : event["numbers"]) {
      numbers.push_back(number.is_number() ? number.get<double>()
                        : number.get<std::string>().starts_with("NaN")
                            ? std::nan("")
                            : (number.get<std::string>().starts_with("-") ? -INFINITY : INFINITY));
    }
  }
  return answers;
}

// The one known-wrong version whose answers these are, if there is exactly one.
void findMisconception(const Project& project, const std::vector<std::vector<double>>& answers,
                       ExerciseResult& result) {
  if (answers.empty()) return;
  const auto content = readIfThere(project.root / fingerprintFile(*result.exercise));
  if (!content) return;
  const json file = json::parse(*content, nullptr, false);
  if (!file.is_object()) return;
  const Wrong* found = nullptr;
  for (const auto& wrong : result.exercise->wrong) {
    const auto entry = file.find(wrong.name);
    if (entry == file.end()) continue;
    std::vector<std::vector<double>> theirs;
    for (const auto& probe : *entry) {
      auto& numbers = theirs.emplace_back();
      for (const auto& number : probe)
        numbers.push_back(number.is_number() ? number.get<double>() : std::nan(""));
    }
    if (!sameAnswers(answers, theirs)) continue;
    if (found) return;  // two explain it: say nothing rather than guess
    found = &wrong;
  }
  if (!found) return;
  result.wrongName = found->name;
  result.wrongSays = found->says;
  result.wrongRead = found->read;
  result.probes = static_cast<int>(answers.size());
}

}  // namespace

bool sameAnswers(const std::vector<std::vector<double>>& a,
                 const std::vector<std::vector<double>>& b) {
  if (a.size() != b.size() || a.empty()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].size() != b[i].size()) return false;
    double scale = 0;
    for (const double number : b[i]) {
      if (std::isfinite(number)) scale = std::max(scale, std::abs(number));
    }
    for (std::size_t j = 0; j < a[i].size(); ++j) {
      const double x = a[i][j];
      const double y = b[i][j];
      if (std::isfinite(x) != std::isfinite(y)) return false;
      // Other compilers round differently; another formula differs by far more than this.
      if (std::isfinite(x) && !(std::abs(x - y) <= 1e-9 * scale)) return false;
    }
  }
  return true;
}

ExerciseResult checkExercise(const Project& project, const Exercise& exercise,
                             const CheckOptions& options) {
  ExerciseResult result;
  result.exercise = &exercise;
  const fs::path source =
      options.source.empty() ? project.root / exercise.studentFile() : fs::absolute(options.source);
  const WorkFolder folder(project);
  const bool linked = !options.throughPipe && options.lazy.empty() && !options.libraryVersion &&
                      !exercise.isPrediction();
  const bool submission = options.lazy.empty() && !options.libraryVersion;
  if (submission && !readIfThere(source)) {
    throw Failure{usage, "there is no file " + source.string() + ": ./course reset " + exercise.id +
                             " brings it back"};
  }
  const Runnable runnable = prepare(project, exercise, options, folder.path(), source, result);
  for (const auto& check : exercise.checks) {
    result.checks.push_back({.name = check.name,
                             .title = check.title,
                             .points = check.points,
                             .failure = {},
                             .reason = {},
                             .output = {}});
  }
  result.seconds = result.compiled.seconds;
  if (result.status != Status::notRun) return result;
  if (exercise.isTest()) {
    checkVersions(project, exercise, options, runnable.program, folder.path(), result);
    return result;
  }

  std::vector<std::size_t> order;
  for (const auto& name : options.checks) {
    const auto at = std::find_if(exercise.checks.begin(), exercise.checks.end(),
                                 [&](const Check& c) { return c.name == name; });
    if (at == exercise.checks.end()) throw Failure{usage, exercise.id + " has no check " + name};
    order.push_back(static_cast<std::size_t>(at - exercise.checks.begin()));
  }
  if (options.checks.empty()) {
    for (std::size_t i = 0; i < exercise.checks.size(); ++i) order.push_back(i);
  }
  int patience = options.patience;
  for (auto i = order.begin(); i != order.end(); ++i) {
    auto& check = result.checks[*i];
    check = runCheck(exercise.checks[*i], runnable, folder.path(), linked);
    nameMissing(project, exercise, check);
    result.seconds += check.seconds;
    if (check.status == Status::stopped && options.sandbox && !grading::works(*options.sandbox)) {
      check.status = Status::ourFault;
      check.reason = std::string("The sandbox (") + nameOf(options.sandbox->tier) +
                     ") does not work any more. " + check.reason;
    }
    // Who waited for the limit once need not wait for it again.
    if (check.timedOut && --patience <= 0) {
      for (auto j = i + 1; j != order.end(); ++j)
        result.checks[*j].reason = "Not run, because '" + check.title + "' did not end.";
      break;
    }
    // What is not written yet need not be asked again.
    if (check.status == Status::notStarted && !options.askAll) {
      for (auto j = i + 1; j != order.end(); ++j) result.checks[*j].status = Status::notStarted;
      break;
    }
  }
  bool all = true;
  Status worst = Status::passed;
  for (const std::size_t i : std::set<std::size_t>(order.begin(), order.end())) {
    const auto& check = result.checks[i];
    all &= check.status == Status::passed;
    if (check.status == Status::ourFault) worst = Status::ourFault;
    if (check.status != Status::passed && worst == Status::passed) worst = check.status;
  }
  result.status = all ? Status::passed : worst;
  // Not written at all, or written in part: the first says so for the whole exercise.
  if (!all && worst == Status::notStarted && result.passed() > 0) result.status = Status::wrong;
  const bool anyWrong = std::any_of(result.checks.begin(), result.checks.end(),
                                    [](const auto& c) { return c.status == Status::wrong; });
  if (options.fingerprint && anyWrong) {
    findMisconception(project, askProbes(runnable, folder.path(), linked), result);
  }
  return result;
}

std::vector<std::vector<double>> probeAnswers(const Project& project, const Exercise& exercise,
                                              const CheckOptions& options) {
  ExerciseResult result;
  result.exercise = &exercise;
  const WorkFolder folder(project);
  CheckOptions piped = options;
  piped.throughPipe = true;
  const Runnable runnable =
      prepare(project, exercise, piped, folder.path(), fs::absolute(options.source), result);
  if (result.status != Status::notRun) {
    throw Failure{ourFault, options.source.string() + ": " + nameOf(result.status) + " " +
                                result.reason + result.compiled.firstError};
  }
  return askProbes(runnable, folder.path(), false);
}

json toJson(const ExerciseResult& result) {
  json checks = json::array();
  for (const auto& check : result.checks) {
    json c = {{"name", check.name},
              {"title", check.title},
              {"status", nameOf(check.status)},
              {"points", check.points},
              {"earned", check.status == Status::passed ? check.points : 0}};
    if (!check.failure.is_null()) c["failure"] = check.failure;
    if (!check.reason.empty()) c["reason"] = check.reason;
    if (check.othersWrong) c["others_wrong"] = check.othersWrong;
    checks.push_back(c);
  }
  json all = {{"id", result.exercise->id},       {"title", result.exercise->title},
              {"status", nameOf(result.status)}, {"checks", checks},
              {"passed", result.passed()},       {"points", result.points()},
              {"of", result.exercise->points},   {"seconds", result.seconds},
              {"notes", result.screening.notes}};
  if (!result.wrongName.empty()) {
    all["misconception"] = {
        {"name", result.wrongName}, {"says", result.wrongSays}, {"probes", result.probes}};
  }
  if (!result.screening.refused.empty()) all["refused"] = result.screening.refused;
  if (!result.reason.empty()) all["reason"] = result.reason;
  if (result.status == Status::doesNotCompile) {
    all["compiler"] = {{"error", result.compiled.firstError}, {"plain", result.compiled.plain}};
  }
  return all;
}

}  // namespace carom::runner
