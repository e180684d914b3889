// Two simple tests, as the source has them and as they must be.
//
// Balls: a distance whose squares leave the range of the doubles, and one that a root rounds away.
// Boxes: what the rules (23) and (24) make of half a million pairs.

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "carom/detection/aabb_of_points.hpp"
#include "carom/detection/aabb_overlap.hpp"
#include "carom/detection/ball_ball.hpp"
#include "carom_io/table.hpp"
#include "grid_bodies.hpp"

using carom::Aabb;
using carom::Real;
using carom::Vector3;
using carom::Verdict;

std::string word(Verdict verdict) {
  if (verdict == Verdict::separated) return "apart";
  return verdict == Verdict::touching ? "touching" : "overlapping";
}

//! [literal]
Real equation22(const Vector3& d, Real ra, Real rb) {
  return std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z()) - ra - rb;
}
//! [literal]

void printBalls() {
  struct Pair {
    std::string name;
    Vector3 d;  // from centre to centre [m]
    Real ra, rb;
  };
  const Real large = std::ldexp(1.0, 660), small = std::ldexp(1.0, -660), half = std::sqrt(3.0) / 2;
  const std::vector<Pair> pairs = {
      {"3, 4, 5", {3, 4, 0}, 2, 3},
      {"2^660 times that", large * Vector3(3, 4, 0), 2 * large, 3 * large},
      {"2^-660 times that", small * Vector3(3, 4, 0), 2 * small, 3 * small},
      {"diagonal of a cube", {1, 1, 1}, half, half}};
  carom::io::Table table;
  table.column("centres and radii").column("by (22) [m]", carom::io::scientific(1));
  table.column("so they are").column("D [m]", carom::io::scientific(1)).column("they are");
  for (const auto& [name, d, ra, rb] : pairs) {
    const Real literal = equation22(d, ra, rb);
    const carom::BallGap gap = carom::ballBall(Vector3::Zero(), ra, d, rb);
    const Verdict said = literal > 0   ? Verdict::separated
                         : literal < 0 ? Verdict::overlapping
                                       : Verdict::touching;
    table.row({name, literal, word(said), gap.separation, word(gap.verdict)});
  }
  std::cout << table;
}

// One axis of two boxes, by the source's equations.
//! [source]
bool equation23(const Aabb<3>& a, const Aabb<3>& b, int axis) {
  return a.high(axis) > b.low(axis) || b.high(axis) > a.low(axis);
}

bool equation24(const Aabb<3>& a, const Aabb<3>& b, int axis) {
  return a.high(axis) == b.low(axis) || b.high(axis) == a.low(axis);
}
//! [source]

void printBoxes() {
  grid_bodies::Draws draws(5);
  std::vector<Aabb<3>> boxes(1000);
  for (Aabb<3>& box : boxes) {
    Vector3 corner, size;
    for (int i = 0; i < 3; ++i) corner(i) = draws.below(100);
    for (int i = 0; i < 3; ++i) size(i) = 1 + draws.below(10);
    box = carom::aabbOfPoints(std::vector<Vector3>{corner + size, corner});
  }
  int all = 0, by23 = 0, by24 = 0, overlapping = 0, touching = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Aabb<3>&a = boxes[i], &b = boxes[j];
      ++all;
      by23 += equation23(a, b, 0) && equation23(a, b, 1) && equation23(a, b, 2);
      by24 += equation24(a, b, 0) && equation24(a, b, 1) && equation24(a, b, 2);
      overlapping += carom::aabbOverlap(a, b) == Verdict::overlapping;
      touching += carom::aabbOverlap(a, b) == Verdict::touching;
    }
  }
  carom::io::Table table;
  table.column("rule").column("pairs");
  table.row({"all", all}).row({"(23), OR, on all axes", by23}).row({"overlapping", overlapping});
  table.row({"(24) on all axes", by24}).row({"touching", touching});
  std::cout << table;
}

int main() {
  std::cout << "Balls\n\n";
  printBalls();
  std::cout << "\n1000 boxes of 1 to 10 m in a cube of 100 m, all numbers whole\n\n";
  printBoxes();
}
