#pragma once
// Other libraries that measure pairs of bodies, each behind a few functions, so that the suite
// knows nothing of their types. Each lives in a shared library of its own, as in peers.hpp.

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "carom/detection/convex_hull.hpp"
#include "carom/detection/pose.hpp"

#define CAROM_PEER __attribute__((visibility("default")))

namespace carom::bench {

/// Two placed bodies. For boxes the half extents count, for hulls the corners.
struct BodyPair {
  Pose A, B;
  Vector3 halfA = Vector3::Ones(), halfB = Vector3::Ones();
};

/// What a library says of a pair. Fields that it does not give stay as they are.
struct PairAnswer {
  bool hit = false;
  Real separation = std::numeric_limits<Real>::quiet_NaN();  ///< not a number: it does not say
  Vector3 normal = Vector3::Zero();                          ///< from A to B
  int points = 0;
};

/// A way to measure pairs: what it is called, and pair number -> answer.
struct PairMethod {
  std::string name;
  std::function<PairAnswer(std::size_t)> run;
  std::size_t most = std::numeric_limits<std::size_t>::max();  ///< too slow for more pairs
};

/// Bullet's btBoxBoxDetector and its GJK with EPA, built with doubles. The pairs must outlive them.
CAROM_PEER std::vector<PairMethod> bulletBoxes(std::span<const BodyPair> pairs);
/// The same for two hulls in many poses.
CAROM_PEER std::vector<PairMethod> bulletHulls(const ConvexHull& a, const ConvexHull& b,
                                               std::span<const BodyPair> pairs);
/// FCL's collide (contacts) and signed distance of boxes.
CAROM_PEER std::vector<PairMethod> fclBoxes(std::span<const BodyPair> pairs);
/// The same for two hulls in many poses.
CAROM_PEER std::vector<PairMethod> fclHulls(const ConvexHull& a, const ConvexHull& b,
                                            std::span<const BodyPair> pairs);
/// ODE's dBoxBox.
CAROM_PEER std::vector<PairMethod> odeBoxes(std::span<const BodyPair> pairs);
/// libccd's GJK with EPA, and its MPR, for boxes.
CAROM_PEER std::vector<PairMethod> ccdBoxes(std::span<const BodyPair> pairs);
/// The same for two hulls in many poses.
CAROM_PEER std::vector<PairMethod> ccdHulls(const ConvexHull& a, const ConvexHull& b,
                                            std::span<const BodyPair> pairs);

/// Triangles of the plane, or tetrahedra: the corners of body i are 3 i (4 i) and those after it.
template <class Point>
struct SimplexPairs {
  std::vector<Point> a, b;
};

/// A way to ask whether pair number i has a point in common.
struct MeetMethod {
  std::string name;
  std::function<bool(std::size_t)> meet;
};

/// CGAL's do_intersect of triangles with doubles, with its filtered predicates, and with exact
/// numbers; the last is the judge.
CAROM_PEER std::vector<MeetMethod> cgalMeet(const SimplexPairs<Vector2>& pairs);
/// The same of tetrahedra.
CAROM_PEER std::vector<MeetMethod> cgalMeet(const SimplexPairs<Vector3>& pairs);

}  // namespace carom::bench
