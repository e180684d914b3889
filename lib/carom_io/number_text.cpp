#include "carom_io/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace carom::io {

namespace {

// The longest fixed text of a double has 309 digits before the point; behind it we write at most
// this many.
constexpr int kMostDigits = 60;

std::string notFinite(Real value) {
  if (std::isnan(value)) return "nan";
  return value > 0 ? "inf" : "-inf";
}

}  // namespace

std::string exactText(Real value) {
  if (!std::isfinite(value)) return notFinite(value);
  std::array<char, 32> buffer;
  const std::to_chars_result end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end.ptr};
}

std::string roundedText(Real value, std::chars_format format, int digits) {
  if (!std::isfinite(value)) return notFinite(value);
  std::array<char, 400> buffer;
  const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                                 value, format, std::clamp(digits, 0, kMostDigits));
  std::string text(buffer.data(), end.ptr);
  // "-0.00" would show the sign of a rounding error, which differs between compilers that agree
  // otherwise.
  const std::string mantissa = text.substr(0, text.find('e'));
  if (text.front() == '-' && mantissa.find_first_of("123456789") == std::string::npos) {
    text.erase(0, 1);
  }
  return text;
}

}  // namespace carom::io
