#include "carom/detection/expanding_polytope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "carom/core/cross.hpp"
#include "carom/precision/exact_determinant.hpp"

namespace carom::detail {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();
constexpr Real kNothing = 1e-140;  // 2^-600 times kLargestLength, rounded up

// Polytopes of boxes and hulls need 10 to 30 corners, curved ones 20 to 100. A cylinder about the
// axis of a box would need any number, because all its ways out are nearly equal: it is stopped here.
constexpr int kMostCorners = 160;
constexpr int kMostFaces = 4 * kMostCorners;

// No member is set by default: clearing all that a polytope might need would take longer than
// growing it takes.
struct Face {
  std::array<std::int16_t, 3> corners;
  std::array<std::int16_t, 3> neighbors;  // i: across the edge from corner i to i + 1
  bool alive;
  bool seen;
  Vector3 normal;
  Real distance;  // of its plane from the origin, signed
};

struct Corner {
  Vector3 difference;
  Vector3 pointA;
  Vector3 pointB;
};

// All on the stack: a step of the simulation allocates nothing.
struct Polytope {
  std::array<Corner, kMostCorners> corners;
  std::array<Face, kMostFaces> faces;
  std::array<std::int16_t, kMostCorners> fromCorner;
  int cornerCount = 0;
  int faceCount = 0;

