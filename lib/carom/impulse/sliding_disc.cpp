#include "carom/impulse/sliding_disc.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "carom/core/checks.hpp"

namespace carom {

namespace {

constexpr Real kPi = std::numbers::pi;

// Complete elliptic integrals of modulus k: K, and K - E, which is small for small k and therefore
// kept by itself.
struct Elliptic {
  Real K = 0;
  Real KminusE = 0;
};

// Arithmetic-geometric mean; K - E = K (c0^2 + 2 c1^2 + 4 c2^2 + ...)/2 (Abramowitz and Stegun
// 17.6).
Elliptic elliptic(Real k) {
  if (k < 1e-3) {
    // Two terms of the series leave out 1e-12 of the second. The mean below would see only the
    // rounding of 1 - k^2.
    const Real k2 = k * k;
    return {kPi / 2 * (1 + k2 / 4 + 9 * k2 * k2 / 64), kPi / 2 * k2 * (0.5 + 3 * k2 / 16)};
  }
  Real a = 1, g = std::sqrt((1 - k) * (1 + k)), c = k, weight = 1;
  Real sum = 0;
  // Each step doubles the digits.
  for (int i = 0; i < 12; ++i) {
    sum += weight * c * c / 2;
    if (c == 0) break;
    const Real mean = (a + g) / 2;
    c = (a - g) / 2;
    g = std::sqrt(a * g);
    a = mean;
    weight *= 2;
  }
  const Real K = kPi / (2 * a);
  return {K, K * sum};
}

// For large x the closed form of the torque cancels; its series in 1/x^2 does not. The coefficients
// are those of the hypergeometric series of K and E, put together as the closed form does.
Real torqueFarOut(Real x) {
  const Real k2 = 1 / (x * x);
  Real before = 0, now = 1, power = 1, sum = 0;  // a(m-1), a(m), k^2m
  for (int m = 0; m < 60; ++m) {
    const Real shrink = Real(2 * m + 1) / (2 * m + 2);
    const Real next = now * shrink * shrink;
    const Real term =
        4 * (m + 1) * next / (2 * m + 1) - 4 * now / (2 * m - 1) - 5 * now + 3 * before;
    sum += term * power;
    power *= k2;
    before = now;
    now = next;
  }
  return 2 * x * sum / 9;
}

// The ratio at which flight and spin fall in the same proportion, F = 2 x T: every motion ends there.
Real finalRatio() {
  Real low = 0.5, high = 1;
  for (int i = 0; i < 60; ++i) {
    const Real middle = (low + high) / 2;
    const DiscFriction f = discFriction(middle);
    (f.force < 2 * middle * f.torque ? low : high) = middle;
  }
  return low;
}

struct State {
  Real x = 0;         // v/(R w)
  Real time = 0;      // in units of R w0/(mu g)
  Real distance = 0;  // in units of (R w0)^2/(mu g)
  Real angle = 0;     // in units of R w0^2/(mu g)
};

// Derivatives by s, where the spin is exp(-s): dw = -2 T dt for a disc of even thickness.
State rate(const State& state, Real spin) {
  const DiscFriction f = discFriction(state.x);
  const Real time = spin / (2 * f.torque);
  return {state.x - f.force / (2 * f.torque), time, state.x * spin * time, spin * time};
}

State moved(const State& s, const State& d, Real h) {
  return {s.x + h * d.x, s.time + h * d.time, s.distance + h * d.distance, s.angle + h * d.angle};
}

}  // namespace

DiscFriction discFriction(Real ratio) {
  if (!(ratio >= 0)) reject("ratio", toText(ratio), "must be zero or positive");
  // Far out and close in the first terms are all that a double holds, and squares might leave it.
  if (ratio > 1e8) return {1, 0.25 / ratio};
  if (ratio < 1e-8) return {ratio, 2.0 / 3};
  const Real x = ratio;
  if (x == 1) return {8 / (3 * kPi), 8 / (9 * kPi)};  // K is infinite there, but its factor is zero
  if (x < 1) {
    const auto [K, difference] = elliptic(x);
    const Real E = K - difference;
    return {4 * (x * (E + K) - difference / x) / (3 * kPi),
            4 * ((4 - 2 * x * x) * E + (x * x - 1) * K) / (9 * kPi)};
  }
  const auto [K, difference] = elliptic(1 / x);
  const Real E = K - difference;
  const Real force = 4 * (E + K - x * x * difference) / (3 * kPi);
  if (x >= 2) return {force, torqueFarOut(x)};
  return {force, 4 * x * ((4 - 2 * x * x) * E + (2 * x * x - 5 + 3 / (x * x)) * K) / (9 * kPi)};
}

DiscStop stopOfDisc(const SlidingDisc& disc) {
  requireNonNegative(disc.speed, "speed");
  requireNonNegative(disc.spin, "spin");
  requirePositive(disc.radius, "radius");
  requirePositive(disc.friction, "friction");
  requirePositive(disc.gravity, "gravity");
  const Real deceleration = disc.friction * disc.gravity;
  const Real rim = disc.radius * disc.spin;
  if (disc.spin == 0) {
    const Real ratio = disc.speed > 0 ? std::numeric_limits<Real>::infinity() : 0;
    return {disc.speed / deceleration, disc.speed * disc.speed / (2 * deceleration), 0, ratio};
  }
  if (disc.speed == 0) {
    const Real time = 3 * rim / (4 * deceleration);
    return {time, 0, disc.spin * time / 2, 0};
  }

  // Until the spin has fallen by e^-40 and with it the speed: then less than 1e-16 of the way is
  // left. Runge's method of order four; halving the step does not change the tenth digit.
  State s;
  s.x = disc.speed / rim;
  constexpr Real kStep = 1.0 / 256;
  const Real end = 40 + std::max(0.0, std::log(s.x));
  for (Real at = 0; at < end; at += kStep) {
    const Real now = std::exp(-at), half = std::exp(-at - kStep / 2), next = std::exp(-at - kStep);
    const State k1 = rate(s, now);
    const State k2 = rate(moved(s, k1, kStep / 2), half);
    const State k3 = rate(moved(s, k2, kStep / 2), half);
    const State k4 = rate(moved(s, k3, kStep), next);
    for (const State* k : {&k1, &k4}) s = moved(s, *k, kStep / 6);
    for (const State* k : {&k2, &k3}) s = moved(s, *k, kStep / 3);
  }
  const Real unitOfTime = rim / deceleration;
  return {s.time * unitOfTime, s.distance * rim * unitOfTime, s.angle * disc.spin * unitOfTime,
          finalRatio()};
}

}  // namespace carom
