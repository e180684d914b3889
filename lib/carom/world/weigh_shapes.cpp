#include "carom/world/weigh_shapes.hpp"

#include <variant>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/mass/combine_bodies.hpp"
#include "carom/mass/inertia_about.hpp"
#include "carom/mass/standard_solids.hpp"

namespace carom::world {

namespace {

// The skin of a hull: its faces cut into triangles.
TriangleMesh meshOf(const ConvexHull& hull) {
  TriangleMesh mesh;
  mesh.vertices = hull.vertices;
  for (const HullFace& face : hull.faces) {
    const auto corner = [&](std::int32_t i) {
      return hull.halfEdges[static_cast<std::size_t>(face.firstHalfEdge + i)].origin;
    };
    for (std::int32_t i = 1; i + 1 < face.count; ++i) {
      mesh.triangles.push_back({corner(0), corner(i), corner(i + 1)});
    }
  }
  return mesh;
}

struct Weigh {
  Real density;

  MassProperties operator()(const Ball& ball) const {
    return solidBall(ball.radius, density);
  }
  MassProperties operator()(const Box& box) const {
    return solidBox(2 * box.halfExtents, density);
  }
  MassProperties operator()(const Capsule& capsule) const {
    return solidCapsule(capsule.radius, 2 * capsule.halfLength, density);
  }
  MassProperties operator()(const Cylinder& cylinder) const {
    return solidCylinder(cylinder.radius, 2 * cylinder.halfHeight, density);
  }
  MassProperties operator()(const ConvexHull& hull) const {
    return massPropertiesOfGoodMesh(meshOf(hull), density);
  }
};

void add(std::vector<MassProperties>& parts, MassProperties part, const Pose& pose) {
  part.center = pointToWorld(pose, part.center);
  part.inertia = rotateInertia(part.inertia, pose.R_WB);
  parts.push_back(part);
}

}  // namespace

MassProperties weighShapes(std::span<const ShapeDescription> shapes) {
  std::vector<MassProperties> parts;
  for (const ShapeDescription& shape : shapes) {
    const Weigh weigh{shape.density};
    const auto weighKind = [&](const auto& kind) {
      using Kind = std::decay_t<decltype(kind)>;
      if constexpr (std::is_same_v<Kind, Compound>) {
        for (const CompoundPart& part : kind.parts) {
          add(parts, std::visit(weigh, part.shape), composed(shape.pose, part.pose));
        }
      } else if constexpr (!std::is_same_v<Kind, HalfSpace>) {
        add(parts, weigh(kind), shape.pose);
      }
    };
    std::visit(weighKind, shape.shape);
  }
  if (parts.empty()) throw InvalidInput("a dynamic body needs a mass, or shapes to weigh");
  return parts.size() == 1 ? parts.front() : combineBodies(parts);
}

}  // namespace carom::world
