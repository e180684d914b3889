#pragma once
// How often is memory asked for, and how much is taken?
//
// The program that links this answers malloc itself, counts, and passes on to the C library: so all
// that runs in it is counted, also what is behind `new` and in the shared libraries of peers.
// Not handled: memory that a library maps for itself.

#include "carom/core/real.hpp"

namespace carom::bench {

/// How often malloc, calloc and realloc were called so far.
long allocationsSoFar();

/// What is taken of the heap now, large blocks included [bytes].
Real bytesTaken();

}  // namespace carom::bench
