#include "runner/versions.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <random>
#include <thread>

#include "carom_io/deflate.hpp"
#include "runner/confine.hpp"
#include "runner/skeleton.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

// What a line of the report begins with (grading/tester.cpp).
constexpr const char* kReportMark =
    "\x1f"
    "case ";

// An open file that is closed with the object, or before.
class OpenFile {
 public:
  explicit OpenFile(int file = -1) : file_(file) {}
  ~OpenFile() {
    close();
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int number() const {
    return file_;
  }
  void close() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

 private:
  int file_;
};

struct Pipe {
  explicit Pipe(int (&ends)[2]) : out(ends[0]), in(ends[1]) {}
  OpenFile out;
  OpenFile in;
};

Pipe* newPipe(std::unique_ptr<Pipe>& pipe) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Failure{ourFault, "no pipe"};
  pipe = std::make_unique<Pipe>(ends);
  return pipe.get();
}

// What became of the cases on one version.
struct Meeting {
  bool complete = false;  // the program came to its end and said so
  bool passed = false;    // and no case failed
  bool notAttempted = false;
  bool functionMissing = false;
  bool timedOut = false;
  std::string end;     // how it ended, in words
  std::string output;  // what it printed
  json failed;         // the first assertion that failed
  json cases = json::array();
  double seconds = 0;
};

Meeting meet(const fs::path& program, const fs::path& version, const fs::path& folder,
             const CheckOptions& options) {
  const int seconds = options.answerSeconds ? options.answerSeconds : 5;
  std::unique_ptr<Pipe> questions;
  std::unique_ptr<Pipe> answers;
  newPipe(questions);
  newPipe(answers);

  // Every version has the same name while it answers: what is listed of processes tells nothing.
  const fs::path name = folder / "function";
  std::error_code none;
  fs::remove(name, none);
  fs::create_hard_link(version, name, none);
  if (none) fs::copy_file(version, name);

  grading::Command server;
  server.words = {name.string()};
  server.directory = folder.string();
  server.files = {questions->out.number(), answers->in.number()};
  server.limits = {.wallSeconds = 2.0 * seconds,
                   .cpuSeconds = std::max(1, seconds / 2),
                   .memoryMegabytes = 1024,
                   .fileKilobytes = 1};
  std::thread serving([&] {
    grading::run(server);
    // Who waits for an answer learns that there will be none.
    questions->out.close();
    answers->in.close();
  });

  grading::Command command;
  command.words = {program.string()};
  command.directory = "/";
  command.files = {answers->out.number(), questions->in.number()};
  command.shutIn = true;
  command.limits = {.wallSeconds = 3.0 * seconds,
                    .cpuSeconds = seconds,
                    .memoryMegabytes = 1024,
                    .fileKilobytes = 1 << 10,
                    .outputKilobytes = 256};
  // What the program can see of itself is the same whichever version answers.
  if (options.sandbox) command = confinedProgram(std::move(command), version, *options.sandbox);
  const auto done = grading::run(command);
  answers->out.close();
  questions->in.close();
  serving.join();

  Meeting meeting{.timedOut = done.timedOut || done.end.find("processor time") != std::string::npos,
                  .end = done.end,
                  .output = {},
                  .failed = {},
                  .seconds = done.seconds};
  for (const auto& line : splitLines(done.output)) {
    if (!line.starts_with(kReportMark)) {
      if (!line.empty()) meeting.output += line + "\n";
      continue;
    }
    const json event = json::parse(line.substr(std::string(kReportMark).size()), nullptr, false);
    if (!event.is_object() || !event.contains("event")) continue;
    if (event["event"] == "case") meeting.cases.push_back(event);
    if (event["event"] == "failed" && meeting.failed.is_null()) meeting.failed = event;
    if (event["event"] == "end") {
      meeting.complete = true;
      meeting.passed = event.value("exit", -1) == 0 && done.ok();
      meeting.notAttempted = event.value("not attempted", false);
      meeting.functionMissing = event.value("function missing", false);
    }
  }
  return meeting;
}

