#pragma once
// One number of each of four things, side by side: what a register of 32 bytes holds.

#include <array>
#include <cstddef>

#include "carom/core/real.hpp"

namespace carom {

/// Things in a block: bodies or contacts. \ingroup solver
inline constexpr std::size_t kBlockLanes = 4;

/// One number of each of them, aligned as lanes are. \ingroup solver
struct alignas(kBlockLanes * sizeof(Real)) LaneValues {
  std::array<Real, kBlockLanes> x = {};  ///< one per lane
};

}  // namespace carom
