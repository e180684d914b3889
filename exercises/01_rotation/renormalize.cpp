// Exercise 01.renormalize: the quaternion of length 1 in the direction of q.
// Check it with: ./course check 01.renormalize

#include "carom/rotation/renormalize.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/errors.hpp"
#include "carom/core/todo.hpp"

namespace carom {

Quaternion renormalize(const Quaternion& q) {
  // Refuse the zero quaternion (throw InvalidInput("...")), and divide all four numbers by the
  // length. Mind the squares of very large and very small numbers.
  return todo<Quaternion>("renormalize");
}

}  // namespace carom