// The program that holds one version and answers the pipe: compiled and linked when something that it is made of has
// changed, and kept in the build folder.
fs::path versionProgram(const Project& project, const Exercise& exercise, const std::string& name,
                        const std::string* source) {
  const auto& entry = project.entry(exercise);
  std::string made = source ? *source : "the library's own";
  auto add = [&](const json& files) {
    for (const auto& file : files) {
      std::error_code none;
      made += "\n" + file.get<std::string>() + " " +
              std::to_string(
                  fs::last_write_time(file.get<std::string>(), none).time_since_epoch().count());
    }
  };
  add(entry.at("child_objects"));
  add(project.manifest.at("serve_objects"));
  add(json::array({entry.at("stage"), entry.at("library_object")}));
  const fs::path folder = project.build / "versions" / exercise.id;
  const fs::path program = folder / (name + "-" + hashOf(made));
  std::error_code none;
  if (fs::exists(program, none)) return program;

  const WorkFolder work(project);
  fs::path object = entry.at("library_object").get<std::string>();
  if (source) {
    const fs::path file = work.path() / (exercise.name + ".cpp");
    writeFile(file, *source);
    const auto compiled = compileSubmission(project, exercise, file, work.path());
    if (!compiled.ok) {
      throw Failure{ourFault, exercise.id + ": version '" + name +
                                  "' does not compile: " + compiled.firstError};
    }
    object = compiled.object;
  }
  const fs::path fresh = linkChild(project, exercise, object, work.path());
  fs::create_directories(folder);
  for (const auto& old : fs::directory_iterator(folder)) {
    if (old.path().filename().string().starts_with(name + "-")) fs::remove(old.path(), none);
  }
  fs::rename(fresh, program);
  return program;
}

std::string line(const json& failed) {
  return failed.value("file", "").empty()
             ? std::string()
             : " (line " + std::to_string(failed.value("line", 0)) + ")";
}

// What a student needs to mend a case that fails on a right version.
std::string failsOnRight(const Meeting& meeting, std::size_t which) {
  const std::string version =
      which == 0 ? "the library's version of the function"
                 : "another right version, which rounds differently or goes another way";
  if (!meeting.complete) return "On " + version + " your program " + meeting.end + ".";
  const auto& f = meeting.failed;
  if (!f.is_object()) return "Some case fails on " + version + ".";
  std::string text = "The case \"" + f.value("case", "") + "\"" + line(f) + " fails on " + version;
  if (!f.value("asserted", "").empty()) text += ": " + f.value("asserted", "");
  if (!f.value("was", "").empty() && f.value("was", "") != f.value("asserted", ""))
    text += " was " + f.value("was", "");
  const std::string was = f.value("was", "");
  const auto equals = was.find(" == ");
  if (equals != std::string::npos && was.substr(0, equals) == was.substr(equals + 4))
    text +=
        ", which looks the same: they differ in digits that are not shown. Leave room for rounding";
  if (!f.value("message", "").empty()) text += ": " + f.value("message", "");
  // Names and messages are the student's own words.
  return printable(text) + ".";
}

std::string emptyCase(const Meeting& meeting) {
  if (meeting.cases.empty()) return "There is no TEST_CASE in the file.";
  for (const auto& c : meeting.cases) {
    const std::string name = "The case \"" + printable(c.value("name", "")) + "\" ";
    if (c.value("assertions", 0L) == 0) return name + "asserts nothing.";
    if (c.value("calls", 0L) == 0) return name + "never calls the function.";
  }
  return "";
}

}  // namespace

fs::path versionsFile(const Exercise& exercise) {
  return exercise.graderFolder() / (exercise.name + ".versions.json");
}

