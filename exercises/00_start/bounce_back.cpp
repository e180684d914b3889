// Exercise 00.bounce_back: how bouncy must a ball be to come back to a given height?
// Check it with: ./course check 00.bounce_back

#include "bounce_back.hpp"

#include <cmath>

#include "carom/core/checks.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Real restitutionForHeight(Real dropHeight, Real returnHeight) {
  // Given: heights that cannot be are refused.
  requirePositive(dropHeight, "dropHeight");
  requireNonNegative(returnHeight, "returnHeight");
  if (returnHeight > dropHeight) {
    reject("returnHeight", toText(returnHeight),
           "must not exceed dropHeight " + toText(dropHeight));
  }
  // With which speed does the ball arrive, and with which must it leave? Return their ratio.
  return todo<Real>("restitutionForHeight");
}

}  // namespace carom
