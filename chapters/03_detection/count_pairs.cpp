// How does the work grow with the number of bodies?
//
// Boxes of 1 to 2 m stand anywhere in a hall of 20 m by 20 m by 20 m. Twice as many boxes are four
// times as many pairs; the test of boxes throws nearly all of them out.

#include <iostream>
#include <vector>

#include "carom/core/random.hpp"
#include "carom_io/table.hpp"
#include "pair_counts.hpp"

using carom::Aabb;
using carom::Real;
using carom::Vector3;

int main() {
  carom::Random random(531);
  std::vector<Aabb<3>> scene;
  for (int n = 0; n < 800; ++n) {
    const Vector3 low = random.vector(10);
    const Vector3 size(random.between(1, 2), random.between(1, 2), random.between(1, 2));
    scene.push_back({low, low + size});
  }
  const std::vector<int> counts = {50, 100, 200, 400, 800};
  carom::io::Table table;
  table.column("boxes", carom::io::fixed(0)).column("pairs asked", carom::io::fixed(0));
  table.column("pairs kept", carom::io::fixed(0)).column("kept of 1000", carom::io::fixed(1));
  for (const carom::PairCount& row : carom::pairCounts(scene, counts)) {
    table.row({Real(row.boxes), Real(row.asked), Real(row.kept), 1000.0 * row.kept / row.asked});
  }
  std::cout << "Boxes of 1 to 2 m in a hall of 20 m\n\n" << table;
}
