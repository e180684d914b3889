#pragma once
// Branches for a course: what students get, and what teachers show afterwards.

#include <string>
#include <vector>

#include "runner/leaks.hpp"
#include "runner/manifest.hpp"
#include "runner/student_tree.hpp"

namespace carom::runner {

struct BranchOptions {
  std::string upto;                 ///< last chapter; empty: all
  fs::path courseFile;              ///< empty: all exercises, and no answer shows
  std::string today;                ///< the day for dates; empty: today
  std::string student = "student";  ///< name of the branch for students
  std::string solved = "solved";    ///< name of the branch with the answers
  fs::path out;                     ///< a bare repository for both; empty: the project's own
  bool build = true;                ///< build the branches in a clean folder and run their checks
};

/// Cuts the student branch and the solution branch from the last commit, proves that no answer is left, tries both,
/// and only then moves the branches and tags, all at once. The user's files, index and current branch stay as they are.
/// \return the exit code of the program: 1 when an answer was left, or a check of the branches failed
/// \throws Failure
int cutBranches(const Project& project, const BranchOptions& options);

/// The answers that are left in the history of a commit: lines, and whole files that must not be there.
std::vector<Leak> leaksInHistory(const Cut& cut, const SecretLines& secrets, const Git& git,
                                 const std::string& commit, const fs::path& scratch);

/// The lines that are kept secret for a cut.
SecretLines secretLines(const Cut& cut);

}  // namespace carom::runner
