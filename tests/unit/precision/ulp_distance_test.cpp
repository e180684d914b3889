#include "carom/precision/ulp_distance.hpp"

#include <cmath>
#include <limits>

#include "carom/core/errors.hpp"
#include "support/catch.hpp"

using namespace carom;

namespace {
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
}

TEST_CASE("neighbouring doubles are one apart, whatever their size and sign") {
  for (const Real x : {1.0, -1.0, 1e-300, 5e-324, -1e308, 0.0, 0x1p53, -0x1p-1022}) {
    CHECK(ulpDistance(x, x) == 0);
    CHECK(ulpDistance(x, std::nextafter(x, kInfinity)) == 1);
    CHECK(ulpDistance(x, std::nextafter(x, -kInfinity)) == 1);
  }
}

TEST_CASE("steps are counted across powers of two and across zero") {
  CHECK(ulpDistance(1, 2) == std::uint64_t{1} << 52);
  CHECK(ulpDistance(2, 1) == std::uint64_t{1} << 52);
  CHECK(ulpDistance(0.0, -0.0) == 0);
  CHECK(ulpDistance(5e-324, -5e-324) == 2);
  CHECK(ulpDistance(0.1 + 0.2, 0.3) == 1);
}

TEST_CASE("infinity is one step beyond the largest double") {
  CHECK(ulpDistance(std::numeric_limits<Real>::max(), kInfinity) == 1);
  CHECK(ulpDistance(-kInfinity, kInfinity) == 2 * (std::uint64_t{0x7ff} << 52));
}

TEST_CASE("there is no distance to what is not a number") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  CHECK_THROWS_AS(ulpDistance(nan, 1), InvalidInput);
  CHECK_THROWS_WITH(ulpDistance(1, nan), "b = nan must be a number");
}
