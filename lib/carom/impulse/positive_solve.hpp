#pragma once
// Three equations with a symmetric, positive matrix: inertia tensors, and the matrix of a contact.
//
// Method: M = L D L^T without square roots; the three numbers in D are positive exactly if the
// matrix is positive definite, so the test comes for free.
// Why not the inverse by cofactors: it multiplies three entries, which leaves the range of the
// doubles for bodies of 1e-120 kg m^2, and a diagonal matrix would not be inverted to the last bit.
// Source: Golub and Van Loan, Matrix Computations, section 4.1.
// Not handled: pivoting, which a positive definite matrix does not need.

#include "carom/core/real.hpp"

namespace carom {

/// A positive definite matrix, taken apart. \ingroup impulse
class PositiveSolve {
 public:
  /// Takes a matrix apart. Only the lower half is read. \param m symmetric matrix [any unit]
  explicit PositiveSolve(const Matrix3& m) {
    d0_ = m(0, 0);
    l10_ = m(1, 0) / d0_;
    l20_ = m(2, 0) / d0_;
    d1_ = m(1, 1) - l10_ * m(1, 0);
    const Real rest = m(2, 1) - l20_ * m(1, 0);
    l21_ = rest / d1_;
    d2_ = m(2, 2) - l20_ * m(2, 0) - l21_ * rest;
  }

  /// \return whether the matrix is positive definite
  bool positive() const {
    return d0_ > 0 && d1_ > 0 && d2_ > 0;
  }

  /// Solves M x = b for a positive definite M. \param b right side [any unit]
  /// \return x [unit of b over that of M]
  Vector3 solve(const Vector3& b) const {
    const Real y1 = b.y() - l10_ * b.x();
    const Real y2 = b.z() - l20_ * b.x() - l21_ * y1;
    const Real z = y2 / d2_;
    const Real y = y1 / d1_ - l21_ * z;
    const Real x = b.x() / d0_ - l10_ * y - l20_ * z;
    return {x, y, z};
  }

  /// \return the inverse, exactly symmetric [1 over the unit of M]
  Matrix3 inverse() const {
    Matrix3 m;
    m.col(0) = solve(Vector3::UnitX());
    m.col(1) = solve(Vector3::UnitY());
    m.col(2) = solve(Vector3::UnitZ());
    return (m + m.transpose()) / 2;
  }

 private:
  Real d0_, d1_, d2_;
  Real l10_, l20_, l21_;
};

}  // namespace carom
