#include "runner/grade_class.hpp"

#include <unistd.h>
#include <algorithm>

#include <atomic>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "grading/sandbox.hpp"
#include "runner/check.hpp"
#include "runner/intake.hpp"
#include "runner/reports.hpp"
#include "runner/skeleton.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

constexpr int kFormat = 1;
// A student with two endless loops in one exercise has told enough.
constexpr int kPatience = 2;
// Seconds of a check from which it is said to be near its limit of five.
constexpr double kLong = 2.5;

// ---- what is graded

std::vector<const Exercise*> exercisesOf(const Project& project, const Course& course) {
  std::vector<const Exercise*> which;
  for (const auto& e : project.exercises) {
    if (course.policy(e).taken && !e.checks.empty()) which.push_back(&e);
  }
  if (which.empty()) throw Failure{usage, "the course has no exercise that can be graded"};
  return which;
}

std::string measuredVersion(const Project& project) {
  std::vector<fs::path> files;
  for (const char* folder : {"lib/carom", "chapters", "tests/grading", "tests/graders"}) {
    std::error_code none;
    for (const auto& file : fs::recursive_directory_iterator(project.root / folder, none)) {
      const auto end = file.path().extension();
      if (end == ".cpp" || end == ".hpp" || end == ".json") files.push_back(file.path());
    }
  }
  for (const auto& e : project.exercises) files.push_back(e.folder / "exercise.ini");
  std::sort(files.begin(), files.end());
  std::string all = project.text("compiler_id");
  for (const auto& file : files)
    all += file.lexically_relative(project.root).string() + hashOf(readIfThere(file).value_or(""));
  return hashOf(all);
}

json courseRecord(const Project& project, const Course& course,
                  const std::vector<const Exercise*>& which, const std::string& sandbox,
                  const std::string& today) {
  json all = json::array();
  for (const auto* e : which) {
    const auto policy = course.policy(*e);
    const double scale = e->points > 0 ? policy.points / e->points : 0;
    json checks = json::array();
    for (const auto& c : e->checks) {
      checks.push_back({{"name", c.name},
                        {"title", c.title},
                        {"points", c.points * scale},
                        {"read", c.read},
                        {"hidden", policy.hides(c.name)}});
    }
    all.push_back({{"id", e->id},
                   {"title", e->title},
                   {"kind", e->kind},
                   {"file", e->fileName()},
                   {"points", policy.points},
                   {"due", policy.due},
                   {"topic", policy.topic},
                   {"checks", checks}});
  }
  return {{"format", kFormat},
          {"title", course.title},
          {"version", courseVersion(project)},
          // Equal for equal secrets, and says nothing about them.
          {"seeds", std::to_string(seedOf(course, "", ""))},
          {"secret", !course.secret.empty()},
          {"sandbox", sandbox},
          {"today", today},
          {"exercises", all}};
}

// ---- one exercise of one student

// Takes what differs between machines and runs out of texts: folders, and bytes that are no text.
class Neutral {
 public:
  Neutral(const Project& project, const fs::path& work) {
    for (const auto& folder : {work, project.build, project.root})
      folders_.push_back(fs::absolute(folder).lexically_normal().string() + "/");
  }
  json operator()(const json& value) const {
    json copy = json::parse(value.dump(-1, ' ', false, json::error_handler_t::replace));
    clean(copy);
    return copy;
  }

 private:
  void clean(json& value) const {
    if (value.is_structured()) {
      for (auto& part : value) clean(part);
    } else if (value.is_string()) {
      std::string text = value;
      for (const auto& folder : folders_) {
        for (auto at = text.find(folder); at != text.npos; at = text.find(folder, at))
          text.erase(at, folder.size());
      }
      value = text;
    }
  }
  std::vector<std::string> folders_;
};

json failureOf(const CheckResult& check) {
  json kept = json::object();
  if (!check.failure.is_object()) return kept;
  for (const char* key : {"call", "given", "about", "unit", "got", "expected", "within", "why"}) {
    if (check.failure.contains(key)) kept[key] = check.failure[key];
  }
  return kept;
}

