#include "carom/solver/friction_law.hpp"

namespace carom {

FrictionLaw frictionLaw(const ContactBlock& block, const Vector3& without, Real limit) {
  if (!block.slips) return {};
  const Vector3 sum = block.slipBefore + without;
  if ((block.inverse * sum).squaredNorm() > limit * limit) return {block.slipBefore, false};
  constexpr Real kAtOnce = 1e3;
  if (limit > kAtOnce * (block.inverse * block.slipBefore).norm()) return {};
  return {block.slipBefore, true};
}

}  // namespace carom
