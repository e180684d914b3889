#include "runner/exercise.hpp"

#include <SimpleIni.h>

#include <algorithm>
#include <set>

#include "runner/skeleton.hpp"

namespace carom::runner {

namespace {

const std::set<std::string> kKinds = {"implement", "fix", "predict", "test", "measure", "explore"};
const std::set<std::string> kKeys = {"id",       "title",   "kind", "level", "minutes",
                                     "points",   "layer",   "home", "read",  "without",
                                     "geometry", "program", "uses", "order", "tests"};
const std::set<std::string> kCheckKeys = {"title", "points", "wrong", "read"};
const std::set<std::string> kTestCheckKeys = {"title", "points", "read", "catches", "slipped"};
const std::set<std::string> kWrongKeys = {"says", "read", "check", "also"};

struct Ini {
  CSimpleIniA ini{true, false, false};
  std::string file;
  std::vector<std::string>& problems;

  std::string text(const std::string& section, const char* key, bool required) {
    const char* value = ini.GetValue(section.c_str(), key);
    if (!value || !*value) {
      if (required) {
        problems.push_back(file + ": " + (section.empty() ? "" : "[" + section + "] ") + "needs '" +
                           key + " = ...'");
      }
      return "";
    }
    return value;
  }

  double number(const std::string& section, const char* key, double low, double high) {
    const std::string value = text(section, key, true);
    if (value.empty()) return 0;
    char* end = nullptr;
    const double result = std::strtod(value.c_str(), &end);
    if (*end != '\0' || !(result >= low && result <= high)) {
      problems.push_back(file + ": '" + key + " = " + value + "' is not a number from " +
                         std::to_string(low) + " to " + std::to_string(high));
      return 0;
    }
    return result;
  }

