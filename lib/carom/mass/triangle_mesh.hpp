#pragma once
// A solid as its skin: vertices, and triangles that name three vertices each.

#include <array>
#include <cstdint>
#include <vector>

#include "carom/core/real.hpp"

/// \defgroup mass Mass properties: chapter 2
/// Volume, centre of mass and inertia of solids.

namespace carom {

/// A closed surface made of triangles. Seen from outside, the corners of a triangle run counter-clockwise, so
/// that its normal points out of the solid. Plain data: check_mesh() says whether it is what it should be.
/// \ingroup mass
struct TriangleMesh {
  std::vector<Vector3> vertices;                     ///< corners [m, frame of the mesh]
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< indices into vertices
};

}  // namespace carom
