#pragma once
// How much work is a formula?
//
// Time depends on the machine; the number of multiplications and additions does not. A formula that
// is written for any kind of number can be run with this one, which counts what is done to it.
// Signs and copies are free. What it does not show: how long the processor waits for memory, and
// how many of the operations it does at once.

#include <cmath>

#include "carom/core/real.hpp"

namespace carom {

/// What a piece of arithmetic took. \ingroup rotation
struct Work {
  int products = 0;  ///< multiplications and divisions
  int sums = 0;      ///< additions and subtractions
  int roots = 0;     ///< square roots
};

//! [counted]
/// A number that counts what is done to it.
/// \ingroup rotation
struct Counted {
  Real value = 0;           ///< the number
  static inline Work work;  ///< what was done since this was set to zero
};

/// Counts a product.
/// \param a factor
/// \param b factor
/// \return a b
/// \ingroup rotation
inline Counted operator*(Counted a, Counted b) {
  ++Counted::work.products;
  return {a.value * b.value};
}
//! [counted]

/// Counts a product. \param a dividend \param b divisor \return a / b \ingroup rotation
inline Counted operator/(Counted a, Counted b) {
  ++Counted::work.products;
  return {a.value / b.value};
}

/// Counts a sum. \param a term \param b term \return a + b \ingroup rotation
inline Counted operator+(Counted a, Counted b) {
  ++Counted::work.sums;
  return {a.value + b.value};
}

/// Counts a sum. \param a term \param b what is taken away \return a - b \ingroup rotation
inline Counted operator-(Counted a, Counted b) {
  ++Counted::work.sums;
  return {a.value - b.value};
}

/// Counts a root. \param a not negative \return the square root \ingroup rotation
inline Counted squareRoot(Counted a) {
  ++Counted::work.roots;
  return {std::sqrt(a.value)};
}

/// Runs something and says what it took. \param run a function without arguments
/// \return the work of all Counted numbers meanwhile \ingroup rotation
template <class Run>
Work workOf(Run run) {
  Counted::work = {};
  run();
  return Counted::work;
}

}  // namespace carom
