#include "scenes/exact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carom::scenes {
namespace {

constexpr long double kNever = std::numeric_limits<long double>::infinity();

// When a ball meets a wall across an axis. Falling, it meets the floor at the later root.
long double untilWall(const HardBall& ball, const HardRoom& room, std::size_t axis) {
  const long double x = ball.x[axis], v = ball.v[axis];
  if (axis == 2 && room.gravity > 0) {
    const long double height = x - ball.radius - room.low[2];
    if (height <= 0 && v > 0) return 2 * v / room.gravity;
    return (v + std::sqrt(v * v + 2 * room.gravity * std::max(height, 0.0L))) / room.gravity;
  }
  if (v > 0) return (room.high[axis] - ball.radius - x) / v;
  if (v < 0) return (room.low[axis] + ball.radius - x) / v;
  return kNever;
}

// When two balls meet. Gravity is the same for both, so their way to each other is straight.
long double untilPair(const HardBall& a, const HardBall& b) {
  long double approach = 0, speed = 0, distance = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double d = a.x[k] - b.x[k], w = a.v[k] - b.v[k];
    approach += d * w, speed += w * w, distance += d * d;
  }
  if (approach >= 0) return kNever;
  const long double reach = a.radius + b.radius;
  const long double room = distance - reach * reach;
  const long double root = approach * approach - speed * room;
  if (root < 0) return kNever;
  return std::max(0.0L, room / (-approach + std::sqrt(root)));
}

void fly(std::vector<HardBall>& balls, const HardRoom& room, long double time) {
  for (HardBall& ball : balls) {
    for (std::size_t k = 0; k < 3; ++k) ball.x[k] += ball.v[k] * time;
    ball.x[2] -= room.gravity * time * time / 2;
    ball.v[2] -= room.gravity * time;
  }
}

void exchange(HardBall& a, HardBall& b) {
  std::array<long double, 3> d;
  long double dd = 0, dw = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    d[k] = a.x[k] - b.x[k];
    dd += d[k] * d[k], dw += d[k] * (a.v[k] - b.v[k]);
  }
  const long double j = 2 * dw / dd * a.mass * b.mass / (a.mass + b.mass);
  for (std::size_t k = 0; k < 3; ++k) {
    a.v[k] -= j / a.mass * d[k];
    b.v[k] += j / b.mass * d[k];
  }
}

// Simpson's rule for a smooth integrand: with this many pieces its error is below rounding.
template <class F>
long double integral(F f, long double from, long double to) {
  constexpr int kPieces = 4000;
  const long double h = (to - from) / kPieces;
  long double sum = f(from) + f(to);
  for (int i = 1; i < kPieces; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

// How much more thrust the weight makes at the springing than any haunch can take: an arch stands if
// that is not negative. Stones are counted from the crown, angles from the vertical.
long double archMargin(int stones, long double thickness, int& joint) {
  const long double inner = 1 - thickness / 2, outer = 1 + thickness / 2;
  const long double piece = std::numbers::pi_v<long double> / stones;
  long double weight = 0, moment = 0, most = 0;
  for (int i = 0; i < stones / 2; ++i) {
    const long double a = i * piece, b = a + piece;
    const long double x[4] = {inner * std::sin(a), outer * std::sin(a), outer * std::sin(b),
                              inner * std::sin(b)};
    const long double y[4] = {inner * std::cos(a), outer * std::cos(a), outer * std::cos(b),
                              inner * std::cos(b)};
    for (int k = 0; k < 4; ++k) {
      const int next = (k + 1) % 4;
      const long double part = (x[next] * y[k] - x[k] * y[next]) / 2;
      weight += part;
      moment += part * (x[k] + x[next]) / 3;
    }
    if (i + 1 == stones / 2) break;
    const long double thrust = (weight * x[3] - moment) / (outer - y[3]);
    if (thrust > most) most = thrust, joint = i + 1;
  }
  return (weight * outer - moment) / outer - most;
}

long double tippingEnergy(const Tipping& box, long double angle) {
  const long double h = box.height, d = box.thickness;
  const long double inertia = (h * h + d * d) / 3;
  const long double fall = h / 2 * (1 - std::cos(angle)) - d / 2 * std::sin(angle);
  return box.spin * box.spin + 2 * box.gravity / inertia * fall;
}

}  // namespace

long hardBalls(std::vector<HardBall>& balls, const HardRoom& room, long double duration) {
  long impacts = 0;
  for (long double left = duration;;) {
    long double soonest = kNever;
    std::size_t first = 0, second = 0, wall = 3;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const long double time = untilWall(balls[i], room, k);
        if (time < soonest) soonest = time, first = i, wall = k;
      }
      for (std::size_t j = i + 1; j < balls.size(); ++j) {
        const long double time = untilPair(balls[i], balls[j]);
        if (time < soonest) soonest = time, first = i, second = j, wall = 3;
      }
    }
    if (soonest >= left) {
      fly(balls, room, left);
      return impacts;
    }
    fly(balls, room, soonest);
    left -= soonest;
    ++impacts;
    if (wall == 3) {
      exchange(balls[first], balls[second]);
    } else {
      balls[first].v[wall] = -balls[first].v[wall];
      // Exactly on the floor, so that the next flight begins there.
      if (wall == 2 && room.gravity > 0) balls[first].x[2] = room.low[2] + balls[first].radius;
    }
  }
}

