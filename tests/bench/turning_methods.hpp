#pragma once
// Ways to follow a body whose angular velocity is known at every time, in the body's axes: what a
// program might do, beside what the library does. A step from the orientation q at time t to the
// one at t + h; body to world, so a turn multiplies from the right.
//
// Euler and Runge-Kutta treat the quaternion as four numbers; the others multiply by a turn. Magnus
// 4 after Blanes, Casas and Ros (BIT 40, 2000), the commutator-free method after Celledoni,
// Marthinsen and Owren (Future Generation Computer Systems 19, 2003).

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_body_rate.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom::bench {

inline Quaternion plus(const Quaternion& q, Real h, const Quaternion& rate) {
  return {q.w + h * rate.w, q.x + h * rate.x, q.y + h * rate.y, q.z + h * rate.z};
}

// dq/dt = q omega / 2.
inline Quaternion derivative(const Quaternion& q, const Vector3& w) {
  return hamiltonProduct(q, {0, w.x() / 2, w.y() / 2, w.z() / 2});
}

inline Quaternion turned(const Quaternion& q, const Vector3& turn) {
  return hamiltonProduct(q, quaternionExponential(turn));
}

template <class Rate>
Quaternion eulerStep(const Rate& rate, const Quaternion& q, Real t, Real h) {
  return plus(q, h, derivative(q, rate(t)));
}

template <class Rate>
Quaternion eulerNormalisedStep(const Rate& rate, const Quaternion& q, Real t, Real h) {
  return renormalize(eulerStep(rate, q, t, h));
}

template <class Rate>
Quaternion startStep(const Rate& rate, const Quaternion& q, Real t, Real h) {
  return renormalize(turned(q, h * rate(t)));
}

template <class Rate>
Quaternion middleStep(const Rate& rate, const Quaternion& q, Real t, Real h) {
  return renormalize(turned(q, h * rate(t + h / 2)));
}

// Gauss points of order 4.
inline constexpr Real kEarly = 0.21132486540518711775, kLate = 0.78867513459481288225;

template <class Rate>
Quaternion magnus4Step(const Rate& rate, const Quaternion& q, Real t, Real h) {
  constexpr Real kSqrt3Over12 = 0.14433756729740644113;
  const Vector3 a = rate(t + kEarly * h), b = rate(t + kLate * h);
  return renormalize(turned(q, h / 2 * (a + b) + kSqrt3Over12 * h * h * cross(a, b)));
}

template <class Rate>
Quaternion commutatorFree4Step(const Rate& rate, const Quaternion& q, Real t, Real h) {
  constexpr Real kNear = 0.53867513459481288225, kFar = -0.03867513459481288225;
  const Vector3 a = rate(t + kEarly * h), b = rate(t + kLate * h);
  return renormalize(turned(turned(q, h * (kNear * a + kFar * b)), h * (kFar * a + kNear * b)));
}

template <class Rate>
Quaternion magnus6Step(const Rate& rate, const Quaternion& q, Real t, Real h) {
  return integrateBodyRate(
      q,
      {rate(t + kGaussPoints[0] * h), rate(t + kGaussPoints[1] * h), rate(t + kGaussPoints[2] * h)},
      h);
}

template <class Rate>
Quaternion rungeKutta4Step(const Rate& rate, const Quaternion& q, Real t, Real h) {
  const Quaternion k1 = derivative(q, rate(t));
  const Quaternion k2 = derivative(plus(q, h / 2, k1), rate(t + h / 2));
  const Quaternion k3 = derivative(plus(q, h / 2, k2), rate(t + h / 2));
  const Quaternion k4 = derivative(plus(q, h, k3), rate(t + h));
  return renormalize(plus(plus(plus(plus(q, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4));
}

// The middle step with everything in float.
template <class Rate>
Quaternion floatMiddleStep(const Rate& rate, const Quaternion& q, Real t, Real h) {
  const Vector3 w = rate(t + h / 2);
  const float x = static_cast<float>(h * w.x()), y = static_cast<float>(h * w.y()),
              z = static_cast<float>(h * w.z());
  const float angle = std::sqrt(x * x + y * y + z * z);
  const float s = angle < 1e-3f ? 0.5f - angle * angle / 48 : std::sin(angle / 2) / angle;
  const float c[4] = {std::cos(angle / 2), s * x, s * y, s * z};
  const float p[4] = {static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y),
                      static_cast<float>(q.z)};
  const float r[4] = {p[0] * c[0] - p[1] * c[1] - p[2] * c[2] - p[3] * c[3],
                      p[0] * c[1] + p[1] * c[0] + p[2] * c[3] - p[3] * c[2],
                      p[0] * c[2] + p[2] * c[0] + p[3] * c[1] - p[1] * c[3],
                      p[0] * c[3] + p[3] * c[0] + p[1] * c[2] - p[2] * c[1]};
  const float norm = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
  return {r[0] / norm, r[1] / norm, r[2] / norm, r[3] / norm};
}

}  // namespace carom::bench
