#pragma once
// Pairs of bodies for the suite `narrowphase`, and a judge who knows how far apart they are.
//
// The judge computes in long double, by trying everything: all axes of both bodies, and for the
// distance all pairs of corners, edges and faces. It shares no code with what is measured.

#include <cstdint>
#include <vector>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {

/// What is true of a pair.
struct Judgement {
  long double gap = -1e30L;        ///< largest gap on any axis; negative: depth [m]
  long double second = -1e30L;     ///< of the next best axis [m]
  long double distance = 0;        ///< of bodies that are apart; only judgeHulls() knows it [m]
  Vector3 axis = Vector3::Zero();  ///< the best one, unit, from A to B
};

/// The best of the fifteen axes of two boxes.
Judgement judgeBoxes(const BodyPair& pair);

/// The best axis of two hulls in the pair's poses, and their distance.
Judgement judgeHulls(const ConvexHull& a, const ConvexHull& b, const BodyPair& pair);

/// Boxes with half extents from 0.2 to 1 m and a given signed gap. Pairs come in twos: the same
/// boxes a thousandth of a radian later, for methods that remember.
std::vector<BodyPair> boxPairs(std::size_t count, Real gap, std::uint64_t seed);

/// Boxes of the same sizes, B upright on A, turned about the vertical and up to 0.3 m off the
/// middle, with a given depth; in twos as well.
std::vector<BodyPair> standingBoxes(std::size_t count, Real depth, std::uint64_t seed);

/// Poses of two hulls with a signed gap near the given one, in twos as boxPairs().
std::vector<BodyPair> hullPairs(const ConvexHull& a, const ConvexHull& b, std::size_t count,
                                Real gap, std::uint64_t seed);

/// The hull of points on a ball of radius 1 m.
ConvexHull cloud(int count, std::uint64_t seed);

}  // namespace carom::bench
