#pragma once
// Packing for pages: zlib's deflate, then base64, because a page is text.

#include <string>

namespace carom::io::detail {

/// Packs bytes in zlib's format, which browsers unpack with DecompressionStream("deflate").
/// \param bytes what to pack \return the packed bytes
std::string deflated(const std::string& bytes);

/// Writes bytes as base64 (RFC 4648). \param bytes any bytes \return the text
std::string base64(const std::string& bytes);

}  // namespace carom::io::detail
