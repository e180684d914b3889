#pragma once
// Which engines can run the scenes?
//
// Carom, and whatever else was found when this was built. Each peer is a shared library of which
// only one function is seen, so that what it is compiled with does not touch ours.

#include <vector>

#include "scenes/scene.hpp"

namespace carom::scenes {

/// Carom, as it is and with ideas switched off.
std::vector<EngineKind> caromEngines();

/// Bullet in double precision.
[[gnu::visibility("default")]] std::vector<EngineKind> bulletEngines();

/// ODE in double precision.
[[gnu::visibility("default")]] std::vector<EngineKind> odeEngines();

/// MuJoCo: small scenes without bounces.
[[gnu::visibility("default")]] std::vector<EngineKind> mujocoEngines();

/// Box3D, of a build that was pointed to.
[[gnu::visibility("default")]] std::vector<EngineKind> box3dEngines();

/// Jolt, of a build that was pointed to.
[[gnu::visibility("default")]] std::vector<EngineKind> joltEngines();

/// All engines of this program.
std::vector<EngineKind> allEngines();

/// How many bodies of a scene move.
inline int movingCount(const Scene& scene) {
  int count = 0;
  for (const Body& body : scene.bodies) count += body.moves ? 1 : 0;
  return count;
}

}  // namespace carom::scenes
