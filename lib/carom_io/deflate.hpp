#pragma once
// Packing for pages: zlib's deflate, then base64, because a page is text.

#include <string>

namespace carom::io::detail {

/// Packs bytes in zlib's format, which browsers unpack with DecompressionStream("deflate").
/// \param bytes what to pack \return the packed bytes
std::string deflated(const std::string& bytes);

/// Writes bytes as base64 (RFC 4648). \param bytes any bytes \return the text
std::string base64(const std::string& bytes);

/// Unpacks what deflated() packed. \param packed the packed bytes \return the bytes
/// \throws std::runtime_error if they are damaged, or more than 64 MB
std::string inflated(const std::string& packed);

/// Reads base64. \param text digits, no blanks \return the bytes
/// \throws std::runtime_error at a character that is no digit
std::string fromBase64(const std::string& text);

}  // namespace carom::io::detail
