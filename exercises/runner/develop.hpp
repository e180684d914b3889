#pragma once
// For authors: new exercises, skeletons and fingerprints kept in step, and the proof that every exercise does what
// it should.

#include "runner/check.hpp"

namespace carom::runner {

/// What `dev new` is told.
struct NewExercise {
  std::string chapter;
  std::string
      name;  ///< file name of the function: sat_boxes; of a prediction or of test cases: any
  std::string kind = "implement";  ///< implement, fix, measure, predict, test
  std::string tests = {};          ///< kind test: the exercise whose function the cases are about
};

/// Writes the files of a new exercise. The function is in the library already (or beside the chapter's programs):
/// from its header and source come the worked answer, the seam, and a grader that compiles and asks nothing yet.
/// Returns what was written, relative to the project.
/// \throws Failure (usage) for names that cannot be, and where the function is missing
std::vector<std::string> newExercise(const Project& project, const NewExercise& wanted);

/// Why the build does not know an exercise: files that are missing. Empty: nothing is.
std::vector<std::string> missingFiles(const Project& project, const Exercise& exercise);

/// Cuts all skeletons and measures all fingerprints anew. A skeleton that a student has edited is left alone
/// unless `force`. Returns what was written, relative to the project.
std::vector<std::string> syncExercises(const Project& project,
                                       const std::vector<const Exercise*>& which, bool force);

/// Proves everything that an exercise promises; see docs/teachers.md for the list.
/// `quick`: the skeleton, the solution and one wrong version, through the pipe, and the texts.
/// Returns {"exercises": [...], "problems": [...]}.
nlohmann::json checkAll(const Project& project, const std::vector<const Exercise*>& which,
                        bool progress, bool quick);

}  // namespace carom::runner
