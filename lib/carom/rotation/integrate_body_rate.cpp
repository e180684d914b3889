#include "carom/rotation/integrate_body_rate.hpp"

#include "carom/core/checks.hpp"
#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {
namespace {
constexpr Real kSqrt3Over12 = 0.14433756729740644113;
}

Quaternion integrateBodyRate(const Quaternion& q, const Vector3& earlyRate, const Vector3& lateRate,
                             Real dt) {
  requireFinite(earlyRate, "earlyRate");
  requireFinite(lateRate, "lateRate");
  requireFinite(dt, "dt");
  const Vector3 mean = (earlyRate + lateRate) / 2;
  const Vector3 swing = kSqrt3Over12 * dt * cross(earlyRate, lateRate);
  return renormalize(hamiltonProduct(q, quaternionExponential((mean + swing) * dt)));
}

}  // namespace carom
