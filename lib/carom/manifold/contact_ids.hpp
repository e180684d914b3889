#pragma once
// How does a contact point keep its name from one step to the next?
//
// Method: a point is named by what touches there: a corner of one body on a face of the other, or
// an edge of A across an edge of B. As long as the same features touch, the name stays, wherever
// the point has moved to; so the impulse of the last step can be handed to the right point.
// Why not the number in the list: clipping starts anywhere, and a corner that comes or goes would
// rename all that follow. Why not the reference face: which of two faces is the reference may
// change without anything else changing.
// The name is one number: two bits of kind for each body and fourteen bits of index, A in the upper
// half, B in the lower. Swapping the bodies swaps the halves.
// Source: Catto's feature pairs, GDC 2006.
// Not handled: bodies with more than 16384 corners, edges or faces.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// What part of a body touches.
/// \ingroup manifold
enum class FeatureKind : std::uint32_t {
  surface = 0,  ///< a round surface, which has one nearest point
  vertex = 1,   ///< a corner
  edge = 2,     ///< an edge
  face = 3,     ///< a face
};

/// One feature of one body. \ingroup manifold
struct Feature {
  FeatureKind kind = FeatureKind::surface;  ///< what it is
  std::uint32_t index = 0;                  ///< its number in the body, below 16384
};

/// What meets at a contact point. \ingroup manifold
struct FeaturePair {
  Feature onA;  ///< feature of body A
  Feature onB;  ///< feature of body B
};

/// The names of contact points.
/// \param pairs the features that meet at each point
/// \return one number per pair, different for different pairs
/// \throws InvalidInput if an index is 16384 or more
/// \ingroup manifold
std::vector<std::uint32_t> contactIds(std::span<const FeaturePair> pairs);

/// The name of the same point when A and B are called the other way round.
/// \param id name made by contactIds() \return name of the swapped pair
/// \ingroup manifold
constexpr std::uint32_t swappedId(std::uint32_t id) {
  return (id << 16) | (id >> 16);
}

}  // namespace carom
