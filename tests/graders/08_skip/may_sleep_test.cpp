// Grader of 08.may_sleep: watches of motions that are known in closed form.

#include "carom/world/may_sleep.hpp"

#include <cmath>

#include "grading/fields_world.hpp"
#include "grading/grade.hpp"
#include "grading/random.hpp"

using namespace carom;
using namespace carom::grading;
using world::maySleep;
using world::RestLimits;
using world::RestWatch;

namespace {

constexpr Real kTime = 0.5;  // of the watch [s]
constexpr RestLimits kLimits{0.05, 1e-3, 1e-6};

// An angle grows like cosh(kt) from `start`: its way is that of a point at the distance 1 m.
RestWatch falling(Real start, Real k) {
  const Real half = std::cosh(k * kTime / 2), end = std::cosh(k * kTime);
  return {start * (half - 1), start * (end - half), start * k * std::sinh(k * kTime)};
}

// A way that dies out like exp(-kt), `all` of it when all is over.
RestWatch settling(Real all, Real k) {
  const Real half = std::exp(-k * kTime / 2);
  return {all * (1 - half), all * half * (1 - half), all * k};
}

RestWatch even(Real speed) {
  return {speed * kTime / 2, speed * kTime / 2, speed};
}

void ask(const RestWatch& watch, bool expected, const char* what,
         const RestLimits& limits = kLimits) {
  GRADE(maySleep(watch, limits), expected, within(0, "yes or no"), given("watch", watch, "m, m/s"),
        given("limits", limits, "m/s, m"), about(what));
}

}  // namespace

TEST_CASE("tips") {
  ask(falling(1e-5, 4), false, "a pencil 0.01 mm off its balance");
  ask(settling(1e-4, 8), true, "a box that settles by a tenth of a millimetre");
  ask(falling(1e-4, 3), false, "a board that begins to tip");
  ask(settling(5e-4, 20), true, "a ball that rolls to its end");
  Random random(seed());
  for (int n = 0; n < 4; ++n) {
    const Real k = random.between(2, 4);
    ask(falling(random.between(2e-5, 1e-4), k), false, "a body that falls slowly");
    const Real rate = random.between(5, 20);
    ask(settling(random.between(1e-5, 9e-4), rate), true, "a body that settles");
  }
}

TEST_CASE("noise") {
  ask(even(2e-6), true, "a box in a stack trembles, half a micrometre in each half");
  ask(even(4e-4), false, "a box creeps down a slope, evenly");
  ask(falling(3e-7, 3), false, "a body tips by less than the noise, and goes on");
  ask({4e-7, 4.2e-7, 1e-5}, true, "a little more in the second half, within the noise");
  ask({4e-4, 3e-4, 2e-3}, false, "a little less in the second half, outside of the noise");
}

TEST_CASE("limits") {
  ask({2e-4, 5e-5, 0.2}, false, "swings fast, and dies out");
  ask({9e-4, 3e-4, 4e-3}, false, "1.2 mm in both halves, and dies out");
  ask({6e-4, 2e-4, 4e-3}, true, "0.8 mm in both halves, and dies out");
  ask({9e-4, 3e-4, 4e-3}, true, "1.2 mm where 2 mm are allowed", {0.05, 2e-3, 1e-6});
  ask({2e-4, 5e-5, 0.2}, true, "0.2 m/s where 0.3 m/s are allowed", {0.3, 1e-3, 1e-6});
}

TEST_CASE("rounding") {
  ask({0, 2e-16, 1e-14}, true, "no way at all, then one of rounding");
  ask({0, 0, 0}, true, "nothing has moved");
  ask({0, 3e-9, 1e-7}, false, "no way at all, then one that is more than rounding");
}

PROBES() {
  Random random(870);
  for (int n = 0; n < 32; ++n) {
    const Real sizes[] = {3e-4, 9e-4, 2e-7, 1e-13};
    const Real first = sizes[n % 4] * random.between(0.9, 1.05);
    const Real ratios[] = {0.3, 0.8, 1.05, 3};
    const Real second = first * ratios[n / 4 % 4];
    const Real speed = n < 16 ? 0.01 : random.between(0.01, 0.09);
    PROBE(maySleep({first, second, speed}, kLimits));
  }
}
