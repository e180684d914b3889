#pragma once
// How deep are the bodies of a scene in each other?
//
// Method: pairs whose bounding balls are apart are left out; of the others the signed gap is
// computed from the poses: balls in closed form, boxes and polyhedra on all separating axes (which
// is the exact depth), anything against a half-space by its lowest point.
// Why here: an engine that calls a centimetre of overlap "touching" would report none.

#include <memory>
#include <span>

#include "scenes/scene.hpp"

namespace carom::scenes {

/// What the overlaps of all bodies come to.
struct Overlaps {
  Real deepest = 0;       ///< largest depth; 0 if nothing overlaps [m]
  Real mean = 0;          ///< over the pairs that overlap [m]
  Real sumOfSquares = 0;  ///< of the depths [m^2]
  int pairs = 0;          ///< that overlap
};

/// The signed gap of two bodies. \return negative: the depth of their overlap [m]
Real gapOf(const Body& a, const State& A, const Body& b, const State& B);

/// Looks at all pairs of which at least one moves.
/// \param scene tells the shapes \param bodies tells the poses \return depths
Overlaps overlapsOf(const Scene& scene, std::span<const State> bodies);

/// The judge of scenes that have no answer but rest: how deep the bodies are in each other over
/// time and at the end, and the energy of motion that is left. \param scene that is run
std::unique_ptr<Judge> depthJudge(const Scene& scene);

}  // namespace carom::scenes