std::vector<TestedVersion> packedVersions(const Project& project, const Exercise& exercise) {
  const fs::path file = project.root / versionsFile(exercise);
  const json all = json::parse(readIfThere(file).value_or(""), nullptr, false);
  if (!all.is_array())
    throw Failure{ourFault, file.string() + " is missing or damaged: run ./course dev sync"};
  std::vector<TestedVersion> versions;
  try {
    for (const auto& version : all) {
      versions.push_back(
          {version.at("check").get<std::string>(),
           io::detail::inflated(io::detail::fromBase64(version.at("packed").get<std::string>()))});
    }
  } catch (const std::exception& error) {
    throw Failure{ourFault, file.string() + " is damaged: " + error.what()};
  }
  return versions;
}

std::vector<TestedVersion> authoredVersions(const Project& project, const Exercise& exercise) {
  const Exercise& tested = project.find(exercise.tests);
  std::vector<TestedVersion> versions;
  versions.push_back(
      {"", cutAnswer(readFile(tested.folder / tested.fileName()), tested.fileName())});
  std::vector<fs::path> right;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(tested.folder / "right", none)) {
    if (file.path().extension() == ".cpp") right.push_back(file.path());
  }
  std::sort(right.begin(), right.end());
  for (const auto& file : right) versions.push_back({"", readFile(file)});
  for (const auto& check : exercise.checks) {
    if (check.catches.empty()) continue;
    auto source = readIfThere(exercise.folder / "versions" / (check.catches + ".cpp"));
    if (!source) source = readIfThere(tested.folder / "wrong" / (check.catches + ".cpp"));
    if (!source) {
      throw Failure{ourFault, exercise.id + ": check '" + check.name + "' catches " +
                                  check.catches +
                                  ", which is neither in versions/ nor in wrong/ of " + tested.id};
    }
    versions.push_back({check.name, *source});
  }
  return versions;
}

std::string packed(const std::vector<TestedVersion>& versions) {
  // A version a line: a change shows as one line of a diff.
  std::string text = "[";
  for (const auto& version : versions) {
    text += (text.size() > 1 ? ",\n " : "\n ") +
            json{{"check", version.check},
                 {"packed", io::detail::base64(io::detail::deflated(version.source))}}
                .dump();
  }
  return text + "\n]\n";
}

