#pragma once
// In a student's copy of the course the graders and the library stand on the student's own functions. One that is not
// written yet is neither the student's mistake in this exercise nor the course's.

#include "runner/check.hpp"

namespace carom::runner {

/// The function of which a program's output says that it is not written yet; empty: none.
std::string missingFunction(std::string_view output);

/// Of a check that ended because a function of another exercise is not written: it was not run, and the reason names
/// that exercise. Where it is the exercise's own function, it is not started.
void nameMissing(const Project& project, const Exercise& exercise, CheckResult& check);

}  // namespace carom::runner
