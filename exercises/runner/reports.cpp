#include "runner/reports.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace carom::runner {

using nlohmann::json;

namespace {

// ---- reading records

std::string textOf(const json& value, const char* key) {
  const auto at = value.find(key);
  return at != value.end() && at->is_string() ? at->get<std::string>() : "";
}

bool isOn(const json& value, const char* key) {
  const auto at = value.find(key);
  return at != value.end() && at->is_boolean() && at->get<bool>();
}

const json& resultOf(const json& student, const std::string& id) {
  static const json kNone = {{"status", "not handed in"}};
  const auto& all = student.at("exercises");
  const auto at = all.find(id);
  return at == all.end() ? kNone : *at;
}

const json& checkOf(const json& result, const std::string& name) {
  static const json kNone = {{"status", "not run"}};
  if (const auto checks = result.find("checks"); checks != result.end()) {
    for (const auto& c : *checks) {
      if (textOf(c, "name") == name) return c;
    }
  }
  return kNone;
}

bool passes(const json& check) {
  return textOf(check, "status") == "passed";
}

bool isFault(const json& result) {
  return textOf(result, "status") == "our fault";
}

// A guard earns nothing, and without it nothing is earned.
std::string brokenGuard(const json& exercise, const json& result) {
  for (const auto& c : exercise.at("checks")) {
    if (c.at("points") == 0 && !passes(checkOf(result, c.at("name")))) {
      return c.at("hidden").get<bool>() ? exercise.at("topic").get<std::string>()
                                        : c.at("title").get<std::string>();
    }
  }
  return "";
}

std::string clipped(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return text.substr(0, end) + " ...";
}

std::string oneLine(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

// ---- what is told of a check

// A line as wide as a feedback is read, the next ones indented like the first.
std::string told(const char* label, const std::string& text) {
  std::string line = label;
  line.resize(10, ' ');
  return line + clipped(oneLine(text), 400) + "\n";
}

std::string withUnit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

// A failed question in full, as plain text. For public checks only.
std::string fullFailure(const json& check) {
  std::string text;
  if (const auto reason = textOf(check, "reason"); !reason.empty())
    text += clipped(oneLine(trimmed(reason)), 400) + "\n";
  const auto failure = check.find("failure");
  if (failure == check.end() || !failure->is_object()) return text;
  const auto unit = textOf(*failure, "unit");
  if (const auto about = textOf(*failure, "about"); !about.empty()) text += told("About", about);
  if (const auto given = failure->find("given"); given != failure->end() && given->is_array()) {
    for (const auto& pair : *given) {
      if (pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string())
        text += told("For", pair[0].get<std::string>() + " = " + pair[1].get<std::string>());
    }
  }
  if (const auto call = textOf(*failure, "call"); !call.empty()) text += told("Asked", call);
  if (const auto got = textOf(*failure, "got"); !got.empty() && textOf(check, "status") == "wrong")
    text += told("You gave", withUnit(got, unit));
  if (const auto expected = textOf(*failure, "expected"); !expected.empty()) {
    text += told("Expected", withUnit(expected, unit));
    if (const auto within = textOf(*failure, "within"); !within.empty()) {
      const auto why = textOf(*failure, "why");
      text += told("Within", within + (why.empty() ? "" : ": " + why));
    }
  }
  return text;
}

struct Item {
  std::string name;   ///< of the check; empty for the hidden ones together
  std::string title;  ///< shown to the student
  double most = 0;
  double score = 0;
  std::string status;  ///< of a hidden item: passed only when all are
  std::string output;  ///< plain text
  bool hidden = false;
};

// The lines of an exercise in a report: each public check, and the hidden ones as one.
std::vector<Item> itemsOf(const json& exercise, const json& result) {
  std::vector<Item> items;
  const std::string guard = brokenGuard(exercise, result);
  const std::string whole = textOf(result, "status");
  bool toldOne = false;
  Item hidden;
  int hiddenCount = 0;
  int hiddenPassed = 0;
  for (const auto& c : exercise.at("checks")) {
    const json& check = checkOf(result, c.at("name"));
    const double points = c.at("points");
    const double score = passes(check) && guard.empty() ? points : 0;
    const std::string status = result.contains("checks") ? textOf(check, "status") : whole;
    if (c.at("hidden").get<bool>()) {
      ++hiddenCount;
      hiddenPassed += passes(check);
      hidden.most += points;
      hidden.score += score;
      if (!passes(check) && hidden.status.empty()) hidden.status = status;
      continue;
    }
    Item item{c.at("name"), c.at("title"), points, score, status, {}, false};
    if (whole == "does not compile" || whole == "refused" || whole == "our fault" ||
        whole == "not handed in") {
      item.status = whole;
    } else if (!passes(check)) {
      // One failure in full: those after it often have the same cause.
      if (!toldOne) item.output = fullFailure(check);
      toldOne = true;
    }
    if (passes(check) && !guard.empty() && points > 0)
      item.output = "It holds, but earns nothing as long as '" + guard + "' does not.\n";
    items.push_back(std::move(item));
  }
  if (hiddenCount > 0) {
    hidden.hidden = true;
    hidden.title = exercise.at("topic").get<std::string>();
    if (hidden.status.empty()) hidden.status = "passed";
    if (result.contains("checks")) {
      hidden.output = std::to_string(hiddenPassed) + " of " + std::to_string(hiddenCount) +
                      " hidden checks hold.\n";
    }
    items.push_back(std::move(hidden));
  }
  return items;
}

// What there is to say of the exercise as a whole, as plain text.
std::string wholeText(const json& exercise, const json& result) {
  const std::string status = textOf(result, "status");
  if (status == "not handed in")
    return "No file " + exercise.at("file").get<std::string>() + " was handed in.\n";
  if (status == "not asked") return "It has not been graded yet.\n";
  if (isFault(result))
    return "It could not be graded. The fault is on the grader's side, not yours, and your teacher "
           "has been told.\n";
  if (status == "refused") {
    std::string text = "It was not run.\n";
    if (const auto all = result.find("refused"); all != result.end()) {
      for (const auto& why : *all) text += clipped(oneLine(why.get<std::string>()), 400) + "\n";
    } else {
      text += clipped(oneLine(textOf(result, "reason")), 400) + "\n";
    }
    return text;
  }
  if (status == "does not compile") {
    const json& compiler = result.at("compiler");
    std::string text = "It does not compile, so nothing could be asked of it.\n";
    const std::string error = textOf(compiler, "error");
    for (const auto& line : splitLines(clipped(error, 1200))) text += oneLine(line) + "\n";
    if (const auto plain = textOf(compiler, "plain"); !plain.empty()) text += plain + "\n";
    return text;
  }
  if (status == "not started") return "The file is as it was given out: nothing is written yet.\n";
  return "";
}

// May the student be told which misconception it was? Not when only hidden checks show it.
bool maySay(const json& exercise, const json& result) {
  for (const auto& c : exercise.at("checks")) {
    if (!c.at("hidden").get<bool>() && textOf(checkOf(result, c.at("name")), "status") == "wrong")
      return true;
  }
  return false;
}

std::string meaning(const json& exercise, const json& result) {
  const auto found = result.find("misconception");
  if (found == result.end() || !maySay(exercise, result)) return "";
  return textOf(*found, "says");
}

// ---- Markdown

// Text between Markdown's signs, as it is.
std::string markdown(const std::string& text) {
  static const std::string_view kSigns = "\\`*_{}[]<>#+!|&~$";
  std::string out;
  for (const char c : oneLine(text)) {
    if (kSigns.find(c) != kSigns.npos) out += '\\';
    out += c;
  }
  return out;
}

// A block of plain text whose fence is longer than any in it.
std::string fenced(const std::string& text) {
  std::size_t longest = 2;
  std::size_t run = 0;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  const std::string fence(longest + 1, '`');
  return fence + "text\n" + text + fence + "\n";
}

std::string feedback(const json& course, const json& student) {
  const Grade grade = gradeOf(course, student);
  const std::string title = textOf(course, "title");
  std::string text = "# Feedback for " + markdown(textOf(student, "student")) + "\n\n";
  if (!title.empty()) text += markdown(title) + ".\n";
  if (grade.state == "not taken") {
    return text +
           "\nWhat you handed in could not be taken: " + markdown(textOf(student, "refused")) +
           ".\nPlease hand it in again, as a folder, a zip or a tar archive that holds your folder "
           "`exercises`.\n";
  }
  if (grade.graded) {
    text +=
        "You have **" + shortNumber(grade.points) + " of " + shortNumber(grade.of) + " points**.\n";
  } else {
    text +=
        "Not everything could be graded, through a fault of ours: there is no sum of points "
        "yet.\n";
  }
  text += "\n| exercise | | points |\n| --- | --- | ---: |\n";
  for (const auto& e : course.at("exercises")) {
    const json& result = resultOf(student, e.at("id"));
    const bool counts = !isFault(result) && textOf(result, "status") != "not asked";
    text += "| " +
            markdown(e.at("id").get<std::string>() + " " + e.at("title").get<std::string>()) +
            " | " + (isFault(result) ? "not graded" : textOf(result, "status")) + " | " +
            (counts ? shortNumber(pointsOf(e, result)) : "") + " of " +
            shortNumber(e.at("points")) + " |\n";
  }
  for (const auto& e : course.at("exercises")) {
    const json& result = resultOf(student, e.at("id"));
    const std::string status = textOf(result, "status");
    if (status == "not handed in" || status == "not asked") continue;
    text += "\n## " + markdown(e.at("id").get<std::string>()) + ": " +
            markdown(e.at("title").get<std::string>()) + "\n\n";
    if (const auto whole = wholeText(e, result); !whole.empty()) {
      text += status == "does not compile" || status == "refused" ? fenced(whole) : whole;
      continue;
    }
    int holding = 0;
    int open = 0;
    const auto items = itemsOf(e, result);
    for (const auto& item : items) {
      open += !item.hidden;
      holding += !item.hidden && item.status == "passed";
    }
    if (open > 0) {
      text += holding == open ? "All " + std::to_string(open) + " public checks hold.\n"
                              : std::to_string(holding) + " of " + std::to_string(open) +
                                    " public checks hold.\n";
    }
    bool first = true;
    int others = 0;
    for (const auto& item : items) {
      if (item.hidden) {
        text += "*" + markdown(item.title) + "*: " + item.output;
        continue;
      }
      if (item.status == "passed") continue;
      if (!first) {
        ++others;
        continue;
      }
      first = false;
      text += "\n**" + markdown(item.title) + "**: " + item.status + ".\n";
      if (!item.output.empty()) text += "\n" + fenced(item.output);
      if (const auto says = meaning(e, result); !says.empty())
        text += "\nWhat it looks like: " + markdown(says) + "\n";
      for (const auto& c : e.at("checks")) {
        const std::string read = textOf(c, "read");
        if (c.at("name") == item.name && !read.empty())
          text += "\nRead again: " + markdown(read) + ".\n";
      }
    }
    if (others == 1) text += "\nOne more check does not hold; it may have the same cause.\n";
    if (others > 1) {
      text += "\n" + std::to_string(others) +
              " more checks do not hold; they may have the same cause.\n";
    }
    if (const auto guard = brokenGuard(e, result); !guard.empty() && holding > 0)
      text += "\nAs long as *" + markdown(guard) + "* does not hold, the others earn nothing.\n";
  }
  text += "\n`./course check` asks the public checks again on your machine, with other numbers.\n";
  return text;
}

// ---- JUnit

std::string suiteOf(const json& exercise, const json& student, bool withName) {
  const json& result = resultOf(student, exercise.at("id"));
  if (textOf(result, "status") == "not asked") return "";
  const std::string id = exercise.at("id");
  std::string cases;
  int failures = 0;
  int errors = 0;
  int skipped = 0;
  const auto items = itemsOf(exercise, result);
  const std::string whole = wholeText(exercise, result);
  bool first = true;
  for (const auto& item : items) {
    cases += "    <testcase classname=\"" + markupEscaped(id) + "\" name=\"" +
             markupEscaped(item.title) + "\"";
    if (item.status == "passed") {
      cases += "/>\n";
      continue;
    }
    std::string text = item.output;
    if (first) {
      text += whole;
      if (const auto says = meaning(exercise, result); !says.empty()) text += says + "\n";
    }
    first = false;
    const char* kind = isFault(result)                                              ? "error"
                       : item.status == "not run" || item.status == "not handed in" ? "skipped"
                                                                                    : "failure";
    (isFault(result) ? errors : std::string_view(kind) == "skipped" ? skipped : failures) += 1;
    cases += "><" + std::string(kind) + " message=\"" + markupEscaped(item.status) + "\"";
    cases += std::string_view(kind) == "skipped"
                 ? "/></testcase>\n"
                 : ">" + markupEscaped(text) + "</" + kind + "></testcase>\n";
  }
  const std::string name = withName ? textOf(student, "student") + " " + id : id;
  return "  <testsuite name=\"" + markupEscaped(name) + "\" tests=\"" +
         std::to_string(items.size()) + "\" failures=\"" + std::to_string(failures) +
         "\" errors=\"" + std::to_string(errors) + "\" skipped=\"" + std::to_string(skipped) +
         "\">\n" + cases + "  </testsuite>\n";
}

std::string junit(const json& course, const std::vector<json>& students) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const auto& student : students) {
    if (const auto refused = textOf(student, "refused"); !refused.empty()) {
      text += "  <testsuite name=\"" + markupEscaped(textOf(student, "student")) +
              "\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\">\n    <testcase "
              "classname=\"submission\" name=\"is taken\"><error message=\"not taken\">" +
              markupEscaped(refused) + "</error></testcase>\n  </testsuite>\n";
      continue;
    }
    for (const auto& e : course.at("exercises")) text += suiteOf(e, student, students.size() > 1);
  }
  return text + "</testsuites>\n";
}

