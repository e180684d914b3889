#pragma once
// Checks an exercise each time its file is saved.

#include "runner/view.hpp"

namespace carom::runner {

/// Watches until q, end of input or Ctrl-C, by reading the file again and again (file_watch.hpp). Never jumps to
/// another exercise by itself.
int watch(Project& project, const Exercise* exercise, const View& view);

/// The first exercise that has not been passed, or nothing.
const Exercise* nextExercise(const Project& project, const State& state);

/// The hint with this number, from 1.
std::string hintText(const Exercise& exercise, int number);

/// Puts the skeleton back and keeps what was there in .carom/backup. Returns where the copy is ("" if none).
std::string resetExercise(const Project& project, const Exercise& exercise);

}  // namespace carom::runner
