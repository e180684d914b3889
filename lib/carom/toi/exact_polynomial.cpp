#include "carom/toi/exact_polynomial.hpp"

#include <algorithm>
#include <utility>

namespace carom {
namespace {

using Coefficients = std::vector<WholeNumber>;

// Halvings after which multiple roots are suspected where Descartes' rule is still undecided. Any
// number is right; a smaller one costs a division of polynomials more often.
constexpr int kPatience = 64;
// Below this a root is an exact zero or shows no digit in a double.
constexpr int kLowestBit = 1074;
constexpr int kDoubleBits = 53;

DyadicCell lowerHalf(const DyadicCell& cell) {
  DyadicCell half = cell;
  half.m <<= 1;
  ++half.e;
  return half;
}

DyadicCell upperHalf(const DyadicCell& cell) {
  DyadicCell half = lowerHalf(cell);
  half.m += 1;
  return half;
}

// p(x) becomes p(x + by), in place (Horner).
void shiftArgument(Coefficients& c, const WholeNumber* by) {
  const std::size_t n = c.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    for (std::size_t j = n - 1; j-- > i;) c[j] += by ? *by * c[j + 1] : c[j + 1];
  }
}

int signChanges(const Coefficients& c) {
  int changes = 0, last = 0;
  for (const WholeNumber& number : c) {
    const int sign = number.sign();
    if (sign == 0) continue;
    if (last != 0 && sign != last) ++changes;
    last = sign;
  }
  return changes;
}

int firstSign(const Coefficients& c) {
  for (const WholeNumber& number : c) {
    if (number.sign() != 0) return number.sign();
  }
  return 0;
}

}  // namespace

ExactPolynomial::ExactPolynomial(std::vector<WholeNumber> coefficients)
    : coefficients_(std::move(coefficients)) {
  while (!coefficients_.empty() && coefficients_.back().sign() == 0) coefficients_.pop_back();
}

int ExactPolynomial::signAt(const DyadicCell& cell) const {
  // Horner with m and powers of two instead of m / 2^e: the sum is p times 2^(e degree).
  WholeNumber sum;
  for (int i = degree(); i >= 0; --i) {
    WholeNumber scaled = coefficients_[static_cast<std::size_t>(i)];
    scaled <<= cell.e * (degree() - i);
    if (sum.sign() != 0) sum = sum * cell.m;
    sum += scaled;
  }
  return sum.sign();
}

std::vector<WholeNumber> ExactPolynomial::bernstein(const DyadicCell& cell) const {
  // Powers of x = 2^e t - m, which runs from 0 to 1 on the cell.
  Coefficients c = coefficients_;
  for (int i = 0; i <= degree(); ++i) c[static_cast<std::size_t>(i)] <<= cell.e * (degree() - i);
  if (cell.m.sign() != 0) shiftArgument(c, &cell.m);
  // (1 + y)^n p(1 / (1 + y)): its coefficient of y^(n - j) is binomial(n, j) b_j.
  std::reverse(c.begin(), c.end());
  shiftArgument(c, nullptr);
  std::reverse(c.begin(), c.end());
  return c;
}

ExactPolynomial ExactPolynomial::derivative() const {
  Coefficients c;
  for (int i = 1; i <= degree(); ++i) c.push_back(coefficients_[static_cast<std::size_t>(i)] * i);
  return ExactPolynomial(c);
}

// Division without fractions: a power of the leading coefficient times this = quotient * divisor +
// remainder.
ExactPolynomial ExactPolynomial::remainder(const ExactPolynomial& divisor,
                                           std::vector<WholeNumber>* quotient) const {
  ExactPolynomial rest = *this;
  const WholeNumber& leading = divisor.coefficients_.back();
  if (quotient) quotient->assign(static_cast<std::size_t>(degree() - divisor.degree() + 1), {});
  while (rest.degree() >= divisor.degree()) {
    const WholeNumber factor = rest.coefficients_.back();
    const auto shift = static_cast<std::size_t>(rest.degree() - divisor.degree());
    for (WholeNumber& c : rest.coefficients_) c = c * leading;
    for (std::size_t i = 0; i < divisor.coefficients_.size(); ++i) {
      rest.coefficients_[i + shift] -= factor * divisor.coefficients_[i];
    }
    if (quotient) {
      for (WholeNumber& c : *quotient) c = c * leading;
      (*quotient)[shift] += factor;
    }
    rest = ExactPolynomial(std::move(rest.coefficients_));
  }
  return rest;
}