json recordOf(const CheckResult& check) {
  json record = {{"name", check.name}, {"status", nameOf(check.status)}};
  // The tests are ours and no submission runs in them: when they end early, nobody's answer is
  // judged.
  if (check.brokeOff) record["status"] = nameOf(Status::ourFault);
  if (check.status == Status::passed) return record;
  if (check.timedOut) {
    // Which of the limits came first depends on the machine.
    record["reason"] = "It did not end in time.";
  } else if (!check.reason.empty()) {
    record["reason"] = check.reason;
  }
  if (const json failure = failureOf(check); !failure.empty()) record["failure"] = failure;
  if (check.othersWrong) record["others_wrong"] = check.othersWrong;
  return record;
}

// What two gradings of one check agree on. The verdict must be the same; a function that reads
// memory that was never set may give another wrong number each time, and stays wrong.
json agreed(const CheckResult& first, const CheckResult& second) {
  json record = recordOf(first);
  const json other = recordOf(second);
  if (record["status"] != other["status"]) {
    return {{"name", first.name},
            {"status", nameOf(Status::ourFault)},
            {"reason", "Graded twice, it was first '" + record["status"].get<std::string>() +
                           "' and then '" + other["status"].get<std::string>() + "'."}};
  }
  if (record == other) return record;
  json common = {{"name", first.name}, {"status", record["status"]}, {"unstable", true}};
  common["reason"] = "The answers differ from run to run, so no example is shown.";
  return common;
}

std::string statusOf(const json& checks) {
  std::string worst = nameOf(Status::passed);
  bool some = false;
  for (const auto& check : checks) {
    const std::string status = check["status"];
    if (status == nameOf(Status::ourFault)) return status;
    some |= status == nameOf(Status::passed);
    if (worst == nameOf(Status::passed)) worst = status;
  }
  // Not written at all, or written in part.
  return some && worst == nameOf(Status::notStarted) ? nameOf(Status::wrong) : worst;
}

class Grader {
 public:
  Grader(const Project& project, const grading::Sandbox& sandbox,
         const std::vector<std::string>& checks)
      : project_(project), sandbox_(sandbox), checks_(checks) {}

  // One file, for every student who handed in these bytes.
  // \return a result per seed
  std::vector<json> grade(const Exercise& exercise, const fs::path& source,
                          const std::vector<std::uint64_t>& seeds) {
    std::vector<json> results;
    auto bench = std::make_unique<Workbench>(project_);
    for (const auto seed : seeds) {
      json result;
      try {
        result = gradeTwice(exercise, source, seed, bench);
      } catch (const Failure& failure) {
        result = fault(exercise, failure.message);
      } catch (const std::exception& error) {
        result = fault(exercise, error.what());
      }
      results.push_back(Neutral(project_, source.parent_path())(result));
    }
    return results;
  }

  // Does the course's own answer pass here? If not, nothing can be said of anybody's.
  // \return empty, or what is wrong
  std::string canary(const Exercise& exercise, const fs::path& folder) const {
    CheckOptions options{
        .source = {}, .throughPipe = true, .lazy = {}, .fingerprint = false, .sandbox = &sandbox_};
    const auto solution = readIfThere(exercise.folder / exercise.fileName());
    const fs::path file = folder / exercise.fileName();
    // A student's copy of the course has no answer to try.
    if (!solution) return "";
    writeFile(file, cutAnswer(*solution, exercise.fileName()));
    options.source = file;
    try {
      const auto result = checkExercise(project_, exercise, options);
      if (result.status == Status::passed) return "";
      std::string why =
          "The course's own answer does not pass here: " + std::string(nameOf(result.status)) +
          ". " + result.reason + result.compiled.firstError;
      for (const auto& c : result.checks) {
        if (c.status != Status::passed) return why + " " + c.title + ": " + c.reason;
      }
      return why;
    } catch (const Failure& failure) {
      return "The course's own answer cannot be graded here: " + failure.message;
    }
  }

  json fault(const Exercise& exercise, const std::string& why) const {
    json checks = json::array();
    for (const auto& c : exercise.checks)
      checks.push_back({{"name", c.name}, {"status", nameOf(Status::ourFault)}});
    return {{"status", nameOf(Status::ourFault)}, {"reason", why}, {"checks", std::move(checks)}};
  }

