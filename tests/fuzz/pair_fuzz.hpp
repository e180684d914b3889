#pragma once
// What detection and manifolds promise for any two bodies, whatever the numbers.

#include <cstdint>
#include <span>

namespace carom_test {

/// What came of a pair. Not usable: a shape or a pose was refused, as it should be.
enum class Tried { refused, apart, overlapping };

/// Makes two bodies and their poses from bytes and asks everything about them.
///
/// Any bytes will do. Where no number is larger than 1e8, every answer is finite, normals have length
/// one, and swapping the bodies mirrors the distance. Where besides no body is thinner than a
/// millionth of the pair, the witness points show the distance, and a cache changes no bit.
/// \throws std::logic_error that says which promise was broken, and for what
Tried tryPair(std::span<const std::uint8_t> bytes);

}  // namespace carom_test
