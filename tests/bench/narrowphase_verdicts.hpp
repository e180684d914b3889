#pragma once
// Do two triangles of the plane, or two tetrahedra, have a point in common? Time and wrong answers.
//
// The corners are whole numbers, or tenths of them, which no double hits (cases D4 and D7). CGAL's
// exact numbers are the judge; without CGAL there is nothing to report.

#include <string>
#include <vector>

#include "bench/bench.hpp"

namespace carom::bench {

/// One method on one set of pairs.
struct VerdictRow {
  std::string method;
  bool plane = true;       ///< triangles, or tetrahedra
  bool tenths = false;     ///< or whole numbers
  Timing time;             ///< per pair
  std::size_t asked = 0;   ///< pairs
  std::size_t wrong = 0;   ///< answers that differ from the judge's
  std::size_t common = 0;  ///< pairs that have a point in common
};

/// Every method on every set.
std::vector<VerdictRow> raceOfVerdicts(const Options& options);

}  // namespace carom::bench
