#pragma once
// Carom with settings of one's own, as an engine of scenes.

#include <string>
#include <vector>

#include "carom/world/world.hpp"
#include "scenes/engines.hpp"

namespace carom::scenes {

/// Settings with what a scene decides: gravity, and whether anything may sleep.
/// \param scene any \param settings to begin with \return settings of a world for it
world::WorldSettings settingsFor(const Scene& scene, const world::WorldSettings& settings = {});

/// Makes the bodies of a scene. \param scene any \param world with settings for it
/// \return their ids, in the order of the scene
std::vector<world::BodyId> addScene(const Scene& scene, world::World& world);

/// Carom with settings. The scene decides on gravity, and may forbid sleeping.
/// \param name of the engine \param words what differs \param settings to begin with
/// \param best whether it is run where nobody asks for it
/// \param tolerance if positive, the world advances with this error over the scene [m]
/// \return the engine
EngineKind caromWith(const std::string& name, const std::string& words,
                     const world::WorldSettings& settings, bool best = false, Real tolerance = 0);

}  // namespace carom::scenes
