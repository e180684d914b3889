#pragma once
// Part of the suite `toi`: a vertex against a face and an edge against an edge (W11).

#include "bench/bench.hpp"

namespace carom::bench {

/// Runs all methods on all queries, prints a table and draws `vertex_face.svg` where the options
/// ask for diagrams. The queries are the public ones where CAROM_CCD_QUERIES_DIR was given, else
/// the project's own.
/// \return rows for the JSON file
Json raceFeatures(const Options& options);

}  // namespace carom::bench
