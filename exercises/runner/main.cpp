// The course runner: what ./course hands over to once the project is built.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <iostream>

#include "runner/debug.hpp"
#include "runner/develop.hpp"
#include "runner/pack.hpp"
#include "runner/reports.hpp"
#include "runner/skeleton.hpp"
#include "runner/teach.hpp"
#include "runner/view.hpp"
#include "runner/watch.hpp"

using namespace carom::runner;
using nlohmann::json;
namespace grading = carom::grading;

namespace {

struct Options {
  std::string root;
  std::string build;
  bool json = false;
  bool plain = false;
  std::string what;
  std::string second;
  std::string file;
  std::string junit;
  bool pipe = false;
  bool mine = false;
  bool force = false;
  int number = 0;
  bool noScreen = false;
  bool printOnly = false;
  bool quick = false;
  std::string kind = "implement";
  std::string tests;
  std::uint64_t seed = 0;
  int answerSeconds = 0;
  int compileSeconds = 0;
  std::vector<std::string> rest;
};

std::vector<std::string> targetsOf(const Project& project,
                                   const std::vector<const Exercise*>& which) {
  std::vector<std::string> targets;
  for (const auto* e : which) targets.push_back(project.entry(*e).at("target").get<std::string>());
  return targets;
}

void buildGraders(const Project& project, const std::vector<const Exercise*>& which, bool quiet) {
  buildTargets(project, targetsOf(project, which), quiet);
}

void writeJunit(const fs::path& file, const std::vector<ExerciseResult>& results) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const auto& r : results) {
    text += "<testsuite name=\"" + markupEscaped(r.exercise->id) + "\" tests=\"" +
            std::to_string(r.checks.size()) + "\" failures=\"" +
            std::to_string(r.checks.size() - static_cast<std::size_t>(r.passed())) + "\">\n";
    for (const auto& c : r.checks) {
      text += "  <testcase classname=\"" + markupEscaped(r.exercise->id) + "\" name=\"" +
              markupEscaped(c.title) + "\"";
      if (c.status == Status::passed) {
        text += "/>\n";
      } else {
        const std::string got = c.failure.is_object()
                                    ? "got " + c.failure.value("got", "") + ", expected " +
                                          c.failure.value("expected", "")
                                    : c.reason;
        text += "><failure message=\"" + markupEscaped(nameOf(c.status)) + "\">" +
                markupEscaped(got) + "</failure></testcase>\n";
      }
    }
    text += "</testsuite>\n";
  }
  writeFile(file, text + "</testsuites>\n");
}

int check(Project& project, const Options& o, const View& view) {
  State state(project.root);
  std::vector<const Exercise*> which;
  if (o.what.empty()) {
    const Exercise* next = nextExercise(project, state);
    if (!next) {
      std::cout << "Every exercise is done.\n";
      return Exit::pass;
    }
    which = {next};
  } else {
    which = project.select(o.what);
  }
  if (!o.file.empty() && which.size() != 1) throw Failure{usage, "--file needs one exercise"};
  if (which.empty()) throw Failure{usage, "chapter " + o.what + " has no exercises yet"};
  buildGraders(project, which, o.json);
  std::vector<ExerciseResult> results;
  int exitCode = Exit::pass;
  json all = json::array();
  for (const auto* e : which) {
    results.push_back(checkExercise(project, *e,
                                    {.source = o.file,
                                     .throughPipe = o.pipe,
                                     .lazy = {},
                                     .screen = !o.noScreen,
                                     .seed = o.seed,
                                     .answerSeconds = o.answerSeconds,
                                     .compileSeconds = o.compileSeconds}));
    const auto& result = results.back();
    if (o.file.empty()) state.remember(project, result);
    // The worst outcome of several is the exit code of all; one alone keeps its own.
    exitCode =
        which.size() == 1 ? result.exitCode() : std::max(exitCode, result.exitCode() == 0 ? 0 : 1);
    if (o.json) {
      all.push_back(toJson(result));
    } else {
      const int left = static_cast<int>(e->hints.size()) - state.hintsSeen(e->id);
      std::cout << describe(result, project, view, left) << std::flush;
    }
  }
  state.save();
  if (o.json) std::cout << (which.size() == 1 && o.what != "all" ? all[0] : all).dump(1) << "\n";
  if (!o.junit.empty()) writeJunit(o.junit, results);
  return exitCode;
}

