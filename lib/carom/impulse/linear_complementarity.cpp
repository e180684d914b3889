#include "carom/impulse/linear_complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/precision/double_double.hpp"

namespace carom {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// Entries of the scaled tableau below this are what roundings leave of zero: its diagonal starts as
// one, and an elimination of some dozen rows grows errors to some hundred ulp. A larger value hides
// real but weak couplings, a smaller one divides by noise.
constexpr Real kNothing = 1e-11;

// Right sides and ratios nearer to each other than this are taken for equal, so that the order of
// contacts decides and not a rounding. It bounds how negative a result may come out.
constexpr Real kTie = 1e-13;

// The tableau of w - M z - z0 = q. Columns: w, z, z0, right side.
class Tableau {
 public:
  Tableau(const DenseMatrix& M, const std::vector<Real>& q, DenseMatrix& rows,
          std::vector<int>& basis)
      : n_(M.rows()), rows_(rows), basis_(basis) {
    rows_.reset(n_, 2 * n_ + 2);
    basis_.resize(q.size());
    for (int i = 0; i < n_; ++i) {
      basis_[at(i)] = i;
      rows_(i, i) = 1;
      for (int j = 0; j < n_; ++j) rows_(i, n_ + j) = -M(i, j);
      rows_(i, artificial()) = -1;
      rows_(i, rightSide()) = q[at(i)];
    }
  }

  int artificial() const {
    return 2 * n_;
  }
  int basic(int row) const {
    return basis_[at(row)];
  }

  // The row that makes everything feasible when the artificial variable enters there.
  int worstRow() const {
    int worst = 0;
    for (int i = 1; i < n_; ++i) {
      if (lexicographicallyLess(i, -1, worst, -1)) worst = i;
    }
    return worst;
  }

  // The row that leaves when `column` enters, or -1 if none stops it.
  int leavingRow(int column) const {
    int leaving = -1;
    for (int i = 0; i < n_; ++i) {
      const Real pivot = rows_(i, column);
      if (pivot <= kNothing) continue;
      if (leaving < 0) {
        leaving = i;
        continue;
      }
      const Real best = rows_(leaving, column);
      // The artificial variable leaves as soon as it may: then we are done.
      const Real ratio = rows_(i, rightSide()) / pivot, least = rows_(leaving, rightSide()) / best;
      const bool tie = std::abs(ratio - least) <= kTie;
      if (tie && basic(leaving) == artificial()) continue;
      if ((tie && basic(i) == artificial()) || lexicographicallyLess(i, column, leaving, column)) {
        leaving = i;
      }
    }
    return leaving;
  }

  // Makes `column` basic in `row`; returns the variable that leaves.
  int pivot(int row, int column) {
    const Real p = rows_(row, column);
    for (int j = 0; j < rows_.columns(); ++j) rows_(row, j) /= p;
    rows_(row, column) = 1;
    for (int i = 0; i < n_; ++i) {
      const Real factor = rows_(i, column);
      if (i == row || factor == 0) continue;
      for (int j = 0; j < rows_.columns(); ++j) rows_(i, j) -= factor * rows_(row, j);
      rows_(i, column) = 0;
    }
    return std::exchange(basis_[at(row)], column);
  }

  Real value(int row) const {
    return rows_(row, rightSide());
  }

 private:
  int rightSide() const {
    return 2 * n_ + 1;
  }

  // Compares two rows, each divided by its entry in its column (-1: not divided): right side first,
  // then the columns of w from the left.
  bool lexicographicallyLess(int i, int columnI, int j, int columnJ) const {
    const Real di = columnI < 0 ? 1 : rows_(i, columnI);
    const Real dj = columnJ < 0 ? 1 : rows_(j, columnJ);
    const Real first = rows_(i, rightSide()) / di - rows_(j, rightSide()) / dj;
    if (std::abs(first) > kTie) return first < 0;
    for (int k = 0; k < n_; ++k) {
      const Real difference = rows_(i, k) / di - rows_(j, k) / dj;
      if (std::abs(difference) > kTie) return difference < 0;
    }
    return false;
  }

