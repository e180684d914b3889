#pragma once
// Classes made of what the course itself has: worked answers, skeletons, other right and known
// wrong versions. For measuring the grader, and for proving that it gives each of them what it
// should get.

#include "runner/manifest.hpp"
#include "runner/records.hpp"

namespace carom_test {

/// A class in which each student hands in one kind of version of every exercise: `solution`,
/// `skeleton`, `right-1`, `right-2`, ..., `wrong-1`, `wrong-2`, ... as far as there are that many.
void writeVersions(const std::vector<const carom::runner::Exercise*>& which,
                   const std::filesystem::path& folder);

/// A class of so many students, each with a mixture: about half of the answers right, in one of
/// several ways, a third wrong in a known way, the rest not started. Files of the same version are
/// different files of their author's: each has a comment of its own, except skeletons.
void writeMixture(const std::vector<const carom::runner::Exercise*>& which, int students,
                  const std::filesystem::path& folder);

/// What came out otherwise than it should when the class of writeVersions() was graded, in
/// sentences: a right version that has not all points, a skeleton that has some, a wrong one that
/// has all, that passes its own check, loses one that the catalogue does not name, or is not named.
struct Verdict {
  std::vector<std::string> problems;
  int right = 0;
  int skeletons = 0;
  int wrong = 0;
  int alone = 0;  ///< of these, those whose catalogue names a single check
};
Verdict judge(const std::vector<const carom::runner::Exercise*>& which,
              const carom::runner::Records& records);

}  // namespace carom_test
