#include "carom/detection/hull_of_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/detection/limits.hpp"
#include "carom/precision/exact_determinant.hpp"

namespace carom {
namespace {

using Index = std::int32_t;

std::size_t at(Index index) {
  return static_cast<std::size_t>(index);
}

// A triangle of the growing surface. Neighbour i lies across the edge from corner i to i + 1.
struct Triangle {
  std::array<Index, 3> corners{};
  std::array<Index, 3> neighbors{};
  bool alive = true;
};

struct Surface {
  std::vector<Vector3> points;  // sorted along the slanted direction, no two alike
  std::vector<Triangle> triangles;
};

bool sees(const Surface& surface, const Triangle& triangle, Index point) {
  const auto& [a, b, c] = triangle.corners;
  return orientation(surface.points[at(a)], surface.points[at(b)], surface.points[at(c)],
                     surface.points[at(point)]) > 0;
}

// Sorted along a direction that no face of an ordinary solid is square to, near-duplicates dropped.
std::vector<Vector3> sortedAndWelded(std::span<const Vector3> points, Real slack) {
  const Vector3 slanted(1, 0.7548776662466927, 0.5698402909980532);  // powers of a plastic number
  std::vector<std::pair<Real, Index>> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    order.emplace_back(slanted.dot(points[i]), static_cast<Index>(i));
  }
  std::sort(order.begin(), order.end());

  std::vector<Vector3> kept;
  std::vector<Real> keys;
  std::size_t near = 0;  // the first kept point whose key is near enough to be a double of this one
  for (const auto& [key, index] : order) {
    const Vector3& point = points[at(index)];
    while (near < kept.size() && key - keys[near] > 3 * slack) ++near;
    bool isNew = true;
    for (std::size_t k = near; k < kept.size() && isNew; ++k) {
      isNew = (kept[k] - point).cwiseAbs().maxCoeff() > slack;
    }
    if (!isNew) continue;
    kept.push_back(point);
    keys.push_back(key);
  }
  return kept;
}

// Six times the area of the triangle 0, 1, i vanishes: exactly, seen along each axis.
bool inLine(const Vector3& a, const Vector3& b, const Vector3& c) {
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Vector3 p(a(i), a(j), 1), q(b(i), b(j), 1), r(c(i), c(j), 1);
    if (exactDeterminant(p, q, r) != 0) return false;
  }
  return true;
}

// A first tetrahedron; its points move to the front of the list, the others keep their order.
Surface firstTetrahedron(std::vector<Vector3> points, std::size_t given) {
  const std::string count = std::to_string(given) + " points";
  if (points.size() < 2) reject("hull", count, "must not be all in one place");
  std::size_t third = 2;
  while (third < points.size() && inLine(points[0], points[1], points[third])) ++third;
  if (third >= points.size()) reject("hull", count, "must not lie in a line");
  std::size_t fourth = third + 1;
  int side = 0;
  for (; fourth < points.size(); ++fourth) {
    side = orientation(points[0], points[1], points[third], points[fourth]);
    if (side != 0) break;
  }
  if (side == 0) reject("hull", count, "must not lie in one plane");
  std::rotate(points.begin() + 2, points.begin() + static_cast<std::ptrdiff_t>(third),
              points.begin() + static_cast<std::ptrdiff_t>(third) + 1);
  std::rotate(points.begin() + 3, points.begin() + static_cast<std::ptrdiff_t>(fourth),
              points.begin() + static_cast<std::ptrdiff_t>(fourth) + 1);

  // Point 3 must be behind the triangle 0, 1, 2.
  const Index b = side < 0 ? 1 : 2, c = side < 0 ? 2 : 1;
  Surface surface{std::move(points), {}};
  surface.triangles = {{{0, b, c}, {1, 2, 3}, true},
                       {{b, 0, 3}, {0, 3, 2}, true},
                       {{c, b, 3}, {0, 1, 3}, true},
                       {{0, c, 3}, {0, 2, 1}, true}};
  return surface;
}

// All triangles that the point sees, found by spreading from one of `near`, or from any.
std::vector<Index> seenFrom(const Surface& surface, Index point, const std::vector<Index>& near,
                            std::vector<char>& mark) {
  std::vector<Index> seen;
  const auto tryStart = [&](Index f) {
    if (!seen.empty() || !surface.triangles[at(f)].alive) return;
    if (sees(surface, surface.triangles[at(f)], point)) seen.push_back(f);
  };
  for (const Index f : near) tryStart(f);
  // The sort is rounded, and the first points are out of order: then every triangle is asked.
  for (std::size_t f = 0; f < surface.triangles.size() && seen.empty(); ++f) {
    tryStart(static_cast<Index>(f));
  }
  if (!seen.empty()) mark[at(seen[0])] = 1;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    for (const Index f : surface.triangles[at(seen[k])].neighbors) {
      if (mark[at(f)] != 0 || !sees(surface, surface.triangles[at(f)], point)) continue;
      mark[at(f)] = 1;
      seen.push_back(f);
    }
  }
  return seen;
}

