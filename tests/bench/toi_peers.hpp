#pragma once
// First contacts in other libraries, for the suite `toi`. Each is a shared library that sees
// nothing of ours but this file.

#include <array>

namespace carom::bench {

/// What another library says of a query.
struct PeerImpact {
  bool hit = false;
  double time = 0;
};

/// FCL: roots of the cubic by Newton's method, inside test with a tolerance (after Provot 1997).
/// \param face vertex against face, else edge against edge
/// \param points twelve coordinates at the start and twelve at the end
[[gnu::visibility("default")]] PeerImpact featuresInFcl(bool face, const double* points);

/// Tight-Inclusion (Wang et al. 2021) with at most 1e6 boxes, as its authors recommend.
/// \param face vertex against face, else edge against edge
/// \param points twelve coordinates at the start and twelve at the end
/// \param tolerance that it stops at
[[gnu::visibility("default")]] PeerImpact featuresInTightInclusion(bool face, const double* points,
                                                                   double tolerance);

/// A motion as Bullet takes it: places and quaternions w, x, y, z.
struct PeerSweep {
  std::array<double, 7> start = {};
  std::array<double, 7> end = {};
};

/// Bullet's conservative advancement (btContinuousConvexCollision), without margins.
/// \param a corners of A, three coordinates each \param countA how many \param A motion of A
/// \param b corners of B \param countB how many \param B motion of B
[[gnu::visibility("default")]] PeerImpact hullsInBullet(const double* a, int countA,
                                                        const PeerSweep& A, const double* b,
                                                        int countB, const PeerSweep& B);

}  // namespace carom::bench
