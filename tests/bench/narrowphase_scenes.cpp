#include "bench/narrowphase_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/signed_distance.hpp"

namespace carom::bench {
namespace {

using Long3 = std::array<long double, 3>;

Long3 operator-(const Long3& a, const Long3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Long3 operator+(const Long3& a, const Long3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Long3 operator*(long double s, const Long3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
long double dot(const Long3& a, const Long3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Long3 crossOf(const Long3& a, const Long3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector3 shortened(const Long3& a) {
  return {static_cast<Real>(a[0]), static_cast<Real>(a[1]), static_cast<Real>(a[2])};
}
Long3 column(const Pose& pose, int k) {
  return {pose.R_WB(0, k), pose.R_WB(1, k), pose.R_WB(2, k)};
}

Vector3 direction(Random& random) {
  while (true) {
    Vector3 v;
    for (Real& x : v) x = random.between(-1, 1);
    if (v.squaredNorm() < 1 && v.squaredNorm() > 0.01) return v.normalized();
  }
}

Pose anyPose(Random& random) {
  while (true) {
    std::array<Real, 4> q{};
    Real squared = 0;
    for (Real& x : q) {
      x = random.between(-1, 1);
      squared += x * x;
    }
    if (squared > 1 || squared < 0.01) continue;
    Vector3 p;
    for (Real& x : p) x = random.between(-1, 1);
    return poseOf({q[0], q[1], q[2], q[3]}, p);
  }
}

// Moves B along a direction until a signed distance is `gap`.
template <class Distance>
BodyPair placed(BodyPair pair, const Vector3& way, Real gap, const Distance& distance) {
  Real low = 0, high = 16;
  const Vector3 from = pair.A.p_WB;
  for (int k = 0; k < 90; ++k) {
    const Real middle = (low + high) / 2;
    pair.B.p_WB = from + middle * way;
    (distance(pair) < gap ? low : high) = middle;
  }
  return pair;
}

// The pair, and the same with B turned a little.
template <class Distance>
void addBoth(BodyPair pair, Random& random, Real gap, const Distance& distance,
             std::vector<BodyPair>& pairs) {
  const Vector3 way = direction(random);
  pairs.push_back(placed(pair, way, gap, distance));
  const Vector3 half = 5e-4 * direction(random);
  pair.B.R_WB = poseOf({1, half.x(), half.y(), half.z()}, Vector3::Zero()).R_WB * pair.B.R_WB;
  pairs.push_back(placed(pair, way, gap, distance));
}

// A hull in the world, seen from A's origin.
struct LongHull {
  const ConvexHull& hull;
  std::vector<Long3> corners;

  LongHull(const ConvexHull& h, const Pose& pose, const Vector3& origin) : hull(h) {
    for (const Vector3& v : h.vertices) {
      Long3 p{};
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        p[k] = static_cast<long double>(pose.p_WB(i)) - origin(i);
        for (int j = 0; j < 3; ++j) p[k] += static_cast<long double>(pose.R_WB(i, j)) * v(j);
      }
      corners.push_back(p);
    }
  }
  const Long3& at(std::int32_t i) const {
    return corners[static_cast<std::size_t>(i)];
  }
  // Corner i of a face.
  const Long3& ofFace(const HullFace& face, std::int32_t i) const {
    return at(hull.halfEdges[static_cast<std::size_t>(face.firstHalfEdge + i)].origin);
  }
};

long double lowest(const LongHull& h, const Long3& axis) {
  long double best = dot(h.corners[0], axis);
  for (const Long3& p : h.corners) best = std::min(best, dot(p, axis));
  return best;
}

// Both directions of an axis. `bound` is the height over each other of a point of B and one of A:
// no gap is larger.
void tryAxis(const LongHull& a, const LongHull& b, const Long3& axis, const Long3& between,
             Judgement& best) {
  const long double length = std::sqrt(dot(axis, axis));
  if (length < 1e-9L) return;
  for (const long double sign : {1.0L, -1.0L}) {
    const Long3 n = (sign / length) * axis;
    if (dot(between, n) <= best.second) continue;
    const long double gap = lowest(b, n) + lowest(a, -1.0L * n);
    if (gap > best.gap) {
      best.second = best.gap;
      best.gap = gap;
      best.axis = shortened(n);
    } else {
      best.second = std::max(best.second, gap);
    }
  }
}

long double squareToSegment(const Long3& p, const Long3& a, const Long3& b) {
  const Long3 ab = b - a;
  const long double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0L, 1.0L);
  const Long3 d = p - (a + t * ab);
  return dot(d, d);
}

// From a corner to the inside of a triangle; a large number if it does not lie above it.
long double squareToInside(const Long3& p, const Long3& a, const Long3& b, const Long3& c) {
  const Long3 n = crossOf(b - a, c - a);
  const bool above = dot(crossOf(b - a, p - a), n) >= 0 && dot(crossOf(c - b, p - b), n) >= 0 &&
                     dot(crossOf(a - c, p - c), n) >= 0;
  if (!above) return 1e30L;
  const long double height = dot(p - a, n);
  return height * height / dot(n, n);
}

// Where both nearest points lie within the segments; ends are left to squareToSegment().
long double squareOfCrossing(const Long3& a, const Long3& b, const Long3& c, const Long3& d) {
  const Long3 u = b - a, v = d - c, w = c - a;
  const Long3 n = crossOf(u, v);
  const long double square = dot(n, n);
  if (square < 1e-18L) return 1e30L;
  const long double s = dot(crossOf(w, v), n) / square, t = dot(crossOf(w, u), n) / square;
  if (s < 0 || s > 1 || t < 0 || t > 1) return 1e30L;
  const long double height = dot(w, n);
  return height * height / square;
}

long double squareFromCorners(const LongHull& from, const LongHull& to) {
  long double least = 1e30L;
  for (const Long3& p : from.corners) {
    for (const HullFace& face : to.hull.faces) {
      for (std::int32_t i = 1; i + 1 < face.count; ++i) {
        least = std::min(least, squareToInside(p, to.ofFace(face, 0), to.ofFace(face, i),
                                               to.ofFace(face, i + 1)));
      }
    }
    for (const HullEdge& e : to.hull.edges) {
      least = std::min(least, squareToSegment(p, to.at(e.from), to.at(e.to)));
    }
  }
  return least;
}

}  // namespace

Judgement judgeBoxes(const BodyPair& pair) {
  Long3 p{};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    p[k] = static_cast<long double>(pair.B.p_WB(i)) - pair.A.p_WB(i);
  }
  std::vector<Long3> axes;
  for (int k = 0; k < 3; ++k) axes.push_back(column(pair.A, k));
  for (int k = 0; k < 3; ++k) axes.push_back(column(pair.B, k));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) axes.push_back(crossOf(column(pair.A, i), column(pair.B, j)));
  }
  Judgement best;
  for (Long3& axis : axes) {
    const long double whole = std::sqrt(dot(axis, axis));
    if (whole < 1e-6L) continue;
    axis = (1 / whole) * axis;
    long double gap = std::abs(dot(axis, p));
    for (int k = 0; k < 3; ++k) {
      gap -= std::abs(dot(axis, column(pair.A, k))) * pair.halfA(k);
      gap -= std::abs(dot(axis, column(pair.B, k))) * pair.halfB(k);
    }
    if (gap > best.gap) {
      best.second = best.gap;
      best.gap = gap;
      best.axis = shortened((dot(axis, p) < 0 ? -1.0L : 1.0L) * axis);
    } else {
      best.second = std::max(best.second, gap);
    }
  }
  return best;
}

Judgement judgeHulls(const ConvexHull& a, const ConvexHull& b, const BodyPair& pair) {
  const LongHull A(a, pair.A, pair.A.p_WB), B(b, pair.B, pair.A.p_WB);
  Judgement best;
  // Any corner of the other body bounds the gap on the normal of a face.
  for (const HullFace& face : a.faces) {
    const Long3 &p = A.ofFace(face, 0), &q = A.ofFace(face, 1), &r = A.ofFace(face, 2);
    tryAxis(A, B, crossOf(q - p, r - p), B.corners[0] - p, best);
  }
  for (const HullFace& face : b.faces) {
    const Long3 &p = B.ofFace(face, 0), &q = B.ofFace(face, 1), &r = B.ofFace(face, 2);
    tryAxis(A, B, crossOf(q - p, r - p), p - A.corners[0], best);
  }
  for (const HullEdge& e : a.edges) {
    for (const HullEdge& f : b.edges) {
      const Long3 u = A.at(e.to) - A.at(e.from), v = B.at(f.to) - B.at(f.from);
      tryAxis(A, B, crossOf(u, v), B.at(f.from) - A.at(e.from), best);
    }
  }
  if (best.gap <= 0) return best;
  long double square = std::min(squareFromCorners(A, B), squareFromCorners(B, A));
  for (const HullEdge& e : a.edges) {
    for (const HullEdge& f : b.edges) {
      square =
          std::min(square, squareOfCrossing(A.at(e.from), A.at(e.to), B.at(f.from), B.at(f.to)));
    }
  }
  best.distance = std::sqrt(square);
  return best;
}

std::vector<BodyPair> boxPairs(std::size_t count, Real gap, std::uint64_t seed) {
  Random random(seed);
  std::vector<BodyPair> pairs;
  while (pairs.size() < count) {
    BodyPair pair{anyPose(random), anyPose(random), Vector3::Ones(), Vector3::Ones()};
    for (Real& x : pair.halfA) x = random.between(0.2, 1);
    for (Real& x : pair.halfB) x = random.between(0.2, 1);
    addBoth(
        pair, random, gap, [](const BodyPair& p) { return static_cast<Real>(judgeBoxes(p).gap); },
        pairs);
  }
  return pairs;
}

std::vector<BodyPair> standingBoxes(std::size_t count, Real depth, std::uint64_t seed) {
  Random random(seed);
  std::vector<BodyPair> pairs;
  while (pairs.size() < count) {
    BodyPair pair{anyPose(random), Pose(), Vector3::Ones(), Vector3::Ones()};
    for (Real& x : pair.halfA) x = random.between(0.2, 1);
    for (Real& x : pair.halfB) x = random.between(0.2, 1);
    const Real angle = random.between(0, 1);
    const Real x = random.between(-0.3, 0.3), y = random.between(-0.3, 0.3);
    for (const Real more : {0.0, 1e-3}) {
      const Real half = (angle + more) / 2;
      const Pose onA = poseOf({std::cos(half), 0, 0, std::sin(half)},
                              {x, y, pair.halfA.z() + pair.halfB.z() - depth});
      pair.B = composed(pair.A, onA);
      pairs.push_back(pair);
    }
  }
  return pairs;
}

std::vector<BodyPair> hullPairs(const ConvexHull& a, const ConvexHull& b, std::size_t count,
                                Real gap, std::uint64_t seed) {
  Random random(seed);
  std::vector<BodyPair> pairs;
  const ConvexShape shapeA = a, shapeB = b;
  while (pairs.size() < count) {
    const BodyPair pair{anyPose(random), anyPose(random), Vector3::Ones(), Vector3::Ones()};
    addBoth(
        pair, random, gap,
        [&](const BodyPair& p) { return signedDistance(shapeA, p.A, shapeB, p.B).separation; },
        pairs);
  }
  return pairs;
}

ConvexHull cloud(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.push_back(direction(random));
  return hullOfPoints(points);
}

}  // namespace carom::bench
