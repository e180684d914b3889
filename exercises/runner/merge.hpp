#pragma once
// Joins reports that were made one by one elsewhere: by jobs of a CI system, or by several people.

#include <vector>

#include "runner/text.hpp"

namespace carom::runner {

/// Writes the records of all folders, and the reports made from them, into one.
/// \param folders what `course teach grade` has written; of a folder that holds none itself, the
/// folders in it are taken, as CI systems unpack the results of their jobs
/// \param out where to; may hold the records of an earlier merge, which are then joined too
/// \return 0; 70 when something was not graded through a fault of ours
/// \throws Failure (usage) naming the folders and the reason, when they are of different courses,
/// versions or seeds, and naming every student who is in two of them with different results
int mergeReports(const std::vector<fs::path>& folders, const fs::path& out);

}  // namespace carom::runner
