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
#include "carom/manifold/swap_manifold.hpp"

namespace carom {
namespace {

// Whether a pair is to be treated as (b, a): by kind, then by position and orientation.
bool comesSecond(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B) {
  if (a.index() != b.index()) return a.index() > b.index();
  for (int k = 0; k < 3; ++k) {
    if (A.p_WB[k] != B.p_WB[k]) return A.p_WB[k] > B.p_WB[k];
  }
  for (int k = 0; k < 9; ++k) {
    if (A.R_WB.data()[k] != B.R_WB.data()[k]) return A.R_WB.data()[k] > B.R_WB.data()[k];
  }
  const auto sizesOf = [](const ConvexShape& shape) -> Vector2 {
    if (const Capsule* capsule = std::get_if<Capsule>(&shape)) {
      return {capsule->radius, capsule->halfLength};
    }
    if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) {
      return {cylinder->radius, cylinder->halfHeight};
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

}  // namespace

Manifold collide(const ConvexShape& a, const Pose& A, const ConvexShape& b, const Pose& B,
                 ManifoldCache* cache, Real margin) {
  // Pairs that order themselves.
  const Box* boxA = std::get_if<Box>(&a);
  const Box* boxB = std::get_if<Box>(&b);
  const ConvexHull* hullA = std::get_if<ConvexHull>(&a);
  const ConvexHull* hullB = std::get_if<ConvexHull>(&b);
  if (boxA != nullptr && boxB != nullptr) return collideBoxes(*boxA, A, *boxB, B, cache, margin);
  if (hullA != nullptr && hullB != nullptr) {
    return collideHulls(*hullA, A, *hullB, B, cache, margin);
  }
  if (boxA != nullptr && hullB != nullptr) {
    return collideBoxAndHull(*boxA, A, *hullB, B, cache, margin);
  }
  if (hullA != nullptr && boxB != nullptr) {
    // The cache knows the bodies in the order of the call below, every time.
    return swapped(collideBoxAndHull(*boxB, B, *hullA, A, cache, margin));
  }
  if (comesSecond(a, A, b, B)) return swapped(collide(b, B, a, A, cache, margin));
  // A ball is the first kind, so a pair with a ball has it as A.
  if (const Ball* ball = std::get_if<Ball>(&a)) {
    return swapped(collideWithBall(b, B, *ball, A, margin));
  }
  return collideFeatures(a, A, b, B, margin);
}

namespace {

int partsOf(const Shape& shape) {
  const Compound* compound = std::get_if<Compound>(&shape);
  return compound != nullptr ? static_cast<int>(compound->parts.size()) : 1;
}

// Calls `use` with part i of a body, a Ball, Box, Capsule, Cylinder or ConvexHull, and its pose.
template <class Use>
void withPart(const Shape& shape, const Pose& pose, int i, const Use& use) {
  std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, Compound>) {
          const CompoundPart& part = kind.parts[static_cast<std::size_t>(i)];
          const Pose placed = composed(pose, part.pose);
          std::visit([&](const auto& convex) { use(convex, placed); }, part.shape);
        } else if constexpr (!std::is_same_v<Kind, HalfSpace>) {
          use(kind, pose);
        }
      },
      shape);
}

// Polyhedra are handed on as they are; only the other kinds are wrapped, which copies them.
template <class A, class B>
Manifold collideParts(const A& a, const Pose& poseA, const B& b, const Pose& poseB,
                      ManifoldCache* cache, Real margin) {
  constexpr bool kBoxA = std::is_same_v<A, Box>, kBoxB = std::is_same_v<B, Box>;
  constexpr bool kHullA = std::is_same_v<A, ConvexHull>, kHullB = std::is_same_v<B, ConvexHull>;
  if constexpr (kBoxA && kBoxB) {
    return collideBoxes(a, poseA, b, poseB, cache, margin);
  } else if constexpr (kHullA && kHullB) {
    return collideHulls(a, poseA, b, poseB, cache, margin);
  } else if constexpr (kBoxA && kHullB) {
    return collideBoxAndHull(a, poseA, b, poseB, cache, margin);
  } else if constexpr (kHullA && kBoxB) {
    return swapped(collideBoxAndHull(b, poseB, a, poseA, cache, margin));
  } else {
    return collide(ConvexShape(a), poseA, ConvexShape(b), poseB, cache, margin);
  }
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
        withPart(b, B, j, [&](const auto& part, const Pose& pose) {
          manifold = collideHalfSpace(*floorA, A, part, pose, margin);
        });
      } else if (floorB != nullptr) {
        withPart(a, A, i, [&](const auto& part, const Pose& pose) {
          manifold = swapped(collideHalfSpace(*floorB, B, part, pose, margin));
        });
      } else {
        withPart(a, A, i, [&](const auto& partA, const Pose& poseA) {
          withPart(b, B, j, [&](const auto& partB, const Pose& poseB) {
            manifold = collideParts(partA, poseA, partB, poseB, cache, margin);
          });
        });
      }
      if (manifold.count > 0) manifolds.push_back({i, j, manifold});
    }
  }
}

}  // namespace carom