void checkVersions(const Project& project, const Exercise& exercise, const CheckOptions& options,
                   const fs::path& program, const fs::path& folder, ExerciseResult& result) {
  // A student's copy of the course has neither the versions nor the library's function while the answer to the
  // exercise about it is secret: then the cases meet the student's own function, and are graded by the teacher.
  const bool withTeacher = !fs::exists(project.root / versionsFile(exercise)) &&
                           !fs::exists(exercise.folder / exercise.fileName());
  const auto versions =
      withTeacher ? std::vector<TestedVersion>{} : packedVersions(project, exercise);
  auto checkNamed = [&](const std::string& name) -> CheckResult* {
    for (auto& check : result.checks) {
      if (check.name == name) return &check;
    }
    return nullptr;
  };
  CheckResult& passes = *checkNamed(kPassesOnRight);
  CheckResult& asks = *checkNamed(kEveryCaseAsks);

  // The library's version first: what fails here needs no other.
  std::vector<std::vector<Meeting>> meetings(versions.size() + 1);
  auto against = [&](std::size_t which) {
    const fs::path version = which == 0 ? versionProgram(project, exercise, "library", nullptr)
                                        : versionProgram(project, exercise, std::to_string(which),
                                                         &versions[which - 1].source);
    meetings[which].push_back(meet(program, version, folder, options));
    result.seconds += meetings[which].back().seconds;
    return &meetings[which].back();
  };
  auto endWith = [&](Status status, const std::string& reason) {
    for (auto& check : result.checks) {
      if (check.status == Status::notRun && check.reason.empty()) check.reason = reason;
    }
    result.status = status;
  };
  const Meeting first = *against(0);
  if (first.functionMissing) {
    const std::string reason =
        "The function that your cases call is not written yet: first comes " + exercise.tests + ".";
    for (auto& check : result.checks) check.reason = reason;
    result.reason = reason;
    return;
  }
  if (first.notAttempted) {
    for (auto& check : result.checks) check.status = Status::notStarted;
    result.status = Status::notStarted;
    return;
  }
  const std::string empty = emptyCase(first);
  asks.status = empty.empty() ? Status::passed : Status::wrong;
  asks.reason = empty;
  auto failsOn = [&](const Meeting& meeting, std::size_t which) {
    passes.status = meeting.complete ? Status::wrong : Status::stopped;
    passes.reason = failsOnRight(meeting, which);
    if (withTeacher) {
      passes.reason += " Here that is your own function of " + exercise.tests +
                       ": which of the two is wrong, the function or the case?";
    }
    passes.output = meeting.output;
    passes.timedOut = meeting.timedOut;
    endWith(passes.status, "Not run, because a case fails on a version that is right.");
  };
  if (!first.complete)
    asks = {.name = asks.name, .title = asks.title, .failure = {}, .reason = {}, .output = {}};
  if (!first.passed) return failsOn(first, 0);

  if (withTeacher) {
    passes.status = Status::passed;
    return endWith(Status::notRun,
                   "The wrong versions are with your teacher: what your cases catch is seen when "
                   "you hand them in.");
  }

  // Everything twice, in an order that nobody can know beforehand.
  std::vector<std::size_t> order = {0};
  for (std::size_t i = 0; i < versions.size(); ++i) {
    // A check that is hidden from students is not among the exercise's.
    if (versions[i].check.empty() || checkNamed(versions[i].check))
      order.insert(order.end(), {i + 1, i + 1});
  }
  std::shuffle(order.begin(), order.end(), std::random_device());
  for (const std::size_t which : order) {
    const Meeting& meeting = *against(which);
    const bool right = which == 0 || versions[which - 1].check.empty();
    if (right && !meeting.passed) return failsOn(meeting, which);
    if (meeting.timedOut) {
      CheckResult& check = *checkNamed(versions[which - 1].check);
      check.status = Status::stopped;
      check.reason = "Your cases did not end on this version: give every loop a bound.";
      check.timedOut = true;
      endWith(Status::stopped, "Not run, because '" + check.title + "' did not end.");
      return;
    }
  }
  passes.status = Status::passed;
  bool all = asks.status == Status::passed;
  Status worst = all ? Status::passed : Status::wrong;
  for (std::size_t i = 0; i < versions.size(); ++i) {
    if (versions[i].check.empty()) continue;
    CheckResult* check = checkNamed(versions[i].check);
    if (!check) continue;  // hidden from students
    const auto& both = meetings[i + 1];
    const auto& known = *std::find_if(exercise.checks.begin(), exercise.checks.end(),
                                      [&](const Check& c) { return c.name == check->name; });
    if (!both[0].complete || !both[1].complete) {
      const Meeting& broken = both[0].complete ? both[1] : both[0];
      check->status = Status::stopped;
      check->reason =
          "On this version your program " + broken.end +
          " before all cases had run. Only a case that fails counts: use REQUIRE before you "
          "use what may be missing.";
      check->output = broken.output;
    } else if (both[0].passed != both[1].passed) {
      check->status = Status::wrong;
      check->reason =
          "The same cases passed once and failed once on the same version. They depend on "
          "something besides the "
          "function: time, random numbers, memory that was never set.";
    } else if (both[0].passed) {
      check->status = Status::wrong;
      check->reason = known.slipped;
    } else {
      check->status = Status::passed;
    }
    all &= check->status == Status::passed;
    if (worst == Status::passed) worst = check->status;
  }
  result.status = all ? Status::passed : worst;
}

}  // namespace carom::runner
