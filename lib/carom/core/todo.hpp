#pragma once
// The placeholder in an exercise.
//
// A skeleton must compile and must not answer anything: a zero would sometimes be right. So it
// throws, and the runner says "not started" instead of "wrong".

#include "carom/core/errors.hpp"

namespace carom {

/// Stands where the answer of an exercise will be: `return todo<Real>("signedVolume");`
/// \tparam T the type of the answer that is missing
/// \param function name of the function, for the message
/// \return never; the type lets the skeleton compile
/// \throws NotAttempted always
/// \ingroup core
template <class T>
[[noreturn]] T todo(const char* function) {
  throw NotAttempted(function);
}

}  // namespace carom
