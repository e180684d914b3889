#include "carom/mass/self_intersections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "carom/core/cross.hpp"
#include "carom/precision/determinant.hpp"
#include "carom/precision/double_double.hpp"
#include "carom/precision/exact_determinant.hpp"

namespace carom {
namespace {

using Triangle = std::array<Vector3, 3>;
using Signs = std::array<int, 3>;

// On which side of the plane of t is p? As orientation(), with two quick ways out of exact
// arithmetic for what is common in meshes: flat faces along an axis, and flat faces that are
// turned.
int side(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  for (int k = 0; k < 3; ++k) {
    if (a[k] == p[k] && b[k] == p[k] && c[k] == p[k]) return 0;
  }
  const Vector3 u = a - p, v = b - p, w = c - p;
  const Real value = u.dot(cross(v, w));
  const Real size = u.cwiseAbs().sum() * v.cwiseAbs().sum() * w.cwiseAbs().sum();
  constexpr Real kDouble = 1e-15, kDoubleDouble = 1e-29;  // above the errors: 2^-50, 2^-99
  constexpr Real kTiny = 1e-200;                          // far from products that vanish
  if (std::abs(value) > kDouble * size && size > kTiny) return value > 0 ? 1 : -1;
  const Real finer = tetrahedronDeterminant(p, a, b, c).value();
  if (std::abs(finer) > kDoubleDouble * size && size > kTiny) return finer > 0 ? 1 : -1;
  return orientation(p, a, b, c);
}

Signs sidesOf(const Triangle& corners, const Triangle& t) {
  return {side(corners[0], t[0], t[1], t[2]), side(corners[1], t[0], t[1], t[2]),
          side(corners[2], t[0], t[1], t[2])};
}

bool allOnOneSide(const Signs& s) {
  return (s[0] > 0 && s[1] > 0 && s[2] > 0) || (s[0] < 0 && s[1] < 0 && s[2] < 0);
}

bool noneDisagrees(const Signs& s) {
  return (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0);
}

// ---- In a plane: coordinate `drop` is left out.

// The coordinate along which a triangle seems largest.
int widestView(const Triangle& t) {
  // Halves, because a difference may overflow; then sides of length about one, because squares may.
  Vector3 u = t[1] / 2 - t[0] / 2, w = t[2] / 2 - t[0] / 2;
  u /= u.cwiseAbs().maxCoeff();
  w /= w.cwiseAbs().maxCoeff();
  Eigen::Index drop = 0;
  cross(u, w).cwiseAbs().maxCoeff(&drop);
  return static_cast<int>(drop);
}

// Whether r lies left (1) or right (-1) of the line from p to q, or on it (0).
int turn(const Vector3& p, const Vector3& q, const Vector3& r, int drop) {
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  const Real ux = q[i] - p[i], uy = q[j] - p[j], wx = r[i] - p[i], wy = r[j] - p[j];
  if ((ux == 0 && wx == 0) || (uy == 0 && wy == 0)) return 0;  // a line along an axis
  const Real left = ux * wy, right = uy * wx;
  const Real size = std::abs(left) + std::abs(right);
  constexpr Real kError = 1e-15;  // above the error of differences, products and sum: 3 2^-53
  constexpr Real kTiny = 1e-200, kHuge = 1e290;  // far from products that vanish or overflow
  if (std::abs(left - right) > kError * size && size > kTiny && size < kHuge) {
    return left > right ? 1 : -1;
  }
  if (size > kTiny && size < kHuge && exactDifference(q[i], p[i]).low == 0 &&
      exactDifference(q[j], p[j]).low == 0 && exactDifference(r[i], p[i]).low == 0 &&
      exactDifference(r[j], p[j]).low == 0) {
    // The differences are what they should be, so the two products decide.
    const DoubleDouble rest = exactProduct(ux, wy) - exactProduct(uy, wx);
    return rest.high > 0 ? 1 : (rest.high < 0 ? -1 : 0);
  }
  // Exactly: as the side of a flat triangle on which a point above it lies.
  Vector3 a = p, b = q, c = r;
  a[drop] = b[drop] = c[drop] = 0;
  Vector3 above = a;
  above[drop] =
      std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  return -orientation(above, a, b, c);
}

bool insideInPlane(const Vector3& p, const Triangle& t, int drop) {
  return noneDisagrees(
      {turn(t[0], t[1], p, drop), turn(t[1], t[2], p, drop), turn(t[2], t[0], p, drop)});
}

// p is known to lie on the line through a and b.
bool between(const Vector3& a, const Vector3& b, const Vector3& p, int drop) {
  for (int k = 0; k < 3; ++k) {
    if (k != drop && (p[k] < std::min(a[k], b[k]) || p[k] > std::max(a[k], b[k]))) return false;
  }
  return true;
}

bool segmentsMeetInPlane(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b,
                         int drop) {
  const int sp = turn(a, b, p, drop), sq = turn(a, b, q, drop);
  const int sa = turn(p, q, a, drop), sb = turn(p, q, b, drop);
  if (sp * sq < 0 && sa * sb < 0) return true;
  return (sp == 0 && between(a, b, p, drop)) || (sq == 0 && between(a, b, q, drop)) ||
         (sa == 0 && between(p, q, a, drop)) || (sb == 0 && between(p, q, b, drop));
}

bool segmentMeetsInPlane(const Vector3& p, const Vector3& q, const Triangle& t, int drop) {
  return insideInPlane(p, t, drop) || insideInPlane(q, t, drop) ||
         segmentsMeetInPlane(p, q, t[0], t[1], drop) ||
         segmentsMeetInPlane(p, q, t[1], t[2], drop) || segmentsMeetInPlane(p, q, t[2], t[0], drop);
}

// ---- In space.

// The segment p q against a triangle; sp and sq are the sides of its ends. A segment in the plane
// of the triangle is passed over: of a triangle that crosses this plane, another edge ends at the
// same points.
bool segmentMeets(const Vector3& p, const Vector3& q, int sp, int sq, const Triangle& t) {
  if (sp * sq > 0 || (sp == 0 && sq == 0)) return false;
  return noneDisagrees({side(p, q, t[0], t[1]), side(p, q, t[1], t[2]), side(p, q, t[2], t[0])});
}

bool strangersMeet(const Triangle& p, const Triangle& q) {
  const Signs sp = sidesOf(p, q);
  if (allOnOneSide(sp)) return false;
  if (sp == Signs{0, 0, 0}) {
    const int drop = widestView(q);
    return segmentMeetsInPlane(p[0], p[1], q, drop) || segmentMeetsInPlane(p[1], p[2], q, drop) ||
           segmentMeetsInPlane(p[2], p[0], q, drop) || insideInPlane(q[0], p, drop);
  }
  const Signs sq = sidesOf(q, p);
  if (allOnOneSide(sq)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (segmentMeets(p[i], p[j], sp[i], sp[j], q) || segmentMeets(q[i], q[j], sq[i], sq[j], p)) {
      return true;
    }
  }
  return false;
}

// Whether a line from the common corner along a side of p has all the rest of q on its far side.
bool sideSeparates(const Triangle& p, const Triangle& q, int drop) {
  const int inner = turn(p[0], p[1], p[2], drop);
  for (std::size_t k = 1; k < 3; ++k) {
    const int outer = k == 1 ? -inner : inner;
    if (turn(p[0], p[k], q[1], drop) == outer && turn(p[0], p[k], q[2], drop) == outer) return true;
  }
  return false;
}

// Both triangles begin with the common corner. Beyond it they meet where the opposite side of one
// passes through the other: both cut the common line of their planes in a segment from that corner,
// and the shorter one ends on such a side.
bool meetBeyondCorner(const Triangle& p, const Triangle& q) {
  const int s1 = side(p[1], q[0], q[1], q[2]), s2 = side(p[2], q[0], q[1], q[2]);
  if (s1 * s2 > 0) return false;
  if (s1 == 0 && s2 == 0) {
    const int drop = widestView(q);
    if (sideSeparates(p, q, drop) || sideSeparates(q, p, drop)) return false;  // nearly always
    return segmentMeetsInPlane(p[1], p[2], q, drop) || segmentMeetsInPlane(q[1], q[2], p, drop);
  }
  return segmentMeets(p[1], p[2], s1, s2, q) ||
         segmentMeets(q[1], q[2], side(q[1], p[0], p[1], p[2]), side(q[2], p[0], p[1], p[2]), p);
}

// Both triangles begin with the common edge. They overlap if one is folded onto the other.
bool meetBeyondEdge(const Triangle& p, const Triangle& q) {
  if (side(p[2], q[0], q[1], q[2]) != 0) return false;
  const int drop = widestView(q);
  return turn(q[0], q[1], p[2], drop) == turn(q[0], q[1], q[2], drop);
}

struct Box {
  Vector3 low, high;
};

Box around(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

bool disjoint(const Box& a, const Box& b) {
  return a.high.x() < b.low.x() || b.high.x() < a.low.x() || a.high.y() < b.low.y() ||
         b.high.y() < a.low.y() || a.high.z() < b.low.z() || b.high.z() < a.low.z();
}

// The bits of a number from 0 to 2^21 - 1, two zeros between each.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffu;
  x = (x | x << 16) & 0x1f0000ff0000ffu;
  x = (x | x << 8) & 0x100f00f00f00f00fu;
  x = (x | x << 4) & 0x10c30c30c30c30c3u;
  return (x | x << 2) & 0x1249249249249249u;
}

// Boxes of the triangles in the order of the curve, and over each range of them that halving gives.
class Tree {
 public:
  Tree(const TriangleMesh& mesh, std::size_t most) : mesh_(mesh), most_(most) {
    const std::size_t n = mesh.triangles.size();
    Box all{mesh.vertices.front(), mesh.vertices.front()};
    for (const Vector3& v : mesh.vertices) all = around(all, {v, v});
    const Real width = (all.high - all.low).maxCoeff();
    const Real cells = width > 0 ? 2097151 / width : 0;
    std::vector<std::pair<std::uint64_t, std::int32_t>> order(n);
    for (std::size_t t = 0; t < n; ++t) {
      const auto [a, b, c] = cornersOf(mesh, mesh.triangles[t]);
      const Vector3 middle = ((a - all.low) / 3 + (b - all.low) / 3 + (c - all.low) / 3) * cells;
      std::uint64_t code = 0;
      for (int k = 0; k < 3; ++k) {
        // What is not a number, in a mesh too large for its size to be one, goes to the first cell.
        const Real cell = middle[k] >= 0 ? std::min(middle[k], Real(2097151)) : 0;
        code |= spread(static_cast<std::uint64_t>(cell)) << k;
      }
      order[t] = {code, static_cast<std::int32_t>(t)};
    }
    std::sort(order.begin(), order.end());
    for (const auto& [code, t] : order) {
      const auto [a, b, c] = cornersOf(mesh, mesh.triangles[static_cast<std::size_t>(t)]);
      triangles_.push_back(t);
      boxes_.push_back({a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)});
    }
    nodes_.reserve(2 * n / kLeaf + 2);
    build(0, n);
  }