  int n_;
  DenseMatrix& rows_;
  std::vector<int>& basis_;
};

// Gaussian elimination with partial pivoting, kept for several right sides.
class Elimination {
 public:
  // Takes m apart.
  Elimination(DenseMatrix& m, std::vector<int>& order) : m_(m), order_(order) {
    const int n = m_.rows();
    order_.resize(at(n));
    for (int i = 0; i < n; ++i) order_[at(i)] = i;
    for (int k = 0; k < n; ++k) {
      int best = k;
      for (int i = k + 1; i < n; ++i) {
        if (std::abs(m_(i, k)) > std::abs(m_(best, k))) best = i;
      }
      if (!(std::abs(m_(best, k)) > kNothing)) {
        singular_ = true;
        return;
      }
      if (best != k) {
        std::swap(order_[at(k)], order_[at(best)]);
        for (int j = 0; j < n; ++j) std::swap(m_(k, j), m_(best, j));
      }
      for (int i = k + 1; i < n; ++i) {
        m_(i, k) /= m_(k, k);
        for (int j = k + 1; j < n; ++j) m_(i, j) -= m_(i, k) * m_(k, j);
      }
    }
  }

  bool singular() const {
    return singular_;
  }

  void solve(const std::vector<Real>& b, std::vector<Real>& x) const {
    const int n = m_.rows();
    x.resize(at(n));
    for (int i = 0; i < n; ++i) {
      x[at(i)] = b[at(order_[at(i)])];
      for (int j = 0; j < i; ++j) x[at(i)] -= m_(i, j) * x[at(j)];
    }
    for (int i = n - 1; i >= 0; --i) {
      for (int j = i + 1; j < n; ++j) x[at(i)] -= m_(i, j) * x[at(j)];
      x[at(i)] /= m_(i, i);
    }
  }

 private:
  DenseMatrix& m_;
  std::vector<int>& order_;
  bool singular_ = false;
};

// M_AA z_A = -q_A for the active A, refined with residuals of twice the digits, in memory.refined.
// Returns false if M_AA is singular.
bool solveActive(ComplementarityMemory& memory) {
  const int n = static_cast<int>(memory.active.size());
  DenseMatrix& part = memory.part;
  part.reset(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      part(i, j) = memory.scaled(memory.active[at(i)], memory.active[at(j)]);
    }
  }
  memory.eliminated = part;
  const Elimination elimination(memory.eliminated, memory.order);
  if (elimination.singular()) return false;
  std::vector<DoubleDouble>& z = memory.refined;
  z.assign(at(n), DoubleDouble{});
  memory.residual.resize(at(n));
  constexpr int kRefinements = 4;  // each gains the digits that the elimination has right
  for (int round = 0; round < kRefinements; ++round) {
    for (int i = 0; i < n; ++i) {
      DoubleDouble sum{-memory.scaledQ[at(memory.active[at(i)])], 0};
      for (int j = 0; j < n; ++j) sum = sum - DoubleDouble{part(i, j), 0} * z[at(j)];
      memory.residual[at(i)] = sum.high;
    }
    elimination.solve(memory.residual, memory.step);
    for (int i = 0; i < n; ++i) z[at(i)] += DoubleDouble{memory.step[at(i)], 0};
  }
  return true;
}

// The power of two next to 1/sqrt(x): scaling with it costs no digit.
Real evenScale(Real x) {
  return x > 0 ? std::ldexp(1.0, -static_cast<int>(std::lround(std::log2(x) / 2))) : 1;
}

void check(const DenseMatrix& M, std::span<const Real> q) {
  if (M.rows() != M.columns()) {
    reject("M", std::to_string(M.rows()) + " x " + std::to_string(M.columns()), "must be square");
  }
  if (at(M.rows()) != q.size()) {
    reject("q", std::to_string(q.size()) + " numbers", "must have one for each row of M");
  }
  for (int i = 0; i < M.rows(); ++i) {
    requireFinite(q[at(i)], "q");
    for (int j = 0; j < M.columns(); ++j) requireFinite(M(i, j), "M");
  }
}

}  // namespace

