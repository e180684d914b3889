#include "carom/core/checks.hpp"

#include <array>
#include <charconv>

namespace carom {

std::string toText(Real value) {
  std::array<char, 32> digits{};  // the longest double takes 24 characters
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

std::string toText(const Vector3& value) {
  return "(" + toText(value.x()) + ", " + toText(value.y()) + ", " + toText(value.z()) + ")";
}

std::string toText(const Matrix3& value) {
  return "(" + toText(Vector3(value.row(0))) + ", " + toText(Vector3(value.row(1))) + ", " +
         toText(Vector3(value.row(2))) + ")";
}

void reject(const std::string& name, const std::string& value, const std::string& rule) {
  throw InvalidInput(name + " = " + value + " " + rule);
}

}  // namespace carom
