// The page for the class: one file, no network, readable without colour, by keyboard and by voice.

#include <algorithm>
#include <map>

#include "runner/reports.hpp"

namespace carom::runner {

using nlohmann::json;

namespace {

const char* const kStyle = R"(
:root{color-scheme:light dark;
--ink:#1c1e21;--back:#fdfdfc;--line:#c9ccd1;--soft:#f0f1f3;--bar:#9cc3ea;
--good:#136b34;--bad:#a3201f;--odd:#7a4b00;--link:#0b5394}
@media(prefers-color-scheme:dark){:root{--ink:#e7e8ea;--back:#16181b;--line:#45494f;--soft:#22262b;
--bar:#28527a;--good:#7fd89b;--bad:#ff9a95;--odd:#f0c06a;--link:#8fc1f5}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:72rem;padding:1rem;font:1rem/1.5 system-ui,sans-serif;color:var(--ink);
background:var(--back)}
h1{font-size:1.6rem;margin:.5rem 0}h2{font-size:1.25rem;margin:2rem 0 .5rem}
a{color:var(--link)}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:.3rem}
.scroll:focus-visible,a:focus-visible,summary:focus-visible{outline:3px solid var(--link);
outline-offset:2px}
table{border-collapse:collapse;width:100%}
caption{text-align:left;padding:.4rem .6rem;font-weight:600}
td ul{margin:0;padding-left:1.2rem}
th,td{padding:.3rem .6rem;text-align:left;vertical-align:top;border-top:1px solid var(--line)}
thead th{background:var(--soft);white-space:nowrap}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
.all th:first-child{position:sticky;left:0;background:var(--back)}
.all thead th:first-child{background:var(--soft)}
tr.group>*{background:var(--soft)}
.rate{min-width:9rem}
.bar{display:block;height:.5rem;border-radius:.25rem;background:var(--soft);
border:1px solid var(--line)}
.bar>span{display:block;height:100%;background:var(--bar);border-radius:.25rem}
.good{color:var(--good)}.bad{color:var(--bad)}.odd{color:var(--odd)}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.1rem 1rem;margin:0}
dt{font-weight:600}dd{margin:0}
nav ul{display:flex;flex-wrap:wrap;gap:.2rem 1.2rem;list-style:none;padding:0;margin:.5rem 0}
.skip{position:absolute;left:-100rem}.skip:focus{left:1rem;background:var(--back);padding:.5rem}
@media print{nav,.skip{display:none}.scroll{overflow:visible;border:0}body{max-width:none}}
)";

std::string textOf(const json& value, const char* key) {
  const auto at = value.find(key);
  return at != value.end() && at->is_string() ? at->get<std::string>() : "";
}

std::string esc(const std::string& text) {
  return markupEscaped(text);
}

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

const json* resultOf(const json& student, const std::string& id) {
  const auto& all = student.at("exercises");
  const auto at = all.find(id);
  return at == all.end() ? nullptr : &*at;
}

const json* checkOf(const json& result, const std::string& name) {
  if (const auto checks = result.find("checks"); checks != result.end()) {
    for (const auto& c : *checks) {
      if (textOf(c, "name") == name) return &c;
    }
  }
  return nullptr;
}

// Whose work counts for a rate: handed in, and graded.
bool counts(const json* result) {
  if (!result) return false;
  const std::string status = textOf(*result, "status");
  return status != "not handed in" && status != "not asked" && status != "our fault";
}

std::string rate(std::size_t good, std::size_t of) {
  if (of == 0) return "<td class=\"n\">none</td><td class=\"rate\"></td>";
  const int percent = static_cast<int>(100 * good / of);
  return "<td class=\"n\">" + std::to_string(good) + " of " + std::to_string(of) +
         "</td><td class=\"rate\"><span class=\"bar\" aria-hidden=\"true\"><span style=\"width:" +
         std::to_string(percent) + "%\"></span></span></td>";
}

// A table that scrolls by itself, also by keyboard.
std::string table(const std::string& id, const std::string& title, const std::string& classes,
                  const std::string& head, const std::string& rows) {
  return "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-labelledby=\"" + id +
         "-title\"><table class=\"" + classes + "\"><caption id=\"" + id + "-title\">" +
         esc(title) + "</caption><thead><tr>" + head + "</tr></thead><tbody>\n" + rows +
         "</tbody></table></div>\n";
}

std::string heading(const char* text, bool number = false) {
  return std::string("<th scope=\"col\"") + (number ? " class=\"n\"" : "") + ">" + text + "</th>";
}

std::string summary(const Records& r) {
  std::size_t graded = 0;
  std::size_t refused = 0;
  std::size_t faults = 0;
  double share = 0;
  for (const auto& student : r.students) {
    const Grade grade = gradeOf(r.course, student);
    refused += grade.state == "not taken";
    faults += grade.state == "not graded";
    if (grade.state != "graded") continue;
    ++graded;
    if (grade.of > 0) share += grade.points / grade.of;
  }
  std::string text = "<dl><dt>Students</dt><dd>" + count(r.students.size(), "student", "students") +
                     ": " + std::to_string(graded) + " graded";
  if (refused) text += ", " + std::to_string(refused) + " not taken";
  if (faults) text += ", " + std::to_string(faults) + " not graded through a fault of ours";
  text += "</dd>";
  if (graded) {
    text += "<dt>On average</dt><dd>" + shortNumber(100 * share / static_cast<double>(graded)) +
            " % of the points</dd>";
  }
  text += "<dt>Exercises</dt><dd>" + std::to_string(r.course.at("exercises").size()) + "</dd>";
  text += "<dt>Submissions ran in</dt><dd>" + esc(textOf(r.course, "sandbox")) + "</dd>";
  text += "<dt>Inputs</dt><dd>" +
          std::string(r.course.at("secret").get<bool>()
                          ? "other ones for each student, drawn with the course's secret"
                          : "other ones for each student; without a secret in the course file, "
                            "anybody can work them out") +
          "</dd><dt>Version</dt><dd>" + esc(textOf(r.course, "version")) + "</dd></dl>\n";
  return text;
}

std::string look(const Records& r) {
  std::string rows;
  for (const auto& student : r.students) {
    const auto remarks = toLookAt(r.course, student);
    if (remarks.empty()) continue;
    rows += "<tr><th scope=\"row\">" + esc(textOf(student, "student")) + "</th><td><ul>";
    for (const auto& remark : remarks) rows += "<li>" + esc(remark) + "</li>";
    rows += "</ul></td></tr>\n";
  }
  if (rows.empty()) return "<p>Nobody.</p>\n";
  return table("look-table", "Students whose work somebody should look at", "",
               heading("student") + heading("why"), rows);
}

std::string misunderstood(const Records& r) {
  struct Row {
    std::string exercise;
    std::string says;
    std::string read;
    std::vector<std::string> who;
  };
  std::vector<Row> all;
  for (const auto& e : r.course.at("exercises")) {
    std::map<std::string, Row> here;
    for (const auto& student : r.students) {
      const json* result = resultOf(student, e.at("id"));
      if (!result || !result->contains("misconception")) continue;
      const json& found = result->at("misconception");
      Row& row = here[textOf(found, "name")];
      row.exercise = e.at("id");
      row.says = textOf(found, "says");
      row.read = textOf(found, "read");
      row.who.push_back(textOf(student, "student"));
    }
    for (auto& [name, row] : here) all.push_back(std::move(row));
  }
  if (all.empty()) return "<p>No answer was that of a known misunderstanding.</p>\n";
  std::stable_sort(all.begin(), all.end(),
                   [](const Row& a, const Row& b) { return a.who.size() > b.who.size(); });
  std::string rows;
  for (const auto& row : all) {
    std::string who;
    for (const auto& name : row.who) who += (who.empty() ? "" : ", ") + name;
    rows += "<tr><td class=\"n\">" + std::to_string(row.who.size()) + "</td><th scope=\"row\">" +
            esc(row.exercise) + "</th><td>" + esc(row.says) + "</td><td>" + esc(row.read) +
            "</td><td>" + esc(who) + "</td></tr>\n";
  }
  return table("wrong-table", "Known misunderstandings, the most frequent first", "",
               heading("students", true) + heading("exercise") + heading("what was misunderstood") +
                   heading("read again") + heading("who"),
               rows);
}

std::string checks(const Records& r) {
  std::string rows;
  for (const auto& e : r.course.at("exercises")) {
    const std::string id = e.at("id");
    std::size_t of = 0;
    std::size_t all = 0;
    std::map<std::string, std::size_t> states;
    for (const auto& student : r.students) {
      const json* result = resultOf(student, id);
      if (result && textOf(student, "refused").empty()) ++states[textOf(*result, "status")];
      if (!counts(result)) continue;
      ++of;
      all += textOf(*result, "status") == "passed";
    }
    std::string other;
    for (const char* state :
         {"not started", "does not compile", "stopped", "refused", "our fault", "not handed in"}) {
      if (states[state])
        other += (other.empty() ? "" : ", ") + std::to_string(states[state]) + " " + state;
    }
    rows += "<tr class=\"group\"><th scope=\"row\">" + esc(id) + " " +
            esc(e.at("title").get<std::string>()) + "</th>" + rate(all, of) + "<td>" + esc(other) +
            "</td></tr>\n";
    for (const auto& c : e.at("checks")) {
      std::size_t good = 0;
      for (const auto& student : r.students) {
        const json* result = resultOf(student, id);
        if (!counts(result)) continue;
        const json* check = checkOf(*result, c.at("name"));
        good += check && textOf(*check, "status") == "passed";
      }
      const bool hidden = c.at("hidden").get<bool>();
      rows += "<tr><th scope=\"row\" style=\"font-weight:400\">" +
              esc(c.at("title").get<std::string>()) + "</th>" + rate(good, of) + "<td>" +
              shortNumber(c.at("points")) + (c.at("points") == 1 ? " point" : " points") +
              (hidden ? ", hidden as '" + esc(e.at("topic").get<std::string>()) + "'" : "") +
              "</td></tr>\n";
    }
  }
  return table(
      "checks-table", "How many passed, of those who handed in the exercise", "",
      heading("exercise and check") + heading("passed", true) + "<td></td>" + heading("remarks"),
      rows);
}

std::string students(const Records& r) {
  std::string head = heading("student") + heading("points", true) + heading("state");
  for (const auto& e : r.course.at("exercises"))
    head += heading(esc(e.at("id").get<std::string>()).c_str(), true);
  std::string rows;
  for (const auto& student : r.students) {
    const Grade grade = gradeOf(r.course, student);
    rows += "<tr><th scope=\"row\">" + esc(textOf(student, "student")) + "</th><td class=\"n\">" +
            (grade.state == "graded" ? shortNumber(grade.points) + " of " + shortNumber(grade.of)
                                     : "") +
            "</td><td>" + esc(grade.state) + "</td>";
    for (const auto& e : r.course.at("exercises")) {
      const json* result = resultOf(student, e.at("id"));
      const std::string status = result ? textOf(*result, "status") : "";
      if (grade.state == "not taken" || status.empty() || status == "not asked") {
        rows += "<td class=\"n\"></td>";
      } else if (status == "our fault") {
        rows += "<td class=\"n odd\">not graded</td>";
      } else if (status == "not handed in") {
        rows += "<td class=\"n\">0 <small>none</small></td>";
      } else {
        const double points = pointsOf(e, *result);
        const char* colour = status == "passed" ? " good" : points == 0 ? " bad" : "";
        rows += std::string("<td class=\"n") + colour + "\">" + shortNumber(points) + " <small>" +
                esc(status) + "</small></td>";
      }
    }
    rows += "</tr>\n";
  }
  return table("students-table", "Points per exercise", "all", head, rows);
}

}  // namespace

std::string classPage(const Records& records) {
  const std::string title = textOf(records.course, "title");
  const std::string name = title.empty() ? "The class" : esc(title);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" "
         "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<title>" +
         name + ": grades</title>\n<style>" + kStyle +
         "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#main\">Skip to the content</a>\n"
         "<header><h1>" +
         name +
         ": grades</h1>\n<nav aria-label=\"On this page\"><ul><li><a href=\"#look\">Who needs a "
         "look</a></li><li><a href=\"#wrong\">What was misunderstood</a></li><li><a "
         "href=\"#checks\">Exercises and checks</a></li><li><a "
         "href=\"#students\">Students</a></li></ul></nav></header>\n<main id=\"main\">\n" +
         summary(records) + "<h2 id=\"look\">Who needs a look</h2>\n" + look(records) +
         "<h2 id=\"wrong\">What was misunderstood</h2>\n" + misunderstood(records) +
         "<h2 id=\"checks\">Exercises and checks</h2>\n" + checks(records) +
         "<h2 id=\"students\">Students</h2>\n" + students(records) + "</main>\n</body>\n</html>\n";
}

}  // namespace carom::runner
