// Two polyhedra: the fast search against the plain one, hints, order of arguments, exact touching.

#include <cmath>
#include <vector>

#include "carom/detection/hull_axes.hpp"
#include "carom/detection/sat_hulls.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "sat_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

TEST_CASE("the search that leaves most axes out finds what trying all of them finds") {
  Random random(21);
  Real worst = 0, worstNormal = 0;
  int wrongVerdicts = 0, otherFeatures = 0, overlapping = 0, crossings = 0;
  for (int n = 0; n < 400; ++n) {
    const ConvexHull a = randomHull(random, 4 + n % 17), b = randomHull(random, 4 + n % 13);
    const Pose A = randomPose(random, 0.3), B = randomPose(random, 0.3 + 0.002 * n);
    const SeparatingAxis plain = satHulls(a, A, b, B);
    const SeparatingAxis fast = separateHulls(a, A, b, B);
    wrongVerdicts += fast.verdict != plain.verdict ? 1 : 0;
    if (plain.verdict != Verdict::overlapping) continue;
    ++overlapping;
    crossings += fast.kind == AxisKind::edges ? 1 : 0;
    worst = std::max(worst, std::abs(fast.separation - plain.separation));
    if (fast.kind != plain.kind || fast.featureA != plain.featureA ||
        fast.featureB != plain.featureB) {
      ++otherFeatures;
    } else {
      worstNormal = std::max(worstNormal, (fast.axis - plain.axis).norm());
    }
  }
  CHECK(overlapping > 100);
  CHECK(crossings > 30);
  CHECK(wrongVerdicts == 0);
  CHECK(otherFeatures == 0);
  CHECK(worst <= 4e-15);
  CHECK(worstNormal <= 1e-14);
}

TEST_CASE("hints, right or wrong, do not change the best axis of two polyhedra") {
  Random random(22);
  int different = 0;
  detail::HullHint stale;
  for (int n = 0; n < 1500; ++n) {
    const ConvexHull a = randomHull(random, 12), b = randomHull(random, 8);
    const Pose A = randomPose(random, 0.2), B = randomPose(random, 0.2);
    const detail::HullPair pair = detail::hullPair(detail::viewOf(a), A, detail::viewOf(b), B);
    const detail::HullAxis cold = detail::bestHullAxis(pair, nullptr, 0);
    if (cold.separation > 0) continue;
    const detail::HullHint own{cold.kind, cold.featureA, cold.featureB};
    for (const detail::HullHint& hint : {own, stale}) {
      const detail::HullAxis warm = detail::bestHullAxis(pair, &hint, 0);
      const bool same = warm.separation == cold.separation && warm.normal == cold.normal &&
                        warm.kind == cold.kind && warm.featureA == cold.featureA &&
                        warm.featureB == cold.featureB;
      different += same ? 0 : 1;
    }
    stale = own;
  }
  CHECK(different == 0);
}

TEST_CASE("swapping two polyhedra turns the axis and changes nothing else") {
  Random random(23);
  int different = 0;
  for (int n = 0; n < 500; ++n) {
    const ConvexHull a = randomHull(random, 10), b = randomHull(random, 10);
    const Pose A = randomPose(random, 0.5), B = randomPose(random, 0.5);
    const SeparatingAxis one = separateHulls(a, A, b, B), other = separateHulls(b, B, a, A);
    const bool mirrored = one.separation == other.separation && one.axis == -other.axis &&
                          one.featureA == other.featureB && one.verdict == other.verdict;
    different += mirrored ? 0 : 1;
  }
  CHECK(different == 0);
}

TEST_CASE("boxes as hulls have the axis that they have as boxes") {
  Random random(24);
  Real worst = 0;
  int otherKind = 0, overlapping = 0;
  for (int n = 0; n < 1000; ++n) {
    const Box a = randomBox(random), b = randomBox(random);
    const Pose A = randomPose(random, 0.4), B = randomPose(random, 0.4);
    const SeparatingAxis boxes = separateBoxes(a, A, b, B);
    if (boxes.verdict != Verdict::overlapping) continue;
    ++overlapping;
    const SeparatingAxis hulls =
        separateHulls(boxHull(a.halfExtents), A, boxHull(b.halfExtents), B);
    const SeparatingAxis mixed = separateBoxAndHull(a, A, boxHull(b.halfExtents), B);
    worst = std::max(worst, std::abs(boxes.separation - hulls.separation));
    worst = std::max(worst, std::abs(boxes.separation - mixed.separation));
    otherKind += boxes.kind != hulls.kind || mixed.kind != hulls.kind ? 1 : 0;
  }
  CHECK(overlapping > 300);
  CHECK(worst <= 4e-15);
  CHECK(otherKind == 0);
}

TEST_CASE("polyhedra far from their own origin and from the world's are judged alike") {
  // The same pair, once about the origin, once with corners at a million metres: the verdict of
  // integers does not change, since all of them are exact.
  CaseNumbers numbers(31);
  int wrong = 0, touching = 0;
  for (int n = 0; n < 300; ++n) {
    std::vector<Vector3> near[2], far[2];
    for (int body = 0; body < 2; ++body) {
      for (int i = 0; i < 5; ++i) {
        const Real x = static_cast<Real>(numbers.next() % 8),
                   y = static_cast<Real>(numbers.next() % 8),
                   z = static_cast<Real>(numbers.next() % 8);
        near[body].emplace_back(x + 4.0 * body, y, z);
        far[body].push_back(near[body].back() + Vector3(1e6, -2e6, 5e5));
      }
    }
    std::vector<ConvexHull> hulls;
    try {
      for (const std::vector<Vector3>& points : {near[0], near[1], far[0], far[1]}) {
        hulls.push_back(hullOfPoints(points));
      }
    } catch (const std::exception&) {
      continue;  // five points in a plane
    }
    const Pose here;
    const Verdict verdict = separateHulls(hulls[0], here, hulls[1], here).verdict;
    wrong += separateHulls(hulls[2], here, hulls[3], here).verdict != verdict ? 1 : 0;
    touching += verdict == Verdict::touching ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(touching > 5);
}
