#pragma once
// Part of the suite `toi`: solids that move and turn.

#include "bench/bench.hpp"

namespace carom::bench {

/// Runs all ways to search for the first contact of two hulls on families of pairs, prints a table
/// and draws `first_contact.svg` where the options ask for diagrams.
/// \return rows for the JSON file
Json raceBodies(const Options& options);

}  // namespace carom::bench
