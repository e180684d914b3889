#include "carom_io/deflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace carom::io::detail {

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
  if (status != Z_OK) throw std::runtime_error("zlib: " + std::string(zError(status)));
  packed.resize(size);
  return packed;
}

std::string inflated(const std::string& packed) {
  constexpr std::size_t kMost = std::size_t{64} << 20;
  std::string bytes(std::max<std::size_t>(1024, 4 * packed.size()), '\0');
  for (;;) {
    uLongf size = bytes.size();
    const int status = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                  reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    if (status == Z_OK) {
      bytes.resize(size);
      return bytes;
    }
    // The format does not say how much is inside: try again with twice the room.
    if (status != Z_BUF_ERROR || bytes.size() >= kMost)
      throw std::runtime_error("zlib: " + std::string(zError(status)));
    bytes.resize(2 * bytes.size());
  }
}

namespace {
constexpr std::string_view digits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
}

std::string fromBase64(const std::string& text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    const auto digit = digits.find(c);
    if (digit == std::string_view::npos)
      throw std::runtime_error(std::string("base64 has no digit '") + c + "'");
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xffu);
    }
  }
  return bytes;
}

std::string base64(const std::string& bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    // Three bytes make 24 bits, that is four digits; what is missing at the end is written as '='.
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return text;
}

}  // namespace carom::io::detail