int runProgram(const fs::path& program, const fs::path& folder, const Project& project) {
  fs::create_directories(folder);
  grading::Command command;
  command.words = {program.string(), folder.string()};
  command.limits = {.wallSeconds = 0, .cpuSeconds = 0, .outputKilobytes = 0};
  command.inheritOutput = true;
  std::cout << std::flush;
  const auto before = fs::file_time_type::clock::now();
  const auto done = grading::run(command);
  if (!done.ok()) {
    std::cout << program.filename().string() << " " << done.end << "\n";
    return Exit::stopped;
  }
  std::vector<std::string> pictures;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.last_write_time() >= before - std::chrono::seconds(1)) {
      pictures.push_back(fs::relative(file.path(), project.root).string());
    }
  }
  std::sort(pictures.begin(), pictures.end());
  for (const auto& picture : pictures) std::cout << "wrote " << picture << "\n";
  return Exit::pass;
}

// Objects of the student's finished functions, by seam.
std::vector<std::pair<std::string, fs::path>> compileMine(const Project& project,
                                                          const WorkFolder& folder) {
  std::vector<std::pair<std::string, fs::path>> mine;
  for (const auto& e : project.exercises) {
    if (e.isPrediction() || e.kind == "test" || isSkeleton(project, e)) continue;
    const auto content = readIfThere(project.root / e.studentFile());
    if (!content || content->find("todo<") != std::string::npos) continue;
    const auto compiled =
        compileSubmission(project, e, project.root / e.studentFile(), folder.path());
    if (!compiled.ok) {
      std::cout << e.id << " does not compile and is left out:\n" << compiled.firstError << "\n";
      continue;
    }
    std::cout << "with your " << e.id << "\n";
    mine.emplace_back(e.name, compiled.object);
  }
  return mine;
}

int run(const Project& project, const Options& o) {
  const std::string chapter = project.chapterFolder(o.what);
  std::vector<std::string> programs;
  for (const auto& [name, entry] : project.manifest.at("programs").items()) {
    if (name.starts_with(chapter + "/") && (o.second.empty() || name == chapter + "/" + o.second))
      programs.push_back(name);
  }
  if (programs.empty()) {
    throw Failure{usage, o.second.empty()
                             ? "chapter " + chapter + " has no programs yet"
                             : "chapter " + chapter + " has no program '" + o.second + "'"};
  }
  if (o.second.empty() && programs.size() > 1) {
    std::cout << "Programs of " << chapter << ":\n";
    for (const auto& name : programs) {
      std::cout << "  ./course run " << o.what << " " << name.substr(chapter.size() + 1) << "\n";
    }
    return Exit::pass;
  }
  std::vector<std::string> targets;
  for (const auto& name : programs)
    targets.push_back(project.manifest.at("programs").at(name).at("target").get<std::string>());
  buildTargets(project, targets, false);
  int exitCode = Exit::pass;
  for (const auto& name : programs) {
    const fs::path folder = project.build / "runs" / name;
    if (o.mine) {
      const WorkFolder work(project);
      const fs::path program = linkProgram(project, name, compileMine(project, work), work.path());
      exitCode = std::max(exitCode, runProgram(program, folder, project));
    } else {
      exitCode = std::max(
          exitCode,
          runProgram(project.manifest.at("programs").at(name).at("executable").get<std::string>(),
                     folder, project));
    }
  }
  return exitCode;
}

int play(const Project& project, const Options& o) {
  const Exercise& e = project.find(o.what);
  if (e.program.empty() || e.isPrediction()) throw Failure{usage, e.id + " has no program to play"};
  buildTargets(
      project,
      {project.manifest.at("programs").at(e.program).at("target").get<std::string>(), "carom_io"},
      false);
  const WorkFolder work(project);
  const auto compiled = compileSubmission(project, e, project.root / e.studentFile(), work.path());
  if (!compiled.ok) {
    std::cout << compiled.firstError << "\n";
    return Exit::doesNotCompile;
  }
  std::cout << e.program << " on your " << e.studentFile().string() << "\n";
  const fs::path program =
      linkProgram(project, e.program, {{e.name, compiled.object}}, work.path());
  return runProgram(program, project.build / "runs" / ("play-" + e.id), project);
}

int debug(const Project& project, const Options& o) {
  const Exercise& e = project.find(o.what);
  if (!e.isPrediction()) buildGraders(project, {&e}, true);
  return debugExercise(project, e, o.second, o.printOnly, o.json);
}