  void onlyKeys(const std::string& section, const std::set<std::string>& known) {
    CSimpleIniA::TNamesDepend keys;
    ini.GetAllKeys(section.c_str(), keys);
    for (const auto& key : keys) {
      if (!known.count(key.pItem)) problems.push_back(file + ": unknown key '" + key.pItem + "'");
    }
  }
};

}  // namespace

Exercise readExercise(const fs::path& folder, std::vector<std::string>& problems) {
  Exercise e;
  e.folder = folder;
  e.name = folder.filename().string();
  // solutions/<chapter>/<name>, or on a student branch exercises/<chapter>/given/<name>.
  const fs::path above = folder.parent_path();
  e.chapter = (above.filename() == "given" ? above.parent_path() : above).filename().string();
  Ini in{.file = (e.chapter + "/" + e.name + "/exercise.ini"), .problems = problems};
  if (in.ini.LoadFile((folder / "exercise.ini").c_str()) < 0) {
    problems.push_back(in.file + ": cannot be read");
    return e;
  }
  in.onlyKeys("", kKeys);
  e.id = in.text("", "id", true);
  e.title = in.text("", "title", true);
  e.kind = in.text("", "kind", true);
  if (!e.kind.empty() && !kKinds.count(e.kind))
    problems.push_back(in.file + ": unknown kind '" + e.kind + "'");
  e.extension = e.isPrediction() ? ".txt" : ".cpp";
  e.level = static_cast<int>(in.number("", "level", 1, 3));
  e.minutes = static_cast<int>(in.number("", "minutes", 1, 240));
  e.points = in.number("", "points", 0, 100);
  e.layer = in.text("", "layer", true);
  e.home = in.text("", "home", !e.isPrediction());
  e.read = in.text("", "read", true);
  e.program = in.text("", "program", false);
  e.uses = words(in.text("", "uses", false));
  e.tests = in.text("", "tests", e.isTest());
  if (e.isTest()) {
    e.checks.push_back({kPassesOnRight, "passes on every right version", 0, "", e.read});
    e.checks.push_back(
        {kEveryCaseAsks, "every case calls the function and asserts something", 0, "", e.read});
  } else if (!e.tests.empty()) {
    problems.push_back(in.file + ": 'tests' is for exercises of the kind test");
  }
  if (!e.id.empty() && e.id != e.chapter.substr(0, 2) + "." + e.name) {
    problems.push_back(in.file + ": the id should be " + e.chapter.substr(0, 2) + "." + e.name);
  }

  CSimpleIniA::TNamesDepend sections;
  in.ini.GetAllSections(sections);
  sections.sort(CSimpleIniA::Entry::LoadOrder());
  double sum = 0;
  for (const auto& section : sections) {
    const std::string name = section.pItem;
    const auto dot = name.find('.');
    const std::string what = name.substr(0, dot);
    const std::string rest = dot == std::string::npos ? "" : name.substr(dot + 1);
    if (name.empty()) continue;
    if (what == "check") {
      in.onlyKeys(name, e.isTest() ? kTestCheckKeys : kCheckKeys);
      Check check{rest,
                  in.text(name, "title", true),
                  in.number(name, "points", 0, 100),
                  in.text(name, "wrong", false),
                  in.text(name, "read", false),
                  in.text(name, "catches", e.isTest()),
                  in.text(name, "slipped", e.isTest())};
      if (check.read.empty()) check.read = e.read;
      sum += check.points;
      e.checks.push_back(check);
    } else if (what == "wrong") {
      in.onlyKeys(name, kWrongKeys);
      Wrong wrong{rest, in.text(name, "says", true), in.text(name, "read", false),
                  in.text(name, "check", true), words(in.text(name, "also", false))};
      if (wrong.read.empty()) wrong.read = e.read;
      e.wrong.push_back(wrong);
    } else if (what == "hint") {
      in.onlyKeys(name, {"text"});
      e.hints.push_back(in.text(name, "text", true));
      if (rest != std::to_string(e.hints.size()))
        problems.push_back(in.file + ": hints are numbered 1, 2, ... in order");
    } else {
      problems.push_back(in.file + ": unknown section [" + name + "]");
    }
  }
  if (e.kind != "explore" && e.checks.empty())
    problems.push_back(in.file + ": has no [check. ...]");
  if (sum != e.points)
    problems.push_back(in.file + ": the points of the checks do not add up to 'points'");
  for (const auto& check : e.checks) {
    const auto known = [&](const Wrong& w) { return w.name == check.wrong; };
    if (!check.wrong.empty() && std::none_of(e.wrong.begin(), e.wrong.end(), known)) {
      problems.push_back(in.file + ": check '" + check.name +
                         "' names the unknown misconception '" + check.wrong + "'");
    }
  }
  for (const auto& wrong : e.wrong) {
    std::vector<std::string> named = wrong.also;
    named.push_back(wrong.check);
    for (const auto& check : named) {
      const auto known = [&](const Check& c) { return c.name == check; };
      if (std::none_of(e.checks.begin(), e.checks.end(), known)) {
        problems.push_back(in.file + ": misconception '" + wrong.name +
                           "' names the unknown check '" + check + "'");
      }
    }
  }
  return e;
}

std::vector<fs::path> exerciseFolders(const fs::path& root) {
  std::vector<fs::path> folders;
  std::error_code none;
  for (const char* top : {"solutions", "exercises"}) {
    for (const auto& chapter : fs::directory_iterator(root / top, none)) {
      const fs::path above =
          top == std::string("solutions") ? chapter.path() : chapter.path() / "given";
      for (const auto& folder : fs::directory_iterator(above, none)) {
        if (fs::exists(folder.path() / "exercise.ini")) folders.push_back(folder.path());
      }
    }
  }
  return folders;
}

std::optional<std::string> skeletonOf(const Exercise& exercise) {
  if (const auto answer = readIfThere(exercise.folder / exercise.fileName()))
    return cutSkeleton(*answer, exercise.fileName());
  return readIfThere(exercise.folder / ("skeleton" + exercise.extension));
}

std::vector<Exercise> readExercises(const fs::path& root, std::vector<std::string>& problems) {
  std::vector<std::pair<std::tuple<std::string, int, int, std::string>, Exercise>> found;
  for (const auto& folder : exerciseFolders(root)) {
    Exercise e = readExercise(folder, problems);
    CSimpleIniA ini(true, false, false);
    ini.LoadFile((folder / "exercise.ini").c_str());
    const int order = static_cast<int>(ini.GetLongValue("", "order", 1000));
    found.emplace_back(std::make_tuple(e.chapter, order, e.level, e.name), std::move(e));
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Exercise> all;
  std::set<std::string> ids;
  for (auto& [key, e] : found) {
    if (!ids.insert(e.id).second) problems.push_back("two exercises have the id " + e.id);
    all.push_back(std::move(e));
  }
  return all;
}

}  // namespace carom::runner
