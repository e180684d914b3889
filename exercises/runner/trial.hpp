#pragma once
// The branches of a course, built and checked as students would, in a folder of their own.

#include "runner/leaks.hpp"
#include "runner/student_tree.hpp"

namespace carom::runner {

struct Trial {
  std::vector<std::string> problems;
  std::vector<Leak> leaks;  ///< in the site
  int exercises = 0;
  int pages = 0;            ///< of the site that were read; 0: it was not built
  std::string withoutSite;  ///< why not
};

/// Clones a repository, builds the student branch and then the solution branch in that folder, and asks the course's
/// own checks: skeletons are not started, worked answers pass, wrong versions are named, and no hidden check is there.
Trial tryBranches(const Cut& cut, const SecretLines& secrets, const Git& repository,
                  const std::string& student, const std::string& solved, const fs::path& folder);

}  // namespace carom::runner
