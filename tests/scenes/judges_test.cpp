// Do the judges measure what they say? On poses whose errors are known beforehand. And are the
// random scenes the same everywhere?

#include <cmath>
#include <map>

#include "carom/impulse/bouncing_ball.hpp"
#include "scenes/families.hpp"
#include "scenes/law.hpp"
#include "scenes/overlaps.hpp"
#include "scenes/run_scene.hpp"
#include "support/cases.hpp"
#include "support/catch.hpp"

using carom::Real;
using carom::Vector3;
using carom_test::number;
using carom_test::readCase;
using carom_test::WithinAbs;
using carom_test::WithinRel;
using scenes_states = std::vector<carom::scenes::State>;
namespace scenes = carom::scenes;
using carom::scenes::figuresOf;
using carom::scenes::runLaw;

namespace {

// What a scene's judge says of two looks: the start, and an end.
std::map<std::string, Real> judged(const scenes::Scene& scene, const scenes_states& end) {
  const auto judge = scene.judge(scene);
  judge->see(0, scenes::startOf(scene));
  judge->see(scene.duration, end);
  return figuresOf(*judge);
}

scenes::Scene sceneNamed(const std::string& name) {
  for (const scenes::SceneEntry& entry : scenes::allScenes()) {
    if (entry.name == name) return entry.make();
  }
  throw std::runtime_error("no scene " + name);
}

}  // namespace

TEST_CASE("a stack whose third box stands a millimetre aside drifts a millimetre") {
  const scenes::Scene scene = sceneNamed("G_stack10");
  scenes_states end = scenes::startOf(scene);
  auto still = judged(scene, end);
  CHECK(still["stands [1]"] == 1);
  CHECK(still["drift [m]"] == 0);
  CHECK(still["deepest [m]"] == 0);
  end[3].position.x() += 0.001;
  auto moved = judged(scene, end);
  CHECK_THAT(moved["drift [m]"], WithinAbs(0.001, 1e-15));
  CHECK(moved["stands [1]"] == 1);
}

TEST_CASE("a box that sinks a millimetre into the one below is a millimetre deep") {
  const scenes::Scene scene = sceneNamed("G_stack10");
  scenes_states end = scenes::startOf(scene);
  for (std::size_t i = 5; i <= 10; ++i) end[i].position.z() -= 0.001;
  auto sunk = judged(scene, end);
  CHECK_THAT(sunk["deepest [m]"], WithinAbs(0.001, 1e-15));
  CHECK_THAT(sunk["mean depth at the end [m]"], WithinAbs(0.001, 1e-15));
  CHECK_THAT(sunk["sunk at the end [m]"], WithinAbs(0.001, 1e-15));
  // Turning it about its own vertical axis does not change that; a fall does.
  end[5].orientation = {std::cos(0.2), 0, 0, std::sin(0.2)};
  CHECK_THAT(judged(scene, end)["deepest [m]"], WithinAbs(0.001, 1e-14));
  end[10].position = {5, 0, 0.5};
  CHECK(judged(scene, end)["stands [1]"] == 0);
}

