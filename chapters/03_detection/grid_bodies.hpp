#pragma once
// Triangles and tetrahedra with whole-number corners, at random and the same on every machine.

#include <cstdint>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/real.hpp"

/// Bodies for counting verdicts without rounding.
namespace grid_bodies {

using carom::Real;
using carom::Vector3;

/// Knuth's linear congruential generator (the constants of MMIX).
class Draws {
 public:
  /// Starts the numbers. \param seed any number; the same seed gives the same numbers
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  /// The next number. \param bound more than zero \return a whole number from 0 to bound - 1
  Real below(std::uint64_t bound) {
    state_ = 6364136223846793005u * state_ + 1442695040888963407u;
    return static_cast<Real>((state_ >> 33) % bound);
  }

 private:
  std::uint64_t state_;
};

/// A triangle with z = 0, or a tetrahedron.
struct Body {
  std::vector<Vector3> corners;  ///< [m]
  std::vector<Vector3> normals;  ///< of faces (of a triangle: of edges), any length, in or out
  std::vector<Vector3> edges;    ///< as vectors [m]

  /// Is it a triangle? \return true for a triangle
  bool flat() const {
    return corners.size() == 3;
  }
};

/// A triangle on a grid of 16 by 16 points. \param draws the numbers \return the triangle
inline Body triangle(Draws& draws) {
  Body body;
  for (int i = 0; i < 3; ++i) {
    const Real x = draws.below(16), y = draws.below(16);
    body.corners.push_back({x, y, 0});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    body.edges.push_back(body.corners[(i + 1) % 3] - body.corners[i]);
    body.normals.push_back({body.edges[i].y(), -body.edges[i].x(), 0});
  }
  return body;
}

/// A tetrahedron on a grid of 8 by 8 by 8 points. \param draws the numbers
/// \return the tetrahedron
inline Body tetrahedron(Draws& draws) {
  Body body;
  for (int i = 0; i < 4; ++i) {
    const Real x = draws.below(8), y = draws.below(8), z = draws.below(8);
    body.corners.push_back({x, y, z});
  }
  const auto edge = [&](std::size_t i, std::size_t j) -> Vector3 {
    return body.corners[j] - body.corners[i];
  };
  body.edges = {edge(0, 1), edge(0, 2), edge(0, 3), edge(1, 2), edge(1, 3), edge(2, 3)};
  body.normals = {carom::cross(edge(0, 1), edge(0, 2)), carom::cross(edge(0, 1), edge(0, 3)),
                  carom::cross(edge(0, 2), edge(0, 3)), carom::cross(edge(1, 2), edge(1, 3))};
  return body;
}

/// Has a body an inside? Those without one are left out. \param body any \return true if it has
inline bool solid(const Body& body) {
  if (body.flat()) return carom::cross(body.edges[0], body.edges[1]).z() != 0;
  return body.normals[0].dot(body.edges[2]) != 0;
}

}  // namespace grid_bodies
