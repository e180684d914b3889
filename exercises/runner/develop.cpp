#include "runner/develop.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <mutex>
#include <thread>

#include "runner/skeleton.hpp"
#include "runner/versions.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

// The versions in wrong/ or right/, sorted by name.
std::vector<fs::path> versions(const Exercise& exercise, const char* folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(exercise.folder / folder, none)) {
    if (file.path().extension() == exercise.extension) files.push_back(file.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string fingerprints(const Project& project, const Exercise& exercise, Workbench& bench) {
  json all = json::object();
  for (const auto& file : versions(exercise, "wrong")) {
    json probes = json::array();
    for (const auto& numbers :
         probeAnswers(project, exercise,
                      {.source = file, .throughPipe = true, .lazy = {}, .bench = &bench})) {
      json list = json::array();
      for (const double number : numbers)
        list.push_back(std::isfinite(number) ? json(number) : json("NaN"));
      probes.push_back(list);
    }
    all[file.stem().string()] = probes;
  }
  // A probe a line: a change shows as a few lines of a diff.
  std::string text = "{";
  bool first = true;
  for (const auto& [name, probes] : all.items()) {
    text += std::string(first ? "" : ",") + "\n \"" + name + "\": [";
    for (std::size_t i = 0; i < probes.size(); ++i)
      text += (i ? ",\n  " : "\n  ") + probes[i].dump();
    text += "]";
    first = false;
  }
  return text + "\n}\n";
}

std::vector<std::vector<double>> readFingerprint(const json& probes) {
  std::vector<std::vector<double>> all;
  for (const auto& probe : probes) {
    auto& numbers = all.emplace_back();
    for (const auto& n : probe) numbers.push_back(n.is_number() ? n.get<double>() : std::nan(""));
  }
  return all;
}

// What git has of a file; nothing when it has none.
std::optional<std::string> committed(const Project& project, const fs::path& file) {
  grading::Command git;
  git.words = {"git", "-C", project.root.string(), "show", "HEAD:" + file.string()};
  git.limits.outputKilobytes = 4096;
  const auto done = grading::run(git);
  if (!done.ok()) return std::nullopt;
  return done.output;
}

struct Proof {
  json row;
  std::vector<std::string> problems;
};

int wordCount(const std::string& text) {
  return static_cast<int>(words(text).size());
}

class Prover {
 public:
  Prover(const Project& project, const Exercise& exercise, bool quick)
      : project_(project), e_(exercise), quick_(quick), bench_(project) {}

  Proof prove() {
    proof_.row = {{"id", e_.id},
                  {"kind", e_.kind},
                  {"checks", e_.checks.size()},
                  {"skeleton_fails_all", false},
                  {"lazy_fails_all", false},
                  {"solution_passes", false},
                  {"right", 0},
                  {"wrong", 0},
                  {"wrong_caught", 0},
                  {"wrong_named", 0}};
    // What a quick check does not look at is not said to hold, nor not to.
    if (quick_) proof_.row["lazy_fails_all"] = proof_.row["right"] = nullptr;
    try {
      texts();
      skeleton();
      if (!quick_) lazy();
      solution();
      if (!quick_) right();
      if (quick_)
        firstWrong();
      else
        wrong();
      if (!quick_) program();
    } catch (const Failure& failure) {
      problem(failure.message);
    } catch (const std::exception& error) {
      problem(error.what());
    }
    return std::move(proof_);
  }

 private:
  void problem(const std::string& text) {
    proof_.problems.push_back(e_.id + ": " + text);
  }

  ExerciseResult check(CheckOptions options) {
    options.bench = &bench_;
    return checkExercise(project_, e_, options);
  }

  std::string firstReason(const ExerciseResult& result) const {
    std::string text = nameOf(result.status);
    if (!result.reason.empty()) text += ": " + result.reason;
    if (!result.compiled.firstError.empty()) text += ": " + result.compiled.firstError;
    for (const auto& c : result.checks) {
      if (c.status == Status::passed) continue;
      text += "; check '" + c.name + "' " + nameOf(c.status) + " " + c.reason;
      if (c.failure.is_object()) {
        text += " (got " + c.failure.value("got", "") + ", expected " +
                c.failure.value("expected", "") + ")";
      }
      break;
    }
    return text;
  }

  void texts() {
    const std::string statement = readIfThere(e_.folder / "statement.md").value_or("");
    const int count = wordCount(statement);
    if (count < 60 || count > 200)
      problem("statement.md has " + std::to_string(count) + " words; 60 to 200 are right");
    if (wordCount(readIfThere(e_.folder / "why.md").value_or("")) < 20)
      problem("why.md is missing or too short");
    if (e_.hints.size() < 2)
      problem("needs at least two hints, the first a question, the last almost the answer");
    const std::string only = answerOnly(source(), e_.fileName());
    for (std::size_t i = 0; i + 1 < e_.hints.size(); ++i) {
      for (const auto& line : splitLines(only)) {
        if (line.size() >= 16 && e_.hints[i].find(line) != std::string::npos) {
          problem("hint " + std::to_string(i + 1) +
                  " holds a line of the answer; only the last one may");
        }
      }
    }
    const int lines = answerLines(source(), e_.fileName());
    if (lines > 30)
      problem("the answer has " + std::to_string(lines) + " lines; a student writes at most 30");
    // The names that the statement stands on exist in a header that this exercise may use.
    for (const auto& name : e_.uses) {
      if (!introduced(name))
        problem("'uses' names " + name + ", which no header of its layers or chapter declares");
    }
  }

  bool introduced(const std::string& name) const {
    grading::Command grep;
    grep.words = {"grep",
                  "-rqw",
                  "--include=*.hpp",
                  name,
                  (project_.root / "lib/carom").string(),
                  (project_.root / "chapters" / e_.chapter).string()};
    return grading::run(grep).exitCode == 0;
  }

  const std::string& source() {
    if (source_.empty()) source_ = readFile(e_.folder / e_.fileName());
    return source_;
  }

  void skeleton() {
    const std::string cut = cutSkeleton(source(), e_.fileName());
    const auto inGit = committed(project_, e_.studentFile());
    if (!inGit) {
      problem(e_.studentFile().string() + " is not committed: run ./course dev sync");
    } else if (*inGit != cut) {
      problem("the committed " + e_.studentFile().string() + " is not what dev sync cuts");
    }
    const WorkFolder folder(project_);
    const fs::path file = folder.path() / e_.fileName();
    writeFile(file, cut);
    bool all = true;
    for (const bool pipe : {true, false}) {
      if (quick_ && !pipe) continue;
      const auto result =
          check({.source = file, .throughPipe = pipe, .lazy = {}, .fingerprint = false});
      if (result.status == Status::doesNotCompile || result.compiled.warnings > 0) {
        problem("the skeleton does not compile without warnings: " + result.compiled.firstError +
                result.compiled.full);
        all = false;
      }
      for (const auto& c : result.checks) {
        if (c.status == Status::passed && c.points > 0) {
          problem("the skeleton passes check '" + c.name + "'");
          all = false;
        }
        if (c.status == Status::ourFault) {
          problem("check '" + c.name + "': " + c.reason);
          all = false;
        }
      }
    }
    proof_.row["skeleton_fails_all"] = all;
  }

  void lazy() {
    bool all = true;
    const WorkFolder folder(project_);
    std::vector<CheckOptions> tries;
    if (e_.isPrediction()) {
      // The lazy prediction: every blank filled with the same number.
      for (const char* number : {"0", "1"}) {
        std::string text;
        for (const auto& line : splitLines(cutSkeleton(source(), e_.fileName()))) {
          const auto blank = line.starts_with("#") ? std::string::npos : line.find('?');
          text += (blank == std::string::npos
                       ? line
                       : line.substr(0, blank) + number + line.substr(blank + 1)) +
                  "\n";
        }
        const fs::path file = folder.path() / (std::string("lazy") + number + ".txt");
        writeFile(file, text);
        tries.push_back({.source = file, .lazy = {}, .fingerprint = false});
      }
    } else if (e_.isTest()) {
      // Cases that somebody writes who has not thought.
      const std::string include = "#include \"support/catch.hpp\"\n";
      const std::pair<const char*, std::string> lazy[] = {
          {"no_cases", include},
          {"always_passes", include + "TEST_CASE(\"all is well\") { CHECK(true); }\n"},
          {"always_fails", include + "TEST_CASE(\"nothing is well\") { CHECK(false); }\n"}};
      for (const auto& [name, text] : lazy) {
        const fs::path file = folder.path() / (std::string("lazy_") + name + ".cpp");
        writeFile(file, text);
        tries.push_back({.source = file, .lazy = {}, .fingerprint = false});
      }
    } else {
      for (const char* mode : {"zero", "one", "echo"})
        tries.push_back({.source = {}, .lazy = mode, .fingerprint = false});
    }
    for (const auto& options : tries) {
      for (const auto& c : check(options).checks) {
        if (c.points > 0 && c.status == Status::passed) {
          problem("a lazy answer (" +
                  (options.lazy.empty() ? options.source.stem().string() : options.lazy) +
                  ") passes check '" + c.name + "'");
          all = false;
        }
      }
    }
    proof_.row["lazy_fails_all"] = all;
  }

  void solution() {
    bool all = true;
    if (!e_.isPrediction() && !e_.isTest()) {
      const auto library =
          check({.source = {}, .lazy = {}, .libraryVersion = true, .fingerprint = false});
      if (library.status != Status::passed) {
        problem("the library's version fails: " + firstReason(library));
        all = false;
      }
    }
    for (const bool pipe : {true, false}) {
      if (quick_ && !pipe) continue;
      for (const std::uint64_t seed : {0, 1, 2}) {
        const auto result = check({.source = e_.folder / e_.fileName(),
                                   .throughPipe = pipe,
                                   .lazy = {},
                                   .fingerprint = false,
                                   .seed = seed});
        if (result.status != Status::passed) {
          problem(std::string("the solution fails ") +
                  (pipe ? "through the pipe" : "in the self-check") + " with seed " +
                  std::to_string(seed) + ": " + firstReason(result));
          all = false;
          break;
        }
        if (result.compiled.warnings)
          problem("the solution compiles with warnings:\n" + result.compiled.full);
        if (quick_ || e_.isPrediction() || e_.isTest() || !pipe) break;  // other seeds once
      }
    }
    proof_.row["solution_passes"] = all;
  }

  void right() {
    int good = 0;
    const auto files = versions(e_, "right");
    for (const auto& file : files) {
      const auto result =
          check({.source = file, .throughPipe = true, .lazy = {}, .fingerprint = false});
      if (result.status == Status::passed)
        ++good;
      else
        problem("right/" + file.filename().string() + " fails: " + firstReason(result));
    }
    if (files.empty()) problem("has no other right answer in right/");
    proof_.row["right"] = good;
  }

  // What exercise.ini says of a file in wrong/; nothing, and a problem, where it does not name it.
  const Wrong* catalogued(const fs::path& file) {
    const std::string name = file.stem().string();
    const auto known = std::find_if(e_.wrong.begin(), e_.wrong.end(),
                                    [&](const Wrong& w) { return w.name == name; });
    if (known != e_.wrong.end()) return &*known;
    problem("wrong/" + file.filename().string() + " has no section [wrong." + name + "]");
    return nullptr;
  }

  // A misunderstanding fails its check, and others only where the catalogue says that they lean on the same. Inputs
  // differ between students, so what it says may fail need not do so for each of them.
  void losesItsChecks(const Wrong& known, const ExerciseResult& result) {
    std::string missing;
    for (const auto& c : result.checks) {
      if (c.status != Status::passed && !known.mayFail(c.name)) missing += " " + c.name;
    }
    if (!missing.empty())
      problem("wrong/" + known.name + " also fails" + missing + ": add that to 'also = '");
  }

  // Catches a wrong version, and says its name.
  void tryWrong(const Wrong& known, const fs::path& file, int& caught, int& named) {
    const auto result = check({.source = file, .throughPipe = true, .lazy = {}});
    const auto own = std::find_if(result.checks.begin(), result.checks.end(),
                                  [&](const CheckResult& c) { return c.name == known.check; });
    if (own != result.checks.end() && own->status == Status::wrong)
      ++caught;
    else
      problem("wrong/" + known.name + " does not fail its check '" + known.check +
              "': " + firstReason(result));
    losesItsChecks(known, result);
    if (result.wrongName == known.name)
      ++named;
    else
      problem("wrong/" + known.name + " is not named (got '" + result.wrongName + "')");
  }

  // Quick: one misunderstanding speaks for all.
  void firstWrong() {
    const auto files = versions(e_, "wrong");
    if (files.empty() || e_.isTest()) return;
    const Wrong* known = catalogued(files.front());
    int caught = 0, named = 0;
    if (known) tryWrong(*known, files.front(), caught, named);
    proof_.row["wrong"] = 1;
    proof_.row["wrong_caught"] = caught;
    proof_.row["wrong_named"] = named;
  }

  void wrong() {
    const auto files = versions(e_, "wrong");
    int caught = 0;
    int named = 0;
    if (files.empty()) problem("has no known-wrong answer in wrong/");
    for (const auto& w : e_.wrong) {
      const fs::path file = e_.folder / "wrong" / (w.name + e_.extension);
      if (std::find(files.begin(), files.end(), file) == files.end())
        problem("wrong/" + w.name + e_.extension + " is missing");
    }
    if (e_.isTest()) return weakCases(files);
    const std::string fresh = fingerprints(project_, e_, bench_);
    const auto kept = readIfThere(project_.root / fingerprintFile(e_));
    const json freshAll = json::parse(fresh);
    const json keptAll = json::parse(kept.value_or(""), nullptr, false);
    const auto answers = probeAnswers(
        project_, e_, {.source = e_.folder / e_.fileName(), .lazy = {}, .bench = &bench_});
    if (answers.empty()) problem("the grader has no probes");
    for (const auto& file : files) {
      const std::string name = file.stem().string();
      const Wrong* known = catalogued(file);
      if (!known) continue;
      const auto mine = readFingerprint(freshAll.at(name));
      // Other compilers round differently, so fingerprints are compared as answers, not as text.
      if (!keptAll.is_object() || !keptAll.contains(name) ||
          !sameAnswers(mine, readFingerprint(keptAll.at(name)))) {
        problem("the fingerprint of wrong/" + file.filename().string() +
                " is out of date: run ./course dev sync");
      }
      if (sameAnswers(mine, answers))
        problem("wrong/" + name + " answers the probes like the solution");
      for (const auto& [other, probes] : freshAll.items()) {
        if (other > name && sameAnswers(mine, readFingerprint(probes))) {
          problem("the probes cannot tell wrong/" + name + " from wrong/" + other);
        }
      }
      tryWrong(*known, file, caught, named);
    }
    proof_.row["wrong"] = files.size();
    proof_.row["wrong_caught"] = caught;
    proof_.row["wrong_named"] = named;
  }

  // Kind test: the wrong answers are cases that let something through. Each scored check is lost by one of them, so
  // that none is earned by whatever cases; what got through is then said in words.
  void weakCases(const std::vector<fs::path>& files) {
    int caught = 0;
    int named = 0;
    const auto kept = readIfThere(project_.root / versionsFile(e_));
    if (kept.value_or("") != packed(authoredVersions(project_, e_)))
      problem(versionsFile(e_).string() + " is out of date: run ./course dev sync");
    for (const auto& file : files) {
      const std::string name = file.stem().string();
      const Wrong* known = catalogued(file);
      if (!known) continue;
      const auto result = check({.source = file, .throughPipe = true, .lazy = {}});
      losesItsChecks(*known, result);
      for (const auto& c : result.checks) {
        const bool own = c.name == known->check;
        if (own && c.status == Status::wrong) {
          ++caught;
          named += !c.reason.empty();
        } else if (own) {
          problem("wrong/" + name + " does not fail its check '" + known->check +
                  "': " + firstReason(result));
        }
      }
    }
    for (const auto& c : e_.checks) {
      const auto loses = [&](const Wrong& w) { return w.check == c.name; };
      if (c.points > 0 && std::none_of(e_.wrong.begin(), e_.wrong.end(), loses))
        problem("no cases in wrong/ let the version of check '" + c.name + "' through");
    }
    proof_.row["wrong"] = files.size();
    proof_.row["wrong_caught"] = caught;
    proof_.row["wrong_named"] = named;
  }

  // `play` is worth something only if the program really runs on the student's function.
  void program() {
    if (e_.program.empty() || e_.isPrediction() || e_.isTest()) return;
    const auto all = project_.manifest.at("programs");
    if (!all.contains(e_.program)) {
      problem("the program " + e_.program + " does not exist");
      return;
    }
    const WorkFolder folder(project_);
    auto outputWith = [&](const fs::path& source) {
      const auto& compiled = bench_.version(source, false).compiled;
      if (!compiled.ok)
        throw Failure{ourFault, source.string() + " does not compile: " + compiled.firstError};
      const fs::path program =
          linkProgram(project_, e_.program, {{e_.name, compiled.object}}, folder.path());
      grading::Command command;
      command.words = {program.string(), folder.path().string()};
      command.directory = folder.path().string();
      command.limits = {.wallSeconds = 120, .cpuSeconds = 60, .outputKilobytes = 4096};
      const auto done = grading::run(command);
      return done.output + (done.exitCode == 0 ? "" : done.end);
    };
    const std::string right = outputWith(e_.folder / e_.fileName());
    bool differs = false;
    for (const auto& file : versions(e_, "wrong")) {
      if (outputWith(file) != right) {
        differs = true;
        break;
      }
    }
    if (!differs)
      problem("no wrong version changes what " + e_.program +
              " prints: the program does not show the function");
  }

  const Project& project_;
  const Exercise& e_;
  const bool quick_;
  std::string source_;
  Workbench bench_;
  Proof proof_;
};

}  // namespace

std::vector<std::string> syncExercises(const Project& project,
                                       const std::vector<const Exercise*>& which, bool force) {
  std::vector<std::string> written;
  for (const auto* e : which) {
    const std::string cut = cutSkeleton(readFile(e->folder / e->fileName()), e->fileName());
    const auto now = readIfThere(project.root / e->studentFile());
    const auto before = committed(project, e->studentFile());
    if (!now || (*now != cut && (force || (before && *now == *before)))) {
      writeFile(project.root / e->studentFile(), cut);
      written.push_back(e->studentFile().string());
    } else if (*now != cut) {
      std::cerr << e->studentFile().string()
                << " has been worked on and is left alone (--force replaces it)\n";
    }
    Workbench bench(project);
    const std::string fresh =
        e->isTest() ? packed(authoredVersions(project, *e)) : fingerprints(project, *e, bench);
    const fs::path file = e->isTest() ? versionsFile(*e) : fingerprintFile(*e);
    if (readIfThere(project.root / file).value_or("") != fresh) {
      writeFile(project.root / file, fresh);
      written.push_back(file.string());
    }
  }
  return written;
}

json checkAll(const Project& project, const std::vector<const Exercise*>& which, bool progress,
              bool quick) {
  std::vector<Proof> proofs(which.size());
  std::atomic<std::size_t> next{0};
  std::mutex printing;
  auto work = [&] {
    for (std::size_t i = next++; i < which.size(); i = next++) {
      proofs[i] = Prover(project, *which[i], quick).prove();
      if (progress) {
        const std::lock_guard lock(printing);
        std::cerr << (proofs[i].problems.empty() ? "  ok  " : "  NOT ") << which[i]->id << "\n";
      }
    }
  };
  std::vector<std::thread> workers;
  const unsigned count = std::max(1u, std::thread::hardware_concurrency());
  for (unsigned i = 1; i < count; ++i) workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();

  json rows = json::array();
  json problems = project.problems;
  for (const auto& proof : proofs) {
    rows.push_back(proof.row);
    for (const auto& p : proof.problems) problems.push_back(p);
  }
  return {{"exercises", rows}, {"problems", problems}};
}

}  // namespace carom::runner
