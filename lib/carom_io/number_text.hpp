#pragma once
// How is a number written so that every machine writes the same characters?
//
// printf and streams follow the locale and, for some digits, the C library. std::to_chars follows
// neither: it is correctly rounded by the standard.

#include <charconv>
#include <string>

#include "carom/core/real.hpp"

namespace carom::io {

/// The shortest text that reads back as exactly this number; "nan", "inf" and "-inf" for those.
/// \param value any number
/// \return its text, with a point as the decimal mark
/// \ingroup io
std::string exactText(Real value);

/// A number with a given count of digits. A result that rounds to zero is written without a sign.
/// \param value any number
/// \param format std::chars_format::fixed, scientific or general
/// \param digits digits behind the point; for general, significant digits
/// \return its text, with a point as the decimal mark
/// \ingroup io
std::string roundedText(Real value, std::chars_format format, int digits);

}  // namespace carom::io
