// Boxes with whole corners, judged by counting: the points that they share, and the cells of one
// cubic metre.
#include <algorithm>

#include "carom/detection/aabb_overlap.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom;

// Whole numbers from low to high that both intervals hold.
int common(Real lowA, Real highA, Real lowB, Real highB) {
  int count = 0;
  for (int x = -9; x <= 9; ++x) count += x >= lowA && x <= highA && x >= lowB && x <= highB;
  return count;
}

Verdict counted(const Aabb<3>& a, const Aabb<3>& b) {
  int points = 1;
  int cells = 1;
  for (int i = 0; i < 3; ++i) {
    const int n = common(a.low(i), a.high(i), b.low(i), b.high(i));
    points *= n;
    cells *= std::max(0, n - 1);
  }
  return cells > 0 ? Verdict::overlapping : points > 0 ? Verdict::touching : Verdict::separated;
}

}  // namespace

TEST_CASE("whole boxes around a beam are as counted") {
  const Aabb<3> beam{{-1, -4, -1}, {1, 4, 1}};
  for (int x = -4; x <= 4; ++x) {
    for (int y = -6; y <= 6; y += 2) {
      for (int z = -4; z <= 4; ++z) {
        for (const Vector3& sides : {Vector3(2, 2, 2), Vector3(6, 2, 2)}) {
          const Vector3 corner(x, y, z);
          const Aabb<3> other{corner, corner + sides};
          CAPTURE(x, y, z);
          CHECK(aabbOverlap(beam, other) == counted(beam, other));
        }
      }
    }
  }
}