// ---- Gradescope

json gradescope(const json& course, const json& student) {
  const Grade grade = gradeOf(course, student);
  json tests = json::array();
  int number = 0;
  for (const auto& e : course.at("exercises")) {
    ++number;
    const json& result = resultOf(student, e.at("id"));
    if (textOf(result, "status") == "not asked") continue;
    int part = 0;
    bool first = true;
    for (const auto& item : itemsOf(e, result)) {
      std::string output = item.output;
      if (item.status != "passed" && !item.hidden && first) {
        output += wholeText(e, result);
        if (const auto says = meaning(e, result); !says.empty()) output += says + "\n";
        first = false;
      }
      if (output.empty() && item.status != "passed") output = item.status + "\n";
      json test = {{"name", e.at("id").get<std::string>() + ": " + item.title},
                   {"name_format", "text"},
                   {"number", std::to_string(number) + "." + std::to_string(++part)},
                   {"max_score", item.most},
                   {"status", item.status == "passed" ? "passed" : "failed"},
                   {"output", output},
                   {"output_format", "text"},
                   {"tags", {e.at("id")}},
                   {"visibility", item.hidden ? "after_published" : "visible"}};
      // What was not graded has no score; one that is no grade would be taken for one.
      if (!isFault(result)) test["score"] = item.score;
      tests.push_back(std::move(test));
    }
  }
  json all = {{"output_format", "text"},
              {"test_output_format", "text"},
              {"visibility", "visible"},
              {"stdout_visibility", "hidden"},
              {"tests", tests}};
  if (grade.state == "not taken") {
    all["output"] = "What you handed in could not be taken: " + textOf(student, "refused") + ".";
    all["tests"] = json::array();
    all["score"] = 0;
  } else if (!grade.graded) {
    all["output"] =
        "Not everything could be graded, through a fault of ours. Your teacher has been told; what "
        "stands here is not your grade.";
  } else {
    all["score"] = grade.points;
    all["output"] = shortNumber(grade.points) + " of " + shortNumber(grade.of) + " points.";
  }
  all["extra_data"] = {{"state", grade.state}, {"version", textOf(course, "version")}};
  return all;
}

