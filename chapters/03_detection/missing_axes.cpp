// What happens if some axes are left out, or a rule of thumb takes the place of the right one?
//
// Thousands of pairs of triangles and of tetrahedra with whole-number corners, so that all dot
// products are exact and there is no doubt about the truth. Each rule gives its verdict.

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/detection/interval.hpp"
#include "carom/detection/verdict.hpp"
#include "carom_io/table.hpp"
#include "grid_bodies.hpp"

using carom::cross;
using carom::Real;
using carom::Vector3;
using namespace grid_bodies;
using carom::Verdict;

//! [rules]
// The sign of the gap on each axis: 1 a gap, 0 just touching, -1 overlap. The axes keep the length
// that they have, so that whole numbers stay whole.
std::vector<int> signs(const Body& a, const Body& b, const std::vector<Vector3>& axes) {
  const auto shadow = [](const Body& body, const Vector3& axis) {
    const Real first = axis.dot(body.corners[0]);
    carom::Interval covered{first, first};
    for (const Vector3& corner : body.corners) {
      covered.low = std::min(covered.low, axis.dot(corner));
      covered.high = std::max(covered.high, axis.dot(corner));
    }
    return covered;
  };
  std::vector<int> result;
  for (const Vector3& axis : axes) {
    const Real gap = carom::gapBetween(shadow(a, axis), shadow(b, axis));
    if (axis.squaredNorm() > 0) result.push_back(gap > 0 ? 1 : gap < 0 ? -1 : 0);
  }
  return result;
}

Verdict verdict(const std::vector<int>& signs) {
  const int largest = *std::max_element(signs.begin(), signs.end());
  return largest > 0 ? Verdict::separated : largest == 0 ? Verdict::touching : Verdict::overlapping;
}

// The source: touching when every axis touches.
Verdict verdictOfSource(const std::vector<int>& signs) {
  const auto [least, largest] = std::minmax_element(signs.begin(), signs.end());
  return *largest > 0 ? Verdict::separated : *least == 0 ? Verdict::touching : Verdict::overlapping;
}
//! [rules]

std::vector<Vector3> joined(std::vector<Vector3> axes, const std::vector<Vector3>& more) {
  axes.insert(axes.end(), more.begin(), more.end());
  return axes;
}

std::vector<Vector3> products(const Body& a, const Body& b) {
  std::vector<Vector3> axes;
  for (const Vector3& u : a.edges) {
    for (const Vector3& v : b.edges) axes.push_back(cross(u, v));
  }
  return axes;
}

// What a rule says of all pairs, beside the truth.
struct Tally {
  std::string rule;
  std::array<int, 3> said = {};  // separated, touching, overlapping
  int wrong = 0;
  void add(Verdict verdict, Verdict truth) {
    ++said[static_cast<std::size_t>(verdict)];
    wrong += verdict != truth;
  }
};

template <class Make>
void compare(const std::string& title, int pairs, std::uint64_t seed, const Make& make) {
  Draws draws(seed);
  std::array<Tally, 5> tallies{{{"normals of A alone"},
                                {"normals of both"},
                                {"normals and edges of both"},
                                {"all axes; all must touch"},
                                {"all axes; one must touch"}}};
  while (pairs > 0) {
    const Body a = make(draws), b = make(draws);
    if (!solid(a) || !solid(b)) continue;
    --pairs;
    const std::vector<Vector3> normals = joined(a.normals, b.normals);
    const std::vector<Vector3> all = a.flat() ? normals : joined(normals, products(a, b));
    const Verdict truth = verdict(signs(a, b, all));
    tallies[0].add(verdict(signs(a, b, a.normals)), truth);
    tallies[1].add(verdict(signs(a, b, normals)), truth);
    tallies[2].add(verdict(signs(a, b, joined(normals, joined(a.edges, b.edges)))), truth);
    tallies[3].add(verdictOfSource(signs(a, b, all)), truth);
    tallies[4].add(truth, truth);
  }
  carom::io::Table table;
  for (const char* column : {"axes and rule", "apart", "touching", "overlapping", "wrong"}) {
    table.column(column);
  }
  for (const auto& [rule, said, wrong] : tallies) {
    table.row({rule, said[0], said[1], said[2], wrong});
  }
  std::cout << title << "\n\n" << table;
}

int main() {
  compare("20000 pairs of triangles on a grid of 16 by 16 points", 20000, 1, triangle);
  std::cout << '\n';
  compare("4000 pairs of tetrahedra on a grid of 8 by 8 by 8 points", 4000, 11, tetrahedron);
}
