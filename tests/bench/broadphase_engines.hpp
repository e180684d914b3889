#pragma once
// Broad phases of other engines, for the suite `broadphase`. Each is a shared library that sees
// nothing of ours but this file.

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace carom::bench {

/// A broad phase: boxes go in, pairs come out. A box is six numbers: low x, y, z, high x, y, z [m].
struct BroadEngine {
  virtual ~BroadEngine() = default;
  /// Puts all bodies in, once.
  /// \param boxes of all bodies \param immovable not zero for those that never move
  virtual void add(const std::vector<double>& boxes, const std::vector<char>& immovable) = 0;
  /// One step. \param boxes of all bodies \param awake those that may have moved
  virtual void step(const double* boxes, const std::vector<std::int32_t>& awake) = 0;
  /// The pairs that it would now hand on, the smaller number first, in any order.
  virtual void pairs(std::vector<std::pair<std::int32_t, std::int32_t>>& out) = 0;
};

/// Bullet's btDbvtBroadphase, two trees that are improved from step to step.
[[gnu::visibility("default")]] std::unique_ptr<BroadEngine> bulletTree();
/// Bullet's three-axis sweep, bt32BitAxisSweep3. \param size the scene is within +-size [m]
/// \param bodies how many at most
[[gnu::visibility("default")]] std::unique_ptr<BroadEngine> bulletSweep(double size, int bodies);
/// ODE's hash space. \param low \param high powers of two between which the bodies' sizes are
[[gnu::visibility("default")]] std::unique_ptr<BroadEngine> odeHash(int low, int high);
/// ODE's sweep and prune space.
[[gnu::visibility("default")]] std::unique_ptr<BroadEngine> odeSweep();

}  // namespace carom::bench
