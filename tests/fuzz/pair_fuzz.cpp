#include "fuzz/pair_fuzz.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/detection/bounds.hpp"
#include "carom/detection/cast_ray.hpp"
#include "carom/detection/closest_point.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/signed_distance.hpp"
#include "carom/manifold/collide.hpp"

namespace carom_test {

using namespace carom;

namespace {

constexpr Real kTame = 1e8;

// Numbers from bytes: mostly tame ones, with the values that are known to hurt among them. When the bytes run out
// it answers zero, so every input ends.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  int choice(int among) {
    return take() % among;
  }
  Real number() {
    const int kind = choice(16);
    if (kind < 7) return (static_cast<Real>(word()) - 32768) / 4096;  // from -8 to 8, exact
    if (kind < 10) return choice(9) - 4;                              // small whole numbers
    if (kind < 12) return std::ldexp(static_cast<Real>(word()), choice(64) - 48);  // many sizes
    if (kind == 12) return std::nextafter(choice(5) - 2, choice(2) ? 10 : -10);    // an ulp beside
    if (kind == 13) return 1e6 + static_cast<Real>(word()) / 65536;                // far away
    if (kind == 14) return std::ldexp(static_cast<Real>(word()), -40);             // nearly nothing
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | take();
    return std::bit_cast<Real>(bits);  // anything at all
  }
  Vector3 vector() {
    const Real x = number();
    const Real y = number();
    return {x, y, number()};
  }

