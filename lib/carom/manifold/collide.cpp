#include "carom/manifold/collide.hpp"

#include <string>
#include <type_traits>
#include <variant>

#include "carom/core/checks.hpp"
#include "carom/manifold/collide_balls.hpp"
#include "carom/manifold/collide_boxes.hpp"
#include "carom/manifold/collide_features.hpp"
#include "carom/manifold/collide_half_space.hpp"
#include "carom/manifold/collide_hulls.hpp"
#include "carom/manifold/shape_view.hpp"
#include "carom/manifold/swap_manifold.hpp"

namespace carom {
namespace {

using detail::ShapeView;

// Whether a pair is to be treated as (b, a): by kind, then by position, orientation and size.
bool comesSecond(const ShapeView& a, const Pose& A, const ShapeView& b, const Pose& B) {
  if (a.index() != b.index()) return a.index() > b.index();
  if (const int order = comparePoses(A, B); order != 0) return order > 0;
  const auto sizesOf = [](const ShapeView& shape) -> Vector2 {
    if (const auto* ball = std::get_if<const Ball*>(&shape)) return {(*ball)->radius, 0};
    if (const auto* capsule = std::get_if<const Capsule*>(&shape)) {
      return {(*capsule)->radius, (*capsule)->halfLength};
    }
    if (const auto* cylinder = std::get_if<const Cylinder*>(&shape)) {
      return {(*cylinder)->radius, (*cylinder)->halfHeight};
    }
    return {0, 0};
  };
  const Vector2 ofA = sizesOf(a), ofB = sizesOf(b);
  return ofA.x() != ofB.x() ? ofA.x() > ofB.x() : ofA.y() > ofB.y();
}

Manifold swapped(Manifold manifold) {
  detail::swapBodies(manifold);
  return manifold;
}

// The one place where pairs of kinds meet their methods.
Manifold collideViews(const ShapeView& a, const Pose& A, const ShapeView& b, const Pose& B,
                      ManifoldCache* cache, Real margin) {
  const auto* ballA = std::get_if<const Ball*>(&a);
  const auto* ballB = std::get_if<const Ball*>(&b);
  if (ballA != nullptr && ballB != nullptr) {
    if (comesSecond(a, A, b, B)) return swapped(collideBalls(**ballB, B, **ballA, A, margin));
    return collideBalls(**ballA, A, **ballB, B, margin);
  }
  const auto* boxA = std::get_if<const Box*>(&a);
  const auto* boxB = std::get_if<const Box*>(&b);
  const auto* hullA = std::get_if<const ConvexHull*>(&a);
  const auto* hullB = std::get_if<const ConvexHull*>(&b);
  // Pairs that order themselves.
  if (boxA != nullptr && boxB != nullptr) return collideBoxes(**boxA, A, **boxB, B, cache, margin);
  if (hullA != nullptr && hullB != nullptr) {
    return collideHulls(**hullA, A, **hullB, B, cache, margin);
  }
  if (boxA != nullptr && hullB != nullptr) {
    return collideBoxAndHull(**boxA, A, **hullB, B, cache, margin);
  }
  if (hullA != nullptr && boxB != nullptr) {
    // The cache knows the bodies in the order of the call below, every time.
    return swapped(collideBoxAndHull(**boxB, B, **hullA, A, cache, margin));
  }
  const bool swap = comesSecond(a, A, b, B);
  const ShapeView& first = swap ? b : a;
  const ShapeView& second = swap ? a : b;
  const Pose& poseOfFirst = swap ? B : A;
  const Pose& poseOfSecond = swap ? A : B;
  Manifold manifold;
  // A ball is the first kind, so a pair with a ball has it first.
  if (const auto* ball = std::get_if<const Ball*>(&first)) {
    manifold =
        swapped(detail::collideWithBallOf(second, poseOfSecond, **ball, poseOfFirst, margin));
  } else {
    manifold = detail::collideFeaturesOf(first, poseOfFirst, second, poseOfSecond, margin);
  }
  if (swap) detail::swapBodies(manifold);
  return manifold;
}

}  // namespace

Manifold collide(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                 ManifoldCache* cache, Real margin) {
  return collideViews(detail::viewOfShape(a), A, detail::viewOfShape(b), B, cache, margin);
}

namespace {

int partsOf(const Shape& shape) {
  const Compound* compound = std::get_if<Compound>(&shape);
  return compound != nullptr ? static_cast<int>(compound->parts.size()) : 1;
}

// A convex part of a body, placed.
struct Part {
  ShapeView shape;
  Pose pose;
};

// Part i of a body that is no half-space.
Part partOf(const Shape& shape, const Pose& pose, int i) {
  if (const Compound* compound = std::get_if<Compound>(&shape)) {
    const CompoundPart& part = compound->parts[static_cast<std::size_t>(i)];
    return {detail::viewOfShape(part.shape), composed(pose, part.pose)};
  }
  const auto view = [](const auto& kind) -> ShapeView {
    using Kind = std::decay_t<decltype(kind)>;
    if constexpr (std::is_same_v<Kind, Compound> || std::is_same_v<Kind, HalfSpace>) {
      return ShapeView();
    } else {
      return &kind;
    }
  };
  return {std::visit(view, shape), pose};
}

}  // namespace

int pairsOfParts(const Shape& a, const Shape& b) {
  return partsOf(a) * partsOf(b);
}

void collide(const Shape& a, const Pose& A, const Shape& b, const Pose& B,
             std::vector<PartManifold>& manifolds, std::span<ManifoldCache> caches, Real margin) {
  requireNonNegative(margin, "margin of collide");
  const HalfSpace* floorA = std::get_if<HalfSpace>(&a);
  const HalfSpace* floorB = std::get_if<HalfSpace>(&b);
  if (floorA != nullptr && floorB != nullptr) {
    throw InvalidInput("collide: a half-space against a half-space has no points of contact");
  }
  if (!caches.empty() && static_cast<int>(caches.size()) != pairsOfParts(a, b)) {
    reject("number of caches", std::to_string(caches.size()),
           "must be the number of pairs of parts, " + std::to_string(pairsOfParts(a, b)));
  }
  manifolds.clear();
  const int countA = partsOf(a), countB = partsOf(b);
  for (int i = 0; i < countA; ++i) {
    for (int j = 0; j < countB; ++j) {
      Manifold manifold;
      ManifoldCache* cache =
          caches.empty() ? nullptr : &caches[static_cast<std::size_t>(i * countB + j)];
      if (floorA != nullptr) {
        const Part part = partOf(b, B, j);
        manifold = detail::collideHalfSpaceWith(*floorA, A, part.shape, part.pose, margin);
      } else if (floorB != nullptr) {
        const Part part = partOf(a, A, i);
        manifold = swapped(detail::collideHalfSpaceWith(*floorB, B, part.shape, part.pose, margin));
      } else {
        const Part partA = partOf(a, A, i), partB = partOf(b, B, j);
        manifold = collideViews(partA.shape, partA.pose, partB.shape, partB.pose, cache, margin);
      }
      if (manifold.count > 0) manifolds.push_back({i, j, manifold});
    }
  }
}

}  // namespace carom
