#pragma once
// For authors: new exercises, skeletons and fingerprints kept in step, and the proof that every exercise does what
// it should.

#include "runner/check.hpp"

namespace carom::runner {

/// Writes the files of a new exercise, ready to be filled in.
void newExercise(const Project& project, const std::string& chapter, const std::string& name);

/// Cuts all skeletons and measures all fingerprints anew. A skeleton that a student has edited is left alone
/// unless `force`. Returns what was written, relative to the project.
std::vector<std::string> syncExercises(const Project& project,
                                       const std::vector<const Exercise*>& which, bool force);

/// Proves everything that an exercise promises; see docs/teachers.md for the list.
/// Returns {"exercises": [...], "problems": [...]}.
nlohmann::json checkAll(const Project& project, const std::vector<const Exercise*>& which,
                        bool progress);

}  // namespace carom::runner
