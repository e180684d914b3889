#pragma once
// A sum without any error.
//
// The sum is kept as a list of doubles that do not overlap, smallest first; adding a term passes it
// up the list and leaves every rounding error behind (grow-expansion: Shewchuk, Discrete &
// Computational Geometry 18, 1997). The largest of them has the sign of the sum, whatever cancels.
// It costs one error-free sum per entry of the list and term, so it is used where a filter has
// failed. What it does not handle: sums that overflow, infinite terms.

#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// The exact sum of the doubles added to it.
/// \ingroup precision
class ExactSum {
 public:
  /// Nothing added yet, and room for most sums.
  ExactSum() {
    constexpr int kUsual = 16;
    parts_.reserve(kUsual);
  }

  /// Makes it zero again; the memory stays.
  void clear() {
    parts_.clear();
  }

  /// Adds a term. \param term any finite number
  void add(Real term);

  /// Adds the product of three numbers, exactly.
  /// \param a first factor \param b second factor \param c third factor; their product must be 0 or
  ///   between 1e-276 and 1e300 in size, and so must that of a and b
  void addProduct(Real a, Real b, Real c);

  /// Adds the product of four numbers, exactly.
  /// \param a first factor \param b second factor \param c third factor \param d fourth factor;
  ///   their product must be 0 or between 1e-260 and 1e300 in size, and so must ab and cd
  void addProduct(Real a, Real b, Real c, Real d);

  /// The sign of the sum. \return -1, 0 or 1, exactly
  int sign() const;

  /// The sum, rounded to the nearest double (ties to even). \return the sum, rounded once
  Real value() const;

 private:
  std::vector<Real> parts_;  // increasing in size, not overlapping, none zero
};

}  // namespace carom
