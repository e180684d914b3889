#include "scenes/overlaps.hpp"

#include <algorithm>
#include <limits>

#include "carom/detection/sat_boxes.hpp"
#include "carom/detection/separate_hulls.hpp"
#include "carom/detection/signed_distance.hpp"

namespace carom::scenes {
namespace {

// No point of the body is farther from its centre; infinite for a half-space.
Real radiusOf(const Shape& shape) {
  if (const Ball* ball = std::get_if<Ball>(&shape)) return ball->radius;
  if (const Box* box = std::get_if<Box>(&shape)) return box->halfExtents.norm();
  if (const ConvexHull* hull = std::get_if<ConvexHull>(&shape)) {
    return hull->boundingRadius + hull->centroid.norm();
  }
  return std::numeric_limits<Real>::infinity();
}

}  // namespace

Real gapOf(const Body& a, const State& A, const Body& b, const State& B) {
  const Ball* ballA = std::get_if<Ball>(&a.shape);
  const Ball* ballB = std::get_if<Ball>(&b.shape);
  if (ballA && ballB) {
    return (B.position - A.position).norm() - ballA->radius - ballB->radius;
  }
  const Pose poseA = poseOfState(A), poseB = poseOfState(B);
  const Box* boxA = std::get_if<Box>(&a.shape);
  const Box* boxB = std::get_if<Box>(&b.shape);
  if (boxA && boxB) return satBoxes(*boxA, poseA, *boxB, poseB).separation;
  const ConvexHull* hullA = std::get_if<ConvexHull>(&a.shape);
  const ConvexHull* hullB = std::get_if<ConvexHull>(&b.shape);
  if (hullA && hullB) return separateHulls(*hullA, poseA, *hullB, poseB).separation;
  return signedDistance(a.shape, poseA, b.shape, poseB).separation;
}

Overlaps overlapsOf(const Scene& scene, std::span<const State> bodies) {
  std::vector<Real> radii;
  for (const Body& body : scene.bodies) radii.push_back(radiusOf(body.shape));
  Overlaps overlaps;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t k = i + 1; k < bodies.size(); ++k) {
      const bool iMoves = scene.bodies[i].moves, kMoves = scene.bodies[k].moves;
      if (!iMoves && !kMoves) continue;
      if (iMoves && kMoves && scene.strangers) continue;
      const Real reach = radii[i] + radii[k];
      if ((bodies[i].position - bodies[k].position).squaredNorm() > reach * reach) continue;
      const Real depth = -gapOf(scene.bodies[i], bodies[i], scene.bodies[k], bodies[k]);
      if (!(depth > 0)) continue;
      overlaps.deepest = std::max(overlaps.deepest, depth);
      overlaps.mean += depth;
      overlaps.sumOfSquares += depth * depth;
      ++overlaps.pairs;
    }
  }
  if (overlaps.pairs > 0) overlaps.mean /= overlaps.pairs;
  return overlaps;
}

namespace {

class DepthJudge : public Judge {
 public:
  explicit DepthJudge(const Scene& scene) : scene_(scene) {}
  void see(Real, std::span<const State> bodies) override {
    last_ = overlapsOf(scene_, bodies);
    deepest_ = std::max(deepest_, last_.deepest);
    means_ += last_.mean, squares_ += last_.sumOfSquares, ++count_;
    energy_ = kineticEnergy(scene_, bodies);
  }
  std::vector<Figure> figures() const override {
    const Real count = static_cast<Real>(count_);
    return {
        {"kinetic energy left [J]", energy_},      {"deepest [m]", deepest_},
        {"deepest at the end [m]", last_.deepest}, {"mean depth [m]", means_ / count},
        {"mean depth at the end [m]", last_.mean}, {"mean sum of squares [m^2]", squares_ / count}};
  }

 private:
  Scene scene_;
  Overlaps last_;
  Real deepest_ = 0, means_ = 0, squares_ = 0, energy_ = 0;
  long count_ = 0;
};

}  // namespace

std::unique_ptr<Judge> depthJudge(const Scene& scene) {
  return std::make_unique<DepthJudge>(scene);
}

}  // namespace carom::scenes