 private:
  unsigned take() {
    return next_ < bytes_.size() ? bytes_[next_++] : 0u;
  }
  unsigned word() {
    const unsigned high = take();
    return high << 8 | take();
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

ConvexShape convex(Bytes& bytes) {
  switch (bytes.choice(6)) {
    case 0:
      return makeBall(bytes.number());
    case 1:
      return makeBox(bytes.vector());
    case 2: {
      const Real radius = bytes.number();
      return makeCapsule(radius, bytes.number());
    }
    case 3: {
      const Real radius = bytes.number();
      return makeCylinder(radius, bytes.number());
    }
    default: {
      std::vector<Vector3> points(static_cast<std::size_t>(4 + bytes.choice(9)));
      for (auto& p : points) p = bytes.vector();
      return hullOfPoints(points);
    }
  }
}

Pose pose(Bytes& bytes) {
  const Vector3 position = bytes.vector();
  if (bytes.choice(3) == 0) return poseOf({1, 0, 0, 0}, position);
  const Real w = bytes.number();
  const Vector3 v = bytes.vector();
  return poseOf({w, v.x(), v.y(), v.z()}, position);
}

Shape shape(Bytes& bytes) {
  const int kind = bytes.choice(8);
  if (kind == 0) {
    const Vector3 normal = bytes.vector();
    return makeHalfSpace(normal, bytes.vector());
  }
  if (kind == 1) {
    Compound compound;
    for (int i = 0; i < 2; ++i) {
      const ConvexShape part = convex(bytes);
      compound.parts.push_back({part, pose(bytes)});
    }
    return makeCompound(std::move(compound.parts));
  }
  return std::visit([](auto&& s) -> Shape { return s; }, convex(bytes));
}

Real sizeOf(const Shape& s, const Pose& p) {
  if (std::holds_alternative<HalfSpace>(s)) {
    return std::max(std::abs(std::get<HalfSpace>(s).offset), p.p_WB.cwiseAbs().maxCoeff());
  }
  const Aabb<3> box = boundsOf(s, p);
  return std::max({box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff(),
                   p.p_WB.cwiseAbs().maxCoeff()});
}

bool roundOf(const ConvexShape& s) {
  return std::holds_alternative<Cylinder>(s);
}

bool roundOf(const Shape& s) {
  if (const auto* compound = std::get_if<Compound>(&s)) {
    return std::any_of(compound->parts.begin(), compound->parts.end(),
                       [](const CompoundPart& part) { return roundOf(part.shape); });
  }
  return std::holds_alternative<Cylinder>(s);
}

// Half of the smallest width of a body, or the half of that where it is cheaper to know: what is round all
// over has none that matters.
struct Thickness {
  Real operator()(const Box& s) const {
    return s.halfExtents.minCoeff();
  }
  Real operator()(const Cylinder& s) const {
    return std::min(s.radius, s.halfHeight);
  }
  Real operator()(const ConvexHull& s) const {
    Real least = s.boundingRadius;
    for (const HullFace& face : s.faces) {
      least = std::min(least, face.offset - face.normal.dot(s.centroid));
    }
    return least;
  }
  Real operator()(const Compound& s) const {
    Real least = std::numeric_limits<Real>::infinity();
    for (const CompoundPart& part : s.parts) least = std::min(least, std::visit(*this, part.shape));
    return least;
  }
  template <class Other>
  Real operator()(const Other&) const {
    return std::numeric_limits<Real>::infinity();
  }
};

// What a failure is told with.
std::string text(const Vector3& v) {
  std::ostringstream out;
  out.precision(17);
  out << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
  return out.str();
}

struct Describe {
  std::string operator()(const Ball& s) const {
    return "ball " + text({s.radius, 0, 0});
  }
  std::string operator()(const Box& s) const {
    return "box " + text(s.halfExtents);
  }
  std::string operator()(const Capsule& s) const {
    return "capsule " + text({s.radius, s.halfLength, 0});
  }
  std::string operator()(const Cylinder& s) const {
    return "cylinder " + text({s.radius, s.halfHeight, 0});
  }
  std::string operator()(const ConvexHull& s) const {
    std::string all = "hull";
    for (const Vector3& v : s.vertices) all += " " + text(v);
    return all;
  }
  std::string operator()(const HalfSpace& s) const {
    return "half-space " + text(s.normal) + " " + text({s.offset, 0, 0});
  }
  std::string operator()(const Compound& s) const {
    std::string all = "compound";
    for (const auto& part : s.parts)
      all += " [" + std::visit(*this, part.shape) + " at " + text(part.pose.p_WB) + "]";
    return all;
  }
};

std::string text(const Shape& shape, const Pose& pose) {
  std::string all = std::visit(Describe(), shape) + "\n   at " + text(pose.p_WB) + ", rows ";
  for (int i = 0; i < 3; ++i) all += text(pose.R_WB.row(i));
  return all;
}

[[noreturn]] void broken(const std::string& promise) {
  throw std::logic_error(promise);
}

void require(bool kept, const char* promise) {
  if (!kept) broken(promise);
}

bool sameBits(const Manifold& a, const Manifold& b) {
  if (a.count != b.count || a.normal != b.normal) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) {
    if (a.points[i].position != b.points[i].position ||
        a.points[i].separation != b.points[i].separation || a.points[i].id != b.points[i].id)
      return false;
  }
  return true;
}

void requireSound(const Manifold& m) {
  require(m.count >= 0 && m.count <= 4, "a manifold has 0 to 4 points");
  if (m.count == 0) return;
  require(std::abs(m.normal.norm() - 1) < 1e-12, "the normal of a manifold has length one");
  for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
    require(m.points[i].position.allFinite(), "points of contact are finite");
    require(std::isfinite(m.points[i].separation), "separations of points are finite");
  }
  require(std::isfinite(m.area) && m.area >= 0, "the area is finite and not negative");
  require(m.areaCentroid.allFinite(), "the centroid of the area is finite");
}

}  // namespace

namespace {

Tried tryBodies(const Shape& a, const Pose& A, const Shape& b, const Pose& B, const Vector3& point,
                const Ray& ray);

}  // namespace

