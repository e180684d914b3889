#include "carom/toi/whole_number.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "carom/core/expect.hpp"

namespace carom {
namespace {

using Digit = std::uint64_t;
__extension__ using TwoDigits = unsigned __int128;
constexpr int kDigitBits = 64;

bool isSmaller(const std::vector<Digit>& a, const std::vector<Digit>& b) {
  if (a.size() != b.size()) return a.size() < b.size();
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

}  // namespace

WholeNumber::WholeNumber(int value) : negative_(value < 0) {
  const auto size = static_cast<std::int64_t>(value);
  if (value != 0) digits_.push_back(static_cast<Digit>(negative_ ? -size : size));
}

WholeNumber WholeNumber::inUnits(Real value, int exponent) {
  WholeNumber result;
  if (value == 0) return result;
  int power = 0;
  const Real mantissa = std::frexp(std::abs(value), &power);
  Digit whole = static_cast<Digit>(std::ldexp(mantissa, 53));
  int shift = power - 53 - exponent;
  if (shift < 0) {
    // The unit divides the value, so only zeros leave on the right.
    CAROM_EXPECT(std::countr_zero(whole) >= -shift, "the unit must divide the value");
    whole >>= -shift;
    shift = 0;
  }
  result.negative_ = value < 0;
  result.digits_.push_back(whole);
  result <<= shift;
  return result;
}

int WholeNumber::sign() const {
  if (digits_.empty()) return 0;
  return negative_ ? -1 : 1;
}

int WholeNumber::bits() const {
  if (digits_.empty()) return 0;
  return kDigitBits * static_cast<int>(digits_.size()) - std::countl_zero(digits_.back());
}

Real WholeNumber::towardsZero(int shift) const {
  // The 53 highest bits are the double; fewer where the lowest would be below the smallest double.
  const int lowest = std::max(bits() - 53, shift - 1074);
  Digit kept = 0;
  for (int i = std::max(lowest, 0); i < bits(); ++i) {
    const Digit bit = digits_[static_cast<std::size_t>(i / kDigitBits)] >> (i % kDigitBits) & 1;
    kept |= bit << (i - std::max(lowest, 0));
  }
  const Real size = std::ldexp(static_cast<Real>(kept), std::max(lowest, 0) - shift);
  return negative_ ? -size : size;
}

WholeNumber& WholeNumber::operator+=(const WholeNumber& other) {
  addMagnitude(other, other.negative_);
  return *this;
}

WholeNumber& WholeNumber::operator-=(const WholeNumber& other) {
  addMagnitude(other, !other.negative_);
  return *this;
}

void WholeNumber::addMagnitude(const WholeNumber& other, bool otherNegative) {
  if (other.digits_.empty()) return;
  if (digits_.empty()) negative_ = otherNegative;
  if (negative_ == otherNegative) {
    // Same sign: add, and carry.
    const std::vector<Digit>& b = other.digits_;
    const std::size_t count = b.size();
    if (digits_.size() < count) digits_.resize(count, 0);
    Digit carry = 0;
    for (std::size_t i = 0; i < digits_.size() && (i < count || carry != 0); ++i) {
      const TwoDigits sum = TwoDigits(digits_[i]) + (i < count ? b[i] : 0) + carry;
      digits_[i] = static_cast<Digit>(sum);
      carry = static_cast<Digit>(sum >> kDigitBits);
    }
    if (carry != 0) digits_.push_back(carry);
    return;
  }
  // Opposite signs: the smaller from the larger, and borrow.
  const bool otherIsLarger = isSmaller(digits_, other.digits_);
  if (otherIsLarger) digits_.resize(other.digits_.size(), 0);
  Digit borrow = 0;
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const Digit mine = digits_[i];
    const Digit theirs = i < other.digits_.size() ? other.digits_[i] : 0;
    const Digit from = otherIsLarger ? theirs : mine, taken = otherIsLarger ? mine : theirs;
    digits_[i] = from - taken - borrow;
    borrow = from < taken || (from == taken && borrow != 0) ? 1 : 0;
  }
  if (otherIsLarger) negative_ = otherNegative;
  dropZeros();
}

WholeNumber& WholeNumber::operator<<=(int shift) {
  if (digits_.empty() || shift == 0) return *this;
  const int within = shift % kDigitBits;
  if (within != 0) {
    const Digit out = digits_.back() >> (kDigitBits - within);
    for (std::size_t i = digits_.size(); i-- > 1;) {
      digits_[i] = digits_[i] << within | digits_[i - 1] >> (kDigitBits - within);
    }
    digits_.front() <<= within;
    if (out != 0) digits_.push_back(out);
  }
  digits_.insert(digits_.begin(), static_cast<std::size_t>(shift / kDigitBits), 0);
  return *this;
}

WholeNumber operator*(const WholeNumber& a, const WholeNumber& b) {
  WholeNumber product;
  if (a.digits_.empty() || b.digits_.empty()) return product;
  const std::size_t m = a.digits_.size(), n = b.digits_.size();
  product.negative_ = a.negative_ != b.negative_;
  product.digits_.assign(m + n, 0);
  for (std::size_t i = 0; i < m; ++i) {
    Digit carry = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const TwoDigits sum = TwoDigits(a.digits_[i]) * b.digits_[j] + product.digits_[i + j] + carry;
      product.digits_[i + j] = static_cast<Digit>(sum);
      carry = static_cast<Digit>(sum >> kDigitBits);
    }
    product.digits_[i + n] = carry;
  }
  product.dropZeros();
  return product;
}

void WholeNumber::dropZeros() {
  while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  if (digits_.empty()) negative_ = false;
}

}  // namespace carom
