#pragma once
// A debugger, started at the question that goes wrong.

#include "runner/check.hpp"

namespace carom::runner {

/// What to start, and why just there.
struct DebugSession {
  std::vector<std::string>
      command;  ///< the debugger and its arguments; the debugger's name alone if none is there
  bool installed = false;  ///< is there a debugger on this machine?
  std::string check;       ///< the check that fails; empty: none
  nlohmann::json failure;  ///< the question, as in a report
  std::string source;      ///< where the breakpoint is, in words
  int exitCode =
      Exit::pass;       ///< of what ends here: it does not compile, is refused, was not started
  std::string message;  ///< and why
};

/// Finds the first check that fails (or the one named), compiles the answer without optimisation and with everything
/// that a debugger wants to know, and links it with the tests. Of test cases (kind test) the debugger stops at the
/// assertion that fails on the right version.
/// \param checkName the check to look at; empty: the first that fails
/// \throws Failure (usage) for a prediction, and for a check that the exercise does not have
DebugSession prepareDebugging(const Project& project, const Exercise& exercise,
                              const std::string& checkName);

/// A command as a shell reads it.
std::string shellText(const std::vector<std::string>& command);

/// The whole verb: prints what fails and the command, and becomes the debugger unless `printOnly`.
int debugExercise(const Project& project, const Exercise& exercise, const std::string& checkName,
                  bool printOnly, bool asJson);

}  // namespace carom::runner
