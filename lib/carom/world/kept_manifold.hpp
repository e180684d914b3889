#pragma once
// What becomes of a manifold while two bodies hardly move against each other?
//
// Method: when it is made, each of its points is written down twice: where it lies on A, as A sees
// it, and where on B. As long as no point of B has gone farther than a little way against A, the
// two copies are carried along with their bodies, and their gap is measured anew along A's normal.
// The way is counted from when the manifold was made, and not from the step before: nothing adds
// up.
// Why: the bodies of a heap lean on each other at the same places for hundreds of steps, and the
// search for axes and the clipping are a third of their time.
// How wrong it can be: the surfaces of both bodies have moved against each other by at most the
// way, and the carried points as well; so no gap is off by more than twice the way, and no point
// nearer than the margin less twice the way is missing. Gaps of points that lie on the same corner
// and face as before are right to the second order.
// Two hulls that have gone farther keep at least the features that were the nearest ones: their
// faces are clipped anew, and nobody looks for others until they strayed too far, or sank or rose by
// more than a little. What those features miss is at most what they strayed by.
// Source: contact recycling, Catto 2025 (Box3D).
// Not handled: bodies that are not in a pile, whose contacts are made anew in each step.

#include <array>

#include "carom/detection/pose.hpp"
#include "carom/manifold/manifold.hpp"

namespace carom::world {

/// A manifold as its two bodies see it. \ingroup world
struct KeptManifold {
  bool known = false;                  ///< has been made, and may be carried
  Real margin = 0;                     ///< gap up to which it has points [m]
  Real deepest = 0;                    ///< the least gap when its features were looked for [m]
  Real strayed = 0;                    ///< how far its bodies had moved since then [m]
  Matrix3 R = Matrix3::Identity();     ///< B to A, when it was made
  Vector3 t = Vector3::Zero();         ///< B's place, then [m, A]
  Vector3 normal = Vector3::UnitZ();   ///< from A to B [1, A]
  Vector3 centroid = Vector3::Zero();  ///< of its area [m, A]
  std::array<Vector3, 4> onA;          ///< its points on A [m, A]
  std::array<Vector3, 4> onB;          ///< on B [m, B]
};

/// Writes a manifold down. \param manifold as just made \param A pose of one body
/// \param B pose of the other \param margin gap up to which it was made [m]
/// \return as the bodies see it \ingroup world
KeptManifold keptManifold(const Manifold& manifold, const Pose& A, const Pose& B, Real margin);

/// How far a point of B can have moved against A. \param kept of a manifold \param A pose of one
/// body now \param B pose of the other now \param reach no point of B is farther from its place [m]
/// \return [m] \ingroup world
Real wayAgainst(const KeptManifold& kept, const Pose& A, const Pose& B, Real reach);

/// Carries a manifold along. \param kept as it was made \param A pose of one body now
/// \param B pose of the other now \param manifold the same as it was made, or carried; changed to
/// how it is now \ingroup world
void carryManifold(const KeptManifold& kept, const Pose& A, const Pose& B, Manifold& manifold);

}  // namespace carom::world
