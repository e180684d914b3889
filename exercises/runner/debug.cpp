#include "runner/debug.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace carom::runner {

using nlohmann::json;

namespace {

// The first of the programs that is in the path; empty: none.
fs::path inPath(const std::string& program) {
  const char* path = std::getenv("PATH");
  const std::string all = path ? path : "/usr/bin:/bin";
  for (std::size_t from = 0; from <= all.size();) {
    const auto end = std::min(all.find(':', from), all.size());
    const fs::path file = fs::path(all.substr(from, end - from)) / program;
    std::error_code none;
    if (fs::is_regular_file(file, none) && access(file.c_str(), X_OK) == 0) return file;
    from = end + 1;
  }
  return {};
}

struct Stop {
  std::vector<std::string> functions;    // where to stop, in this order: one after the other
  std::vector<std::string> arguments;    // of the program
  std::vector<std::string> environment;  // NAME=value
};

// gdb's command line, or lldb's where there is only that one.
std::vector<std::string> debuggerCommand(const fs::path& program, const Stop& stop,
                                         bool& installed) {
  const bool gdb = !inPath("gdb").empty();
  const bool lldb = !gdb && !inPath("lldb").empty();
  installed = gdb || lldb;
  std::vector<std::string> words;
  auto add = [&](const char* option, const std::string& text) {
    words.push_back(option);
    words.push_back(text);
  };
  if (lldb) {
    words = {"lldb"};
    for (const auto& entry : stop.environment) add("-o", "settings set target.env-vars " + entry);
    for (std::size_t i = 0; i < stop.functions.size(); ++i) {
      add("-o", "breakpoint set --name " + stop.functions[i]);
      if (i == 0) add("-o", "run");
    }
    add("-o", stop.functions.empty() ? "run" : stop.functions.size() > 1 ? "continue" : "bt");
    words.push_back("--");
  } else {
    words = {"gdb", "-q"};
    for (const auto& entry : stop.environment) {
      const auto equals = entry.find('=');
      add("-ex", "set environment " + entry.substr(0, equals) + " " + entry.substr(equals + 1));
    }
    for (std::size_t i = 0; i < stop.functions.size(); ++i) {
      add("-ex", "break " + stop.functions[i]);
      if (i == 0) add("-ex", "run");
    }
    add("-ex", stop.functions.empty() ? "run" : stop.functions.size() > 1 ? "continue" : "bt");
    words.push_back("--args");
  }
  words.push_back(program.string());
  words.insert(words.end(), stop.arguments.begin(), stop.arguments.end());
  return words;
}

}  // namespace

namespace {

// The same for an editor that drives gdb by itself: one program and one file of commands, always at the same place.
void leaveForEditors(const Project& project, const fs::path& program, const Stop& stop) {
  const fs::path folder = project.build / "debug";
  std::error_code none;
  fs::remove(folder / "program", none);
  fs::create_symlink(program, folder / "program", none);
  std::string commands = "set breakpoint pending on\n";
  for (const auto& entry : stop.environment) {
    const auto equals = entry.find('=');
    commands +=
        "set environment " + entry.substr(0, equals) + " " + entry.substr(equals + 1) + "\n";
  }
  commands += "set args";
  for (const auto& argument : stop.arguments) commands += " " + argument;
  commands += "\n";
  if (!stop.functions.empty()) {
    commands += "tbreak " + stop.functions.front() + "\ncommands\nsilent\n";
    for (std::size_t i = 1; i < stop.functions.size(); ++i)
      commands += "break " + stop.functions[i] + "\n";
    commands += "continue\nend\n";
  }
  writeFile(folder / "commands.gdb", commands);
}

}  // namespace

std::string shellText(const std::vector<std::string>& command) {
  std::string text;
  for (const auto& word : command) {
    const bool bare = !word.empty() && std::all_of(word.begin(), word.end(), [](unsigned char c) {
      return std::isalnum(c) ||
             std::string("-_./:=+,@").find(static_cast<char>(c)) != std::string::npos;
    });
    std::string quoted;
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += (text.empty() ? "" : " ") + (bare ? word : "'" + quoted + "'");
  }
  return text;
}

