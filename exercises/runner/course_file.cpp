#include "runner/course_file.hpp"

#include <SimpleIni.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>

namespace carom::runner {

namespace {

// Reads the sections and collects everything that is wrong, so that a teacher mends the file once.
class Reader {
 public:
  Reader(const fs::path& file, const Project& project)
      : file_(file), project_(project), ini_(true, true, false) {}

  Course read() {
    if (ini_.LoadFile(file_.c_str()) < 0)
      throw Failure{usage, "the course file " + file_.string() + " cannot be read"};
    Course course = defaultCourse(project_);
    course.file = file_;
    CSimpleIniA::TNamesDepend sections;
    ini_.GetAllSections(sections);
    sections.sort(CSimpleIniA::Entry::LoadOrder());
    bool head = false;
    for (const auto& entry : sections) {
      const std::string section = entry.pItem;
      const auto parts = words(section);
      if (section == "course") {
        head = true;
        readHead(course);
      } else if (parts.size() == 2 && parts[0] == "chapter") {
        if (const auto folder = chapter(section, parts[1]); !folder.empty())
          course.chapterRules[folder] = rules(section, {"due", "solutions"});
      } else if (parts.size() == 2 && parts[0] == "exercise") {
        if (const Exercise* e = exercise(section, parts[1])) {
          course.exerciseRules[e->id] =
              rules(section, {"due", "solutions", "points", "hidden", "topic"});
          hiddenChecks(section, *e, course.exerciseRules[e->id].hidden);
        }
      } else {
        wrong("[" + section + "] is none of [course], [chapter NUMBER], [exercise ID]");
      }
    }
    if (!head) wrong("there is no section [course]");
    if (!problems_.empty()) throw Failure{usage, problems_};
    return course;
  }

 private:
  void wrong(const std::string& what) {
    problems_ += (problems_.empty() ? "" : "\n") + file_.string() + ": " + what;
  }

  void wrong(const std::string& section, const char* key, const std::string& value,
             const std::string& why) {
    wrong("[" + section + "] " + key + " = " + value + ": " + why);
  }

  void onlyKeys(const std::string& section, const std::set<std::string>& known) {
    CSimpleIniA::TNamesDepend keys;
    ini_.GetAllKeys(section.c_str(), keys);
    for (const auto& key : keys) {
      CSimpleIniA::TNamesDepend values;
      ini_.GetAllValues(section.c_str(), key.pItem, values);
      if (!known.count(key.pItem)) {
        wrong("[" + section + "] unknown key '" + key.pItem + "'");
      } else if (values.size() > 1) {
        wrong("[" + section + "] '" + key.pItem + "' is given twice");
      }
    }
  }

  std::string text(const std::string& section, const char* key) {
    return trimmed(ini_.GetValue(section.c_str(), key, ""));
  }

  std::string chapter(const std::string& section, const std::string& name) {
    try {
      return project_.chapterFolder(name);
    } catch (const Failure& failure) {
      wrong("[" + section + "] " + failure.message);
      return "";
    }
  }

  const Exercise* exercise(const std::string& section, const std::string& id) {
    for (const auto& e : project_.exercises) {
      if (e.id == id) return &e;
    }
    wrong("[" + section + "] there is no exercise " + id);
    return nullptr;
  }

  void readHead(Course& course) {
    onlyKeys("course", {"title", "chapters", "without", "solutions", "secret", "due"});
    course.title = text("course", "title");
    if (course.title.empty()) wrong("[course] needs 'title = ...'");
    if (const auto names = words(text("course", "chapters")); !names.empty()) {
      course.chapters.clear();
      for (const auto& name : names) {
        if (const auto folder = chapter("course", name); !folder.empty())
          course.chapters.insert(folder);
      }
    }
    for (const auto& id : words(text("course", "without"))) {
      if (exercise("course", id)) course.without.insert(id);
    }
    course.rules.due = date("course");
    course.rules.solutions = solutions("course");
    if (const std::string name = text("course", "secret"); !name.empty()) {
      course.secretFile = (fs::absolute(file_).parent_path() / name).lexically_normal();
      course.secret = readIfThere(course.secretFile).value_or("");
      if (course.secret.empty())
        wrong("course", "secret", name,
              "there is no such file beside the course file, or it is empty");
    }
  }

  std::string date(const std::string& section) {
    const std::string value = text(section, "due");
    if (!value.empty() && !isDate(value))
      wrong(section, "due", value, "a day is written 2026-12-01");
    return value;
  }

  std::string solutions(const std::string& section) {
    const std::string value = text(section, "solutions");
    if (!value.empty() && value != "always" && value != "after due" && value != "never")
      wrong(section, "solutions", value, "it is one of always, after due, never");
    return value;
  }