// Replaces what the point sees by triangles from the rim to the point; returns those.
std::vector<Index> joinPoint(Surface& surface, Index point, const std::vector<Index>& seen,
                             const std::vector<char>& mark, std::vector<Index>& fromCorner) {
  std::vector<Index> made;
  for (const Index f : seen) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index outside = surface.triangles[at(f)].neighbors[i];
      if (mark[at(outside)] != 0) continue;
      const Index u = surface.triangles[at(f)].corners[i];
      const Index v = surface.triangles[at(f)].corners[(i + 1) % 3];
      const Index fresh = static_cast<Index>(surface.triangles.size());
      surface.triangles.push_back({{u, v, point}, {outside, -1, -1}, true});
      for (Index& neighbor : surface.triangles[at(outside)].neighbors) {
        if (neighbor == f) {
          // Two triangles can share two edges only with a third corner between; compare the edge.
          Triangle& other = surface.triangles[at(outside)];
          const auto k = static_cast<std::size_t>(&neighbor - other.neighbors.data());
          if (other.corners[k] == v && other.corners[(k + 1) % 3] == u) neighbor = fresh;
        }
      }
      fromCorner[at(u)] = fresh;
      made.push_back(fresh);
    }
    surface.triangles[at(f)].alive = false;
  }
  // The rim is one closed loop: the triangle that starts at corner v follows the one that ends
  // there.
  for (const Index f : made) {
    const Index next = fromCorner[at(surface.triangles[at(f)].corners[1])];
    surface.triangles[at(f)].neighbors[1] = next;
    surface.triangles[at(next)].neighbors[2] = f;
  }
  return made;
}

// The closed surface of triangles around all points.
Surface wrap(std::span<const Vector3> points, Real slack) {
  Surface surface = firstTetrahedron(sortedAndWelded(points, slack), points.size());
  std::vector<Index> near = {0, 1, 2, 3};
  std::vector<Index> fromCorner(surface.points.size(), -1);
  std::vector<char> mark;
  for (Index point = 4; point < static_cast<Index>(surface.points.size()); ++point) {
    mark.resize(surface.triangles.size(), 0);
    const std::vector<Index> seen = seenFrom(surface, point, near, mark);
    if (seen.empty()) continue;  // inside, or on the surface
    near = joinPoint(surface, point, seen, mark, fromCorner);
    for (const Index f : seen) mark[at(f)] = 0;
  }

  // Only the living, renumbered.
  std::vector<Index> number(surface.triangles.size(), -1);
  std::vector<Triangle> living;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    if (!surface.triangles[f].alive) continue;
    number[f] = static_cast<Index>(living.size());
    living.push_back(surface.triangles[f]);
  }
  for (Triangle& triangle : living) {
    for (Index& neighbor : triangle.neighbors) neighbor = number[at(neighbor)];
  }
  surface.triangles = std::move(living);
  return surface;
}

// Which triangles make one flat face: per triangle the number of its group. The largest triangle
// starts a group, because its plane is the best known.
std::vector<Index> groupFlat(const Surface& surface, Real slack) {
  const std::vector<Triangle>& triangles = surface.triangles;
  std::vector<Vector3> normals;
  std::vector<Real> areas;
  std::vector<char> needle;  // lower than the slack: its normal is noise
  for (const Triangle& t : triangles) {
    const Vector3& a = surface.points[at(t.corners[0])];
    const Vector3& b = surface.points[at(t.corners[1])];
    const Vector3& c = surface.points[at(t.corners[2])];
    normals.push_back(cross(b - a, c - a));
    areas.push_back(normals.back().norm());
    Vector3 longest = b - a;
    for (const Vector3& edge : {Vector3(c - b), Vector3(a - c)}) {
      if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
    }
    needle.push_back(areas.back() <= slack * longest.norm());
    // What rounding tilts the normal along a long triangle would be a height at its far end.
    normals.back() -= normals.back().dot(longest) / longest.squaredNorm() * longest;
  }
  std::vector<Index> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index p, Index q) { return areas[at(p)] > areas[at(q)]; });

  std::vector<Index> group(triangles.size(), -1);
  Index groups = 0;
  for (const Index seed : order) {
    if (group[at(seed)] >= 0) continue;
    const Vector3 normal = normals[at(seed)].normalized();
    const Vector3& origin = surface.points[at(triangles[at(seed)].corners[0])];
    const auto flat = [&](Index f) {
      bool within = needle[at(f)] != 0 || normal.dot(normals[at(f)]) > 0;
      for (const Index corner : triangles[at(f)].corners) {
        within = within && std::abs(normal.dot(surface.points[at(corner)] - origin)) <= slack;
      }
      return within;
    };
    std::vector<Index> open = {seed};
    group[at(seed)] = groups;
    while (!open.empty()) {
      const Index f = open.back();
      open.pop_back();
      for (const Index neighbor : triangles[at(f)].neighbors) {
        if (group[at(neighbor)] >= 0 || !flat(neighbor)) continue;
        group[at(neighbor)] = groups;
        open.push_back(neighbor);
      }
    }
    ++groups;
  }
  return group;
}

