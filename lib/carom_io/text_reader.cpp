#include <charconv>
#include <cmath>
#include <limits>

#include "carom_io/mesh_formats.hpp"

namespace carom::io::detail {

namespace {

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// std::from_chars knows no plus sign, files do.
std::string_view withoutPlus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

}  // namespace

// A hostile word must not fill the screen, nor send control characters to it.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, kLongest)) {
    result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  return result + (text.size() > kLongest ? "...'" : "'");
}

void failAtLine(const MeshSource& source, std::size_t line, const std::string& what) {
  throw MeshFileError(source.name + ":" + std::to_string(line) + ": " + what);
}

void failAtByte(const MeshSource& source, std::size_t byte, const std::string& what) {
  throw MeshFileError(source.name + ", byte " + std::to_string(byte) + ": " + what);
}

TextReader::TextReader(const MeshSource& source, bool comments, std::size_t start)
    : source_(source), comments_(comments), next_(start) {}

bool TextReader::nextLine() {
  const std::string_view all = source_.content;
  while (next_ < all.size()) {
    const std::size_t start = next_;
    const std::size_t end = std::min(all.find_first_of("\r\n", start), all.size());
    const bool twoBytes = end + 1 < all.size() && all[end] == '\r' && all[end + 1] == '\n';
    next_ = std::min(end + (twoBytes ? 2 : 1), all.size());
    ++line_;
    rest_ = all.substr(start, end - start);
    if (comments_) rest_ = rest_.substr(0, rest_.find('#'));
    while (!rest_.empty() && isSpace(rest_.front())) rest_.remove_prefix(1);
    if (!rest_.empty()) return true;
  }
  rest_ = {};
  return false;
}

std::optional<std::string_view> TextReader::word() {
  while (!rest_.empty() && isSpace(rest_.front())) rest_.remove_prefix(1);
  if (rest_.empty()) return std::nullopt;
  std::size_t length = 0;
  while (length < rest_.size() && !isSpace(rest_[length])) ++length;
  const std::string_view result = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return result;
}

std::string_view TextReader::wordAnywhere(const std::string& wanted) {
  for (;;) {
    if (const std::optional<std::string_view> found = word()) return *found;
    if (!nextLine()) fail("the file ends where " + wanted + " should be");
  }
}

Real TextReader::number(const std::string& wanted) {
  const std::optional<std::string_view> text = word();
  if (!text) fail("the line ends where " + wanted + " should be");
  return numberIn(*text, wanted);
}

std::int64_t TextReader::whole(const std::string& wanted) {
  const std::optional<std::string_view> text = word();
  if (!text) fail("the line ends where " + wanted + " should be");
  return wholeIn(*text, wanted);
}

Real TextReader::numberIn(std::string_view text, const std::string& wanted) const {
  const std::string_view digits = withoutPlus(text);
  Real value = 0;
  const std::from_chars_result end =
      std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end.ec == std::errc::result_out_of_range) {
    fail(shown(text) + " is outside the range of a double: " + wanted);
  }
  if (end.ec != std::errc() || end.ptr != digits.data() + digits.size()) {
    fail(shown(text) + " is not a number: " + wanted + " should be here");
  }
  if (!std::isfinite(value)) fail(shown(text) + " is not finite: " + wanted);
  return value;
}

std::int64_t TextReader::wholeIn(std::string_view text, const std::string& wanted) const {
  const std::string_view digits = withoutPlus(text);
  std::int64_t value = 0;
  const std::from_chars_result end =
      std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end.ec != std::errc() || end.ptr != digits.data() + digits.size()) {
    fail(shown(text) + " is not a whole number: " + wanted + " should be here");
  }
  return value;
}

std::size_t TextReader::fitting(std::int64_t count, std::size_t bytesEach,
                                const std::string& wanted) const {
  if (count < 0 || count > std::numeric_limits<std::int32_t>::max()) {
    fail(std::to_string(count) + " " + wanted + ": must be 0 to 2147483647");
  }
  const std::size_t bytesLeft = source_.content.size() - next_ + rest_.size();
  if (static_cast<std::size_t>(count) > (bytesLeft + 1) / bytesEach) {
    fail(std::to_string(count) + " " + wanted + " are promised, but only " +
         std::to_string(bytesLeft) + " bytes follow");
  }
  return static_cast<std::size_t>(count);
}

void TextReader::fail(const std::string& what) const {
  failAtLine(source_, line_, what);
}

void addFan(TriangleMesh& mesh, const std::vector<std::int32_t>& corners) {
  for (std::size_t k = 2; k < corners.size(); ++k) {
    mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
  }
}

}  // namespace carom::io::detail