 private:
  ExerciseResult once(const Exercise& exercise, const fs::path& source, std::uint64_t seed,
                      std::vector<std::string> order, Workbench& bench) const {
    return checkExercise(project_, exercise,
                         {.source = source,
                          .throughPipe = true,
                          .lazy = {},
                          .seed = seed,
                          .checks = std::move(order),
                          .patience = kPatience,
                          .askAll = true,
                          .sandbox = &sandbox_,
                          .bench = &bench});
  }

  json gradeTwice(const Exercise& exercise, const fs::path& source, std::uint64_t seed,
                  std::unique_ptr<Workbench>& bench) const {
    auto order = checks_;
    if (order.empty()) {
      for (const auto& c : exercise.checks) order.push_back(c.name);
    }
    const auto first = once(exercise, source, seed, order, *bench);
    // What the first did not get to is not for the second to find out.
    std::vector<std::string> asked;
    for (const auto& name : order) {
      const auto at = std::find_if(first.checks.begin(), first.checks.end(),
                                   [&](const CheckResult& c) { return c.name == name; });
      if (at->status != Status::notRun) asked.push_back(name);
    }
    std::reverse(asked.begin(), asked.end());
    // A compiler that failed is asked again from the start: memory or disk may have been short.
    if (first.status == Status::doesNotCompile) bench = std::make_unique<Workbench>(project_);
    const auto second =
        once(exercise, source, seed, asked.empty() ? order : std::move(asked), *bench);
    return joined(exercise, first, second);
  }

  json joined(const Exercise& exercise, const ExerciseResult& first,
              const ExerciseResult& second) const {
    json result = {{"checks", json::array()}};
    const bool ran = !first.checks.empty() && first.status != Status::refused &&
                     first.status != Status::doesNotCompile;
    const bool ranAgain = !second.checks.empty() && second.status != Status::refused &&
                          second.status != Status::doesNotCompile;
    if (ran != ranAgain || (!ran && first.status != second.status)) {
      return fault(exercise, "Graded twice, it was first '" + std::string(nameOf(first.status)) +
                                 "' and then '" + nameOf(second.status) + "'.");
    }
    if (!first.reason.empty()) result["reason"] = first.reason;
    if (!first.screening.refused.empty()) result["refused"] = first.screening.refused;
    if (!first.screening.notes.empty()) result["notes"] = first.screening.notes;
    if (first.status == Status::doesNotCompile) {
      result["compiler"] = {{"error", first.compiled.firstError}, {"plain", first.compiled.plain}};
    }
    if (!ran) {
      for (const auto& c : first.checks)
        result["checks"].push_back({{"name", c.name}, {"status", nameOf(Status::notRun)}});
      result["status"] = nameOf(first.status);
      return result;
    }
    bool slow = false;
    for (std::size_t i = 0; i < first.checks.size(); ++i) {
      const auto& a = first.checks[i];
      const auto& b = second.checks.at(i);
      if (!checks_.empty() && a.name != checks_.front()) continue;
      result["checks"].push_back(a.status == Status::notRun ? recordOf(a) : agreed(a, b));
      slow |= !a.timedOut && std::max(a.seconds, b.seconds) > kLong;
    }
    if (slow) result["slow"] = true;
    if (!first.wrongName.empty() && first.wrongName == second.wrongName) {
      result["misconception"] = {{"name", first.wrongName},
                                 {"says", first.wrongSays},
                                 {"read", first.wrongRead},
                                 {"probes", first.probes}};
    }
    result["status"] =
        first.status == Status::ourFault ? nameOf(Status::ourFault) : statusOf(result["checks"]);
    return result;
  }

  const Project& project_;
  const grading::Sandbox& sandbox_;
  std::vector<std::string> checks_;
};

// ---- the class

// Says what was graded already, should the run end here: a line per result.
class Journal {
 public:
  explicit Journal(fs::path file) : file_(std::move(file)) {
    for (const auto& line : splitLines(readIfThere(file_).value_or(""))) {
      const json entry = json::parse(line, nullptr, false);
      // The last line may have been cut off.
      if (entry.is_object() && entry.contains("result"))
        known_[entry.value("student", "") + "/" + entry.value("exercise", "")] = entry["result"];
    }
    fs::create_directories(file_.parent_path());
    out_.open(file_, std::ios::app | std::ios::binary);
  }
  const json* find(const std::string& student, const std::string& exercise) const {
    const auto at = known_.find(student + "/" + exercise);
    return at == known_.end() ? nullptr : &at->second;
  }
  void add(const std::string& student, const std::string& exercise, const json& result) {
    out_ << json{{"student", student}, {"exercise", exercise}, {"result", result}}.dump(
                -1, ' ', false, json::error_handler_t::replace)
         << "\n"
         << std::flush;
    if (!out_) throw Failure{ourFault, "cannot write " + file_.string()};
  }
  void done() {
    out_.close();
    fs::remove(file_);
  }

