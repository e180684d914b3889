#pragma once
// The half of a contact point's name that one body gives, for all who make names while they clip.
// The layout is that of contactIds(), which is an exercise: this stands in a header of its own.

#include <cstdint>

#include "carom/manifold/contact_ids.hpp"

namespace carom::detail {

/// Two bits of kind and fourteen of index.
/// \param kind what touches \param index its number in the body; of a larger one than 16383 only
///   the lowest fourteen bits are kept
/// \return sixteen bits \ingroup manifold
template <class Index>
constexpr std::uint32_t nameOf(FeatureKind kind, Index index) {
  return (static_cast<std::uint32_t>(kind) << 14) | (static_cast<std::uint32_t>(index) & 0x3fffu);
}

}  // namespace carom::detail