  std::vector<TrianglePair> pairs() {
    within(0);
    std::sort(found_.begin(), found_.end(), [](const TrianglePair& a, const TrianglePair& b) {
      return a.first != b.first ? a.first < b.first : a.second < b.second;
    });
    return found_;
  }

 private:
  static constexpr std::size_t kLeaf = 4;  // fewer: more nodes than triangles; more: more tests

  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;
    std::size_t right = 0;  // the left child follows its parent; 0: a leaf
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    const std::size_t self = nodes_.size();
    nodes_.push_back({boxes_[begin], begin, end, 0});
    if (end - begin <= kLeaf) {
      Box box = boxes_[begin];
      for (std::size_t i = begin + 1; i < end; ++i) box = around(box, boxes_[i]);
      nodes_[self].box = box;
    } else {
      const std::size_t middle = begin + (end - begin) / 2;
      build(begin, middle);
      const std::size_t right = build(middle, end);
      nodes_[self].right = right;
      nodes_[self].box = around(nodes_[self + 1].box, nodes_[right].box);
    }
    return self;
  }

  void test(std::size_t i, std::size_t j) {
    if (found_.size() >= most_ || disjoint(boxes_[i], boxes_[j])) return;
    const auto [first, second] = std::minmax(triangles_[i], triangles_[j]);
    if (trianglesMeet(mesh_, first, second)) found_.push_back({first, second});
  }

