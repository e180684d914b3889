// How far must B go to be free of A, and which way?
//
// For three overlapping pairs: what a rule says, and how they stand to each other after the push. A
// push that leaves an overlap is too short, one that leaves a gap is longer than it need be.

#include <algorithm>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/detection/project.hpp"
#include "carom/manifold/edge_contact.hpp"
#include "carom/manifold/least_displacement.hpp"
#include "carom/manifold/orient_normal.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom_io/table.hpp"

using carom::Interval;
using carom::Matrix3;
using carom::Real;
using carom::Vector3;
using Corners = std::vector<Vector3>;

struct Pair {
  Corners a, b;               // [m]
  std::vector<Vector3> axes;  // all that matter
};

Corners box(const Vector3& half, const Matrix3& R, const Vector3& center) {
  Corners points;
  for (int i = 0; i < 8; ++i) {
    const Vector3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    points.push_back(R * sign.cwiseProduct(half) + center);
  }
  return points;
}

Corners moved(Corners corners, const Vector3& by) {
  for (Vector3& corner : corners) corner += by;
  return corners;
}

void report(const std::string& rule, const Pair& pair, const Vector3& push,
            carom::io::Table& table) {
  const Real gap = carom::leastDisplacement(pair.axes, pair.a, moved(pair.b, push)).separation;
  table.row({rule, push.norm(), std::abs(gap) < 1e-12 ? 0 : gap,
             std::abs(gap) < 1e-12 ? "just free"
             : gap < 0             ? "not free"
                                   : "free, and away"});
}

// How far B has to go along a direction that need not be an axis: until the first axis shows a gap.
Real wayAlong(const Pair& pair, const Vector3& direction) {
  Real way = std::numeric_limits<Real>::infinity();
  for (const Vector3& axis : pair.axes) {
    const Vector3 unit = axis.normalized();
    const Interval a = carom::project(pair.a, unit), b = carom::project(pair.b, unit);
    const Real speed = unit.dot(direction);
    if (speed > 1e-9) way = std::min(way, (a.high - b.low) / speed);
    if (speed < -1e-9) way = std::min(way, (a.low - b.high) / speed);
  }
  return way;
}

Vector3 best(const Pair& pair) {
  const carom::LeastDisplacement least = carom::leastDisplacement(pair.axes, pair.a, pair.b);
  return -least.separation * least.normal;
}

// A small box inside a large one.
void inside(carom::io::Table& table) {
  const Matrix3 E = Matrix3::Identity();
  const Pair pair{box({1, 1, 1}, E, {1, 1, 1}),
                  box({0.25, 0.25, 0.25}, E, {0.75, 0.9, 0.9}),
                  {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()}};
  //! [length]
  const Interval a = carom::project(pair.a, pair.axes[0]);
  const Interval b = carom::project(pair.b, pair.axes[0]);
  const Real shared = std::min(a.high, b.high) - std::max(a.low, b.low);
  //! [length]
  report("one inside: length of overlap", pair, -shared * pair.axes[0], table);
  report("one inside: shorter way out", pair, best(pair), table);
}

// A wedge in a slab: its centre of mass lies nearer to the blunt end than the middle of its shadow.
void wedge(carom::io::Table& table) {
  const Pair pair{
      box({0.6, 10, 10}, Matrix3::Identity(), {0.6, 0, 0}),
      {{-1, -9, -9}, {-1, 9, -9}, {3, 0, -9}, {-1, -9, 9}, {-1, 9, 9}, {3, 0, 9}},
      {Vector3::UnitX(), Vector3(9, 4, 0), Vector3(9, -4, 0), Vector3::UnitY(), Vector3::UnitZ()}};
  const Vector3 axis = Vector3::UnitX();
  const Real centerA = 0.6, centerB = 1.0 / 3;  // of mass, along x [m]
  const Vector3 byCenters = centerB > centerA ? axis : Vector3(-axis);
  const Vector3 right = carom::orientNormal(axis, pair.a, pair.b);
  report("wedge: from centre to centre", pair, wayAlong(pair, byCenters) * byCenters, table);
  report("wedge: shorter way out", pair, wayAlong(pair, right) * right, table);
}

// Two boxes in a general position, which meet with two edges.
void crossing(carom::io::Table& table) {
  Matrix3 A;
  A << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  A /= 3;
  const Matrix3 B = carom::quaternionToMatrix({4, 1, -2, 3});
  Pair pair{box({1, 0.5, 0.75}, A, {0, 0, 0}), box({1.0 / 3, 2, 0.25}, B, {1.5, 0.2, -0.25}), {}};
  for (int i = 0; i < 3; ++i) pair.axes.push_back(A.col(i));
  for (int i = 0; i < 3; ++i) pair.axes.push_back(B.col(i));
  const carom::LeastDisplacement face = carom::leastDisplacement(pair.axes, pair.a, pair.b);
  for (int k = 0; k < 9; ++k) pair.axes.push_back(carom::cross(A.col(k / 3), B.col(k % 3)));

  // The edge of A runs along its second axis, between two faces whose normals look along n.
  const Vector3 n = best(pair).normalized();
  const auto towards = [&](const Vector3& axis) -> Vector3 {
    return axis.dot(n) < 0 ? Vector3(-axis) : axis;
  };
  const Vector3 mean = (towards(A.col(0)) + towards(A.col(2))).normalized();
  report("two edges: the best face", pair, -face.separation * face.normal, table);
  report("two edges: mean of A's faces", pair, wayAlong(pair, mean) * mean, table);

  // The edges that meet: the one of A that lies farthest along n, the one of B farthest against it.
  const auto ends = [](const Corners& corners, const Vector3& direction) {
    std::vector<Vector3> sorted = corners;
    std::sort(sorted.begin(), sorted.end(), [&](const Vector3& p, const Vector3& q) {
      return direction.dot(p) > direction.dot(q);
    });
    return sorted;
  };
  const Corners a = ends(pair.a, n), b = ends(pair.b, -n);
  const carom::EdgeContact contact = carom::edgeContact(a[0], a[1], b[0], b[1], n);
  report("two edges: cross product", pair, -contact.separation * contact.normal, table);
}

int main() {
  carom::io::Table table;
  table.column("pair: rule").column("push [m]", carom::io::fixed(3));
  table.column("gap then [m]", carom::io::fixed(3)).column("B is");
  inside(table);
  wedge(table);
  crossing(table);
  std::cout << table;
}