void reserve(ComplementarityMemory& memory, Complementarity& result, int rows) {
  const std::size_t n = at(rows);
  result.z.reserve(n);
  for (DenseMatrix* square : {&memory.scaled, &memory.part, &memory.eliminated}) {
    square->reserve(rows, rows);
  }
  memory.tableau.reserve(rows, 2 * rows + 2);
  for (std::vector<Real>* numbers :
       {&memory.scale, &memory.scaledQ, &memory.residual, &memory.step}) {
    numbers->reserve(n);
  }
  memory.refined.reserve(n);
  for (std::vector<int>* numbers : {&memory.basis, &memory.active, &memory.order}) {
    numbers->reserve(n);
  }
}

Complementarity solveComplementarity(const DenseMatrix& M, std::span<const Real> q) {
  ComplementarityMemory memory;
  Complementarity result;
  solveComplementarity(M, q, memory, result);
  return result;
}

void solveComplementarity(const DenseMatrix& M, std::span<const Real> q,
                          ComplementarityMemory& memory, Complementarity& result) {
  check(M, q);
  const int n = M.rows();
  result.status = ComplementarityStatus::solved;
  result.pivots = 0;
  result.residual = 0;
  result.z.assign(q.size(), 0);
  if (std::all_of(q.begin(), q.end(), [](Real x) { return x >= 0; })) return;

  // Scaled so that the diagonal is about one, also for masses of many decades.
  std::vector<Real>&scale = memory.scale, &scaledQ = memory.scaledQ;
  scale.resize(q.size());
  scaledQ.resize(q.size());
  DenseMatrix& scaled = memory.scaled;
  scaled.reset(n, n);
  for (int i = 0; i < n; ++i) scale[at(i)] = evenScale(M(i, i));
  Real largest = 0;
  for (int i = 0; i < n; ++i) {
    scaledQ[at(i)] = scale[at(i)] * q[at(i)];
    largest = std::max(largest, std::abs(scaledQ[at(i)]));
    for (int j = 0; j < n; ++j) scaled(i, j) = scale[at(i)] * M(i, j) * scale[at(j)];
  }
  const Real unit = std::ldexp(1.0, std::ilogb(largest));
  for (Real& value : scaledQ) value /= unit;

  Tableau tableau(scaled, scaledQ, memory.tableau, memory.basis);
  int left = tableau.pivot(tableau.worstRow(), tableau.artificial());
  result.pivots = 1;
  const int most = 50 * n + 100;  // problems with contacts need about n
  while (left != tableau.artificial()) {
    const int entering = left < n ? left + n : left - n;  // the partner of what left
    const int row = tableau.leavingRow(entering);
    if (row < 0 || result.pivots == most) {
      result.status = row < 0 ? ComplementarityStatus::ray : ComplementarityStatus::pivotLimit;
      result.z.clear();
      return;
    }
    left = tableau.pivot(row, entering);
    ++result.pivots;
  }

  std::vector<int>& active = memory.active;
  active.clear();
  for (int i = 0; i < n; ++i) {
    const int variable = tableau.basic(i);
    if (variable < n) continue;
    active.push_back(variable - n);
    result.z[at(variable - n)] = std::max(0.0, tableau.value(i));
  }
  std::sort(active.begin(), active.end());
  if (solveActive(memory)) {
    for (std::size_t i = 0; i < active.size(); ++i) {
      result.z[at(active[i])] = std::max(0.0, memory.refined[i].high);
    }
  }

  for (int i = 0; i < n; ++i) {
    Real w = scaledQ[at(i)];
    for (int j = 0; j < n; ++j) w += scaled(i, j) * result.z[at(j)];
    const Real wrong = result.z[at(i)] > 0 ? std::abs(w) : -w;
    result.residual = std::max(result.residual, wrong);
  }
  for (int i = 0; i < n; ++i) result.z[at(i)] *= scale[at(i)] * unit;
}

}  // namespace carom