  // All pairs below one node.
  void within(std::size_t n) {
    const Node& node = nodes_[n];
    if (node.right != 0) {
      within(n + 1);
      within(node.right);
      between(n + 1, node.right);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      for (std::size_t j = i + 1; j < node.end; ++j) test(i, j);
    }
  }

  // All pairs with one triangle below each of two nodes.
  void between(std::size_t m, std::size_t n) {
    const Node &a = nodes_[m], &b = nodes_[n];
    if (found_.size() >= most_ || disjoint(a.box, b.box)) return;
    if (a.right == 0 && b.right == 0) {
      for (std::size_t i = a.begin; i < a.end; ++i) {
        for (std::size_t j = b.begin; j < b.end; ++j) test(i, j);
      }
    } else if (b.right == 0 || (a.right != 0 && a.end - a.begin >= b.end - b.begin)) {
      between(m + 1, n);
      between(a.right, n);
    } else {
      between(m, n + 1);
      between(m, b.right);
    }
  }

  const TriangleMesh& mesh_;
  std::size_t most_;
  std::vector<std::int32_t> triangles_;  // in the order of the curve
  std::vector<Box> boxes_;               // in the same order
  std::vector<Node> nodes_;
  std::vector<TrianglePair> found_;
};

}  // namespace

bool trianglesMeet(const TriangleMesh& mesh, std::int32_t first, std::int32_t second) {
  // Put the shared corners in front, in the same order in both; the sense of rotation is not used.
  std::array<std::int32_t, 3> p = mesh.triangles[static_cast<std::size_t>(first)];
  std::array<std::int32_t, 3> q = mesh.triangles[static_cast<std::size_t>(second)];
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto same = std::find(q.begin() + static_cast<std::ptrdiff_t>(shared), q.end(), p[i]);
    if (same == q.end()) continue;
    std::iter_swap(q.begin() + static_cast<std::ptrdiff_t>(shared), same);
    std::swap(p[shared++], p[i]);
  }
  const auto pointsOf = [&mesh](const std::array<std::int32_t, 3>& t) {
    const auto [a, b, c] = cornersOf(mesh, t);
    return Triangle{a, b, c};
  };
  switch (shared) {
    case 0:
      return strangersMeet(pointsOf(p), pointsOf(q));
    case 1:
      return meetBeyondCorner(pointsOf(p), pointsOf(q));
    case 2:
      return meetBeyondEdge(pointsOf(p), pointsOf(q));
    default:
      return true;
  }
}

std::vector<TrianglePair> selfIntersections(const TriangleMesh& mesh, std::size_t most) {
  requireUsable(mesh);
  return Tree(mesh, most).pairs();
}

std::vector<MeshProblem> checkSelfIntersections(const TriangleMesh& mesh) {
  std::vector<MeshProblem> problems;
  for (const TrianglePair& pair : selfIntersections(mesh)) {
    MeshProblem problem;
    problem.kind = MeshProblemKind::selfIntersection;
    problem.triangle = pair.first;
    problem.message = "triangles " + std::to_string(pair.first) + " and " +
                      std::to_string(pair.second) + " cut or touch each other";
    problems.push_back(problem);
  }
  return problems;
}

}  // namespace carom
