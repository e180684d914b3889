#pragma once
// How does a list that is written anew in each step stop asking for memory?
//
// Method: when its room is too small it gets twice what it needs.
// Why: assign() and reserve() of the standard library take no more than they are told to, so a list
// that grows by one element a step asks for memory in every step.
// Not handled: giving room back.

#include <cstddef>

namespace carom {

/// Gives a list room for a number of elements, and for as many again if it has to ask for memory.
/// \param list keeps its elements \param count how many elements it is going to have
/// \ingroup core
template <class List>
void reserveAhead(List& list, std::size_t count) {
  if (list.capacity() < count) list.reserve(2 * count);
}

}  // namespace carom