Tried tryPair(std::span<const std::uint8_t> all) {
  Bytes bytes(all);
  Shape a;
  Shape b;
  Pose A;
  Pose B;
  try {
    a = shape(bytes);
    b = shape(bytes);
    A = pose(bytes);
    B = pose(bytes);
  } catch (const InvalidInput&) {
    return Tried::refused;
  }
  const Vector3 point = bytes.vector();
  const Ray ray{point, bytes.vector()};
  try {
    return tryBodies(a, A, b, B, point, ray);
  } catch (const std::logic_error& error) {
    throw std::logic_error(std::string(error.what()) + "\n A " + text(a, A) + "\n B " + text(b, B));
  }
}

namespace {

Tried tryBodies(const Shape& a, const Pose& A, const Shape& b, const Pose& B, const Vector3& point,
                const Ray& ray) {
  const bool tame = sizeOf(a, A) <= kTame && sizeOf(b, B) <= kTame;
  const bool planes = std::holds_alternative<HalfSpace>(a) && std::holds_alternative<HalfSpace>(b);

  const Real size = sizeOf(a, A) + sizeOf(b, B);
  const bool solid =
      std::min(std::visit(Thickness(), a), std::visit(Thickness(), b)) >= 1e-6 * size;

  const Separation d = signedDistance(a, A, b, B);
  const Separation back = signedDistance(b, B, a, A);
  if (tame && !planes) {
    require(std::isfinite(d.separation), "the signed distance is finite");
    require(d.pointA.allFinite() && d.pointB.allFinite(), "witness points are finite");
    require(std::abs(d.normal.norm() - 1) < 1e-12, "the normal has length one");
    // An iteration that ran out of steps says so, and how far off it may be.
    const bool ended =
        d.status != SeparationStatus::stalled && back.status != SeparationStatus::stalled;
    const Real band = 1e-9 * (1 + size) + d.errorBound + back.errorBound;
    if (!(std::abs(d.separation - back.separation) <= band)) {
      broken("swapping keeps the distance: " + text({d.separation, back.separation, band}));
    }
    const Vector3 between = d.pointB - d.pointA;
    // A cylinder's rim is found by ever smaller triangles: beside a body a million times smaller they give out early.
    const Real rim = roundOf(a) || roundOf(b) ? 1e-5 * size : 0;
    if (solid && ended && !((between - d.separation * d.normal).norm() <= band + rim)) {
      broken("the points show the distance: " + text(between) + " is not " +
             text({d.separation, 0, 0}) + " times " + text(d.normal));
    }
  }

  if (!planes) {
    std::vector<PartManifold> cold;
    std::vector<PartManifold> warm;
    std::vector<ManifoldCache> caches(static_cast<std::size_t>(pairsOfParts(a, b)));
    collide(a, A, b, B, cold);
    // The first fills the caches, the second uses them.
    for (int i = 0; i < 2; ++i) collide(a, A, b, B, warm, caches);
    if (tame) {
      for (const PartManifold& part : cold) requireSound(part.manifold);
      for (const PartManifold& part : warm) requireSound(part.manifold);
    }
    if (tame && solid) {
      require(cold.size() == warm.size(), "a cache changes no verdict");
      for (std::size_t i = 0; i < cold.size(); ++i) {
        require(sameBits(cold[i].manifold, warm[i].manifold), "a cache changes no bit");
      }
    }
  }
  try {
    const SurfacePoint near = closestPoint(a, A, point);
    const RayHit hit = castRay(a, A, ray);
    if (tame && point.cwiseAbs().maxCoeff() <= kTame) {
      require(near.point.allFinite() && std::isfinite(near.distance),
              "the nearest point is finite");
      require(!hit.hit || (std::isfinite(hit.t) && hit.point.allFinite() && hit.normal.allFinite()),
              "where a ray hits is finite");
    }
  } catch (const InvalidInput&) {
    // A ray without a direction, or a point that is no number.
  }
  return d.separation > 0 ? Tried::apart : Tried::overlapping;
}

}  // namespace

}  // namespace carom_test