DebugSession prepareDebugging(const Project& project, const Exercise& exercise,
                              const std::string& checkName) {
  DebugSession session;
  if (exercise.isPrediction()) {
    throw Failure{usage, exercise.id +
                             " is a prediction: there is no program to debug. ./course "
                             "show " +
                             exercise.id + " says what to think about"};
  }
  const auto known = [&](const Check& c) { return c.name == checkName || c.title == checkName; };
  if (!checkName.empty() && std::none_of(exercise.checks.begin(), exercise.checks.end(), known)) {
    std::string names;
    for (const auto& c : exercise.checks) names += "\n  " + c.name + "  " + c.title;
    throw Failure{usage, exercise.id + " has no check '" + checkName + "'; it has" + names};
  }

  CheckOptions options{.source = {}, .lazy = {}, .fingerprint = false};
  const ExerciseResult result = checkExercise(project, exercise, options);
  auto ends = [&](int exitCode, const std::string& message) {
    session.exitCode = exitCode;
    session.message = message;
    return session;
  };
  if (result.status == Status::doesNotCompile)
    return ends(Exit::doesNotCompile, "It does not compile yet:\n" + result.compiled.firstError);
  if (result.status == Status::refused)
    return ends(Exit::checkFailed, "It is not run: " + result.screening.refused.front());
  if (result.status == Status::notStarted)
    return ends(Exit::checkFailed, "Not started: " + exercise.studentFile().string() +
                                       " has no answer yet that could be looked at.");
  const CheckResult* failing = nullptr;
  for (const auto& check : result.checks) {
    const bool asked = checkName.empty() || check.name == checkName || check.title == checkName;
    const bool fails = check.status == Status::wrong || check.status == Status::stopped;
    if (asked && fails && !failing) failing = &check;
  }
  if (!failing) {
    return ends(Exit::pass, checkName.empty() ? "Nothing fails: there is nothing to debug."
                                              : "The check '" + checkName + "' does not fail.");
  }
  if (exercise.isTest() && failing->name != kPassesOnRight) {
    return ends(Exit::checkFailed,
                "Your cases are right; they do not catch enough. That is for thinking, not for a "
                "debugger:\n" +
                    failing->reason);
  }
  session.check = failing->name;
  session.failure = failing->failure;

  const fs::path folder = project.build / "debug" / exercise.id;
  fs::create_directories(folder);
  const fs::path source = project.root / exercise.studentFile();
  const auto compiled = compileSubmission(project, exercise, source, folder, 0, nullptr,
                                          {"-O0", "-g3", "-fno-omit-frame-pointer"});
  if (!compiled.ok) return ends(Exit::doesNotCompile, compiled.firstError);
  Stop stop;
  if (exercise.isTest()) {
    const fs::path program = linkCases(project, exercise, compiled.object, folder);
    // Catch2 stops at an assertion that fails when a debugger watches.
    stop.arguments = {"--break"};
    session.source = "the assertion that fails";
    session.command = debuggerCommand(program, stop, session.installed);
    leaveForEditors(project, program, stop);
    return session;
  }
  const fs::path program = linkSelfCheck(project, exercise, compiled.object, folder);
  const auto names =
      definedFunctions(project, project.entry(exercise).at("library_object").get<std::string>());
  long number = 1;
  if (session.failure.is_object()) number = session.failure.value("number", 1L);
  stop.environment = {"CAROM_DEBUG_QUESTION=" + std::to_string(number)};
  stop.functions = {"carom::grading::theQuestion"};
  stop.functions.insert(stop.functions.end(), names.begin(), names.end());
  stop.arguments = {session.check};
  session.source = names.empty() ? "the question" : names.front();
  session.command = debuggerCommand(program, stop, session.installed);
  leaveForEditors(project, program, stop);
  return session;
}

int debugExercise(const Project& project, const Exercise& exercise, const std::string& checkName,
                  bool printOnly, bool asJson) {
  const DebugSession session = prepareDebugging(project, exercise, checkName);
  if (asJson) {
    std::cout << json{{"id", exercise.id},
                      {"check", session.check},
                      {"failure", session.failure},
                      {"command", session.command},
                      {"installed", session.installed},
                      {"message", session.message}}
                     .dump(1)
              << "\n";
    return session.exitCode;
  }
  if (session.command.empty()) {
    std::cout << session.message << "\n";
    return session.exitCode;
  }
  std::cout << "Check: " << session.check << "\n";
  if (session.failure.is_object()) {
    std::cout << "Asked: " << session.failure.value("call", "") << "\n";
    for (const auto& given : session.failure.value("given", json::array()))
      std::cout << "For: " << given[0].get<std::string>() << " = " << given[1].get<std::string>()
                << "\n";
  }
  std::cout << "Stops at: " << session.source << "\n"
            << "Command: " << shellText(session.command) << "\n";
  if (printOnly) return Exit::pass;
  if (!session.installed) {
    std::cout
        << "There is no debugger here. Install one, then try again: sudo apt-get install gdb\n";
    return Exit::usage;
  }
  std::cout << "In the debugger: n for the next line, s to step into a call, p x to print x, q to "
               "quit.\n"
            << std::flush;
  std::vector<char*> words;
  for (const auto& word : session.command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words[0], words.data());
  throw Failure{ourFault, session.command.front() + " cannot be started"};
}

}  // namespace carom::runner
