#pragma once
// Any convex shape, without copying it.
//
// A body's shape is a variant of all shapes, a part of a compound a variant of the convex ones. The
// pair functions want neither to know nor to copy a hull: a pointer to the shape itself serves
// both.
// Not handled: nothing is owned; a view dies with its shape.

#include <type_traits>
#include <variant>

#include "carom/core/real.hpp"
#include "carom/detection/core_shape.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/detection/support.hpp"

namespace carom::detail {

/// A pointer to one of the convex shapes, in the order of ConvexShape. \ingroup manifold
using ShapeView =
    std::variant<const Ball*, const Box*, const Capsule*, const Cylinder*, const ConvexHull*>;

/// A view of a convex shape. \param shape must outlive the view \return the view
/// \ingroup manifold
inline ShapeView viewOfShape(const ConvexShape& shape) {
  return std::visit([](const auto& kind) -> ShapeView { return &kind; }, shape);
}

/// The core that GJK computes with. \param shape a view \return its core \ingroup manifold
inline CoreShape coreOfView(const ShapeView& shape) {
  return std::visit([](const auto* kind) { return coreOf(*kind); }, shape);
}

/// The farthest point of a shape. \param shape a view \param direction any length [body]
/// \return the point [m, body] \ingroup manifold
inline Vector3 supportOfView(const ShapeView& shape, const Vector3& direction) {
  return std::visit([&](const auto* kind) -> Vector3 { return supportOf(*kind, direction).point; },
                    shape);
}

}  // namespace carom::detail
