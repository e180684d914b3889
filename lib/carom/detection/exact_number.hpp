#pragma once
// A number without rounding, for the cases that rounding would decide.
//
// Sums and products of doubles, kept as a list of doubles that do not overlap, smallest first
// (expansions: Shewchuk, Discrete & Computational Geometry 18, 1997). The largest entry has the
// sign of the number. Two boxes that touch exactly have a gap of zero in this arithmetic, whatever
// the directions of their faces.
// Why so late: a product of two lists multiplies their lengths, so an axis costs microseconds. Only
// axes whose gap in doubles is within its own error of zero come here.
// Not handled: overflow, and products of doubles below 1e-290; no division.

#include <vector>

#include "carom/core/real.hpp"
#include "carom/core/two_sum.hpp"
#include "carom/precision/grow_expansion.hpp"

namespace carom {

/// A polynomial of doubles, exactly.
/// \ingroup detection
class ExactNumber {
 public:
  /// Zero.
  ExactNumber() = default;
  /// A double, exactly. Implicit, so that formulas mix both. \param value any finite number
  ExactNumber(Real value) {
    if (value != 0) parts_.push_back(value);
  }

  /// Adds another number. \param other any number \return this number
  ExactNumber& operator+=(const ExactNumber& other) {
    for (const Real part : other.parts_) growExpansion(parts_, part);
    return *this;
  }

  /// The same with the other sign. \return minus this number
  ExactNumber operator-() const {
    ExactNumber result = *this;
    for (Real& part : result.parts_) part = -part;
    return result;
  }

  /// Sum. \param a first term \param b second term \return a + b
  friend ExactNumber operator+(ExactNumber a, const ExactNumber& b) {
    a += b;
    return a;
  }

  /// Difference. \param a first term \param b second term \return a - b
  friend ExactNumber operator-(ExactNumber a, const ExactNumber& b) {
    for (const Real part : b.parts_) growExpansion(a.parts_, -part);
    return a;
  }

  /// Product. \param a first factor \param b second factor \return a b
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
    ExactNumber result;
    for (const Real x : a.parts_) {
      for (const Real y : b.parts_) {
        const TwoProduct p = twoProduct(x, y);
        growExpansion(result.parts_, p.error);
        growExpansion(result.parts_, p.product);
      }
    }
    return result;
  }

  /// The sign. \return -1, 0 or 1
  int sign() const {
    if (parts_.empty()) return 0;
    return parts_.back() > 0 ? 1 : -1;
  }

  /// The number as a double. \return the value, right to one unit in the last place
  Real value() const {
    Real sum = 0;
    for (const Real part : parts_) sum += part;
    return sum;
  }

 private:
  std::vector<Real> parts_;  // increasing in size, not overlapping, none zero
};

/// The absolute value. \param a any number \return |a| \ingroup detection
inline ExactNumber absolute(const ExactNumber& a) {
  return a.sign() < 0 ? -a : a;
}

}  // namespace carom
