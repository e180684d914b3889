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

// A label in a column of its own, and a text that may run over several lines behind it.
std::string labelled(const std::string& label, const std::string& text) {
  const std::string indent(15, ' ');
  std::string block = wrapped(text, 100, indent);
  return "    " + padded(label, 11) + block.substr(indent.size()) + "\n";
}

std::string failureText(const CheckResult& check, const ExerciseResult& result,
                        const Project& project) {
  std::string text;
  const auto& f = check.failure;
  auto value = [&](const char* key) { return f.is_object() ? f.value(key, "") : std::string(); };
  if (!value("about").empty()) text += labelled("Question", value("about"));
  if (f.is_object() && f.contains("given")) {
    bool first = true;
    for (const auto& g : f["given"]) {
      text +=
          labelled(first ? "For" : "", g[0].get<std::string>() + " = " + g[1].get<std::string>());
      first = false;
    }
  }
  const std::string unit = value("unit").empty() || value("unit") == "1" ? "" : " " + value("unit");
  if (check.status == Status::wrong) {
    // A unit belongs behind a number, not behind a sentence.
    auto withUnit = [&](const std::string& answer) {
      const bool number =
          !answer.empty() && std::string("0123456789-+{[(").find(answer[0]) != std::string::npos;
      return answer + (number ? unit : "");
    };
    text += labelled("You gave", value("call") + " = " + withUnit(value("got")));
    std::string expected = withUnit(value("expected"));
    if (!value("within").empty()) {
      const bool share = value("within").find(" of its size") != std::string::npos;
      expected += "   (within " + value("within") + (share ? "" : unit) + ": " + value("why") + ")";
    }
    text += labelled("Expected", expected);
  } else if (check.status == Status::stopped && !value("call").empty()) {
    text += labelled("Asked", value("call"));
  }
  if (!check.reason.empty()) text += labelled("Because", check.reason);
  if (!result.wrongName.empty()) {
    text += labelled("Meaning", result.wrongSays + " [matched " + std::to_string(result.probes) +
                                    " of " + std::to_string(result.probes) + " probes]");
  }
  std::error_code none;
  if (!value("file").empty()) {
    text += labelled("Where", result.exercise->studentFile().string() + "   asked in " +
                                  fs::relative(value("file"), project.root, none).string() + ":" +
                                  std::to_string(f.value("line", 0)));
  }
  for (const auto& c : result.exercise->checks) {
    if (c.name == check.name) {
      text += labelled("Read",
                       "chapter " + std::to_string(std::atoi(result.exercise->chapter.c_str())) +
                           ", \"" + (result.wrongRead.empty() ? c.read : result.wrongRead) + "\"");
    }
  }
  if (!result.exercise->program.empty())
    text += labelled("See it", "./course play " + result.exercise->id);
  if (!check.output.empty() && check.status == Status::stopped &&
      check.output.find("Catch") == std::string::npos) {
    text += labelled("It printed", check.output.substr(0, 400));
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

std::string describe(const ExerciseResult& result, const Project& project, const View& view,
                     int hintsLeft) {
  const auto& e = *result.exercise;
  std::string text = view.strong(e.id + "  " + e.title) + "   " + std::to_string(result.passed()) +
                     " of " + std::to_string(e.checks.size()) + " checks pass\n";
  const std::string file = e.studentFile().string();
  for (const auto& note : result.screening.notes) text += view.dim(labelled("Note", note));

  switch (result.status) {
    case Status::passed:
      for (const auto& check : result.checks) text += view.good("  ✓ ") + check.title + "\n";
      text += view.good("  All " + std::to_string(e.checks.size()) + " public checks pass.") + "\n";
      text += "Next: ./course solution " + e.id + "   shows why it is written so\n";
      return text;
    case Status::notStarted:
      text += "  Not started: write your answer in " + file + "\n";
      text += "Next: ./course show " + e.id + "   ./course hint " + e.id + "\n";
      return text;
    case Status::doesNotCompile:
      text += view.bad("  ✗ does not compile") + "\n";
      for (const auto& line : splitLines(result.compiled.firstError)) text += "    " + line + "\n";
      if (!result.compiled.plain.empty()) text += labelled("Meaning", result.compiled.plain);
      return text + "Next: edit the file and check again.\n";
    case Status::refused:
      text += view.bad("  ✗ not run") + "\n";
      for (const auto& reason : result.screening.refused) text += labelled("Because", reason);
      return text;
    case Status::ourFault:
      text += view.bad("  This is the course's mistake, not yours.") + "\n";
      if (!result.reason.empty()) text += labelled("Because", result.reason);
      for (const auto& check : result.checks) {
        if (check.status == Status::ourFault) text += labelled(check.name, check.reason);
      }
      return text;
    default:
      break;
  }

  int more = 0;
  bool told = false;
  for (const auto& check : result.checks) {
    if (check.status == Status::passed) {
      text += view.good("  ✓ ") + check.title + "\n";
    } else if (!told) {
      told = true;
      const std::string how =
          check.status == Status::wrong ? "" : std::string("  [") + nameOf(check.status) + "]";
      text += view.bad("  ✗ ") + check.title + how + "\n" + failureText(check, result, project);
      if (check.othersWrong) {
        text += labelled(
            "", std::to_string(check.othersWrong) +
                    (check.othersWrong == 1 ? " more question of this check is answered wrong."
                                            : " more questions of this check are answered wrong."));
      }
    } else {
      ++more;
    }
  }
  if (more) {
    text += "  " + std::to_string(more) + " more check" +
            (more > 1 ? "s fail; they" : " fails; it") + " may have the same cause.\n";
  }
  text +=
      "Next: edit " + file + " and check again." +
      (hintsLeft ? "   ./course hint " + e.id + " (" + std::to_string(hintsLeft) + " left)" : "") +
      "\n";
  return text;
}

std::string listing(const Project& project, const State& state,
                    const std::vector<const Exercise*>& which, const View& view) {
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
