// Is a world that advances as right as it was asked to be, on every scene whose end is known?

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "scenes/engine_carom.hpp"
#include "scenes/families.hpp"
#include "scenes/run_scene.hpp"
#include "support/catch.hpp"

using carom::Real;
namespace scenes = carom::scenes;

namespace {

scenes::EngineKind advancing(Real tolerance) {
  return scenes::caromWith("advance", {}, {}, false, tolerance);
}

// Figures without a length or an angle in them are no places.
bool isAsked(const std::string& name) {
  for (const char* unit : {"[m]", "[rad]", "[s]", "[m/s]", "[rad/s]"}) {
    if (name.ends_with(unit)) return true;
  }
  return false;
}

// Scenes that take little time, with what of them says nothing about the end of a motion.
std::vector<scenes::Scene> known() {
  return {scenes::bounceScene(),
          scenes::slideScene("B_slide", 0),
          scenes::rollScene(),
          scenes::inclineScene("I8_below", -1e-6),
          scenes::inclineScene("I8_above", 1e-6),
          scenes::inclineScene("I8_steep", 0.1),
          scenes::masseScene(),
          scenes::dominoScene(),
          scenes::rockingScene(),
          scenes::cornerScene(),
          scenes::cradleScene("I5_cradle1", 1),
          scenes::cradleScene("I5_cradle2", 2),
          scenes::twoBallsScene("S9_ratio3", 3),
          scenes::twoBallsScene("S9_ratio1000", 1000),
          scenes::breakScene("T13", 1),
          scenes::topScene(),
          scenes::gasScene(),
          scenes::bouncing49Scene()};
}

}  // namespace

TEST_CASE("what is asked for is what comes out, three times it at most") {
  for (const scenes::Scene& scene : known()) {
    for (const Real tolerance : {1e-3, 1e-6, 1e-9}) {
      const scenes::Run run = scenes::runScene(advancing(tolerance), scene, 1.0 / 60);
      CHECK(run.finite);
      for (const scenes::Figure& figure : run.figures) {
        if (!isAsked(figure.name)) continue;
        INFO(scene.name << ", " << figure.name << ", asked for " << tolerance);
        CHECK(std::abs(figure.value) <= 3 * tolerance);
      }
    }
  }
}

TEST_CASE("a ball that comes down slowly in one long step does not sink in") {
  // The big ball stands still in the air when it has given all it had to the small one, and comes
  // down from a tenth of a millimetre: seven millimetres in the half second that is left.
  scenes::Scene scene = scenes::twoBallsScene("S9_ratio3", 3);
  scene.lookEvery = scene.duration;
  const scenes::Run run = scenes::runScene(advancing(1e-3), scene, scene.duration);
  CHECK(std::abs(run.figures[0].value) < 3e-3);
}

TEST_CASE("every compiler comes to the same last bit, whatever steps the error asks for") {
  struct Known {
    scenes::Scene scene;
    std::uint64_t hash;
  };
  std::vector<Known> all{{scenes::dominoScene(), 0x3DDCDD63760554F0},
                         {scenes::rockingScene(), 0x6030DD186970C953},
                         {scenes::masseScene(), 0x0D7B9D235FE2E10C},
                         {scenes::gasScene(), 0xC6FE99AAEE8E2ABB},
                         {scenes::bounceScene(), 0x5D06BF8BF54A395D}};
  for (Known& known : all) {
    known.scene.duration = known.scene.lookEvery = 0.5;
    known.scene.sleeps = false;
    INFO(known.scene.name);
    CHECK(scenes::runScene(advancing(1e-6), known.scene, 0.1).hash == known.hash);
  }
}

TEST_CASE("a thousandth of the error costs less than six times as much where motion is smooth") {
  // An exponent of -1/4 would be 1000^(1/4) = 5.6.
  const auto subSteps = [](Real tolerance) {
    scenes::Scene scene = scenes::dominoScene();
    scene.duration = scene.lookEvery = 0.45;  // it has not come down yet
    const scenes::Run run = scenes::runScene(advancing(tolerance), scene, 0.45);
    for (const scenes::Figure& counter : run.counters) {
      if (counter.name == "sub-steps") return counter.value;
    }
    return Real(0);
  };
  const Real coarse = subSteps(1e-3), middle = subSteps(1e-6), fine = subSteps(1e-9);
  CHECK(coarse > 0);
  CHECK(middle < 5.6 * coarse);
  CHECK(fine < 5.6 * middle);
}