int pack(const Project& project, const Options& o) {
  const auto files = filesToPack(project, project.select(o.what.empty() ? "all" : o.what));
  const fs::path zip = o.file.empty() ? project.root / "carom-answers.zip" : fs::path(o.file);
  writePack(project, files, zip);
  std::size_t untouched = 0;
  json rows = json::array();
  for (const auto& file : files) {
    untouched += file.untouched;
    rows.push_back({{"id", file.exercise->id}, {"path", file.path}, {"untouched", file.untouched}});
    if (!o.json) {
      std::cout << file.path << ", " << file.bytes << " bytes"
                << (file.untouched ? ", not started" : "") << "\n";
    }
  }
  if (o.json) {
    std::cout << json{{"zip", zip.string()}, {"files", rows}}.dump(1) << "\n";
  } else {
    std::cout << "wrote " << zip.string() << ": " << files.size() << " files, " << untouched
              << " of them not started\n";
  }
  return Exit::pass;
}

int hint(const Project& project, const Options& o) {
  State state(project.root);
  const Exercise* e = o.what.empty() ? nextExercise(project, state) : &project.find(o.what);
  if (!e) return Exit::pass;
  const int number = o.number > 0
                         ? o.number
                         : std::min(state.hintsSeen(e->id) + 1, static_cast<int>(e->hints.size()));
  if (number < 1 || number > static_cast<int>(e->hints.size())) {
    throw Failure{usage, e->id + " has hints 1 to " + std::to_string(e->hints.size())};
  }
  if (o.json) {
    std::cout << json{{"id", e->id},
                      {"number", number},
                      {"of", e->hints.size()},
                      {"text", e->hints[static_cast<std::size_t>(number) - 1]}}
                     .dump(1)
              << "\n";
  } else {
    std::cout << hintText(*e, number);
  }
  state.sawHint(e->id, number);
  state.save();
  return Exit::pass;
}

int solution(const Project& project, const Options& o, const View& view) {
  const Exercise& e = project.find(o.what);
  State state(project.root);
  if (state.statusOf(project, e) != Status::passed && !o.force) {
    std::cout << "The solution is shown after a pass. ./course solution " << e.id
              << " --give-up shows it now.\n";
    return Exit::checkFailed;
  }
  const auto source = readIfThere(e.folder / e.fileName());
  if (!source) throw Failure{usage, "this copy of the course does not hold the answer to " + e.id};
  std::cout << view.strong("A worked answer") << "\n" << cutAnswer(*source, e.fileName()) << "\n";
  std::cout << readIfThere(e.folder / "why.md").value_or("");
  return Exit::pass;
}

int status(const Project& project, const Options& o, const View& view) {
  const State state(project.root);
  int done = 0;
  for (const auto& e : project.exercises) done += state.statusOf(project, e) == Status::passed;
  const Exercise* next = nextExercise(project, state);
  if (o.json) {
    std::cout << json{{"done", done},
                      {"of", project.exercises.size()},
                      {"next", next ? json(next->id) : json()}}
                     .dump(1)
              << "\n";
    return Exit::pass;
  }
  std::cout << done << " of " << project.exercises.size() << " exercises done.\n";
  if (next) {
    std::cout << "Next: " << view.strong(next->id + "  " + next->title) << "\n"
              << "  ./course show " << next->id << "    what it asks\n"
              << "  edit " << next->studentFile().string() << "\n"
              << "  ./course check " << next->id
              << "   or ./course watch, which checks each time you save\n";
  }
  return Exit::pass;
}

int start(const Project& project, const Options& o, const View& view) {
  buildTargets(project, {"course_ready"}, false);
  std::cout << view.strong("The first lesson: two billiard balls") << "\n\n";
  Options first = o;
  first.what = "0";
  first.second = "first_collision";
  const int exitCode = run(project, first);
  std::cout << "\nOpen the .html file above in a browser: it plays by double-click.\n\n";
  status(project, o, view);
  return exitCode;
}

