// Two boxes, judged by quadruple precision: the table of random pairs at fixed gaps.

#include <cmath>
#include <vector>

#include "box_truth.hpp"
#include "carom/core/errors.hpp"
#include "carom/detection/sat_boxes.hpp"
#include "carom/detection/separate_boxes.hpp"
#include "sat_reference.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

struct BoxesAtGap {
  Box a, b;
  Pose A, B;
};

// Random boxes, pushed together along a random direction until the true gap is as wanted.
BoxesAtGap boxesAtGap(Random& random, Real gap) {
  BoxesAtGap pair;
  pair.a = randomBox(random);
  pair.b = randomBox(random);
  pair.A = randomPose(random, 1);
  pair.B = randomPose(random, 1);
  const Vector3 direction = randomDirection(random);
  Real low = 0, high = 6;
  for (int n = 0; n < 60; ++n) {
    const Real middle = (low + high) / 2;
    pair.B.p_WB = pair.A.p_WB + middle * direction;
    (trueAxes(pair.a, pair.A, pair.b, pair.B)[0].gap > gap ? high : low) = middle;
  }
  return pair;
}

}  // namespace

TEST_CASE("random boxes at fixed gaps: depth to 1e-14, no wrong normal, no wrong verdict") {
  for (const Real gap : {-0.1, -1e-3, -1e-6, -1e-9, -1e-12, 1e-9, 1e-6}) {
    Random random(5);
    Real worstDepth = 0, worstNormal = 0;
    int wrongVerdicts = 0, dependsOnOrder = 0;
    for (int n = 0; n < 400; ++n) {
      const BoxesAtGap p = boxesAtGap(random, gap);
      const std::vector<TrueAxis> truth = trueAxes(p.a, p.A, p.b, p.B);
      const SeparatingAxis axis = separateBoxes(p.a, p.A, p.b, p.B);
      worstDepth = std::max(worstDepth, std::abs(axis.separation - truth[0].gap));
      if (truth[0].gap - truth[1].gap >= 1e-9) {
        worstNormal = std::max(worstNormal, degreesBetween(axis.axis, truth[0].normal));
      }
      wrongVerdicts += axis.verdict != verdictOf(truth[0].gap) ? 1 : 0;
      const SeparatingAxis swapped = separateBoxes(p.b, p.B, p.a, p.A);
      const bool mirrored = swapped.separation == axis.separation && swapped.axis == -axis.axis &&
                            swapped.featureA == axis.featureB && swapped.verdict == axis.verdict;
      dependsOnOrder += mirrored ? 0 : 1;
    }
    CAPTURE(gap);
    CHECK(worstDepth <= 1e-14);
    CHECK(worstNormal <= 1e-6);
    CHECK(wrongVerdicts == 0);
    CHECK(dependsOnOrder == 0);
  }
}

TEST_CASE("boxes with nearly parallel edges keep their digits") {
  // B is turned by a small angle against A about a random axis; the edges that win then meet at
  // that angle.
  Real worst = 0;
  int wrongVerdicts = 0;
  Random random(6);
  for (int n = 0; n < 2000; ++n) {
    const Box a = randomBox(random), b = randomBox(random);
    const Pose A = randomPose(random, 1);
    const Real angle = std::pow(10.0, random.between(-14, -1));
    const Vector3 axis = std::sin(angle / 2) * randomDirection(random);
    const Pose turn = poseOf({std::cos(angle / 2), axis.x(), axis.y(), axis.z()}, {0, 0, 0});
    Pose B = composed(A, turn);
    const Vector3 direction = randomDirection(random);
    Real low = 0, high = 6;
    for (int i = 0; i < 50; ++i) {
      const Real middle = (low + high) / 2;
      B.p_WB = A.p_WB + middle * direction;
      (trueAxes(a, A, b, B)[0].gap > 1e-9 ? high : low) = middle;
    }
    const Real truth = trueAxes(a, A, b, B)[0].gap;
    const SeparatingAxis found = separateBoxes(a, A, b, B);
    // A face may be chosen where edges are better by less than a tie, and a larger face where
    // another is better by less than that.
    worst = std::max(worst, std::abs(found.separation - truth));
    wrongVerdicts += found.verdict != verdictOf(truth) ? 1 : 0;
  }
  CHECK(worst <= 1e-14 + 2 * kAxisTie * 6);
  CHECK(wrongVerdicts == 0);
}

TEST_CASE("the least displacement of two boxes really separates them") {
  Random random(7);
  int stuck = 0;
  for (int n = 0; n < 2000; ++n) {
    const BoxesAtGap p{randomBox(random), randomBox(random), randomPose(random, 0.5),
                       randomPose(random, 0.5)};
    const SeparatingAxis axis = separateBoxes(p.a, p.A, p.b, p.B);
    if (axis.verdict != Verdict::overlapping) continue;
    Pose moved = p.B;
    moved.p_WB += (-axis.separation + 1e-14) * axis.axis;
    stuck += trueAxes(p.a, p.A, p.b, moved)[0].gap < 0 ? 1 : 0;
  }
  CHECK(stuck == 0);
}

TEST_CASE("boxes that touch exactly are called touching, in every orientation that is exact") {
  // Quarter turns, and thirds of a turn about the diagonal, have exact matrices; so has the 3-4-5
  // rotation times 1/8 of a box of 5/8: its corners are not exact, but its gap is.
  const Box a{{1, 0.5, 0.25}}, b{{0.5, 1, 2}};
  int wrong = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real side : {-1.0, 1.0}) {
      Pose A, B;
      A.R_WB << 0, 0, 1, 1, 0, 0, 0, 1, 0;
      B.R_WB << 0, -1, 0, 1, 0, 0, 0, 0, 1;
      const auto reach = [](const Box& box, const Pose& pose, int k) {
        return pose.R_WB.row(k).cwiseAbs().dot(box.halfExtents);
      };
      A.p_WB = {1e6, -3, 7};
      B.p_WB = A.p_WB;
      B.p_WB[axis] += side * (reach(a, A, axis) + reach(b, B, axis));
      wrong += separateBoxes(a, A, b, B).verdict != Verdict::touching ? 1 : 0;
      B.p_WB[axis] = std::nextafter(B.p_WB[axis], side * 1e9);
      wrong += separateBoxes(a, A, b, B).verdict != Verdict::separated ? 1 : 0;
      B.p_WB[axis] = std::nextafter(B.p_WB[axis], -side * 1e9);
      B.p_WB[axis] = std::nextafter(B.p_WB[axis], -side * 1e9);
      wrong += separateBoxes(a, A, b, B).verdict != Verdict::overlapping ? 1 : 0;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a witness axis changes the time and not the verdict") {
  Random random(8);
  WitnessAxis kept;
  int wrong = 0, apart = 0;
  for (int n = 0; n < 3000; ++n) {
    const Box a = randomBox(random), b = randomBox(random);
    const Pose A = randomPose(random, 1), B = randomPose(random, 1);
    WitnessAxis fresh;
    const bool cold = boxesAreApart(a, A, b, B, 0.01, fresh);
    wrong += boxesAreApart(a, A, b, B, 0.01, kept) != cold ? 1 : 0;  // a witness of another pair
    wrong += boxesAreApart(a, A, b, B, 0.01, fresh) != cold ? 1 : 0;
    wrong += cold != (separateBoxes(a, A, b, B).separation > 0.01) ? 1 : 0;
    apart += cold ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(apart > 200);
  CHECK(apart < 2700);
}
