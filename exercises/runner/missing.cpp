#include "runner/missing.hpp"

#include <cctype>

namespace carom::runner {

std::string missingFunction(std::string_view output) {
  // Catch2 breaks lines where they get long.
  std::string text;
  for (const auto& word : words(output)) text += word + " ";
  const auto end = text.find(" is not written yet");
  if (end == std::string::npos) return "";
  const auto isName = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  auto begin = end;
  while (begin > 0 && isName(text[begin - 1])) --begin;
  return text.substr(begin, end - begin);
}

void nameMissing(const Project& project, const Exercise& exercise, CheckResult& check) {
  if (check.status != Status::notStarted && check.status != Status::stopped &&
      check.status != Status::ourFault)
    return;
  const std::string function = missingFunction(check.output);
  if (function.empty()) return;
  const auto asksFor = [&](const Exercise& e) {
    const std::string quoted = e.isPrediction() ? function : "\"" + function + "\"";
    return skeletonOf(e).value_or("").find(quoted) != std::string::npos;
  };
  if (asksFor(exercise)) {
    check.status = Status::notStarted;
    check.reason.clear();
    return;
  }
  // Where the course is authored the library has every function.
  if (fs::exists(project.root / "solutions")) return;
  check.status = Status::notRun;
  check.failure = {};
  check.reason = "It stands on " + function + ", of a chapter that comes later.";
  for (const auto& e : project.exercises) {
    if (e.isPrediction() || !asksFor(e)) continue;
    check.reason = "It stands on your function of exercise " + e.id +
                   ", which is not written yet: ./course show " + e.id;
    return;
  }
}

}  // namespace carom::runner
