#pragma once
// What a Failure of the runner says.

#include <string>

#include "runner/text.hpp"
#include "support/catch.hpp"

namespace carom_test {

/// The message of the Failure that `call` ends in; fails the test when there is none.
template <class F>
std::string failureOf(F&& call) {
  try {
    call();
  } catch (const carom::runner::Failure& failure) {
    return failure.message;
  }
  FAIL("no Failure was thrown");
  return "";
}

}  // namespace carom_test
