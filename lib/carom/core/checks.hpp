#pragma once
// Checks at the doors of the library.
//
// A public function that cannot work with a value says so at once: InvalidInput with the name, the
// value and the rule, for example "mass = -2 must be positive". The checks cost a comparison; the
// text is made only when one fails. Inside the library CAROM_EXPECT does this work (expect.hpp).

#include <cmath>
#include <string>

#include "carom/core/errors.hpp"
#include "carom/core/real.hpp"

namespace carom {

/// A number as the shortest text that reads back as the same double.
/// \param value any number, also infinite or NaN
/// \return its text, for example "0.1" or "-inf"
/// \ingroup core
std::string toText(Real value);

/// A vector as text. \param value any vector \return its text, for example "(1, 0.5, nan)"
/// \ingroup core
std::string toText(const Vector3& value);

/// Four numbers as text. \param value any four numbers \return their text, as for a vector of three
/// \ingroup core
std::string toText(const Vector4& value);

/// A matrix as text, row by row. \param value any matrix
/// \return its text, for example "((1, 0, 0), (0, 1, 0), (0, 0, 1))"
/// \ingroup core
std::string toText(const Matrix3& value);

/// Ends a public function that cannot work with a value.
/// \param name what the value is called
/// \param value its text, see toText()
/// \param rule what it breaks, for example "must be positive"
/// \throws InvalidInput always: "name = value rule"
/// \ingroup core
[[noreturn]] void reject(const std::string& name, const std::string& value,
                         const std::string& rule);

/// Lets only finite numbers pass. \param value the number \param name what it is called
/// \throws InvalidInput for infinities and NaN
/// \ingroup core
inline void requireFinite(Real value, const char* name) {
  if (!std::isfinite(value)) reject(name, toText(value), "must be finite");
}

/// Lets only finite vectors pass. \param value the vector \param name what it is called
/// \throws InvalidInput if a component is infinite or NaN
/// \ingroup core
inline void requireFinite(const Vector3& value, const char* name) {
  if (!value.allFinite()) reject(name, toText(value), "must be finite");
}

/// Lets only finite matrices pass. \param value the matrix \param name what it is called
/// \throws InvalidInput if an entry is infinite or NaN
/// \ingroup core
inline void requireFinite(const Matrix3& value, const char* name) {
  if (!value.allFinite()) reject(name, toText(value), "must be finite");
}

/// Lets only finite numbers above zero pass. \param value the number \param name what it is called
/// \throws InvalidInput for zero, negative numbers, infinities and NaN
/// \ingroup core
inline void requirePositive(Real value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) {
    reject(name, toText(value), "must be positive and finite");
  }
}

/// Lets only finite numbers from zero up pass.
/// \param value the number \param name what it is called
/// \throws InvalidInput for negative numbers, infinities and NaN
/// \ingroup core
inline void requireNonNegative(Real value, const char* name) {
  if (!(value >= 0) || !std::isfinite(value)) {
    reject(name, toText(value), "must be zero or positive, and finite");
  }
}

}  // namespace carom
