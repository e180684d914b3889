#include "runner/view.hpp"

#include <cstdio>

namespace carom::runner {

namespace {

std::string paint(bool colour, const char* code, const std::string& text) {
  return colour ? std::string("\033[") + code + "m" + text + "\033[0m" : text;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

// A label in a column of its own, and a text that may run over several lines behind it. In plain output a line of its
// own.
std::string labelled(const View& view, const std::string& label, const std::string& text) {
  if (view.plain) {
    const auto all = words(text);
    std::string line = label.empty() ? "" : label + ":";
    for (const auto& word : all) line += (line.empty() ? "" : " ") + word;
    return line + "\n";
  }
  const std::string indent(15, ' ');
  std::string block = wrapped(text, 100, indent);
  return "    " + padded(label, 11) + block.substr(indent.size()) + "\n";
}

// For editors: a check that fails, at the student's file.
std::string whereLine(const CheckResult& check, const ExerciseResult& result,
                      const std::string& asked = "") {
  return "Where: " + result.exercise->studentFile().string() + ", check \"" + check.title + "\"" +
         (asked.empty() ? "" : ", " + asked) + "\n";
}

std::string failureText(const CheckResult& check, const ExerciseResult& result,
                        const Project& project, const View& view) {
  std::string text;
  const auto& f = check.failure;
  auto value = [&](const char* key) { return f.is_object() ? f.value(key, "") : std::string(); };
  if (!value("about").empty()) text += labelled(view, "Question", value("about"));
  if (f.is_object() && f.contains("given")) {
    bool first = true;
    for (const auto& g : f["given"]) {
      text += labelled(view, first || view.plain ? "For" : "",
                       g[0].get<std::string>() + " = " + g[1].get<std::string>());
      first = false;
    }
  }
  const std::string unit = value("unit").empty() || value("unit") == "1" ? "" : " " + value("unit");
  if (check.status == Status::wrong && f.is_object()) {
    // A unit belongs behind a number, not behind a sentence.
    auto withUnit = [&](const std::string& answer) {
      const bool number =
          !answer.empty() && std::string("0123456789-+{[(").find(answer[0]) != std::string::npos;
      return answer + (number ? unit : "");
    };
    text += labelled(view, "You gave", value("call") + " = " + withUnit(value("got")));
    std::string expected = withUnit(value("expected"));
    if (!value("within").empty()) {
      const bool share = value("within").find(" of its size") != std::string::npos;
      expected += "   (within " + value("within") + (share ? "" : unit) + ": " + value("why") + ")";
    }
    text += labelled(view, "Expected", expected);
  } else if (check.status == Status::stopped && !value("call").empty()) {
    text += labelled(view, "Asked", value("call"));
  }
  if (!check.reason.empty()) text += labelled(view, "Because", check.reason);
  if (!result.wrongName.empty()) {
    text += labelled(view, "Meaning",
                     result.wrongSays + " [matched " + std::to_string(result.probes) + " of " +
                         std::to_string(result.probes) + " probes]");
  }
  std::error_code none;
  const std::string asked = value("file").empty()
                                ? ""
                                : "asked in " +
                                      fs::relative(value("file"), project.root, none).string() +
                                      ":" + std::to_string(f.value("line", 0));
  if (view.plain)
    text += whereLine(check, result, asked);
  else if (!asked.empty())
    text += labelled(view, "Where", result.exercise->studentFile().string() + "   " + asked);
  for (const auto& c : result.exercise->checks) {
    if (c.name == check.name) {
      text += labelled(view, "Read",
                       "chapter " + std::to_string(std::atoi(result.exercise->chapter.c_str())) +
                           ", \"" + (result.wrongRead.empty() ? c.read : result.wrongRead) + "\"");
    }
  }
  if (!result.exercise->program.empty())
    text += labelled(view, "See it", "./course play " + result.exercise->id);
  if (!check.output.empty() && check.status == Status::stopped &&
      check.output.find("Catch") == std::string::npos) {
    text += labelled(view, "It printed", check.output.substr(0, 400));
  }
  return text;
}

}  // namespace

std::string View::good(const std::string& text) const {
  return paint(colour, "32", text);
}
std::string View::bad(const std::string& text) const {
  return paint(colour, "31", text);
}
std::string View::dim(const std::string& text) const {
  return paint(colour, "2", text);
}
std::string View::strong(const std::string& text) const {
  return paint(colour, "1", text);
}

namespace {

// What became of a check, on a line of its own.
std::string verdictLine(const ExerciseResult& result, std::size_t which, const View& view) {
  const auto& check = result.checks[which];
  const bool passed = check.status == Status::passed;
  if (view.plain) {
    return result.exercise->id + ", check " + std::to_string(which + 1) + " of " +
           std::to_string(result.checks.size()) + ", " + nameOf(check.status) + ": " + check.title +
           "\n";
  }
  if (passed) return view.good("  ✓ ") + check.title + "\n";
  const std::string how =
      check.status == Status::wrong ? "" : std::string("  [") + nameOf(check.status) + "]";
  return view.bad("  ✗ ") + check.title + how + "\n";
}

// A verdict on the whole: in plain output it names the exercise.
std::string wholeLine(const ExerciseResult& result, const View& view, const std::string& text,
                      const std::string& words) {
  return (view.plain ? result.exercise->id + ": " + words : "  " + text) + "\n";
}

// What to do next: a line each in plain output.
std::string nextLine(const View& view, const std::string& first, const std::string& second = "",
                     const std::string& remark = "") {
  const bool both = !second.empty();
  if (!view.plain)
    return "Next: " + first + (both ? "   " + second : "") + (remark.empty() ? "" : " " + remark) +
           "\n";
  return "Next: " + first + (both || remark.empty() ? "" : " " + remark) + "\n" +
         (both ? "Or: " + second + (remark.empty() ? "" : " " + remark) + "\n" : "");
}

std::string describeText(const ExerciseResult& result, const Project& project, const View& view,
                         int hintsLeft) {
  const auto& e = *result.exercise;
  const std::string count =
      std::to_string(result.passed()) + " of " + std::to_string(e.checks.size()) + " checks pass";
  std::string text = view.plain ? e.id + ", " + e.title + ": " + count + "\n"
                                : view.strong(e.id + "  " + e.title) + "   " + count + "\n";
  const std::string file = e.studentFile().string();
  for (const auto& note : result.screening.notes) text += view.dim(labelled(view, "Note", note));

  switch (result.status) {
    case Status::passed:
      for (std::size_t i = 0; i < result.checks.size(); ++i) text += verdictLine(result, i, view);
      {
        const std::string all = "All " + std::to_string(e.checks.size()) + " public checks pass.";
        text += wholeLine(result, view, view.good(all), all);
      }
      return text +
             nextLine(view, "./course solution " + e.id, "",
                      view.plain ? "shows why it is written so" : "  shows why it is written so");
    case Status::notStarted:
      text += wholeLine(result, view, "Not started: write your answer in " + file,
                        "not started, write your answer in " + file);
      return text + nextLine(view, "./course show " + e.id, "./course hint " + e.id);
    case Status::doesNotCompile:
      text += wholeLine(result, view, view.bad("✗ does not compile"), "does not compile");
      for (const auto& line : splitLines(result.compiled.firstError))
        text += (view.plain ? "" : "    ") + line + "\n";
      if (!result.compiled.plain.empty()) text += labelled(view, "Meaning", result.compiled.plain);
      return text + nextLine(view, "edit the file and check again.");
    case Status::refused:
      text += wholeLine(result, view, view.bad("✗ not run"), "refused, not run");
      for (const auto& reason : result.screening.refused) text += labelled(view, "Because", reason);
      return text;
    case Status::ourFault:
      text += wholeLine(result, view, view.bad("This is the course's mistake, not yours."),
                        "this is the course's mistake, not yours.");
      if (!result.reason.empty()) text += labelled(view, "Because", result.reason);
      for (const auto& check : result.checks) {
        if (check.status == Status::ourFault) text += labelled(view, check.name, check.reason);
      }
      return text;
    default:
      break;
  }

  int more = 0;
  bool told = false;
  for (std::size_t i = 0; i < result.checks.size(); ++i) {
    const auto& check = result.checks[i];
    if (check.status == Status::passed) {
      text += verdictLine(result, i, view);
    } else if (result.status == Status::notRun) {
      // What cannot be asked here has one reason for all.
      if (!told) text += labelled(view, "Not run", check.reason);
      told = true;
    } else if (!told) {
      told = true;
      text += verdictLine(result, i, view) + failureText(check, result, project, view);
      if (check.othersWrong) {
        text += labelled(
            view, "",
            std::to_string(check.othersWrong) +
                (check.othersWrong == 1 ? " more question of this check is answered wrong."
                                        : " more questions of this check are answered wrong."));
      }
    } else if (e.isTest() && check.status != Status::notRun) {
      // Versions that got through have nothing to do with each other.
      text += verdictLine(result, i, view) + labelled(view, "Because", check.reason) +
              (view.plain ? whereLine(check, result) : "");
    } else {
      ++more;
    }
  }
  if (more) {
    text += (view.plain ? "" : "  ") + std::to_string(more) + " more check" +
            (more > 1 ? "s fail; they" : " fails; it") + " may have the same cause.\n";
  }
  const bool hints = hintsLeft > 0;
  return text + nextLine(view, "edit " + file + " and check again.",
                         hints ? "./course hint " + e.id : "",
                         hints ? "(" + std::to_string(hintsLeft) + " left)" : "");
}

}  // namespace

std::string describe(const ExerciseResult& result, const Project& project, const View& view,
                     int hintsLeft) {
  const std::string text = describeText(result, project, view, hintsLeft);
  return view.plain ? spoken(text) : text;
}

std::string listing(const Project& project, const State& state,
                    const std::vector<const Exercise*>& which, const View& view) {
  if (view.plain) {
    std::string lines;
    int minutes = 0;
    int passed = 0;
    for (const auto* e : which) {
      const Status status = state.statusOf(project, *e);
      const std::string how = status == Status::passed       ? "done"
                              : status == Status::notRun     ? "not checked since it was changed"
                              : status == Status::notStarted ? "not started"
                                                             : "not yet right";
      passed += status == Status::passed;
      minutes += status == Status::passed ? 0 : e->minutes;
      lines += e->id + ": " + how + ". " + e->title + ". Kind " + e->kind + ", level " +
               std::to_string(e->level) + ", " + std::to_string(e->minutes) + " minutes.\n";
    }
    return spoken(lines + std::to_string(passed) + " of " + std::to_string(which.size()) +
                  " exercises are done, about " + std::to_string(minutes) + " minutes are left.\n");
  }
  std::string text;
  std::string chapter;
  int left = 0;
  int done = 0;
  for (const auto* e : which) {
    if (e->chapter != chapter) {
      chapter = e->chapter;
      text += (text.empty() ? "" : "\n") +
              view.strong("Chapter " + std::to_string(std::atoi(chapter.c_str())) + "  " +
                          chapter.substr(3)) +
              "\n";
    }
    const Status status = state.statusOf(project, *e);
    std::string mark = "· not started";
    if (status == Status::passed)
      mark = view.good("✓ done       ");
    else if (status == Status::notRun)
      mark = "? not checked";
    else if (status != Status::notStarted)
      mark = view.bad("✗ not yet    ");
    if (status == Status::passed)
      ++done;
    else
      left += e->minutes;
    text += "  " + mark + "  " + padded(e->id, 30) + padded(e->kind, 10) +
            padded("level " + std::to_string(e->level), 8) +
            padded(" " + std::to_string(e->minutes) + " min", 9) + e->title + "\n";
  }
  text += "\n" + std::to_string(done) + " of " + std::to_string(which.size()) + " done, about " +
          std::to_string(left) + " minutes left\n";
  return text;
}

std::string statement(const Exercise& e, const View& view) {
  if (view.plain) {
    std::string lines = e.id + ": " + e.title + "\n" + e.kind + ", level " +
                        std::to_string(e.level) + ", about " + std::to_string(e.minutes) +
                        " minutes, " + number(e.points) + " points.\n\n" +
                        readIfThere(e.folder / "statement.md").value_or("(no statement)\n") + "\n";
    for (std::size_t i = 0; i < e.checks.size(); ++i) {
      const auto& check = e.checks[i];
      lines += "Check " + std::to_string(i + 1) + ": " + check.title +
               (check.points > 0 ? ", " + number(check.points) + " points" : "") + "\n";
    }
    return spoken(lines + "Your file: " + e.studentFile().string() + "\nThen: ./course check " +
                  e.id + "\n");
  }
  std::string text = view.strong(e.id + "  " + e.title) + "\n" + e.kind + ", level " +
                     std::to_string(e.level) + ", about " + std::to_string(e.minutes) +
                     " minutes, " + number(e.points) + " points\n\n";
  text += readIfThere(e.folder / "statement.md").value_or("(no statement)\n");
  text += "\nChecks:\n";
  for (const auto& check : e.checks) {
    text +=
        "  - " + check.title + (check.points > 0 ? " (" + number(check.points) + ")" : "") + "\n";
  }
  text += "\nYour file: " + e.studentFile().string() + "\nThen:      ./course check " + e.id + "\n";
  return text;
}

}  // namespace carom::runner
