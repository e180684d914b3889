#pragma once
// Where are the roots of a polynomial between 0 and 1, and which sign has another one there?
//
// The polynomials of moving points have whole coefficients once a power of two is taken out. Their
// roots are found by halving [0, 1]: Descartes' rule says that an open interval holds no root
// where the Bernstein coefficients do not change their sign, and exactly one where they change it
// once (Collins and Akritas 1976). A root is then an interval [m, m + 1] / 2^e that can be halved
// as often as one likes, so its digits come out as those of a double do, and cutting them off
// rounds down.
// The sign of another polynomial q at a root of p: halve until q has no root in the interval. That
// would go on for ever if both have the same root, which their greatest common divisor tells.
// Why no floating point: whether a vertex just touches an edge is the question whether a
// polynomial is exactly zero at a root of another one.
// Not handled: roots outside [0, 1].

#include <vector>

#include "carom/toi/whole_number.hpp"

namespace carom {

/// The numbers from m / 2^e to (m + 1) / 2^e. \ingroup toi
struct DyadicCell {
  WholeNumber m;  ///< lower end, in cells of this size
  int e = 0;      ///< how often [0, 1] was halved
};

/// A polynomial with whole coefficients. \ingroup toi
class ExactPolynomial {
 public:
  /// The polynomial zero.
  ExactPolynomial() = default;
  /// A polynomial. \param coefficients of 1, t, t^2, ...; zeros at the end are dropped
  explicit ExactPolynomial(std::vector<WholeNumber> coefficients);

  /// The highest power of t. \return -1 for the polynomial zero
  int degree() const {
    return static_cast<int>(coefficients_.size()) - 1;
  }
  /// Is it zero everywhere? \return true if it has no coefficient but zero
  bool isZero() const {
    return coefficients_.empty();
  }

  /// The sign at the lower end of a cell. \param cell any cell \return -1, 0 or 1
  int signAt(const DyadicCell& cell) const;
  /// Multiples of the Bernstein coefficients on a cell, each by a positive factor: their signs are
  /// what counts. \param cell any cell \return degree() + 1 numbers, lower end first
  std::vector<WholeNumber> bernstein(const DyadicCell& cell) const;

  /// The slope. \return the derivative by t
  ExactPolynomial derivative() const;
  /// The same roots, each once. \return p / gcd(p, p') times some number that is not zero
  ExactPolynomial withoutMultipleRoots() const;

  /// The common divisor of highest degree. \param a any polynomial \param b any polynomial
  /// \return gcd(a, b) times some number that is not zero
  friend ExactPolynomial commonDivisor(ExactPolynomial a, ExactPolynomial b);

  /// Sum. \param a first term \param b second term \return a + b
  friend ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b);

 private:
  ExactPolynomial remainder(const ExactPolynomial& divisor,
                            std::vector<WholeNumber>* quotient) const;

  std::vector<WholeNumber> coefficients_;  // the last one is not zero
};

/// One root of a polynomial in [0, 1], known to any number of digits. \ingroup toi
class ExactRoot {
 public:
  /// A number m / 2^e itself. \param cell whose lower end it is
  explicit ExactRoot(DyadicCell cell);
  /// The only root inside a cell, ends excluded. \param polynomial has one simple root there
  /// \param cell where the root is
  ExactRoot(const ExactPolynomial& polynomial, DyadicCell cell);

  /// The sign of another polynomial at this root. \param q any polynomial \return -1, 0 or 1
  int signOf(const ExactPolynomial& q);
  /// The root as a double. \return the largest double that is not above it
  Real roundedDown();

 private:
  void halve();
  void sharpen();

  ExactPolynomial polynomial_;
  DyadicCell cell_;
  bool isLowerEnd_ = false;  // the root is the lower end of the cell, else strictly inside
  int signBelow_ = 0;        // of the polynomial, between the lower end and the root
};

/// All roots in [0, 1], each once, rising. \param polynomial not zero \return its roots
/// \ingroup toi
std::vector<ExactRoot> rootsInUnitInterval(const ExactPolynomial& polynomial);

}  // namespace carom
