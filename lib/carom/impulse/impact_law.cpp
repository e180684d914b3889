#include "carom/impulse/impact_law.hpp"

#include "carom/core/checks.hpp"
#include "carom/impulse/body_motion.hpp"

namespace carom {

void requireUsable(const ImpactLaw& law) {
  requireRestitution(law.restitution);
  requireNonNegative(law.friction, "friction");
  if (!(law.tangentialRestitution >= -1 && law.tangentialRestitution <= 1)) {
    reject("tangentialRestitution", toText(law.tangentialRestitution), "must be from -1 to 1");
  }
}

}  // namespace carom
