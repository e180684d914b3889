#pragma once
// What the runner shows: on a terminal in colour and in columns; elsewhere, and for who listens to it, plain.
//
// Plain output is for screen readers, Braille lines and programs: ASCII, no colour, no table, no symbol in place of a
// word; a statement a line, and each verdict's line says on its own which exercise and check it is about.

#include "runner/state.hpp"

namespace carom::runner {

struct View {
  bool colour = false;
  bool plain = false;
  std::string good(const std::string& text) const;
  std::string bad(const std::string& text) const;
  std::string dim(const std::string& text) const;
  std::string strong(const std::string& text) const;
};

/// The verdict in full: one failure told completely, the others counted.
std::string describe(const ExerciseResult& result, const Project& project, const View& view,
                     int hintsLeft);
/// A table of exercises with what has been done.
std::string listing(const Project& project, const State& state,
                    const std::vector<const Exercise*>& which, const View& view);
/// Title, statement, checks.
std::string statement(const Exercise& exercise, const View& view);

}  // namespace carom::runner
