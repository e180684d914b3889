#pragma once
// Carom with settings of one's own, as an engine of scenes.

#include <string>

#include "carom/world/settings.hpp"
#include "scenes/engines.hpp"

namespace carom::scenes {

/// Carom with settings. The scene decides on gravity, and may forbid sleeping.
/// \param name of the engine \param words what differs \param settings to begin with
/// \param best whether it is run where nobody asks for it
/// \param tolerance if positive, the world advances with this error over the scene [m]
/// \return the engine
EngineKind caromWith(const std::string& name, const std::string& words,
                     const world::WorldSettings& settings, bool best = false, Real tolerance = 0);

}  // namespace carom::scenes