int doctor(const Project& project, const Options& o) {
  struct Finding {
    std::string what, found, advice;
    bool good;
  };
  std::vector<Finding> findings;
  auto tool = [&](const char* name, const char* package, bool needed) {
    grading::Command command;
    command.words = {name, "--version"};
    const auto done = grading::run(command);
    const auto lines = splitLines(done.output);
    findings.push_back({name, done.ok() && !lines.empty() ? lines[0] : "missing",
                        done.ok() ? "" : std::string("install ") + package, done.ok() || !needed});
  };
  tool(project.text("compiler").c_str(), "g++", true);
  tool(project.text("cmake").c_str(), "cmake", true);
  for (const auto& [library, version] : project.manifest.at("versions").items())
    findings.push_back({library, version.get<std::string>(), "", true});
  tool("ninja", "ninja-build", true);
  tool("git", "git", true);
  tool("gnuplot", "gnuplot-nox", true);
  tool("doxygen", "doxygen", false);
  tool("chromium", "chromium", false);
  tool("bwrap", "bubblewrap", false);
  // Only a teacher needs it.
  const auto sandbox = grading::bestSandbox();
  const bool closed = sandbox.tier != grading::Tier::limits;
  findings.push_back({"grading runs in", describe(sandbox),
                      closed ? "" : "not safe for work that nobody vouches for", true});
  std::error_code error;
  fs::create_directories(project.root / ".carom", error);
  const bool writable = access(project.root.c_str(), W_OK) == 0 && !error;
  findings.push_back({"writing here", writable ? "yes" : "no",
                      writable ? "" : "the project's folder must be writable", writable});
  const std::string path = project.root.string();
  const bool plainPath =
      std::all_of(path.begin(), path.end(), [](unsigned char c) { return c > 32 && c < 127; });
  findings.push_back(
      {"path", path, plainPath ? "" : "blanks and accents in the path confuse some tools", true});
  findings.push_back({"exercises", std::to_string(project.exercises.size()),
                      project.problems.empty() ? "" : project.problems.front(),
                      project.problems.empty()});
  bool allGood = true;
  json rows = json::array();
  for (const auto& f : findings) {
    allGood &= f.good;
    rows.push_back({{"what", f.what}, {"found", f.found}, {"good", f.good}, {"advice", f.advice}});
    if (!o.json)
      std::cout << (f.good ? "  ok  " : "  NOT ") << f.what << ": " << f.found
                << (f.advice.empty() ? "" : "   (" + f.advice + ")") << "\n";
  }
  if (o.json) std::cout << json{{"ok", allGood}, {"findings", rows}}.dump(1) << "\n";
  return allGood ? Exit::pass : Exit::ourFault;
}

// An exercise that has just been written is not in the build yet: lets CMake look again, and says what is missing.
void acquaint(Project& project, const Options& o) {
  auto unknown = [&] {
    std::vector<const Exercise*> list;
    for (const auto* e : project.select(o.what.empty() ? "all" : o.what)) {
      if (!project.manifest.at("exercises").contains(e->id)) list.push_back(e);
    }
    return list;
  };
  if (unknown().empty()) return;
  grading::Command cmake;
  cmake.words = {project.text("cmake"), "-S", project.root.string(), "-B", project.build.string()};
  cmake.limits = {.wallSeconds = 0, .cpuSeconds = 0, .outputKilobytes = 4096};
  const auto done = grading::run(cmake);
  if (!done.ok()) throw Failure{ourFault, "CMake could not configure the project:\n" + done.output};
  project = openProject(project.root, project.build);
  std::string problems;
  for (const auto* e : unknown()) {
    for (const auto& problem : missingFiles(project, *e)) problems += problem + "\n";
    const std::string of = e->chapter + "/" + e->name + "/";
    for (const auto& problem : project.problems) {
      if (problem.starts_with(of)) problems += problem + "\n";
    }
  }
  if (!problems.empty()) throw Failure{checkFailed, problems + "The exercise is not complete yet."};
}

int devCheck(Project& project, const Options& o) {
  acquaint(project, o);
  const auto which = project.select(o.what.empty() ? "all" : o.what);
  // All graders, or what the exercises named need.
  std::vector<std::string> targets = {"graders"};
  if (which.size() < project.exercises.size()) {
    targets = {"carom_io", "carom_variant_library", "carom_variant_mine"};
    for (const auto* e : which) {
      const auto& entry = project.entry(*e);
      targets.push_back(entry.at("target").get<std::string>());
    }
  }
  for (const auto* e : which) {
    if (!o.quick && !e->program.empty() && project.manifest.at("programs").contains(e->program)) {
      targets.push_back(
          project.manifest.at("programs").at(e->program).at("target").get<std::string>());
    }
  }
  buildTargets(project, targets, o.json);
  const json result = checkAll(project, which, !o.json, o.quick);
  if (o.json) {
    std::cout << result.dump(1) << "\n";
  } else {
    for (const auto& problem : result["problems"]) std::cout << problem.get<std::string>() << "\n";
    std::cout << result["exercises"].size() << " exercises, " << result["problems"].size()
              << " problems\n";
  }
  return result["problems"].empty() ? Exit::pass : Exit::checkFailed;
}