 private:
  fs::path file_;
  std::ofstream out_;
  std::map<std::string, json> known_;
};

struct Unit {
  const Exercise* exercise = nullptr;
  std::string content;
  std::vector<std::size_t> students;
};

struct Wanted {
  const Exercise* exercise = nullptr;  ///< null: all
  std::vector<std::string> checks;     ///< of it; empty: all
};

Wanted wantedOf(const Project& project, const std::vector<const Exercise*>& which,
                const std::string& text) {
  Wanted wanted;
  if (text.empty()) return wanted;
  const auto slash = text.find('/');
  const Exercise& e = project.find(text.substr(0, slash));
  if (std::find(which.begin(), which.end(), &e) == which.end())
    throw Failure{usage, "the course does not take " + e.id};
  wanted.exercise = &e;
  if (slash == text.npos) return wanted;
  const std::string name = text.substr(slash + 1);
  std::string names;
  for (const auto& c : e.checks) {
    if (c.name == name) wanted.checks = {name};
    names += (names.empty() ? "" : ", ") + c.name;
  }
  if (wanted.checks.empty())
    throw Failure{usage, e.id + " has no check '" + name + "'; it has: " + names};
  return wanted;
}

std::string keyOf(const std::string& version, std::uint64_t seed, const std::string& content) {
  return version + "-" + std::to_string(seed) + "-" + hashOf(content);
}

const json* resultIn(const json* record, const std::string& id) {
  if (!record || !record->contains("exercises")) return nullptr;
  const auto at = record->at("exercises").find(id);
  return at == record->at("exercises").end() ? nullptr : &*at;
}