Real tippingSpin(const Tipping& box, Real angle) {
  return static_cast<Real>(std::sqrt(tippingEnergy(box, angle)));
}

Real tippingTime(const Tipping& box, Real angle) {
  return static_cast<Real>(
      integral([&](long double p) { return 1 / std::sqrt(tippingEnergy(box, p)); }, 0, angle));
}

RockingAnswer rockingAnswer(const Rocking& block, Real part) {
  const long double b = block.halfWidth, h = block.halfHeight, g = block.gravity;
  const long double alpha = std::atan(b / h);
  const long double p2 = 3 * g / (4 * std::sqrt(b * b + h * h));
  const long double start = part * alpha;
  // theta'^2 = 2 p^2 (cos(alpha - start) - cos(alpha - theta)): with theta = start - u^2/2 the
  // difference of the cosines is 2 sin(alpha - start + u^2/4) sin(u^2/4), and its root at the
  // start is gone.
  const auto perU = [&](long double u) {
    const long double half = u == 0 ? 0.5L : std::sin(u * u / 4) / (u * u / 2);
    return 1 / std::sqrt(p2 * 2 * std::sin(alpha - start + u * u / 4) * half);
  };
  const long double time = integral(perU, 0, std::sqrt(2 * start));
  const long double before = std::sqrt(2 * p2 * (std::cos(alpha - start) - std::cos(alpha)));
  const long double kept = 1 - 1.5L * std::sin(alpha) * std::sin(alpha);
  const long double after = kept * before;
  const long double next = alpha - std::acos(std::cos(alpha) + after * after / (2 * p2));
  return {static_cast<Real>(alpha), static_cast<Real>(time), static_cast<Real>(before),
          static_cast<Real>(after), static_cast<Real>(next)};
}

ArchAnswer archAnswer(int stones) {
  long double low = 0.01L, high = 0.5L;
  int joint = 0;
  for (int i = 0; i < 80; ++i) {
    const long double middle = (low + high) / 2;
    (archMargin(stones, middle, joint) >= 0 ? high : low) = middle;
  }
  archMargin(stones, high, joint);
  return {static_cast<Real>(high), joint};
}

Real cardFriction(Real angle) {
  return std::tan(angle) / 2;
}

std::vector<std::array<Real, 2>> pyramidLoads(int rows) {
  std::vector<std::array<Real, 2>> forces{{0.5, 0.5}};
  for (int row = 1; row < rows; ++row) {
    // Its own weight, and on the left half what the upper left box has on its right one.
    std::vector<std::array<Real, 2>> below(forces.size() + 1, {0.5, 0.5});
    for (std::size_t i = 0; i < forces.size(); ++i) {
      below[i][1] += forces[i][0];
      below[i + 1][0] += forces[i][1];
    }
    forces = below;
  }
  return forces;
}

}  // namespace carom::scenes
