#pragma once
// A small dense matrix whose size is known only at run time.
//
// Row by row in one vector. Eigen has one too; its sums are split over the lanes of the machine, so
// that the last bit depends on the processor. The loops that use this one add from left to right.
// Not handled: anything but storage.

#include <cstddef>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// A dense matrix, zero at first. \ingroup impulse
class DenseMatrix {
 public:
  /// An empty matrix.
  DenseMatrix() = default;

  /// A matrix of zeros. \param rows zero or more \param columns zero or more
  DenseMatrix(int rows, int columns)
      : rows_(rows),
        columns_(columns),
        values_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)) {}

  /// Takes memory for a matrix of this size. \param rows zero or more \param columns zero or more
  void reserve(int rows, int columns) {
    values_.reserve(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  }

  /// Makes it a matrix of zeros, in the memory that it has. \param rows zero or more
  /// \param columns zero or more
  void reset(int rows, int columns) {
    rows_ = rows;
    columns_ = columns;
    values_.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns), 0);
  }

  /// \return number of rows
  int rows() const {
    return rows_;
  }
  /// \return number of columns
  int columns() const {
    return columns_;
  }
  /// An entry. \param row from 0 \param column from 0 \return the entry, which may be changed
  Real& operator()(int row, int column) {
    return values_[indexOf(row, column)];
  }
  /// An entry. \param row from 0 \param column from 0 \return the entry
  Real operator()(int row, int column) const {
    return values_[indexOf(row, column)];
  }

 private:
  std::size_t indexOf(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int rows_ = 0;
  int columns_ = 0;
  std::vector<Real> values_;
};

}  // namespace carom