  CourseRules rules(const std::string& section, const std::set<std::string>& keys) {
    onlyKeys(section, keys);
    CourseRules rules{.due = date(section),
                      .solutions = solutions(section),
                      .points = -1,
                      .hidden = words(text(section, "hidden")),
                      .topic = text(section, "topic")};
    if (const std::string value = text(section, "points"); !value.empty()) {
      char* end = nullptr;
      rules.points = std::strtod(value.c_str(), &end);
      if (*end != '\0' || !(rules.points >= 0 && rules.points <= 1000))
        wrong(section, "points", value, "it is a number from 0 to 1000");
    }
    return rules;
  }

  void hiddenChecks(const std::string& section, const Exercise& e,
                    const std::vector<std::string>& hidden) {
    for (const auto& name : hidden) {
      const auto known = [&](const Check& c) { return c.name == name; };
      if (std::none_of(e.checks.begin(), e.checks.end(), known))
        wrong("[" + section + "] hidden: " + e.id + " has no check '" + name + "'");
    }
    const auto shown = [&](const Check& c) {
      return c.points > 0 && std::find(hidden.begin(), hidden.end(), c.name) == hidden.end();
    };
    if (std::none_of(e.checks.begin(), e.checks.end(), shown))
      wrong("[" + section + "] hidden: no scored check of " + e.id + " is left for students");
  }

  const fs::path& file_;
  const Project& project_;
  CSimpleIniA ini_;  // keeps a key that is given twice, to tell of it
  std::string problems_;
};

}  // namespace

bool ExercisePolicy::hides(const std::string& check) const {
  return std::find(hidden.begin(), hidden.end(), check) != hidden.end();
}

ExercisePolicy Course::policy(const Exercise& exercise) const {
  ExercisePolicy policy;
  policy.taken = chapters.count(exercise.chapter) && !without.count(exercise.id);
  policy.points = exercise.points;
  const auto apply = [&](const CourseRules& r) {
    if (!r.due.empty()) policy.due = r.due;
    if (!r.solutions.empty()) policy.solutions = r.solutions;
    if (r.points >= 0) policy.points = r.points;
    if (!r.hidden.empty()) policy.hidden = r.hidden;
    if (!r.topic.empty()) policy.topic = r.topic;
  };
  apply(rules);
  if (const auto r = chapterRules.find(exercise.chapter); r != chapterRules.end()) apply(r->second);
  if (const auto r = exerciseRules.find(exercise.id); r != exerciseRules.end()) apply(r->second);
  return policy;
}

bool Course::solutionShows(const Exercise& exercise, const std::string& today) const {
  const auto rule = policy(exercise);
  if (rule.solutions == "always") return true;
  // Days written so compare as texts.
  return rule.solutions == "after due" && !rule.due.empty() && today > rule.due;
}

Course readCourse(const fs::path& file, const Project& project) {
  return Reader(file, project).read();
}

Course defaultCourse(const Project& project) {
  Course course;
  course.title = "Carom";
  std::error_code none;
  for (const auto& folder : fs::directory_iterator(project.root / "chapters", none)) {
    if (folder.is_directory()) course.chapters.insert(folder.path().filename().string());
  }
  for (const auto& e : project.exercises) course.chapters.insert(e.chapter);
  return course;
}

std::string todaysDate() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &local);
  return text;
}

bool isDate(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  for (const std::size_t i : {0, 1, 2, 3, 5, 6, 8, 9}) {
    if (text[i] < '0' || text[i] > '9') return false;
  }
  const std::chrono::year_month_day day{
      std::chrono::year{std::stoi(text.substr(0, 4))},
      std::chrono::month{static_cast<unsigned>(std::stoi(text.substr(5, 2)))},
      std::chrono::day{static_cast<unsigned>(std::stoi(text.substr(8, 2)))}};
  return day.ok();
}

std::uint64_t seedOf(const Course& course, const std::string& student,
                     const std::string& exercise) {
  const std::string key = course.secret.empty() ? "carom" : course.secret;
  const std::string message = student + '\0' + exercise;
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (!HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
            reinterpret_cast<const unsigned char*>(message.data()), message.size(), digest,
            &size)) {
    throw Failure{ourFault, "the seed cannot be computed: HMAC-SHA-256 failed"};
  }
  std::uint64_t seed = 0;
  for (int i = 0; i < 8; ++i) seed = seed << 8 | digest[i];
  // 0 stands for the seed of self-checks, which everybody has.
  return seed ? seed : 1;
}

}  // namespace carom::runner
