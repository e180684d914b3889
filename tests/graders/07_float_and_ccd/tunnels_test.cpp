// Grader of 07.tunnels: pictures are taken, from many starting places, and looked at.

#include "carom/toi/tunnels.hpp"

#include <cmath>

#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kYesOrNo = "it is yes or no";

// Passes the bodies by each other from 997 starts, and says whether one of them is never seen. The
// rear of B is at zero; its front and A's length together end the overlap.
bool someoneSlipsBy(Real lengthA, Real lengthB, Real jump) {
  for (int n = 0; n < 997; ++n) {
    bool seen = false;
    for (Real front = -jump * (n + 0.5) / 997; front <= lengthA + lengthB; front += jump) {
      seen = seen || front >= 0;
    }
    if (!seen) return true;
  }
  return false;
}

void ask(Real lengthA, Real lengthB, Real speed, Real dt, bool expected, const char* what) {
  GRADE(tunnels(lengthA, lengthB, speed, dt), expected, within(0, kYesOrNo),
        given("lengthA", lengthA, "m"), given("lengthB", lengthB, "m"),
        given("speed", speed, "m/s"), given("dt", dt, "s"), about(what));
}

// A jump of some share of both lengths.
void askShare(Random& random, Real share, const char* what) {
  const Real a = random.between(0.1, 5), b = random.between(0.1, 5), dt = random.between(0.01, 0.2);
  ask(a, b, share * (a + b) / dt, dt, someoneSlipsBy(a, b, share * (a + b)), what);
}

}  // namespace

TEST_CASE("cars") {
  ask(3.6, 3.6, 72, 0.11, true, "the cars, a picture every 0.11 s: jumps of 7.92 m");
  ask(3.6, 3.6, 72, 0.09, false, "the cars, a picture every 0.09 s: jumps of 6.48 m");
  ask(3.6, 3.6, 80, 0.1, true, "the cars, at 80 m/s: jumps of 8 m");
  ask(3.6, 3.6, 72, 1 / 60.0, false, "the cars, sixty pictures a second: jumps of 1.2 m");
}

TEST_CASE("any") {
  Random random(seed());
  for (int n = 0; n < 6; ++n) {
    askShare(random, random.between(0.75, 0.95), "a jump a little shorter than both together");
    askShare(random, random.between(1.05, 1.3), "a jump a little longer than both together");
  }
  ask(0.008, 0.012, 900, 2.3e-5, true, "a bullet of 8 mm, a wall of 12 mm: jumps of 20.7 mm");
  ask(0.008, 0.012, 900, 2.1e-5, false, "a bullet of 8 mm, a wall of 12 mm: jumps of 18.9 mm");
}

TEST_CASE("edge") {
  ask(3, 5, 16, 0.5, false, "a jump of just 8 m");
  ask(3, 5, 16, 0.5 + 0x1p-20, true, "a jump a little longer than 8 m");
  ask(3, 5, -32, 0.5, true, "a jump of 16 m to the left");
  ask(3, 5, -8, 0.5, false, "a jump of 4 m to the left");
  ask(3, 5, 0, 0.5, false, "no motion at all");
  ask(0, 0, 1, 0.5, true, "two points");
}

TEST_CASE("refuses") {
  GRADE_REFUSES(tunnels(-1, 1, 1, 1), given("lengthA", -1.0, "m"));
  GRADE_REFUSES(tunnels(1, 1, std::nan(""), 1), given("speed", std::nan(""), "m/s"));
}

PROBES() {
  Random random(708);
  for (const Real share : {0.4, 0.6, 0.8, 0.9, 1.03, 1.08, 1.12, 1.16, 1.3, 2.0}) {
    const Real a = random.between(1, 5), b = random.between(1, 5), dt = random.between(0.01, 0.2);
    PROBE(tunnels(a, b, share * (a + b) / dt, dt));
    PROBE(tunnels(a, b, -share * (a + b) / dt, dt));
  }
  PROBE(tunnels(3, 5, 16, 0.5));
  PROBE(tunnels(2, 2, 1, 1));
  PROBE(tunnels(2, 3, 4, 5));
  PROBE(tunnels(3, 2, -3, 6));
}