ExactPolynomial commonDivisor(ExactPolynomial a, ExactPolynomial b) {
  if (a.degree() < b.degree()) std::swap(a, b);
  while (!b.isZero()) {
    ExactPolynomial rest = a.remainder(b, nullptr);
    a = std::move(b);
    b = std::move(rest);
  }
  return a;
}

ExactPolynomial ExactPolynomial::withoutMultipleRoots() const {
  const ExactPolynomial repeated = commonDivisor(*this, derivative());
  if (repeated.degree() < 1) return *this;
  Coefficients quotient;
  remainder(repeated, &quotient);
  return ExactPolynomial(quotient);
}

ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b) {
  Coefficients c = a.coefficients_;
  c.resize(std::max(a.coefficients_.size(), b.coefficients_.size()));
  for (std::size_t i = 0; i < b.coefficients_.size(); ++i) c[i] += b.coefficients_[i];
  return ExactPolynomial(c);
}

ExactRoot::ExactRoot(DyadicCell cell) : cell_(std::move(cell)), isLowerEnd_(true) {}

ExactRoot::ExactRoot(const ExactPolynomial& polynomial, DyadicCell cell)
    : polynomial_(polynomial), cell_(std::move(cell)) {
  signBelow_ = firstSign(polynomial_.bernstein(cell_));
}

// One binary digit more.
void ExactRoot::halve() {
  DyadicCell upper = upperHalf(cell_);
  const int sign = polynomial_.signAt(upper);
  if (sign == 0) isLowerEnd_ = true;
  cell_ = sign == 0 || sign == signBelow_ ? std::move(upper) : lowerHalf(cell_);
}

// As many digits as a double has.
void ExactRoot::sharpen() {
  while (!isLowerEnd_ && cell_.m.bits() < kDoubleBits && cell_.e < kLowestBit) halve();
}

int ExactRoot::signOf(const ExactPolynomial& q) {
  if (q.isZero()) return 0;
  bool sharesNone = false;
  for (;; halve()) {
    if (isLowerEnd_) return q.signAt(cell_);
    const Coefficients b = q.bernstein(cell_);
    // A zero at an end is none inside.
    if (signChanges(b) == 0) return firstSign(b);
    if (!sharesNone) {
      const ExactPolynomial common = commonDivisor(polynomial_, q);
      if (common.degree() > 0) {
        // Its roots are roots of the polynomial, of which there is one in here, and a simple one.
        if (signChanges(common.bernstein(cell_)) % 2 == 1) return 0;
      }
      sharesNone = true;
    }
  }
}

Real ExactRoot::roundedDown() {
  sharpen();
  return cell_.m.towardsZero(cell_.e);
}

std::vector<ExactRoot> rootsInUnitInterval(const ExactPolynomial& polynomial) {
  std::vector<ExactRoot> roots;
  ExactPolynomial p = polynomial;
  bool isSimple = false;
  std::vector<DyadicCell> open = {{}};
  while (!open.empty()) {
    const DyadicCell cell = std::move(open.back());
    open.pop_back();
    const Coefficients b = p.bernstein(cell);
    // The lower end of a lower half has been looked at before.
    if (b.front().sign() == 0 && (cell.e == 0 || cell.m.isOdd())) roots.emplace_back(cell);
    const int changes = signChanges(b);
    if (changes == 1) roots.emplace_back(p, cell);
    if (changes <= 1) continue;
    if (cell.e >= kPatience && !isSimple) {
      // Once more from the start, with each root once: then the halving comes to an end.
      p = p.withoutMultipleRoots();
      isSimple = true;
      roots.clear();
      open = {{}};
      continue;
    }
    open.push_back(upperHalf(cell));
    open.push_back(lowerHalf(cell));
  }
  const DyadicCell one{1, 0};
  if (p.signAt(one) == 0) roots.emplace_back(one);
  return roots;
}

}  // namespace carom
