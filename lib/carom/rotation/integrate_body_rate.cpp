#include "carom/rotation/integrate_body_rate.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {
namespace {

constexpr Real kSqrt15Over3 = 1.29099444873580562839;

// The commutator of two small turns, as a rotation vector. In the body turns multiply from the
// right, so the order is the reverse of the textbook's.
Vector3 bracket(const Vector3& a, const Vector3& b) {
  return cross(b, a);
}

}  // namespace

Quaternion integrateBodyRate(const Quaternion& q, const std::array<Vector3, 3>& rates, Real dt) {
  for (const Vector3& rate : rates) requireFinite(rate, "rate");
  requireFinite(dt, "dt");

  // Value, slope and curvature of omega in the middle of the step, times powers of dt.
  const Vector3 a1 = dt * rates[1];
  const Vector3 a2 = kSqrt15Over3 * dt * (rates[2] - rates[0]);
  const Vector3 a3 = Real(10) / 3 * dt * (rates[2] - 2 * rates[1] + rates[0]);

  const Vector3 c1 = bracket(a1, a2);
  const Vector3 c2 = bracket(a1, 2 * a3 + c1) / -60;
  const Vector3 turn = a1 + a3 / 12 + bracket(-20 * a1 - a3 + c1, a2 + c2) / 240;
  return renormalize(hamiltonProduct(q, quaternionExponential(turn)));
}

}  // namespace carom
