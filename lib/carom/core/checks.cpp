#include "carom/core/checks.hpp"

#include <array>
#include <charconv>

namespace carom {

std::string toText(Real value) {
  std::array<char, 32> digits{};  // the longest double takes 24 characters
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

namespace {

template <class Vector>
std::string listed(const Vector& value) {
  std::string text = "(";
  for (int i = 0; i < value.size(); ++i) {
    if (i > 0) text += ", ";
    text += toText(value(i));
  }
  text += ")";
  return text;
}

}  // namespace

std::string toText(const Vector3& value) {
  return listed(value);
}

std::string toText(const Vector4& value) {
  return listed(value);
}

std::string toText(const Matrix3& value) {
  std::string text = "(";
  text += toText(Vector3(value.row(0))) + ", ";
  text += toText(Vector3(value.row(1))) + ", ";
  text += toText(Vector3(value.row(2))) + ")";
  return text;
}

void reject(const std::string& name, const std::string& value, const std::string& rule) {
  throw InvalidInput(name + " = " + value + " " + rule);
}

}  // namespace carom
