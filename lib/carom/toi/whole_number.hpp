#pragma once
// A whole number of any size, for what must not be rounded at all.
//
// Every double is a whole number times a power of two, so sums and products of doubles become sums
// and products of whole numbers once a common power of two is taken out. Sign and digits apart,
// digits of 64 bits, smallest first; the school methods of adding and multiplying.
// Why not expansions (detection/exact_number.hpp): the remainders of polynomials multiply sixteen
// coordinates, whose lowest bits would fall below the smallest double. Why not Karatsuba: the
// numbers have 2 to 20 digits.
// Not handled: division; nothing here needs it.

#include <cstdint>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// An integer without a largest value. \ingroup toi
class WholeNumber {
 public:
  /// Zero.
  WholeNumber() = default;
  /// A small number. Implicit, so that formulas mix both. \param value any integer
  WholeNumber(int value);

  /// A double, exactly, in units of a power of two: the result times 2^exponent is the value.
  /// \param value any finite number that is a multiple of 2^exponent \param exponent of the unit
  /// \return value / 2^exponent
  static WholeNumber inUnits(Real value, int exponent);

  /// The sign. \return -1, 0 or 1
  int sign() const;
  /// Is it odd? \return true if the last bit is set
  bool isOdd() const {
    return !digits_.empty() && digits_.front() % 2 == 1;
  }
  /// How many bits the absolute value has. \return 0 for zero, 1 for one, 2 for two and three
  int bits() const;
  /// The number times 2^-shift as a double, rounded towards zero.
  /// \param shift power of two that is divided by, not negative
  /// \return the nearest double that is not larger in size; zero below the smallest double
  Real towardsZero(int shift) const;

  /// Adds in place. \param other any number \return this number
  WholeNumber& operator+=(const WholeNumber& other);
  /// Subtracts in place. \param other any number \return this number
  WholeNumber& operator-=(const WholeNumber& other);
  /// Times a power of two. \param shift its exponent, not negative \return this number
  WholeNumber& operator<<=(int shift);

  /// Sum. \param a first term \param b second term \return a + b
  friend WholeNumber operator+(WholeNumber a, const WholeNumber& b) {
    a += b;
    return a;
  }
  /// Difference. \param a first term \param b second term \return a - b
  friend WholeNumber operator-(WholeNumber a, const WholeNumber& b) {
    a -= b;
    return a;
  }
  /// Product. \param a first factor \param b second factor \return a b
  friend WholeNumber operator*(const WholeNumber& a, const WholeNumber& b);

 private:
  void addMagnitude(const WholeNumber& other, bool otherNegative);
  void dropZeros();

  bool negative_ = false;              // false for zero
  std::vector<std::uint64_t> digits_;  // smallest first, the last one not zero
};

}  // namespace carom