  void add(const SimplexVertex<3>& vertex) {
    Corner& corner = corners[static_cast<std::size_t>(cornerCount++)];
    corner.difference = vertex.difference;
    // Exact signs multiply three coordinates; the last digits of what is smaller would not fit.
    for (Real& x : corner.difference) {
      if (std::abs(x) < kNothing) x = 0;
    }
    corner.pointA = vertex.pointA;
    corner.pointB = vertex.pointB;
  }
  int add(int a, int b, int c, int ab, int bc, int ca) {
    Face& face = faces[static_cast<std::size_t>(faceCount)];
    face.corners = {static_cast<std::int16_t>(a), static_cast<std::int16_t>(b),
                    static_cast<std::int16_t>(c)};
    face.neighbors = {static_cast<std::int16_t>(ab), static_cast<std::int16_t>(bc),
                      static_cast<std::int16_t>(ca)};
    face.alive = true;
    face.seen = false;
    return faceCount++;
  }
  const Vector3& at(int corner) const {
    return corners[static_cast<std::size_t>(corner)].difference;
  }
  Face& face(int f) {
    return faces[static_cast<std::size_t>(f)];
  }
};

void setPlane(Polytope& polytope, Face& face) {
  const Vector3& a = polytope.at(face.corners[0]);
  const Vector3& b = polytope.at(face.corners[1]);
  const Vector3& c = polytope.at(face.corners[2]);
  const Vector3 ab = b - a, bc = c - b, ca = a - c;
  Vector3 longest = ab;
  if (bc.squaredNorm() > longest.squaredNorm()) longest = bc;
  if (ca.squaredNorm() > longest.squaredNorm()) longest = ca;
  Vector3 normal = cross(ab, bc);
  // Rounding tilts the normal of a needle along the needle; its longest edge takes that out.
  normal -= normal.dot(longest) / longest.squaredNorm() * longest;
  const Real whole = normal.norm();
  face.normal = normal;
  face.distance = kInfinity;
  // A needle thinner than rounding has no direction, and its neighbours cover what it covers.
  if (!(whole > 64 * kEpsilon * longest.squaredNorm())) return;
  face.normal = normal / whole;
  face.distance = std::max({face.normal.dot(a), face.normal.dot(b), face.normal.dot(c)});
}

// A tetrahedron to begin with: two points far apart, one far from their line, one far from the plane
// of the three. Each is looked for where it must be, square to what is there already.
bool firstTetrahedron(const CorePair& pair, const Simplex<3>& seed, Polytope& polytope,
                      int& iterations) {
  std::array<SimplexVertex<3>, 16> candidates;
  std::size_t count = 0;
  for (int i = 0; i < seed.count; ++i) {
    candidates[count++] = seed.vertices[static_cast<std::size_t>(i)];
  }
  const auto askBothWays = [&](const Vector3& direction) {
    candidates[count++] = pair(direction);
    candidates[count++] = pair(-direction);
    iterations += 2;
  };
  const auto farthest = [&](const auto& measure) {
    std::size_t best = 0;
    Real most = -1;
    for (std::size_t i = 0; i < count; ++i) {
      const Real value = measure(candidates[i].difference);
      if (value > most) {
        most = value;
        best = i;
      }
    }
    return best;
  };
  std::array<std::size_t, 4> chosen{};
  if (count < 2) askBothWays(Vector3::UnitX());
  const Vector3 o = candidates[0].difference;
  chosen[1] = farthest([&](const Vector3& x) { return (x - o).squaredNorm(); });
  const Vector3 u = candidates[chosen[1]].difference - o;
  if (count < 4) {
    int least = 0;
    u.cwiseAbs().minCoeff(&least);
    const Vector3 aside = cross(u, Vector3::Unit(least));
    if (aside.isZero(0)) return false;
    askBothWays(aside);
    askBothWays(cross(u, aside));
  }
  chosen[2] = farthest([&](const Vector3& x) { return cross(u, x - o).squaredNorm(); });
  const Vector3 n = cross(u, candidates[chosen[2]].difference - o);
  if (count != 4 || seed.count != 4) {
    if (n.isZero(0)) return false;
    askBothWays(n);
  }
  chosen[3] = farthest([&](const Vector3& x) { return std::abs(n.dot(x - o)); });

  for (const std::size_t k : chosen) polytope.add(candidates[k]);
  const int side = orientation(polytope.at(0), polytope.at(1), polytope.at(2), polytope.at(3));
  if (side == 0) return false;
  if (side > 0) std::swap(polytope.corners[1], polytope.corners[2]);
  // As in hull_of_points.cpp, point 3 is behind the triangle 0, 1, 2.
  polytope.add(0, 1, 2, 1, 2, 3);
  polytope.add(1, 0, 3, 0, 3, 2);
  polytope.add(2, 1, 3, 0, 1, 3);
  polytope.add(0, 2, 3, 0, 2, 1);
  for (int f = 0; f < 4; ++f) setPlane(polytope, polytope.face(f));
  return true;
}

bool sees(const Polytope& polytope, const Face& face, int corner) {
  return orientation(polytope.at(face.corners[0]), polytope.at(face.corners[1]),
                     polytope.at(face.corners[2]), polytope.at(corner)) > 0;
}

// Joins the last corner to the rim of what it sees, starting from a face. False if it sees nothing
// (it lies on the surface), or there is no room.
bool grow(Polytope& polytope, int start) {
  const int corner = polytope.cornerCount - 1;
  if (!sees(polytope, polytope.face(start), corner)) return false;
  std::array<std::int16_t, kMostFaces> seen;
  int seenCount = 1;
  seen[0] = static_cast<std::int16_t>(start);
  polytope.face(start).seen = true;
  int rim = 0;
  for (int k = 0; k < seenCount; ++k) {
    for (const std::int16_t f : polytope.face(seen[static_cast<std::size_t>(k)]).neighbors) {
      Face& face = polytope.face(f);
      if (face.seen) continue;
      if (!sees(polytope, face, corner)) {
        ++rim;
        continue;
      }
      face.seen = true;
      seen[static_cast<std::size_t>(seenCount++)] = f;
    }
  }
  if (polytope.faceCount + rim > kMostFaces) return false;

  const int firstNew = polytope.faceCount;
  for (int k = 0; k < seenCount; ++k) {
    const std::int16_t f = seen[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int16_t outside = polytope.face(f).neighbors[i];
      if (polytope.face(outside).seen) continue;
      const std::int16_t u = polytope.face(f).corners[i];
      const std::int16_t v = polytope.face(f).corners[(i + 1) % 3];
      const auto fresh = static_cast<std::int16_t>(polytope.add(u, v, corner, outside, -1, -1));
      setPlane(polytope, polytope.face(fresh));
      std::replace(polytope.face(outside).neighbors.begin(), polytope.face(outside).neighbors.end(),
                   f, fresh);
      polytope.fromCorner[static_cast<std::size_t>(u)] = fresh;
    }
  }
  for (int f = firstNew; f < polytope.faceCount; ++f) {
    const std::int16_t next =
        polytope.fromCorner[static_cast<std::size_t>(polytope.face(f).corners[1])];
    polytope.face(f).neighbors[1] = next;
    polytope.face(next).neighbors[2] = static_cast<std::int16_t>(f);
  }
  for (int k = 0; k < seenCount; ++k) {
    polytope.face(seen[static_cast<std::size_t>(k)]).alive = false;
  }
  return true;
}

// Lets the polytope reach the seed's other corners too: the seed holds the origin, or comes as near
// to it as rounding lets it see, and a polytope without it may have the origin far beside it.
void growToSeed(const Simplex<3>& seed, Polytope& polytope) {
  for (int i = 0; i < seed.count; ++i) {
    const SimplexVertex<3>& vertex = seed.vertices[static_cast<std::size_t>(i)];
    // Corners that it has already would cost exact signs that are all zero.
    const auto end = polytope.corners.begin() + polytope.cornerCount;
    const bool known = std::any_of(polytope.corners.begin(), end, [&vertex](const Corner& corner) {
      return corner.pointA == vertex.pointA && corner.pointB == vertex.pointB;
    });
    if (known) continue;
    polytope.add(vertex);
    bool outside = false;
    for (int f = 0; f < polytope.faceCount && !outside; ++f) {
      outside = polytope.face(f).alive && grow(polytope, f);
    }
    if (!outside) --polytope.cornerCount;
  }
}

int nearestFace(const Polytope& polytope) {
  int best = -1;
  Real least = kInfinity;
  for (int f = 0; f < polytope.faceCount; ++f) {
    const Face& face = polytope.faces[static_cast<std::size_t>(f)];
    if (face.alive && face.distance < least) {
      least = face.distance;
      best = f;
    }
  }
  return best;
}

// The mix of corners that lies over the origin, and the points of A and B that it mixes. A flat side
// of the difference is many triangles at one distance, so the one under the origin is looked for.
void setWitnesses(const Polytope& polytope, Real noise, Penetration& result) {
  const Vector3 foot = result.depth * result.normal;
  Real least = kInfinity;
  for (int f = 0; f < polytope.faceCount; ++f) {
    const Face& face = polytope.faces[static_cast<std::size_t>(f)];
    if (!face.alive || !(std::abs(face.distance - result.depth) <= noise + result.errorBound)) {
      continue;
    }
    Simplex<3> simplex;
    for (const std::int16_t corner : face.corners) {
      const Corner& from = polytope.corners[static_cast<std::size_t>(corner)];
      simplex.vertices[static_cast<std::size_t>(simplex.count++)] = {
          from.difference - foot, from.pointA, from.pointB, -1, -1};
    }
    // Seen from the foot of the perpendicular, the nearest point of the face has the weights.
    const Real squared = closestToOrigin(simplex).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    witnessPoints(simplex, result.pointA, result.pointB);
  }
}

}  // namespace