int devSync(Project& project, const Options& o) {
  acquaint(project, o);
  const auto which = project.select(o.what.empty() ? "all" : o.what);
  buildGraders(project, which, true);
  for (const auto& problem : project.problems) std::cerr << problem << "\n";
  for (const auto& file : syncExercises(project, which, o.force))
    std::cout << "wrote " << file << "\n";
  return project.problems.empty() ? Exit::pass : Exit::checkFailed;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Carom: learn how collisions of rigid bodies are simulated"};
  app.name("course");
  Options o;
  app.add_option("--root", o.root)->group("");
  app.add_option("--build", o.build)->group("");
  app.add_flag("--json", o.json, "Answer in JSON");
  app.add_flag(
      "--plain", o.plain,
      "Words instead of colours, columns and symbols, for screen readers and programs (so it "
      "is already where there is no terminal)");
  app.fallthrough();

  auto* startVerb =
      app.add_subcommand("start", "Set everything up, run the first lesson, show what comes next");
  auto* listVerb = app.add_subcommand("list", "All exercises and what is done");
  listVerb->add_option("chapter", o.what, "Only this chapter");
  auto* showVerb = app.add_subcommand("show", "What an exercise asks");
  showVerb->add_option("id", o.what)->required();
  auto* checkVerb = app.add_subcommand(
      "check", "Check an exercise, a chapter, or all; without a name, the next one");
  checkVerb->add_option("what", o.what);
  checkVerb->add_option("--file", o.file, "Check this file instead of the one in exercises/");
  checkVerb->add_flag("--pipe", o.pipe, "As when graded: the answer runs in a process of its own");
  checkVerb->add_option("--junit", o.junit, "Write a JUnit report to this file");
  // For the tests of the grader itself: none of these makes anything easier.
  checkVerb->add_flag("--no-screen", o.noScreen)->group("")->needs("--pipe");
  checkVerb->add_option("--seed", o.seed)->group("");
  checkVerb->add_option("--answer-seconds", o.answerSeconds)->group("");
  checkVerb->add_option("--compile-seconds", o.compileSeconds)->group("");
  auto* watchVerb = app.add_subcommand("watch", "Check each time the file is saved");
  watchVerb->add_option("id", o.what);
  auto* debugVerb = app.add_subcommand(
      "debug", "Start a debugger at the question that goes wrong, in your function");
  debugVerb->add_option("id", o.what)->required();
  debugVerb->add_option("--check", o.second, "This check instead of the first that fails");
  debugVerb->add_flag("--print", o.printOnly, "Only print what would be started");
  auto* packVerb = app.add_subcommand("pack", "Your answers in one file, to hand in");
  packVerb->add_option("what", o.what, "Only this exercise or chapter");
  packVerb->add_option("--out", o.file, "Name of the archive (carom-answers.zip)");
  auto* hintVerb = app.add_subcommand("hint", "The next hint, or a given one");
  hintVerb->add_option("id", o.what);
  hintVerb->add_option("number", o.number);
  auto* solutionVerb =
      app.add_subcommand("solution", "A worked answer and why it is written so, after a pass");
  solutionVerb->add_option("id", o.what)->required();
  solutionVerb->add_flag("--give-up", o.force, "Show it now");
  auto* resetVerb =
      app.add_subcommand("reset", "Put the skeleton back; your file is kept as a copy");
  resetVerb->add_option("id", o.what)->required();
  auto* runVerb = app.add_subcommand("run", "Run a chapter's program");
  runVerb->add_option("chapter", o.what)->required();
  runVerb->add_option("program", o.second);
  runVerb->add_flag("--mine", o.mine, "On the functions that you have written");
  auto* playVerb = app.add_subcommand("play", "Run the exercise's program on your function");
  playVerb->add_option("id", o.what)->required();
  auto* doctorVerb = app.add_subcommand("doctor", "What is installed, what is missing");
  auto* developVerb = app.add_subcommand("dev", "For authors of exercises");
  auto* newVerb = developVerb->add_subcommand("new", "Files of a new exercise");
  newVerb->add_option("chapter", o.what)->required();
  newVerb->add_option("name", o.second)->required();
  newVerb->add_option("--kind", o.kind, "implement, fix, measure, predict or test");
  newVerb->add_option("--tests", o.tests, "Kind test: the exercise whose function is tested");
  auto* syncVerb =
      developVerb->add_subcommand("sync", "Cut skeletons and measure fingerprints anew");
  syncVerb->add_option("what", o.what);
  syncVerb->add_flag("--force", o.force, "Also over files that have been edited");
  auto* proveVerb =
      developVerb->add_subcommand("check", "Prove that every exercise does what it should");
  proveVerb->add_option("what", o.what);
  proveVerb->add_flag("--quick", o.quick,
                      "Only the texts, skeleton, solution and one wrong version");
  developVerb->require_subcommand(1);
  const TeachVerbs teach(app);
  // Handled by the script ./course; listed here for --help.
  app.add_subcommand("test",
                     "Build everything and run the tests; --whole: also those that take long");
  app.add_subcommand("docs", "Build the site");
  app.add_subcommand("carom", "Run the program carom: ./course carom mass FILE");
  app.add_subcommand("bench", "Measure time and error: ./course bench --suite mass --json FILE");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? static_cast<int>(Exit::pass) : static_cast<int>(Exit::usage);
  }
  const bool plain = o.plain || !isatty(1);
  const View view{.colour = !plain && !o.json && !std::getenv("NO_COLOR"), .plain = plain};
  try {
    Project project =
        openProject(o.root.empty() ? fs::current_path() : fs::path(o.root),
                    o.build.empty() ? fs::current_path() / "build/default" : fs::path(o.build));
    if (*startVerb) return start(project, o, view);
    if (*listVerb) {
      const State state(project.root);
      const auto which = project.select(o.what.empty() ? "all" : o.what);
      if (o.json) {
        json rows = json::array();
        for (const auto* e : which) {
          rows.push_back({{"id", e->id},
                          {"title", e->title},
                          {"kind", e->kind},
                          {"level", e->level},
                          {"minutes", e->minutes},
                          {"points", e->points},
                          {"file", e->studentFile().string()},
                          {"status", nameOf(state.statusOf(project, *e))}});
        }
        std::cout << rows.dump(1) << "\n";
      } else {
        std::cout << listing(project, state, which, view);
      }
      return Exit::pass;
    }
    if (*showVerb) {
      const Exercise& e = project.find(o.what);
      if (o.json) {
        json checks = json::array();
        for (const auto& c : e.checks)
          checks.push_back({{"name", c.name}, {"title", c.title}, {"points", c.points}});
        std::cout << json{{"id", e.id},
                          {"title", e.title},
                          {"kind", e.kind},
                          {"level", e.level},
                          {"minutes", e.minutes},
                          {"points", e.points},
                          {"file", e.studentFile().string()},
                          {"checks", checks},
                          {"hints", e.hints.size()},
                          {"statement", readIfThere(e.folder / "statement.md").value_or("")}}
                         .dump(1)
                  << "\n";
      } else {
        std::cout << statement(e, view);
      }
      return Exit::pass;
    }
    if (*checkVerb) return check(project, o, view);
    if (*watchVerb) return watch(project, o.what.empty() ? nullptr : &project.find(o.what), view);
    if (*debugVerb) return debug(project, o);
    if (*packVerb) return pack(project, o);
    if (*hintVerb) return hint(project, o);
    if (*solutionVerb) return solution(project, o, view);
    if (*resetVerb) {
      const Exercise& e = project.find(o.what);
      const std::string backup = resetExercise(project, e);
      std::cout << e.studentFile().string() << " is the skeleton again."
                << (backup.empty() ? "" : " Your file is kept as " + backup) << "\n";
      return Exit::pass;
    }
    if (*runVerb) return run(project, o);
    if (*playVerb) return play(project, o);
    if (*doctorVerb) return doctor(project, o);
    if (*newVerb) {
      for (const auto& file : newExercise(
               project, {.chapter = o.what, .name = o.second, .kind = o.kind, .tests = o.tests}))
        std::cout << "wrote " << file << "\n";
      std::cout << "Fill them in; ./course dev check " << o.second << " says what is missing.\n";
      return Exit::pass;
    }
    if (*syncVerb) return devSync(project, o);
    if (*proveVerb) return devCheck(project, o);
    if (teach.asked()) return teach.run(project);
    return status(project, o, view);
  } catch (const Failure& failure) {
    if (o.json)
      std::cout << json{{"error", failure.message}, {"exit", failure.exitCode}}.dump(1) << "\n";
    std::cerr << failure.message << "\n";
    return failure.exitCode;
  } catch (const std::exception& error) {
    std::cerr << "the course runner failed: " << error.what() << "\n";
    return Exit::ourFault;
  }
}
