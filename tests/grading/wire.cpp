#include "grading/wire.hpp"

namespace carom::grading {

std::string showNumber(double number) {
  if (std::isnan(number)) return "NaN (not a number: 0/0, or the root of a negative number)";
  if (std::isinf(number)) return number > 0 ? "infinity" : "-infinity";
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  return {text, end};
}

}  // namespace carom::grading