Penetration expandPolytope(const CorePair& pair, const Simplex<3>& seed, Real size) {
  Penetration result;
  Polytope polytope;
  if (!firstTetrahedron(pair, seed, polytope, result.iterations)) {
    result.flat = true;
    return result;
  }
  growToSeed(seed, polytope);
  // A support point is known to a few ulp of the coordinates: what is nearer is no progress.
  const Real noise = 4 * kEpsilon * size;
  Face face;
  face.distance = kInfinity;
  for (int best = nearestFace(polytope); best >= 0; best = nearestFace(polytope)) {
    face = polytope.face(best);
    const SimplexVertex<3> fresh = pair(face.normal);
    ++result.iterations;
    result.normal = face.normal;
    result.depth = std::max(face.normal.dot(fresh.difference), face.distance);
    result.errorBound = result.depth - face.distance;
    if (result.errorBound <= noise) result.errorBound = 0;
    if (result.errorBound == 0 || polytope.cornerCount == kMostCorners) break;
    polytope.add(fresh);
    if (!grow(polytope, best)) break;
  }
  result.flat = face.distance == kInfinity;
  if (result.flat) return result;
  setWitnesses(polytope, 4 * noise, result);
  // On curved bodies the faces get so small that their normals are noise; there the way from the
  // origin to the nearest point is the better normal, because it is longer than the face is wide.
  const Vector3 way = result.pointA - result.pointB;
  const Vector3 u = polytope.at(face.corners[1]) - polytope.at(face.corners[0]);
  const Vector3 v = polytope.at(face.corners[2]) - polytope.at(face.corners[0]);
  const Real longest = std::max(u.squaredNorm(), v.squaredNorm());
  if (result.depth > 0 && cross(u, v).squaredNorm() < longest * way.squaredNorm() * 0x1p-20) {
    // It is taken if it proves as short a way out.
    const Vector3 straight = way / way.norm();
    const Real reach = straight.dot(pair(straight).difference);
    ++result.iterations;
    if (reach <= result.depth + noise) {
      result.normal = straight;
      result.depth = reach;
    }
  }
  return result;
}

}  // namespace carom::detail