// ---- GitHub Classroom

json classroom(const json& course, const json& student) {
  const Grade grade = gradeOf(course, student);
  json tests = json::array();
  bool all = true;
  for (const auto& e : course.at("exercises")) {
    const json& result = resultOf(student, e.at("id"));
    if (textOf(result, "status") == "not asked") continue;
    bool first = true;
    for (const auto& item : itemsOf(e, result)) {
      std::string message = item.output;
      if (item.status != "passed" && !item.hidden && first) {
        message += wholeText(e, result);
        if (const auto says = meaning(e, result); !says.empty()) message += says + "\n";
        first = false;
      }
      all &= item.status == "passed";
      tests.push_back({{"name", e.at("id").get<std::string>() + ": " + item.title},
                       {"status", item.status == "passed" ? "pass"
                                  : isFault(result)       ? "error"
                                                          : "fail"},
                       {"score", item.score},
                       {"message", item.status == "passed" ? "" : item.status + "\n" + message},
                       {"line_no", 0},
                       {"filename", e.at("file")},
                       {"test_code", "./course check " + e.at("id").get<std::string>()}});
    }
  }
  const bool refused = grade.state == "not taken";
  if (refused) {
    tests = {{{"name", "The submission is taken"},
              {"status", "error"},
              {"score", 0},
              {"message", textOf(student, "refused")},
              {"line_no", 0},
              {"filename", ""},
              {"test_code", ""}}};
  }
  return {{"version", 1},
          {"status", refused || !grade.graded ? "error"
                     : all                    ? "pass"
                                              : "fail"},
          {"max_score", grade.of},
          {"tests", tests}};
}

