// How far apart are two boxes along the axes?
//
// A box of 2 m stands at the origin, and a second one is carried past it on a straight line. Their
// distance is asked of boxDistance(), which looks at the axes one by one, and of GJK, which knows
// nothing of axes: two ways to one number.

#include <iostream>
#include <vector>

#include "box_distance.hpp"
#include "carom/detection/gjk_distance.hpp"
#include "carom_io/table.hpp"

using carom::Aabb;
using carom::Real;
using carom::Vector3;

std::vector<Vector3> corners(const Aabb<3>& box) {
  std::vector<Vector3> all;
  for (int n = 0; n < 8; ++n) {
    all.push_back({n & 1 ? box.high.x() : box.low.x(), n & 2 ? box.high.y() : box.low.y(),
                   n & 4 ? box.high.z() : box.low.z()});
  }
  return all;
}

int main() {
  const Aabb<3> fixed{{-1, -1, -1}, {1, 1, 1}};
  carom::io::Table table;
  table.column("x [m]", carom::io::fixed(1)).column("y [m]", carom::io::fixed(1));
  table.column("axes [m]", carom::io::fixed(6)).column("GJK [m]", carom::io::fixed(6));
  for (int k = 0; k <= 10; ++k) {
    const Vector3 center(-5 + k, 4 - 0.5 * k, 0.5);
    const Aabb<3> moving{center - Vector3(1, 1, 1), center + Vector3(1, 1, 1)};
    table.row({center.x(), center.y(), carom::boxDistance(fixed, moving),
               carom::gjkDistance(corners(fixed), corners(moving)).distance});
  }
  std::cout << "A cube of 2 m passes another one that stands at the origin\n\n" << table;
}