int gradeAll(const Project& project, const Course& course, const GradeOptions& options,
             std::vector<Submission> submissions, bool anew) {
  const auto which = exercisesOf(project, course);
  const Wanted wanted = wantedOf(project, which, options.check);
  const std::string today = options.today.empty() ? todaysDate() : options.today;
  if (!isDate(today)) throw Failure{usage, "--today " + today + " is not a day as 2026-12-01"};
  if (!options.only.empty()) {
    std::erase_if(submissions, [&](const Submission& s) { return s.student != options.only; });
    if (submissions.empty())
      throw Failure{usage, "there is no submission of '" + options.only + "'"};
  }
  const grading::Sandbox best = grading::bestSandbox();
  if (best.tier == grading::Tier::limits && !options.trust) {
    throw Failure{usage, "No sandbox can be had here: " + best.why +
                             ". Install bubblewrap, or, if you vouch for what was handed in, add "
                             "--trust-submissions."};
  }
  const std::string sandbox = nameOf(best.tier);
  const json classRecord = courseRecord(project, course, which, sandbox, today);
  const std::string version = classRecord["version"];

  // What an earlier run has found out.
  std::map<std::string, json> earlier;
  const fs::path records = options.out / "records";
  if (fs::exists(records / "class.json")) {
    for (auto& record : readRecords(options.out).students) {
      const std::string student = record["student"];
      const bool here = std::any_of(submissions.begin(), submissions.end(),
                                    [&](const Submission& s) { return s.student == student; });
      if (!here && record.value("version", "") != version) {
        throw Failure{usage, options.out.string() + " holds grades of another version of the " +
                                 "course (" + student + "): grade all anew, in another folder"};
      }
      earlier[student] = std::move(record);
    }
  }
  const auto earlierOf = [&](const std::string& student) -> const json* {
    const auto at = earlier.find(student);
    return at == earlier.end() ? nullptr : &at->second;
  };

  // The work: each file once, with all who handed it in.
  Journal journal(records / "journal");
  std::vector<std::map<std::string, json>> results(submissions.size());
  std::map<std::pair<const Exercise*, std::string>, std::size_t> unitOf;
  std::vector<Unit> units;
  std::vector<const Exercise*> needed;
  std::size_t todo = 0;
  for (const auto* e : which) {
    const bool asked = !wanted.exercise || wanted.exercise == e;
    for (std::size_t i = 0; i < submissions.size(); ++i) {
      const auto& s = submissions[i];
      const auto content = s.files.find(e->id);
      if (content == s.files.end()) continue;
      const std::string key = keyOf(version, seedOf(course, s.student, e->id), content->second);
      const json* known = resultIn(earlierOf(s.student), e->id);
      if (!known || known->value("key", "") != key) known = journal.find(s.student, e->id);
      const bool good = known && known->value("key", "") == key &&
                        known->value("status", "") != nameOf(Status::ourFault);
      if (good && !(anew && asked)) {
        results[i][e->id] = *known;
        continue;
      }
      if (!asked) continue;
      const auto [at, fresh] = unitOf.try_emplace({e, content->second}, units.size());
      if (fresh) units.push_back({e, content->second, {}});
      units[at->second].students.push_back(i);
      if (needed.empty() || needed.back() != e) needed.push_back(e);
      ++todo;
    }
  }

  std::vector<std::string> targets;
  for (const auto* e : needed) targets.push_back(project.entry(*e).at("target").get<std::string>());
  if (!targets.empty()) buildTargets(project, targets, true);

  const WorkFolder staging(project);
  std::mutex lock;
  std::map<const Exercise*, std::once_flag> tried;
  std::map<const Exercise*, std::string> broken;
  for (const auto* e : needed) tried[e], broken[e];
  std::atomic<std::size_t> next{0};
  std::size_t finished = 0;
  std::string lost;
  const auto work = [&] {
    Grader grader(project, best, wanted.checks);
    for (std::size_t u = next++; u < units.size(); u = next++) {
      const Unit& unit = units[u];
      const Exercise& e = *unit.exercise;
      try {
        const fs::path folder = staging.path() / std::to_string(u);
        std::call_once(tried.at(&e), [&] {
          const fs::path answer = staging.path() / ("answer-" + e.id);
          broken.at(&e) = Neutral(project, answer)(grader.canary(e, answer));
        });
        std::vector<std::uint64_t> seeds;
        for (const auto i : unit.students)
          seeds.push_back(seedOf(course, submissions[i].student, e.id));
        std::vector<json> all;
        if (!broken.at(&e).empty()) {
          all.assign(seeds.size(), grader.fault(e, broken.at(&e)));
        } else {
          const fs::path source = folder / e.fileName();
          writeFile(source, unit.content);
          all = grader.grade(e, source, seeds);
          std::error_code ignored;
          fs::remove_all(folder, ignored);
        }
        const std::lock_guard guard(lock);
        for (std::size_t k = 0; k < seeds.size(); ++k) {
          const auto& student = submissions[unit.students[k]].student;
          json& result = all[k];
          // One check of several: the others are as they were.
          const json* known = resultIn(earlierOf(student), e.id);
          if (!wanted.checks.empty() && result["status"] != nameOf(Status::ourFault) && known &&
              known->contains("checks")) {
            json whole = *known;
            for (auto& old : whole["checks"]) {
              for (const auto& fresh : result["checks"]) {
                if (old["name"] == fresh["name"]) old = fresh;
              }
            }
            if (result.contains("misconception")) whole["misconception"] = result["misconception"];
            whole["status"] = statusOf(whole["checks"]);
            result = std::move(whole);
          }
          result["key"] = keyOf(version, seeds[k], unit.content);
          result["seed"] = std::to_string(seeds[k]);
          journal.add(student, e.id, result);
          results[unit.students[k]][e.id] = std::move(result);
          ++finished;
        }
        if (isatty(2)) std::cerr << "\rgraded " << finished << " of " << todo << std::flush;
      } catch (const Failure& failure) {
        const std::lock_guard guard(lock);
        lost = failure.message;
      } catch (const std::exception& error) {
        const std::lock_guard guard(lock);
        lost = error.what();
      }
    }
  };
  const auto cores = std::max(1u, std::thread::hardware_concurrency());
  const auto jobs = options.jobs > 0 ? static_cast<unsigned>(options.jobs) : cores;
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < jobs && i < units.size(); ++i) workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();
  if (isatty(2) && todo > 0) std::cerr << "\n";

  // The records, and from them the reports.
  for (std::size_t i = 0; i < submissions.size(); ++i) {
    const auto& s = submissions[i];
    const fs::path folder = filesFolder(options.out, s.student);
    json record = {
        {"format", kFormat},         {"student", s.student}, {"source", s.source},
        {"version", version},        {"date", s.date},       {"notes", s.notes},
        {"refused", s.refusedWhole}, {"files", s.refused},   {"exercises", json::object()}};
    for (const auto* e : which) {
      json& result = record["exercises"][e->id];
      if (const auto found = results[i].find(e->id); found != results[i].end()) {
        result = found->second;
      } else if (s.files.count(e->id)) {
        const bool asked = !wanted.exercise || wanted.exercise == e;
        result = {{"status", asked ? nameOf(Status::ourFault) : "not asked"}, {"reason", lost}};
      } else if (s.refused.count(e->id)) {
        result = {{"status", nameOf(Status::refused)}, {"reason", s.refused.at(e->id)}};
      } else {
        result = {{"status", "not handed in"}};
      }
    }
    if (!anew) {
      std::error_code none;
      fs::remove_all(folder, none);
      for (const auto* e : which) {
        if (const auto file = s.files.find(e->id); file != s.files.end())
          writeFile(folder / e->chapter / e->fileName(), file->second);
      }
    }
    writeRecord(recordFile(options.out, s.student), record);
  }
  writeRecord(records / "class.json", classRecord);
  journal.done();
  const Records all = readRecords(options.out);
  writeReports(options.out, all);

  int exitCode = Exit::pass;
  std::size_t look = 0;
  for (const auto& student : all.students) {
    const Grade grade = gradeOf(all.course, student);
    look += !toLookAt(all.course, student).empty();
    if (grade.state == "not graded") {
      std::cout << student["student"].get<std::string>()
                << ": not graded, through a fault of ours\n";
      exitCode = Exit::ourFault;
    }
    if (grade.state == "not taken") {
      std::cout << student["student"].get<std::string>() << ": not taken, "
                << student["refused"].get<std::string>() << "\n";
    }
  }
  std::cout << all.students.size() << (all.students.size() == 1 ? " student, " : " students, ")
            << which.size() << (which.size() == 1 ? " exercise; " : " exercises; ") << look
            << " to look at, see " << (options.out / "class.html").string() << "\n"
            << "submissions ran in: " << grading::describe(best) << "\n";
  if (course.secret.empty()) {
    std::cout << "The course has no secret, so anybody can work out the inputs of a student.\n";
  }
  return exitCode;
}

}  // namespace

