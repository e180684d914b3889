// What every manifold must be, on random bodies with fixed seeds.

#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/support.hpp"
#include "carom/manifold/collide.hpp"
#include "carom/manifold/collide_boxes.hpp"
#include "carom/manifold/collide_half_space.hpp"
#include "carom/manifold/collide_hulls.hpp"
#include "carom/manifold/plain_manifold.hpp"
#include "manifold_reference.hpp"

using namespace carom;
using namespace carom_test;

namespace {

ConvexShape randomShape(Random& random, int kind) {
  const Real x = random.between(0.3, 1), y = random.between(0.3, 1), z = random.between(0.3, 1);
  switch (kind) {
    case 0:
      return Ball{x};
    case 1:
      return Box{{x, y, z}};
    case 2:
      return Capsule{x / 2, y};
    case 3:
      return Cylinder{x, y};
    default:
      return randomHull(random, 14);
  }
}

// Both bodies moved by one rigid motion.
Pose movedBy(const Pose& motion, const Pose& pose) {
  return composed(motion, pose);
}

Real deepestOf(const Manifold& manifold) {
  Real deepest = 1e300;
  for (int k = 0; k < manifold.count; ++k) {
    deepest = std::min(deepest, manifold.points[static_cast<std::size_t>(k)].separation);
  }
  return deepest;
}

Real largestDifference(const Manifold& x, const Manifold& y, const Pose& motion) {
  Real worst = (directionToWorld(motion, x.normal) - y.normal).norm();
  worst = std::max(worst, std::abs(x.area - y.area));
  worst = std::max(worst, (pointToWorld(motion, x.areaCentroid) - y.areaCentroid).norm());
  for (int i = 0; i < x.count; ++i) {
    // The same points, in any order.
    Real nearest = 1e300;
    for (int k = 0; k < y.count; ++k) {
      const ManifoldPoint& p = x.points[static_cast<std::size_t>(i)];
      const ManifoldPoint& q = y.points[static_cast<std::size_t>(k)];
      nearest = std::min(nearest, (pointToWorld(motion, p.position) - q.position).norm() +
                                      std::abs(p.separation - q.separation));
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

}  // namespace

TEST_CASE("points lie on both bodies, the normal has length one, names differ, swapping mirrors") {
  const char* names[] = {"ball", "box", "capsule", "cylinder", "hull"};
  for (int kindA = 0; kindA < 5; ++kindA) {
    for (int kindB = 0; kindB < 5; ++kindB) {
      CAPTURE(names[kindA], names[kindB]);
      Random random(static_cast<std::uint64_t>(100 + 5 * kindA + kindB));
      const bool round = kindA == 2 || kindA == 3 || kindB == 2 || kindB == 3;
      Real offSurface = 0, normal = 0;
      int contacts = 0, notMirrored = 0, sameNames = 0, otherWithCache = 0, noneDeep = 0;
      for (int n = 0; n < 150; ++n) {
        const ConvexShape a = randomShape(random, kindA), b = randomShape(random, kindB);
        const Pose A = randomPose(random, 0.8), B = randomPose(random, 0.8);
        const Manifold manifold = collide(a, A, b, B);
        notMirrored += same(mirrored(collide(b, B, a, A)), manifold) ? 0 : 1;
        ManifoldCache cache;
        for (int again = 0; again < 2; ++again) {
          otherWithCache += same(collide(a, A, b, B, &cache), manifold) ? 0 : 1;
        }
        if (manifold.count == 0) continue;
        ++contacts;
        normal = std::max(normal, std::abs(manifold.normal.norm() - 1));
        offSurface = std::max(offSurface, worstOffSurface(manifold, a, A, b, B));
        sameNames += namesDiffer(manifold) ? 0 : 1;
        // Moved apart by the deepest point's depth, the bodies do not touch any more.
        Real deepest = 0;
        for (int k = 0; k < manifold.count; ++k) {
          deepest = std::min(deepest, manifold.points[static_cast<std::size_t>(k)].separation);
        }
        Pose freed = B;
        freed.p_WB += ((round ? 1e-6 : 1e-9) - deepest) * manifold.normal;
        noneDeep += collide(a, A, b, freed).count != 0 ? 1 : 0;
      }
      CHECK(contacts > 20);
      CHECK(normal <= 2e-15);
      CHECK(sameNames == 0);
      CHECK(notMirrored == 0);
      CHECK(otherWithCache == 0);
      // Chords of a cap's polygon of 32 corners run 0.5 % of the radius inside the circle.
      const bool cap = kindA == 3 || kindB == 3;
      CHECK(offSurface <= (cap ? 6e-3 : round ? 1e-6 : 1e-13));
      CHECK(noneDeep == 0);
    }
  }
}

TEST_CASE("points of shallow contacts lie on both surfaces") {
  for (int kindA = 0; kindA < 5; ++kindA) {
    for (int kindB = 0; kindB < 5; ++kindB) {
      CAPTURE(kindA, kindB);
      Random random(static_cast<std::uint64_t>(200 + 5 * kindA + kindB));
      Real offSurface = 0, deepestOver = 0;
      int contacts = 0;
      for (int n = 0; n < 60; ++n) {
        const ConvexShape a = randomShape(random, kindA), b = randomShape(random, kindB);
        const Pose A = randomPose(random, 0.5);
        Pose B = randomPose(random, 0.5);
        const Vector3 direction = randomDirection(random);
        // Pushed together until they touch, then 1 mm farther.
        Real low = 0, high = 5;
        for (int i = 0; i < 40; ++i) {
          const Real middle = (low + high) / 2;
          B.p_WB = A.p_WB + middle * direction;
          (collide(a, A, b, B).count == 0 ? high : low) = middle;
        }
        B.p_WB = A.p_WB + (low - 1e-3) * direction;
        const Manifold manifold = collide(a, A, b, B);
        REQUIRE(manifold.count > 0);
        ++contacts;
        offSurface = std::max(offSurface, worstOffSurface(manifold, a, A, b, B));
        for (int k = 0; k < manifold.count; ++k) {
          deepestOver = std::max(deepestOver,
                                 -manifold.points[static_cast<std::size_t>(k)].separation - 1e-3);
        }
      }
      CHECK(contacts == 60);
      // No deeper than the push, and on both surfaces: the corners of a cap's polygon to rounding,
      // crossings of its chords to their distance from the circle.
      CHECK(deepestOver <= 1e-9);
      CHECK(offSurface <= (kindA == 3 || kindB == 3 ? 6e-3 : 1e-9));
    }
  }
}

TEST_CASE("a rigid motion of both bodies moves the manifold with them") {
  for (int kindA = 0; kindA < 5; ++kindA) {
    for (int kindB = kindA; kindB < 5; ++kindB) {
      CAPTURE(kindA, kindB);
      Random random(static_cast<std::uint64_t>(300 + 5 * kindA + kindB));
      Real worst = 0;
      int otherCount = 0, contacts = 0;
      for (int n = 0; n < 200; ++n) {
        const ConvexShape a = randomShape(random, kindA), b = randomShape(random, kindB);
        const Pose A = randomPose(random, 0.6), B = randomPose(random, 0.6);
        const Pose motion = randomPose(random, 10);
        const Manifold here = collide(a, A, b, B);
        const Manifold there = collide(a, movedBy(motion, A), b, movedBy(motion, B));
        otherCount += here.count != there.count ? 1 : 0;
        if (here.count == 0 || there.count == 0) continue;
        ++contacts;
        const bool closedForm =
            kindA == 0 || ((kindA == 1 || kindA == 4) && (kindB == 1 || kindB == 4));
        if (closedForm && here.count == there.count) {
          worst = std::max(worst, largestDifference(here, there, motion));
        } else {
          // The normal of an iteration is right to a few millionths; where two lines are nearly
          // parallel the place of their deepest point hangs on it more than that.
          worst =
              std::max(worst, 1e-7 * (directionToWorld(motion, here.normal) - there.normal).norm());
          worst = std::max(worst, 1e-7 * std::abs(deepestOf(here) - deepestOf(there)));
        }
      }
      CHECK(contacts > 30);
      CHECK(otherCount <= (kindA == 0 || kindA == 1 || kindA == 4 ? 0 : 2));
      CHECK(worst <= 1e-11);
    }
  }
}

TEST_CASE("boxes on boxes: area and centroid are those of the overlap of two rectangles") {
  Random random(41);
  Real worstArea = 0, worstCentroid = 0, worstMeanOfPoints = 0;
  for (int n = 0; n < 1000; ++n) {
    const Box a = randomBox(random), b = randomBox(random);
    // Stacked along z in the frame of A, shifted, all of it turned anyhow.
    const Real x = random.between(-0.25, 0.25), y = random.between(-0.25, 0.25);
    const Pose A = randomPose(random, 3);
    Pose relative;
    relative.p_WB = {x, y, a.halfExtents.z() + b.halfExtents.z() - 1e-3};
    const Pose B = composed(A, relative);
    const Real low[2] = {std::max(-a.halfExtents.x(), x - b.halfExtents.x()),
                         std::max(-a.halfExtents.y(), y - b.halfExtents.y())};
    const Real high[2] = {std::min(a.halfExtents.x(), x + b.halfExtents.x()),
                          std::min(a.halfExtents.y(), y + b.halfExtents.y())};
    const Real area = (high[0] - low[0]) * (high[1] - low[1]);
    const Vector3 centroid_A((low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
                             a.halfExtents.z() - 0.5e-3);
    for (const Manifold& manifold :
         {collideBoxes(a, A, b, B), collideBoxAndHull(a, A, boxHull(b.halfExtents), B)}) {
      REQUIRE(manifold.count == 4);
      worstArea = std::max(worstArea, std::abs(manifold.area / area - 1));
      worstCentroid =
          std::max(worstCentroid, (manifold.areaCentroid - pointToWorld(A, centroid_A)).norm());
      Vector3 mean = Vector3::Zero();
      for (const ManifoldPoint& point : manifold.points) mean += point.position / 4;
      worstMeanOfPoints = std::max(worstMeanOfPoints, (mean - manifold.areaCentroid).norm());
    }
  }
  CHECK(worstArea <= 1e-12);
  CHECK(worstCentroid <= 1e-12);
  CHECK(worstMeanOfPoints <= 1e-12);  // a rectangle's corners do have the centroid as their mean
}

TEST_CASE("the fast manifold of two polyhedra is the plain one") {
  Random random(42);
  Real worst = 0;
  int otherCount = 0, contacts = 0;
  for (int n = 0; n < 400; ++n) {
    const ConvexHull a = randomHull(random, 6 + n % 9), b = randomHull(random, 6 + n % 7);
    const Pose A = randomPose(random, 0.4), B = randomPose(random, 0.4);
    const Manifold fast = collideHulls(a, A, b, B), plain = plainManifold(a, A, b, B);
    if ((fast.count == 0) != (plain.count == 0)) ++otherCount;
    if (fast.count == 0 || plain.count == 0) continue;
    ++contacts;
    worst = std::max(worst, (fast.normal - plain.normal).norm());
    Real deepFast = 0, deepPlain = 0;
    for (int k = 0; k < fast.count; ++k) {
      deepFast = std::min(deepFast, fast.points[static_cast<std::size_t>(k)].separation);
    }
    for (int k = 0; k < plain.count; ++k) {
      deepPlain = std::min(deepPlain, plain.points[static_cast<std::size_t>(k)].separation);
    }
    worst = std::max(worst, std::abs(deepFast - deepPlain));
  }
  CHECK(contacts > 200);
  CHECK(otherCount == 0);
  CHECK(worst <= 1e-13);
}

TEST_CASE("a box resting on a box keeps its points and their names while it rocks by a billionth") {
  const Box lower{{1, 1, 0.25}}, upper{{0.4, 0.5, 0.3}};
  const Pose A;
  Random random(43);
  std::vector<std::uint32_t> first;
  int changed = 0;
  Real worst = 0;
  for (int n = 0; n < 2000; ++n) {
    const Real x = random.between(-1e-9, 1e-9), y = random.between(-1e-9, 1e-9);
    const Pose B = poseOf({1, x, y, 0.1}, {0.1, -0.2, 0.55 - 1e-5});
    const Manifold manifold = collideBoxes(lower, A, upper, B);
    std::vector<std::uint32_t> names;
    for (int k = 0; k < manifold.count; ++k) {
      names.push_back(manifold.points[static_cast<std::size_t>(k)].id);
      worst =
          std::max(worst, std::abs(manifold.points[static_cast<std::size_t>(k)].separation + 1e-5));
    }
    std::sort(names.begin(), names.end());
    if (first.empty()) first = names;
    changed += names != first ? 1 : 0;
  }
  CHECK(first.size() == 4);
  CHECK(changed == 0);
  CHECK(worst <= 3e-9);
}

TEST_CASE("with a margin, bodies that are apart by less have points with positive separation") {
  Random random(44);
  int wrong = 0, points = 0;
  for (int n = 0; n < 600; ++n) {
    const ConvexShape a = randomShape(random, n % 5), b = randomShape(random, (n / 5) % 5);
    const Pose A = randomPose(random, 1), B = randomPose(random, 1);
    const Manifold near = collide(a, A, b, B, nullptr, 0.05), touching = collide(a, A, b, B);
    if (touching.count > 0 && near.count == 0) ++wrong;
    if (touching.count > 0 || near.count == 0) continue;
    for (int k = 0; k < near.count; ++k) {
      const Real separation = near.points[static_cast<std::size_t>(k)].separation;
      wrong += separation <= 0 || separation > 0.05 + 1e-12 ? 1 : 0;
      ++points;
    }
  }
  CHECK(wrong == 0);
  CHECK(points > 10);
}

TEST_CASE("a floor under every shape") {
  const HalfSpace floor{{0, 0, 1}, 0.5};
  const Pose here;
  Pose B;
  struct Standing {
    ConvexShape shape;
    Real height;
    int points;
    Real area;
  };
  const Real kPi = std::acos(-1.0);
  const std::vector<Standing> bodies = {
      {Ball{0.7}, 0.7, 1, 0},
      {Box{{0.4, 0.3, 0.2}}, 0.2, 4, 0.48},
      {Cylinder{0.4, 0.6}, 0.6, 4, 16 * std::sin(kPi / 16) * 0.16},
      {boxHull({0.4, 0.3, 0.2}), 0.2, 4, 0.48},
      {Capsule{0.2, 0.5}, 0.7, 1, 0}};
  for (const Standing& body : bodies) {
    B.p_WB = {3, -4, 0.5 + body.height - 0.01};
    const Manifold manifold = collideHalfSpace(floor, here, body.shape, B);
    CHECK(manifold.normal == Vector3(0, 0, 1));
    CHECK(manifold.count == body.points);
    CHECK(std::abs(manifold.area - body.area) <= 1e-14);
    CHECK((manifold.areaCentroid - Vector3(3, -4, 0.495)).norm() <= 1e-14);
    for (int k = 0; k < manifold.count; ++k) {
      CHECK(std::abs(manifold.points[static_cast<std::size_t>(k)].separation + 0.01) <= 1e-15);
    }
    B.p_WB.z() += 0.02;
    CHECK(collideHalfSpace(floor, here, body.shape, B).count == 0);
  }
  // A capsule on its side touches at both ends of its line.
  Pose lying = poseOf({1, 0, 1, 0}, {0, 0, 0.69});
  const Manifold line = collideHalfSpace(floor, here, Capsule{0.2, 0.5}, lying);
  REQUIRE(line.count == 2);
  CHECK(std::abs((line.points[0].position - line.points[1].position).norm() - 1) <= 1e-15);
}

TEST_CASE("a box that stands on an edge is held at both ends of it") {
  const HalfSpace floor{{0, 0, 1}, 0};
  const Cylinder table{3, 1};
  const Pose under = poseOf({1, 0, 0, 0}, {0, 0, -1});
  const Box box{{1, 0.5, 0.5}};
  const ConvexHull hull = boxHull(box.halfExtents);
  for (const Real angle : {0.7853981633974483, 0.5, 0.2}) {
    INFO("turned by " << angle);
    const Real height = 0.5 * (std::sin(angle) + std::cos(angle)) - 1e-3;
    const Pose B = poseOf({std::cos(angle / 2), std::sin(angle / 2), 0, 0}, {0, 0, height});
    for (const Manifold& manifold :
         {collideHalfSpace(floor, Pose(), box, B), collideHalfSpace(floor, Pose(), hull, B),
          collide(table, under, box, B), collide(table, under, hull, B)}) {
      REQUIRE(manifold.count == 2);
      CHECK((manifold.normal - Vector3(0, 0, 1)).norm() <= 1e-12);
      const Vector3 edge = manifold.points[1].position - manifold.points[0].position;
      CHECK(std::abs(std::abs(edge.x()) - 2) <= 1e-12);
      CHECK(edge.tail<2>().norm() <= 1e-12);
      for (const auto k : {0u, 1u}) CHECK(std::abs(manifold.points[k].separation + 1e-3) <= 1e-12);
      CHECK(manifold.points[0].id != manifold.points[1].id);
    }
  }
}

TEST_CASE("the deepest point of any body over a floor is among its points") {
  Random random(45);
  const HalfSpace floor{{0, 0, 1}, 0};
  Real worst = 0;
  for (int n = 0; n < 1000; ++n) {
    const ConvexShape shape = randomShape(random, n % 5);
    const Pose A = randomPose(random, 2);
    Pose B = randomPose(random, 0);
    B.p_WB = pointToWorld(A, {0, 0, random.between(-0.2, 0.2)});
    const Manifold manifold = collideHalfSpace(floor, A, shape, B);
    REQUIRE(manifold.count > 0);
    const Vector3 normal = A.R_WB.col(2);
    const Support support = supportOf(shape, B.R_WB.transpose() * -normal);
    const Real depth = normal.dot(pointToWorld(B, support.point) - A.p_WB);
    Real deepest = 1;
    for (int k = 0; k < manifold.count; ++k) {
      deepest = std::min(deepest, manifold.points[static_cast<std::size_t>(k)].separation);
    }
    worst = std::max(worst, std::abs(deepest - depth));
  }
  CHECK(worst <= 1e-8);
}

TEST_CASE("compounds touch part by part") {
  const Compound dumbbell =
      makeCompound({{Ball{0.5}, Pose()}, {Ball{0.5}, Pose{Matrix3::Identity(), {3, 0, 0}}}});
  const Shape a = dumbbell;
  const Shape b = Box{{5, 1, 0.5}};
  Pose B;
  B.p_WB = {1.5, 0, -0.99};
  std::vector<PartManifold> manifolds;
  collide(a, Pose(), b, B, manifolds);
  REQUIRE(manifolds.size() == 2);
  CHECK(manifolds[0].partA == 0);
  CHECK(manifolds[1].partA == 1);
  for (const PartManifold& part : manifolds) {
    CHECK(part.partB == 0);
    CHECK(part.manifold.count == 1);
    CHECK((part.manifold.normal - Vector3(0, 0, -1)).norm() <= 1e-15);
    CHECK(std::abs(part.manifold.points[0].separation + 0.01) <= 1e-15);
  }
  CHECK(pairsOfParts(a, b) == 2);
  std::vector<ManifoldCache> caches(2), wrong(3);
  std::vector<PartManifold> again;
  collide(a, Pose(), b, B, again, caches);
  CHECK(again.size() == 2);
  CHECK_THROWS_AS(collide(a, Pose(), b, B, again, wrong), InvalidInput);
  CHECK_THROWS_AS(collide(a, Pose(), b, B, again, {}, -1), InvalidInput);

  const Shape floor = HalfSpace{{0, 0, 1}, 0};
  CHECK_THROWS_AS(collide(floor, Pose(), floor, Pose(), again), InvalidInput);
  Pose low;
  low.p_WB = {0, 0, 0.4};
  collide(floor, Pose(), a, low, again);
  REQUIRE(again.size() == 2);
  CHECK(again[1].partB == 1);
  CHECK(again[0].manifold.normal == Vector3(0, 0, 1));
  collide(a, low, floor, Pose(), again);
  CHECK(again[0].manifold.normal == Vector3(0, 0, -1));
}

TEST_CASE("equal boxes that stand straight on each other keep their points through rounding") {
  // Corners over corners, faces of one size, positions of one x and y: everything ties, and the
  // poses differ from step to step in their last digits only.
  const Box box{{0.5, 0.5, 0.5}};
  const ConvexHull hull = boxHull(box.halfExtents);
  Random random(46);
  std::vector<std::uint32_t> first[2];
  int changed = 0, fewer = 0;
  for (int n = 0; n < 2000; ++n) {
    const auto noise = [&random] { return random.between(-1e-15, 1e-15); };
    Pose A = poseOf({1, noise(), noise(), noise()}, {0, 0, 0});
    Pose B = poseOf({1, noise(), noise(), noise()}, {0, 0, 1 - 1e-4});
    A.p_WB += Vector3(noise(), noise(), noise());
    B.p_WB += Vector3(noise(), noise(), noise());
    for (int k = 0; k < 2; ++k) {
      const Manifold manifold =
          k == 0 ? collideBoxes(box, A, box, B) : collideHulls(hull, A, hull, B);
      fewer += manifold.count != 4 ? 1 : 0;
      std::vector<std::uint32_t> names;
      for (int i = 0; i < manifold.count; ++i) {
        names.push_back(manifold.points[static_cast<std::size_t>(i)].id);
      }
      std::sort(names.begin(), names.end());
      if (first[k].empty()) first[k] = names;
      changed += names != first[k] ? 1 : 0;
    }
  }
  CHECK(fewer == 0);
  CHECK(changed == 0);
}
