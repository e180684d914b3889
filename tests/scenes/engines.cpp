#include "scenes/engines.hpp"

namespace carom::scenes {

std::vector<EngineKind> allEngines() {
  std::vector<EngineKind> all;
  const auto append = [&all](std::vector<EngineKind> kinds) {
    for (EngineKind& kind : kinds) all.push_back(std::move(kind));
  };
#if defined(CAROM_SCENES_WORLD)
  append(caromEngines());
#endif
#if defined(CAROM_SCENES_BULLET)
  append(bulletEngines());
#endif
#if defined(CAROM_SCENES_ODE)
  append(odeEngines());
#endif
#if defined(CAROM_SCENES_MUJOCO)
  append(mujocoEngines());
#endif
#if defined(CAROM_SCENES_BOX3D)
  append(box3dEngines());
#endif
#if defined(CAROM_SCENES_JOLT)
  append(joltEngines());
#endif
  return all;
}

}  // namespace carom::scenes
