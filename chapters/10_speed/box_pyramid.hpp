#pragma once
// Which contacts has a pyramid of boxes?
//
// Boxes of 1 m and 1 kg in rows, each on two of the row below, in a plane; every contact is a point
// in the middle of where two boxes overlap. The ground has the number after the last box.

#include <string>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/solver/color_graph.hpp"
#include "plain_row.hpp"

namespace carom {

/// A pyramid of boxes. \ingroup solver
struct BoxPyramid {
  std::vector<Vector2> centres;     ///< of the boxes, row by row from below [m]
  std::vector<ColorEdge> contacts;  ///< from the lower body to the upper one
  std::vector<PlainRow> rows;       ///< of the contacts; the ground is nobody
  std::vector<Vector2> points;      ///< of the contacts [m]
};

/// \cond
namespace detail {

// A contact at x = armA and armB from the centres of both bodies.
inline void addContact(BoxPyramid& p, int a, int b, Real armA, Real armB, int ground) {
  PlainRow row{.bodyA = a == ground ? kNobody : a, .bodyB = b};
  if (a != ground) row.alongA = {0, 0, -1, 0, armA, 0};
  row.alongB = {0, 0, 1, 0, -armB, 0};
  Real perImpulse = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Real light = i < 3 ? 1 : 6;  // 1 / kg, and of a cube of 1 m 1 / (kg m^2)
    row.changeA[i] = light * row.alongA[i];
    row.changeB[i] = light * row.alongB[i];
    perImpulse += row.alongA[i] * row.changeA[i] + row.alongB[i] * row.changeB[i];
  }
  row.mass = 1 / perImpulse;
  p.rows.push_back(row);
  p.contacts.push_back({a, b});
  p.points.emplace_back(p.centres[static_cast<std::size_t>(b)] + Vector2(armB, -0.5));
}

}  // namespace detail
/// \endcond

/// Builds one. \param height rows of boxes, positive \return the pyramid, at rest
/// \throws InvalidInput if there is no row
/// \ingroup solver
inline BoxPyramid boxPyramid(int height) {
  if (height < 1) reject("height", std::to_string(height), "must be positive");
  BoxPyramid p;
  for (int row = 0; row < height; ++row) {
    for (int i = 0; i < height - row; ++i) p.centres.emplace_back(i + 0.5 * row, row + 0.5);
  }
  const int ground = static_cast<int>(p.centres.size());
  int first = 0, firstBelow = ground;
  for (int row = 0; row < height; ++row) {
    for (int i = 0; i < height - row; ++i) {
      const int below = row > 0 ? firstBelow + i : ground;
      detail::addContact(p, below, first + i, 0.25, -0.25, ground);
      detail::addContact(p, row > 0 ? below + 1 : ground, first + i, -0.25, 0.25, ground);
    }
    firstBelow = first;
    first += height - row;
  }
  return p;
}

}  // namespace carom