std::string courseVersion(const Project& project) {
  // Once: who works on the course while a class is graded gets one version for all.
  static std::map<fs::path, std::string> known;
  auto& version = known[project.root];
  if (version.empty()) version = measuredVersion(project);
  return version;
}

int gradeClass(const Project& project, const Course& course, const GradeOptions& options) {
  auto intake = takeIn(exercisesOf(project, course), options.from, options.student);
  for (const auto& note : intake.notes) std::cout << note << "\n";
  if (intake.submissions.empty()) throw Failure{usage, "there is no submission to grade"};
  return gradeAll(project, course, options, std::move(intake.submissions), false);
}

int regradeClass(const Project& project, const Course& course, const GradeOptions& options) {
  const Records records = readRecords(options.out);
  const auto which = exercisesOf(project, course);
  if (records.course.value("title", "") != course.title)
    throw Failure{usage, "the records are of the course '" + records.course.value("title", "") +
                             "': name its file with --course"};
  std::vector<Submission> submissions;
  for (const auto& record : records.students) {
    Submission s;
    s.student = record.at("student");
    s.source = record.at("source");
    s.date = record.at("date");
    s.refusedWhole = record.at("refused");
    s.notes = record.at("notes").get<std::vector<std::string>>();
    s.refused = record.at("files").get<std::map<std::string, std::string>>();
    for (const auto* e : which) {
      const auto file =
          readIfThere(filesFolder(options.out, s.student) / e->chapter / e->fileName());
      if (file) s.files[e->id] = *file;
    }
    submissions.push_back(std::move(s));
  }
  return gradeAll(project, course, options, std::move(submissions), true);
}

}  // namespace carom::runner
