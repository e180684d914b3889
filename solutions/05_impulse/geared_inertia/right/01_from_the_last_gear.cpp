// From the last gear to the first: what each gear feels of all behind it.
#include "carom/core/errors.hpp"
#include "geared_inertia.hpp"

namespace carom {

Real gearedInertia(std::span<const GearWheel> train) {
  if (train.empty()) throw InvalidInput("no gear");
  Real felt = 0;
  int teethBehind = train.back().teeth;
  for (std::size_t k = train.size(); k-- > 0;) {
    const GearWheel& gear = train[k];
    if (gear.teeth < 1 || !(gear.inertia >= 0)) throw InvalidInput("no such gear");
    const Real ratio = Real(gear.teeth) / teethBehind;
    felt = felt * ratio * ratio + gear.inertia;
    teethBehind = gear.teeth;
  }
  return felt;
}

}  // namespace carom