// ---- CSV

std::string csv(const Records& records) {
  const auto& course = records.course;
  std::string text = "student,points,of,percent,state";
  for (const auto& e : course.at("exercises")) text += "," + csvCell(e.at("id"));
  text += ",misunderstood,remarks\n";
  for (const auto& student : records.students) {
    const Grade grade = gradeOf(course, student);
    const bool counts = grade.graded && grade.state != "not taken";
    char percent[32] = "";
    if (counts && grade.of > 0)
      std::snprintf(percent, sizeof percent, "%.1f", 100 * grade.points / grade.of);
    text += csvCell(textOf(student, "student")) + "," + (counts ? shortNumber(grade.points) : "") +
            "," + shortNumber(grade.of) + "," + percent + "," + csvCell(grade.state);
    std::string misunderstood;
    for (const auto& e : course.at("exercises")) {
      const json& result = resultOf(student, e.at("id"));
      const std::string status = textOf(result, "status");
      if (grade.state == "not taken" || status == "not asked")
        text += ",";
      else if (isFault(result))
        text += ",not graded";
      else
        text += "," + shortNumber(pointsOf(e, result));
      if (const auto found = result.find("misconception"); found != result.end()) {
        misunderstood += (misunderstood.empty() ? "" : "; ") + e.at("id").get<std::string>() + "/" +
                         textOf(*found, "name");
      }
    }
    std::string remarks;
    for (const auto& remark : toLookAt(course, student))
      remarks += (remarks.empty() ? "" : "; ") + remark;
    text += "," + csvCell(misunderstood) + "," + csvCell(remarks) + "\n";
  }
  return text;
}

}  // namespace

