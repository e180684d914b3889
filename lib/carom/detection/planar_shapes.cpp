#include "carom/detection/planar_shapes.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/limits.hpp"
#include "carom/precision/exact_determinant.hpp"

namespace carom {
namespace {

std::string cornerText(std::size_t index, const Vector2& corner) {
  return std::to_string(index) + " at (" + toText(corner.x()) + ", " + toText(corner.y()) + ")";
}

// Positive if a, b, c turn left. Exact: lifted to z = 1 the three points span a determinant.
Real turn(const Vector2& a, const Vector2& b, const Vector2& c) {
  return exactDeterminant({a.x(), a.y(), 1}, {b.x(), b.y(), 1}, {c.x(), c.y(), 1});
}

}  // namespace

Disc makeDisc(Real radius) {
  requireLength(radius, "radius of a disc");
  return {radius};
}

Polygon makePolygon(std::span<const Vector2> vertices) {
  const std::size_t count = vertices.size();
  if (count < 3) reject("polygon", std::to_string(count) + " corners", "must have at least 3");
  for (const Vector2& v : vertices) {
    requireCoordinate(v.x(), "corner of a polygon");
    requireCoordinate(v.y(), "corner of a polygon");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    if (turn(vertices[i], vertices[j], vertices[(i + 2) % count]) > 0) continue;
    reject("corner", cornerText(j, vertices[j]),
           "must be a left turn: corners of a convex polygon run counter-clockwise; cut a concave "
           "one into convex parts");
  }
  // Left turns alone also make a star that runs round twice. Seen from corner 0 the others must
  // come in order.
  for (std::size_t i = 1; i + 1 < count; ++i) {
    if (turn(vertices[0], vertices[i], vertices[i + 1]) > 0) continue;
    reject("corner", cornerText(i + 1, vertices[i + 1]),
           "must follow counter-clockwise: the polygon runs round more than once");
  }

  Polygon polygon{{vertices.begin(), vertices.end()}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2 edge = vertices[(i + 1) % count] - vertices[i];
    const Vector3 outward = scaledToOne({edge.y(), -edge.x(), 0});
    polygon.normals.push_back(outward.head<2>() / outward.norm());
  }
  return polygon;
}

PlanarCompound makePlanarCompound(std::vector<PlanarCompoundPart> parts) {
  if (parts.empty()) reject("planar compound", "0 parts", "must have at least one part");
  for (const PlanarCompoundPart& part : parts) {
    requireUsable(part.pose, "pose of a part");
    if (const Disc* disc = std::get_if<Disc>(&part.shape)) {
      requireLength(disc->radius, "radius of a disc");
    } else if (std::get<Polygon>(part.shape).vertices.size() < 3) {
      reject("polygon", "fewer than 3 corners", "must be made by makePolygon()");
    }
  }
  return {std::move(parts)};
}

}  // namespace carom
