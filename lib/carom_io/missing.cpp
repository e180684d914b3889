// What does a program say when it meets a function that is not written yet?
//
// In a student's copy of the course the library stands on the student's own functions. A skeleton
// throws NotAttempted, which programs do not catch: the exercise is named here, and the program
// ends with the exit code of `course` for "stopped". Linked into chapter programs there, and only
// there.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "carom/core/errors.hpp"

namespace {

struct Asked {
  const char* function;
  const char* exercise;
  bool later;  // of a chapter that is not here yet
};

// The names are those that the skeletons pass to todo(); CMake collects them.
constexpr Asked kAsked[] = {
#include "exercises.inc"
    {"", "", false}};

std::terminate_handler usual = nullptr;

void tell(const std::string& message) {
  std::cout.flush();
  std::fflush(stdout);
  std::string text = "This program stands on a function of an exercise: " + message + ".\n";
  for (const Asked& asked : kAsked) {
    if (message.rfind(std::string(asked.function) + " ", 0) != 0) continue;
    text += asked.later
                ? std::string("It is ") + asked.exercise + ", of a chapter that comes later.\n"
                : std::string("  ./course show ") + asked.exercise + "\n";
  }
  std::fputs(text.c_str(), stderr);
}

[[noreturn]] void end() {
  if (const auto current = std::current_exception()) {
    try {
      std::rethrow_exception(current);
    } catch (const carom::NotAttempted& missing) {
      tell(missing.what());
      std::_Exit(3);
    } catch (...) {
    }
  }
  if (usual) usual();
  std::abort();
}

[[maybe_unused]] const bool installed = [] {
  usual = std::set_terminate(end);
  return true;
}();

}  // namespace
