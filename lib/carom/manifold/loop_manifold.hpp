#pragma once
// From a clipped loop to a manifold.
//
// Method: the loop lies over the reference face, each corner with its height. Its part below the
// plane gives area and centroid; of its corners below the plane at most four are kept, by the rule
// of reduceContacts(), and turned to world coordinates, halfway between the two surfaces.
// Where two edges cross at a small angle the least displacement is a hair off both faces. Then
// heights are measured along it, and x and y are those of the place on the reference plane where
// that direction leads (Shear).
// Not handled: loops of more than kMostCorners corners.

#include <algorithm>

#include "carom/core/real.hpp"
#include "carom/manifold/clip_loop.hpp"
#include "carom/manifold/manifold.hpp"
#include "carom/manifold/reduce_contacts.hpp"

namespace carom::detail {

/// Corners that a loop may have: two faces of 128 corners each. \ingroup manifold
inline constexpr int kMostCorners = 256;

/// The plane of a reference face. \ingroup manifold
struct ReferencePlane {
  Vector3 origin;  ///< where x = y = 0 in the plane [m, world]
  Vector3 u;       ///< unit vector of x [1, world]
  Vector3 v;       ///< unit vector of y [1, world]
  Vector3 normal;  ///< unit, the manifold's, out of the reference body [1, world]
};

/// From heights along the normal of a face to heights along a direction beside it.
/// \ingroup manifold
struct Shear {
  Real stretch = 1;  ///< height along the direction per height along the face's normal
  Real x = 0;        ///< component of the direction along x
  Real y = 0;        ///< component of the direction along y

  /// None. \return heights stay as they are
  Shear() = default;
  /// For a direction. \param normal of the face, unit \param u axis of x, unit \param v axis of y,
  /// unit \param direction unit, near the normal
  Shear(const Vector3& normal, const Vector3& u, const Vector3& v, const Vector3& direction)
      : stretch(1 / direction.dot(normal)), x(direction.dot(u)), y(direction.dot(v)) {}

  /// A corner over the place on the plane where the direction leads.
  /// \param corner with its height along the face's normal
  /// \return the same corner, measured along the direction
  ClipCorner operator()(const ClipCorner& corner) const {
    const Real height = corner.height * stretch;
    return {corner.x - x * height, corner.y - y * height, height, corner.label};
  }
};

/// Area, first moments of a loop in its plane. \ingroup manifold
struct LoopArea {
  Real area = 0;    ///< never negative [m^2]
  Real x = 0;       ///< centroid [m]
  Real y = 0;       ///< centroid [m]
  Real height = 0;  ///< height of the loop over the centroid [m]
};

/// Area and centroid of a loop; a loop without area has the middle of its outline.
/// \param loop corners in order \param count at least 1 \return area and centroid
/// \ingroup manifold
inline LoopArea areaOf(const ClipCorner* loop, int count) {
  const ClipCorner& o = loop[0];
  Real doubled = 0, mx = 0, my = 0, mh = 0, reach = 0;
  for (int i = 1; i + 1 < count; ++i) {
    const Real bx = loop[i].x - o.x, by = loop[i].y - o.y, bh = loop[i].height - o.height;
    const Real cx = loop[i + 1].x - o.x, cy = loop[i + 1].y - o.y;
    const Real ch = loop[i + 1].height - o.height;
    const Real area = bx * cy - by * cx;
    doubled += area;
    mx += area * (bx + cx);
    my += area * (by + cy);
    mh += area * (bh + ch);
    reach = std::max(reach, bx * bx + by * by);
  }
  // As in polygonCentroid(): what rounding leaves of a line's area is none.
  constexpr Real kRounding = 1e-15;
  if (std::abs(doubled) > kRounding * reach) {
    const Real third = 1 / (3 * doubled);
    return {std::abs(doubled) / 2, o.x + mx * third, o.y + my * third, o.height + mh * third};
  }
  LoopArea line{0, o.x, o.y, o.height};
  Real around = 0, x = 0, y = 0, h = 0;
  for (int i = 0; i < count; ++i) {
    const ClipCorner& a = loop[i];
    const ClipCorner& b = loop[i + 1 < count ? i + 1 : 0];
    const Real edge = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    around += edge;
    x += edge / 2 * (a.x + b.x - 2 * o.x);
    y += edge / 2 * (a.y + b.y - 2 * o.y);
    h += edge / 2 * (a.height + b.height - 2 * o.height);
  }
  if (around > 0) {
    line.x += x / around;
    line.y += y / around;
    line.height += h / around;
  }
  return line;
}

/// reduceContacts() in the plane of the loop, in fixed memory.
/// \param loop corners in order \param index numbers of the corners to choose from, in order
/// \param n how many, more than 4 \param chosen receives four of the numbers, in order
/// \ingroup manifold
void reduceLoop(const ClipCorner* loop, const int* index, int n, int* chosen);

/// Puts the deepest point of a contact among the points if none of them is as deep: in the place,
/// and under the name, of one that is near, or beside them if there is room. A manifold without
/// points gets it as its only one.
/// \param position of the deepest point, halfway between the surfaces [m, world]
/// \param separation its separation [m]
/// \param reach size of the bodies: depths within kDepthTie of it are equal, points within a tenth
///   of it near [m]
/// \param id its name where it stands beside the others
/// \param manifold is changed
/// \ingroup manifold
void keepDeepest(const Vector3& position, Real separation, Real reach, std::uint32_t id,
                 Manifold& manifold);

/// Fills a manifold from a loop over a reference face.
/// \tparam Name callable: (label before, label after) of a corner gives its id
/// \param plane the reference plane
/// \param loop corners in order \param count how many
/// \param limit corners higher than this are no contact [m]
/// \param name makes the ids
/// \param manifold receives points, count, area and centroid; not the normal
/// \ingroup manifold
template <class Name>
inline void fillFromLoop(const ReferencePlane& plane, const ClipCorner* loop, int count, Real limit,
                         const Name& name, Manifold& manifold) {
  manifold.count = 0;
  manifold.area = 0;
  int below[kMostCorners];
  int n = 0;
  for (int i = 0; i < count; ++i) {
    below[n] = i;
    n += loop[i].height <= limit ? 1 : 0;
  }
  if (n == 0) return;

  const auto toWorld = [&](Real x, Real y, Real height) -> Vector3 {
    return plane.origin + x * plane.u + y * plane.v + (height / 2) * plane.normal;
  };

  // Area: of the whole loop, or of the part that the plane cuts off.
  LoopArea area;
  if (n == count) {
    area = areaOf(loop, count);
  } else {
    ClipCorner part[kMostCorners];
    const int left = clipLoop(
        loop, count, -1, [limit](const ClipCorner& c) { return c.height - limit; }, 0, part);
    area = areaOf(part, left);
  }
  manifold.area = area.area;
  manifold.areaCentroid = toWorld(area.x, area.y, area.height);

  int chosen[4] = {below[0], below[n > 1 ? 1 : 0], below[n > 2 ? 2 : 0], below[n > 3 ? 3 : 0]};
  if (n > 4) reduceLoop(loop, below, n, chosen);
  manifold.count = std::min(n, 4);
  for (int k = 0; k < manifold.count; ++k) {
    const int i = chosen[k];
    const ClipCorner& corner = loop[i];
    ManifoldPoint& point = manifold.points[k];
    point.position = toWorld(corner.x, corner.y, corner.height);
    point.separation = corner.height;
    point.id = name(loop[i > 0 ? i - 1 : count - 1].label, corner.label);
  }
}

}  // namespace carom::detail
