#include "teach/sample.hpp"

#include <algorithm>

#include "runner/reports.hpp"
#include "runner/skeleton.hpp"

namespace carom_test {

using namespace carom::runner;
using nlohmann::json;

namespace {

std::vector<fs::path> versions(const Exercise& e, const char* folder) {
  std::vector<fs::path> all;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(e.folder / folder, none)) {
    if (file.path().extension() == e.extension) all.push_back(file.path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string solution(const Exercise& e) {
  return cutAnswer(readFile(e.folder / e.fileName()), e.fileName());
}

}  // namespace

void writeVersions(const std::vector<const Exercise*>& which, const fs::path& folder) {
  for (const auto* e : which) {
    writeFile(folder / "solution" / e->studentFile(), solution(*e));
    writeFile(folder / "skeleton" / e->studentFile(), skeletonOf(*e).value());
    for (const char* kind : {"right", "wrong"}) {
      int number = 0;
      for (const auto& file : versions(*e, kind)) {
        const std::string student = kind + ("-" + std::to_string(++number));
        writeFile(folder / student / e->studentFile(), readFile(file));
      }
    }
  }
}

void writeMixture(const std::vector<const Exercise*>& which, int students, const fs::path& folder) {
  for (int s = 0; s < students; ++s) {
    const std::string student = "student-" + std::to_string(100 + s);
    for (std::size_t i = 0; i < which.size(); ++i) {
      const Exercise& e = *which[i];
      const auto right = versions(e, "right");
      const auto wrong = versions(e, "wrong");
      const std::size_t draw = (static_cast<std::size_t>(s) * 7 + i * 11) % 12;
      const std::string sign = e.isPrediction() ? "# " : "// ";
      const std::string own = "\n" + sign + "by " + student + "\n";
      std::string content;
      if (draw >= 10)
        content = skeletonOf(e).value();
      else if (draw >= 6 && !wrong.empty())
        content = readFile(wrong[(draw + static_cast<std::size_t>(s)) % wrong.size()]) + own;
      else if (draw >= 3 && !right.empty())
        content = readFile(right[draw % right.size()]) + own;
      else
        content = solution(e) + own;
      writeFile(folder / student / e.studentFile(), content);
    }
  }
}

Verdict judge(const std::vector<const Exercise*>& which, const Records& records) {
  Verdict verdict;
  for (const auto& student : records.students) {
    const std::string name = student.at("student");
    const auto dash = name.find('-');
    const std::string kind = name.substr(0, dash);
    for (const auto& e : records.course.at("exercises")) {
      const std::string id = e.at("id");
      const json& result = student.at("exercises").at(id);
      const std::string status = result.at("status");
      if (status == "not handed in") continue;
      const std::string where = id + " " + name;
      const double points = pointsOf(e, result);
      const double of = e.at("points");
      if (kind == "solution" || kind == "right") {
        ++verdict.right;
        if (status != "passed" || points != of) verdict.problems.push_back(where + ": " + status);
        continue;
      }
      if (kind == "skeleton") {
        ++verdict.skeletons;
        if (points != 0 || status == "passed")
          verdict.problems.push_back(where + " has " + shortNumber(points) + " points");
        continue;
      }
      ++verdict.wrong;
      const auto at = std::find_if(which.begin(), which.end(),
                                   [&](const Exercise* one) { return one->id == id; });
      const auto files = versions(**at, "wrong");
      const std::string version = files.at(std::stoul(name.substr(dash + 1)) - 1).stem().string();
      const auto known = std::find_if((*at)->wrong.begin(), (*at)->wrong.end(),
                                      [&](const Wrong& w) { return w.name == version; });
      if (known == (*at)->wrong.end()) {
        verdict.problems.push_back(id + " wrong/" + version + " is in no catalogue");
        continue;
      }
      verdict.alone += known->also.empty();
      for (const auto& check : result.value("checks", json::array())) {
        const std::string one = check.at("name");
        const bool lost = check.at("status") != "passed";
        if (one == known->check && !lost)
          verdict.problems.push_back(id + " wrong/" + version + " passes its check (" + status +
                                     ")");
        if (lost && !known->mayFail(one))
          verdict.problems.push_back(id + " wrong/" + version + " also loses " + one);
      }
      if (points >= of && of > 0)
        verdict.problems.push_back(id + " wrong/" + version + " has all points");
      // Cases that let something through are told by their checks what that was.
      if (!(*at)->isTest() &&
          (!result.contains("misconception") || result["misconception"]["name"] != version))
        verdict.problems.push_back(id + " wrong/" + version + " is not named");
    }
  }
  return verdict;
}

}  // namespace carom_test