TEST_CASE("the depth of two overlapping balls, boxes and polyhedra is the way that frees them") {
  scenes::Scene scene;
  scene.bodies = {scenes::ballBody(0.5, 1), scenes::ballBody(0.25, 1)};
  scenes_states states = scenes::startOf(scene);
  states[1].position = {0, 0.7, 0};
  CHECK_THAT(scenes::overlapsOf(scene, states).deepest, WithinAbs(0.05, 1e-15));
  const std::vector<Vector3> corners{{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
  scene.bodies = {scenes::hullBody(corners, 1), scenes::hullBody(corners, 1)};
  states = scenes::startOf(scene);
  // Face to face, the second is the first turned upside down; its depth falls as it moves away.
  states[1].position = {0.5, 0.25, 2};
  const Real deep = scenes::overlapsOf(scene, states).deepest;
  const Real gap = scenes::gapOf(scene.bodies[0], states[0], scene.bodies[1], states[1]);
  CHECK_THAT(deep, WithinAbs(std::max(0.0, -gap), 1e-15));
  scene.strangers = true;
  CHECK(scenes::overlapsOf(scene, states).pairs == 0);
}

TEST_CASE("a cube that stops a millimetre late and aside has those errors") {
  const scenes::Scene scene = sceneNamed("M_slide_1e5");
  scenes_states end = scenes::startOf(scene);
  end[1].velocity = Vector3::Zero();
  end[1].position = {1e5 + 25 / (2 * 0.5 * 9.81) + 0.001, -0.002, 0.5};
  end[1].orientation = {std::cos(0.01), 0, 0, std::sin(0.01)};
  auto figures = judged(scene, end);
  CHECK_THAT(figures["stop [m]"], WithinAbs(0.001, 1e-10));  // an ulp at 1e5 m is 1.5e-11 m
  CHECK_THAT(figures["drift [m]"], WithinAbs(0.002, 1e-15));
  CHECK_THAT(figures["yaw [rad]"], WithinAbs(0.02, 1e-15));
}

TEST_CASE("a ball that bounces as the closed form says has no error, one a millimetre up has one") {
  const scenes::Scene scene = scenes::bounceScene();
  const auto lifted = [](Real lift) {
    return [lift](int body, Real time) {
      scenes::State state;
      if (body == 0) return state;
      const auto ball = carom::bounceBall({5, 0}, {.restitution = 0.8, .gravity = 9.81}, time);
      state.position = {0, 0, 0.5 + ball.height + lift};
      return state;
    };
  };
  auto exact = runLaw(scene, 1.0 / 60, lifted(0));
  CHECK(exact["height rms [m]"] < 1e-13);
  CHECK(exact["free fall rms [m]"] < 1e-13);
  CHECK_THAT(exact["apex 1 [m]"], WithinAbs(0, 1e-12));
  CHECK_THAT(exact["apex 5 [m]"], WithinAbs(0, 1e-12));
  auto high = runLaw(scene, 1.0 / 60, lifted(0.001));
  CHECK_THAT(high["height rms [m]"], WithinRel(0.001, 0.01));  // the start is not lifted
  CHECK_THAT(high["apex 3 [m]"], WithinAbs(0.001, 1e-12));
}

TEST_CASE("49 balls in free flight are exact; a thousandth more speed is seen in the energy") {
  const auto S2 = readCase("scenes", "S2");
  const scenes::Scene scene = scenes::bouncing49Scene();
  Real last = 0, speed = 0;
  const auto law = [&](Real factor) {
    return [&, factor](int body, Real time) {
      scenes::State state;
      if (body == 0) return state;
      const auto ball = carom::bounceBall({4.9, 0}, {.restitution = 1, .gravity = 9.81}, time);
      state.position = {0, 0, 0.1 + ball.height};
      state.velocity = {0, 0, factor * ball.velocity};
      last = state.position.z(), speed = state.velocity.z();
      return state;
    };
  };
  auto exact = runLaw(scene, 1.0 / 60, law(1));
  CHECK_THAT(last, WithinAbs(number(S2["height"]), 1e-12));
  CHECK_THAT(speed, WithinAbs(number(S2["velocity"]), 1e-11));
  CHECK(exact["energy rms [1]"] < 1e-14);
  CHECK(exact["height at the end [m]"] < 1e-12);
  CHECK(runLaw(scene, 1.0 / 60, law(1.001))["energy rms [1]"] > 1e-4);
}

TEST_CASE("the corner, the pushed box and the domino know their own answers") {
  const auto I19 = readCase("scenes", "I19");
  const scenes::Scene corner = scenes::cornerScene();
  scenes_states end = scenes::startOf(corner);
  end[1].velocity = {number(I19["velocity"][0]), 0, number(I19["velocity"][1])};
  end[1].angularVelocity = {0, -number(I19["spin"]), 0};
  auto figures = judged(corner, end);
  CHECK_THAT(figures["velocity [m/s]"], WithinAbs(0, 1e-15));
  CHECK_THAT(figures["spin [rad/s]"], WithinAbs(0, 1e-15));
  // The corner comes to the floor at its time: its arm is that of the case.
  scenes::State hit = corner.bodies[1].start;
  hit.position += 0.105 * hit.velocity;
  CHECK_THAT(hit.position.z(), WithinAbs(1.1, 1e-14));

  const auto I14 = readCase("scenes", "I14");
  const scenes::Scene pushed = scenes::pushedBoxScene();
  const auto box = runLaw(pushed, 1.0 / 60, [&](int body, Real time) {
    scenes::State state = pushed.bodies[static_cast<std::size_t>(body)].start;
    if (body == 0) return state;
    const Real a = number(I14[body == 1 ? "box" : "ball"]);
    const Vector3 direction(0.5, std::sqrt(3.0) / 2, 0);
    state.velocity = a * time * direction;
    state.position += a * time * time / 2 * direction;
    return state;
  });
  CHECK(box.at("mean square velocity [m^2/s^2]") < 1e-28);
  CHECK(box.at("box position [m]") < 1e-14);
}

TEST_CASE(
    "a block that rocks as its equation says comes down at its time and rises to its height") {
  const scenes::Scene scene = scenes::rockingScene();
  const Real p = number(readCase("scenes", "S10")["p"]);
  const Real alpha = number(readCase("scenes", "S10")["alpha"]);
  const Real kept = std::sqrt(number(readCase("scenes", "S10")["energy_ratio"]));
  // Small steps from the start to each look; a change of edge at zero.
  const auto rock = [&](int body, Real until) {
    scenes::State state;
    if (body == 0) return state;
    Real angle = alpha / 2, rate = 0;
    const int steps = std::max(1, static_cast<int>(until * 1e5));
    const Real h = until / steps;
    const auto pull = [&](Real a) {
      return a > 0 ? -p * p * std::sin(alpha - a) : p * p * std::sin(alpha + a);
    };
    for (int i = 0; i < steps; ++i) {
      const Real before = angle;
      rate += h / 2 * pull(angle);
      angle += h * rate;
      rate += h / 2 * pull(angle);
      if (before > 0 && angle <= 0) rate *= kept;
    }
    state.orientation = {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
    state.angularVelocity = {0, rate, 0};
    return state;
  };
  const auto figures = runLaw(scene, 1.0 / 60, rock);
  CHECK_THAT(figures.at("impact time [s]"), WithinAbs(0, 1e-8));
  CHECK_THAT(figures.at("spin before [rad/s]"), WithinAbs(0, 1e-7));
  CHECK_THAT(figures.at("next angle [rad]"), WithinAbs(0, 2e-5));  // of a step within the law
}

TEST_CASE("balls behind the wall are through, balls in it are inside") {
  const scenes::Scene scene = scenes::bulletScene("J", 50);
  REQUIRE(scene.bodies.size() == 1001);
  scenes_states end = scenes::startOf(scene);
  for (std::size_t i = 1; i < end.size(); ++i) end[i].position.z() = 1;
  end[1].position.z() = -3;
  end[2].position.z() = 0.05;  // a centimetre deep
  auto figures = judged(scene, end);
  CHECK(figures["through the wall [1]"] == 1);
  CHECK(figures["inside it [1]"] == 1);
  CHECK_THAT(figures["deepest [m]"], WithinAbs(0.01, 1e-15));
}

TEST_CASE(
    "every scene has bodies that can be told apart from its name, and starts free of overlap") {
  const auto entries = scenes::allScenes();
  CHECK(entries.size() >= 40);
  for (const scenes::SceneEntry& entry : entries) {
    const scenes::Scene scene = entry.make();
    INFO(entry.name);
    CHECK(scene.name == entry.name);
    CHECK(scene.duration > scene.untimed);
    REQUIRE(scene.judge);
    for (const scenes::Body& body : scene.bodies) {
      CHECK(body.mass > 0);
      CHECK(body.moments.minCoeff() > 0);
    }
    if (scene.bodies.size() > 2000) continue;
    CHECK(scenes::overlapsOf(scene, scenes::startOf(scene)).deepest < 1e-9);
  }
}

TEST_CASE("the random scenes are the same under every compiler") {
  const std::map<std::string, std::uint64_t> known{
      {"D_drop666", 0x2aadf31ff08fa55eu},    {"E_elastic666", 0x93d2a58020445ae8u},
      {"E2_free666", 0x4a36817bdfde2dfdu},   {"J_bullet50", 0xe77fcaf322e55219u},
      {"J_bullet3000", 0x5cd66938ed67a7e1u}, {"L_hulls", 0xf99f44122441cfb5u},
      {"S3_elastic", 0x3a3b4b8be0a635feu},   {"S8_gas", 0x3e28f620995f67f6u}};
  for (const auto& [name, hash] : known) {
    const scenes::Scene scene = sceneNamed(name);
    INFO(name << " is " << std::hex << scenes::hashOf(scene, scenes::startOf(scene)));
    CHECK(scenes::hashOf(scene, scenes::startOf(scene)) == hash);
  }
  // Of the polyhedra the corners too.
  const scenes::Scene hulls = sceneNamed("L_hulls");
  Real sum = 0;
  for (const scenes::Body& body : hulls.bodies) {
    if (const auto* hull = std::get_if<carom::ConvexHull>(&body.shape)) {
      for (const Vector3& v : hull->vertices) sum = sum / 2 + v.x() + v.y() + v.z();
    }
  }
  INFO("sum " << std::hexfloat << sum);
  CHECK(sum == 0x1.21c06fb8eade4p-3);
}

TEST_CASE("the balls of case S3 start where the case book says") {
  const auto S3 = readCase("scenes", "S3");
  const scenes::Scene scene = sceneNamed("S3_elastic");
  REQUIRE(scene.bodies.size() == 217);
  CHECK((scene.bodies[1].start.position - carom_test::vector(S3["first_ball"])).norm() < 1e-15);
  Real energy = 0;
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    energy += 10 * 9.81 * scene.bodies[i].start.position.z();
  }
  CHECK_THAT(energy, WithinRel(number(S3["energy"]), 1e-13));
}
