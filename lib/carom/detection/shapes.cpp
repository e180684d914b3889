#include "carom/detection/shapes.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "carom/core/checks.hpp"
#include "carom/core/length.hpp"
#include "carom/detection/limits.hpp"

namespace carom {
namespace {

// One check per kind; std::visit picks it, and a new kind without a check does not compile.
struct Checker {
  void operator()(const Ball& ball) const {
    requireLength(ball.radius, "radius of a ball");
  }
  void operator()(const Box& box) const {
    for (int i = 0; i < 3; ++i) requireLength(box.halfExtents(i), "half extent of a box");
  }
  void operator()(const Capsule& capsule) const {
    requireLength(capsule.radius, "radius of a capsule");
    requireLength(capsule.halfLength, "half length of a capsule");
  }
  void operator()(const Cylinder& cylinder) const {
    requireLength(cylinder.radius, "radius of a cylinder");
    requireLength(cylinder.halfHeight, "half height of a cylinder");
  }
  void operator()(const ConvexHull& hull) const {
    if (hull.vertices.size() < 4 || hull.faces.size() < 4) {
      reject("hull", std::to_string(hull.vertices.size()) + " vertices",
             "must be made by hullOfPoints() or hullFromFaces()");
    }
  }
  void operator()(const HalfSpace& space) const {
    requireFinite(space.normal, "normal of a half-space");
    requireCoordinate(space.offset, "offset of a half-space");
    // A normal that was divided by its length is within a few ulp of length one.
    if (!(std::abs(space.normal.squaredNorm() - 1) <= 1e-14)) {
      reject("normal of a half-space", toText(space.normal), "must have length one");
    }
  }
  void operator()(const Compound& compound) const {
    if (compound.parts.empty()) reject("compound", "0 parts", "must have at least one part");
    for (const CompoundPart& part : compound.parts) {
      std::visit(*this, part.shape);
      requireUsable(part.pose, "pose of a part");
    }
  }
};

}  // namespace

Ball makeBall(Real radius) {
  const Ball ball{radius};
  Checker{}(ball);
  return ball;
}

Box makeBox(const Vector3& halfExtents) {
  const Box box{halfExtents};
  Checker{}(box);
  return box;
}

Capsule makeCapsule(Real radius, Real halfLength) {
  const Capsule capsule{radius, halfLength};
  Checker{}(capsule);
  return capsule;
}

Cylinder makeCylinder(Real radius, Real halfHeight) {
  const Cylinder cylinder{radius, halfHeight};
  Checker{}(cylinder);
  return cylinder;
}

HalfSpace makeHalfSpace(const Vector3& normal, const Vector3& point) {
  requireFinite(normal, "normal of a half-space");
  requireCoordinates(point, "point of a half-space");
  const Vector3 scaled = scaledToOne(normal);  // so that no length overflows
  if (scaled.isZero(0)) reject("normal of a half-space", toText(normal), "must not be zero");
  const Vector3 unit = scaled / scaled.norm();
  return {unit, unit.dot(point)};
}

Compound makeCompound(std::vector<CompoundPart> parts) {
  Compound compound{std::move(parts)};
  Checker{}(compound);
  return compound;
}

void requireUsable(const Shape& shape) {
  std::visit(Checker{}, shape);
}

}  // namespace carom
