// Grader of 05.cradle: the library hits the balls one after the other until none approaches; what
// happens with all contacts at once follows from two equations.

#include <vector>

#include "carom/impulse/impulse_2d.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Within kMargin = within(0.05, "a prediction may be 5% off");

// The velocities after the blow has gone through the row.
std::vector<Real> row(const std::vector<Real>& masses, const std::vector<Real>& speeds,
                      Real restitution, int passes) {
  std::vector<PlanarBody> balls;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    balls.push_back({planarBodyMass(masses[i], masses[i]), {{speeds[i], 0}, 0}});
  }
  const PlanarContact contact{{1, 0}, {0, 0}, {0, 0}};
  for (int n = 0; n < passes; ++n) {
    for (std::size_t i = 0; i + 1 < balls.size(); ++i) {
      const Real j = impulse2d(balls[i], balls[i + 1], contact, restitution);
      balls[i].velocity.linear.x() -= j / masses[i];
      balls[i + 1].velocity.linear.x() += j / masses[i + 1];
    }
  }
  std::vector<Real> after;
  for (const PlanarBody& ball : balls) after.push_back(ball.velocity.linear.x());
  return after;
}

const std::vector<Real> equal(5, 1), halved{1, 0.5, 0.25, 0.125, 0.0625};

// Three balls of 1 kg: an impulse at one contact parts its balls by 2 m/s per N s, and takes 1 m/s
// from the other contact. Both are to part as they met: (2, -1; -1, 2) (j, k) = (2, 0).
Real firstBallBack() {
  const Real determinant = 2 * 2 - 1 * 1;
  const Real j = (2 * 2 - -1 * 0) / determinant;
  return j - 1;  // it came in at 1 m/s
}

}  // namespace

TEST_CASE("two") {
  const std::vector<Real> after = row(equal, {1, 1, 0, 0, 0}, 1, 5);
  GRADE(predicted("two_in_fifth_ball", "m/s"), after[4], kMargin, unit("m/s"),
        about("two come in: the speed of the fifth ball"));
  GRADE(predicted("two_in_third_ball", "m/s"), after[2], kMargin, unit("m/s"),
        about("two come in: the speed of the third ball"));
}

TEST_CASE("light") {
  GRADE(predicted("halved_last_ball", "m/s"), row(halved, {1, 0, 0, 0, 0}, 1, 1)[4],
        withinRelative(0.05, "a prediction may be 5% off"), unit("m/s"),
        about("halved masses: the speed of the last ball"));
  GRADE(predicted("direct_last_ball", "m/s"), row({1, 0.0625}, {1, 0}, 1, 1)[1],
        withinRelative(0.05, "a prediction may be 5% off"), unit("m/s"),
        about("the heavy ball hits the light one directly"));
}

TEST_CASE("dull") {
  GRADE(predicted("dull_last_ball", "m/s"), row(equal, {1, 0, 0, 0, 0}, 0.9, 1)[4],
        withinRelative(0.05, "a prediction may be 5% off"), unit("m/s"),
        about("e = 0.9: the speed of the last ball"));
}

TEST_CASE("at_once") {
  GRADE(predicted("at_once_first_ball_back", "m/s"), firstBallBack(), kMargin, unit("m/s"),
        about("both contacts solved at once: how fast the first ball goes back"));
}

PROBES() {
  PROBE(predicted("two_in_fifth_ball", "m/s"));
  PROBE(predicted("two_in_third_ball", "m/s"));
  PROBE(predicted("halved_last_ball", "m/s"));
  PROBE(predicted("direct_last_ball", "m/s"));
  PROBE(predicted("dull_last_ball", "m/s"));
  PROBE(predicted("at_once_first_ball_back", "m/s"));
}