std::string markupEscaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        // XML has no way to write control characters.
        out +=
            (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') || c == 0x7f ? '?' : c;
    }
  }
  return out;
}

std::string csvCell(const std::string& text) {
  std::string cell = oneLine(text);
  if (!cell.empty() && std::string_view("=+-@").find(cell[0]) != std::string_view::npos)
    cell = "'" + cell;
  if (cell.find_first_of(",\";'") == cell.npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string shortNumber(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", value);
  std::string number = text;
  while (number.back() == '0') number.pop_back();
  if (number.back() == '.') number.pop_back();
  return number;
}

double pointsOf(const json& exercise, const json& result) {
  double sum = 0;
  for (const auto& c : exercise.at("checks")) {
    if (passes(checkOf(result, c.at("name")))) sum += c.at("points").get<double>();
  }
  return brokenGuard(exercise, result).empty() ? sum : 0;
}

Grade gradeOf(const json& course, const json& student) {
  Grade grade;
  for (const auto& e : course.at("exercises")) {
    const json& result = resultOf(student, e.at("id"));
    if (textOf(result, "status") == "not asked") continue;
    grade.of += e.at("points").get<double>();
    grade.points += pointsOf(e, result);
    grade.graded &= !isFault(result);
  }
  grade.state = grade.graded ? "graded" : "not graded";
  if (!textOf(student, "refused").empty()) grade = {0, grade.of, false, "not taken", {}};
  const auto remarks = toLookAt(course, student);
  if (!remarks.empty()) grade.firstWord = remarks.front();
  return grade;
}

std::vector<std::string> toLookAt(const json& course, const json& student) {
  std::vector<std::string> all;
  const std::string refused = textOf(student, "refused");
  if (!refused.empty()) return {"not taken: " + refused};
  bool some = false;
  for (const auto& e : course.at("exercises")) {
    const std::string id = e.at("id");
    const json& result = resultOf(student, id);
    const std::string status = textOf(result, "status");
    some |= status != "not handed in";
    if (isFault(result)) {
      std::string why = textOf(result, "reason");
      if (const auto checks = result.find("checks"); checks != result.end()) {
        for (const auto& c : *checks) {
          if (why.empty() && isFault(c)) why = textOf(c, "reason");
        }
      }
      all.push_back(id + ": not graded, our fault: " + clipped(oneLine(why), 300));
    }
    if (status == "refused") {
      const auto list = result.find("refused");
      all.push_back(
          id + ": refused: " +
          clipped(oneLine(list != result.end() && !list->empty() ? (*list)[0].get<std::string>()
                                                                 : textOf(result, "reason")),
                  300));
    }
    if (isOn(result, "slow")) all.push_back(id + ": close to the limit on time");
    if (const auto checks = result.find("checks"); checks != result.end()) {
      const bool unstable = std::any_of(checks->begin(), checks->end(),
                                        [](const json& c) { return isOn(c, "unstable"); });
      if (unstable) all.push_back(id + ": answers differ from run to run");
    }
    const std::string due = textOf(e, "due");
    const std::string date = textOf(student, "date");
    if (!due.empty() && !date.empty() && date > due && status != "not handed in") {
      all.push_back(id + ": last commit is dated " + date + ", after " + due +
                    " (its author's own date; nothing was taken off)");
    }
  }
  if (!some) all.push_back("holds no file of the course");
  for (const auto& note : student.at("notes")) all.push_back(oneLine(note.get<std::string>()));
  return all;
}

void writeReports(const fs::path& out, const Records& records) {
  for (const auto& student : records.students) {
    const fs::path folder = out / folderOf(textOf(student, "student"));
    const json& course = records.course;
    writeFile(folder / "feedback.md", feedback(course, student));
    writeFile(folder / "junit.xml", junit(course, {student}));
    writeFile(folder / "results.json", dumped(gradescope(course, student)));
    writeFile(folder / "classroom.json", dumped(classroom(course, student)));
  }
  writeFile(out / "grades.csv", csv(records));
  writeFile(out / "junit.xml", junit(records.course, records.students));
  writeFile(out / "class.html", classPage(records));
}

}  // namespace carom::runner