// The rim of each group, counter-clockwise. Corners at which only two groups meet lie on a straight
// edge and are left out. Empty if a rim is not one loop of at least three corners.
std::vector<std::vector<Index>> rims(const Surface& surface, const std::vector<Index>& group) {
  const std::vector<Triangle>& triangles = surface.triangles;
  const Index groups = 1 + *std::max_element(group.begin(), group.end());
  std::vector<std::vector<Index>> loops(at(groups));
  std::vector<Index> rimEdges(at(groups), 0);
  std::vector<Index> meets(surface.points.size(), 0);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (group[at(triangles[f].neighbors[i])] == group[f]) continue;
      ++rimEdges[at(group[f])];
      std::vector<Index>& loop = loops[at(group[f])];
      if (!loop.empty()) continue;
      // Walk round the rim: along the edge, then turn within the group to the next rim edge.
      Index now = static_cast<Index>(f);
      std::size_t edge = i;
      do {
        loop.push_back(triangles[at(now)].corners[edge]);
        edge = (edge + 1) % 3;
        while (group[at(triangles[at(now)].neighbors[edge])] == group[f]) {
          const Index pivot = triangles[at(now)].corners[edge];
          now = triangles[at(now)].neighbors[edge];
          edge = 0;
          while (triangles[at(now)].corners[edge] != pivot) ++edge;
        }
      } while ((now != static_cast<Index>(f) || edge != i) && loop.size() <= 3 * triangles.size());
    }
  }
  for (std::size_t g = 0; g < loops.size(); ++g) {
    if (loops[g].size() != at(rimEdges[g])) return {};
    for (const Index corner : loops[g]) ++meets[at(corner)];
  }
  for (std::vector<Index>& loop : loops) {
    loop.erase(std::remove_if(loop.begin(), loop.end(),
                              [&](Index corner) { return meets[at(corner)] < 3; }),
               loop.end());
    if (loop.size() < 3) return {};
  }
  return loops;
}

// The hull with its faces, its corners in the order in which they were given.
ConvexHull finish(const Surface& surface, std::vector<std::vector<Index>> loops,
                  std::span<const Vector3> given) {
  std::vector<char> used(surface.points.size(), 0);
  for (const auto& loop : loops) {
    for (const Index corner : loop) used[at(corner)] = 1;
  }
  // Where each kept point first stood in the list that was given.
  std::vector<std::pair<std::size_t, Index>> order;
  std::vector<std::size_t> sortedGiven(given.size());
  std::iota(sortedGiven.begin(), sortedGiven.end(), std::size_t{0});
  const auto less = [](const Vector3& p, const Vector3& q) {
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  };
  std::stable_sort(sortedGiven.begin(), sortedGiven.end(),
                   [&](std::size_t p, std::size_t q) { return less(given[p], given[q]); });
  for (std::size_t k = 0; k < surface.points.size(); ++k) {
    if (used[k] == 0) continue;
    const auto place = std::lower_bound(
        sortedGiven.begin(), sortedGiven.end(), surface.points[k],
        [&](std::size_t p, const Vector3& point) { return less(given[p], point); });
    order.emplace_back(*place, static_cast<Index>(k));
  }
  std::sort(order.begin(), order.end());

  std::vector<Vector3> vertices;
  std::vector<Index> number(surface.points.size(), -1);
  for (const auto& [place, k] : order) {
    number[at(k)] = static_cast<Index>(vertices.size());
    vertices.push_back(surface.points[at(k)]);
  }
  for (auto& loop : loops) {
    for (Index& corner : loop) corner = number[at(corner)];
    // A face begins at its first corner, so that the hull does not depend on how it was built.
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  std::sort(loops.begin(), loops.end());
  // A group is flat against its largest triangle, a face against its mean plane: twice the range,
  // and twice that again where both planes lean.
  return hullFromFaces(vertices, loops, 4 * kFlatness);
}

}  // namespace

ConvexHull hullOfPoints(std::span<const Vector3> points) {
  Real largest = 0;
  for (const Vector3& point : points) {
    requireCoordinates(point, "point of a hull");
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  if (points.empty()) reject("hull", "0 points", "must have at least 4");
  const Real slack = kFlatness / 4 * largest;
  const Surface surface = wrap(points, slack);

  const std::vector<Index> group = groupFlat(surface, slack);
  const std::vector<std::vector<Index>> loops = rims(surface, group);
  if (loops.size() < 4) {
    reject("hull", std::to_string(points.size()) + " points",
           "must not lie in one plane or line; they are about " + toText(slack) + " m thick");
  }
  return finish(surface, loops, points);
}

}  // namespace carom
