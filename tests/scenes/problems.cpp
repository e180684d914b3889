#include "scenes/problems.hpp"

#include <stdexcept>

#include "scenes/families.hpp"

namespace carom::scenes {
namespace {

constexpr Real kAtTheEnd = -1;  // a look then, and none before
constexpr Real kHundred =
    100;  // times dearer, where motion has a closed form or is a chain of hits

Scene sceneNamed(const std::string& name) {
  for (const SceneEntry& entry : allScenes()) {
    if (entry.name == name) return entry.make();
  }
  throw std::runtime_error("there is no scene " + name);
}

// A scene, looked at every `look` seconds, and cut to `duration` if that is positive.
Problem problemOf(const std::string& name, const std::string& scene, Real look,
                  std::vector<Question> questions, Real duration = 0) {
  Problem problem;
  problem.name = name;
  problem.title = sceneNamed(scene).title;
  problem.make = [scene, look, duration] {
    Scene made = sceneNamed(scene);
    if (duration > 0) made.duration = duration;
    made.lookEvery = look == kAtTheEnd ? made.duration : look;
    return made;
  };
  problem.questions = std::move(questions);
  return problem;
}

void addOneBody(std::vector<Problem>& all) {
  const auto height = [](Real wanted) {
    return Question{"height rms [m]", "rms error of the height [m]", 1e-12, wanted, true};
  };
  all.push_back(problemOf("A_bounce", "A_bounce", 1, {height(kHundred)}));
  all.push_back(problemOf("A_bounce_film", "A_bounce", 1.0 / 30, {height(1)}));
  all.back().title += " (30 looks a second)";
  all.push_back(
      problemOf("B_slide", "B_slide", kAtTheEnd,
                {{"stop [m]", "error of the place where it stops [m]", 1e-13, kHundred, true}}));
  all.push_back(
      problemOf("C_roll", "C_roll", kAtTheEnd,
                {{"position [m]", "error of the place after 5 s [m]", 1e-13, kHundred, true}}));
  // The judge's closed form is the library's own, tested against 60 digits (N7); what it may be off
  // by, 4 ulp of the phase, is the bound here.
  const Question after10{"orientation 10 s [rad]", "error of the orientation after 10 s [rad]",
                         1e-11, kHundred, true};
  const Question after100{"orientation 100 s [rad]", "error of the orientation after 100 s [rad]",
                          1e-9, 1, true};
  const Question energy{"energy [1]", "error of the energy [1]", 1e-14};
  all.push_back(problemOf("F_rotor", "F_rotor", 10, {after10, after100, energy}));
}

void addGases(std::vector<Problem>& all) {
  const auto energy = [](Real wanted) {
    return Question{"energy rms [1]", "rms error of the energy [1]", 1e-13, wanted};
  };
  all.push_back(problemOf("E_elastic666", "E_elastic666", 1, {energy(kHundred)}));
  all.push_back(
      problemOf("E2_free666", "E2_free666", 1,
                {energy(1), {"angular momentum [1]", "error of the angular momentum [1]", 1e-14}}));
  all.push_back(problemOf(
      "S2_bouncing", "S2_bouncing", 1,
      {energy(1), {"height at the end [m]", "largest error of a height [m]", 1e-11, 1, true}}));
  all.push_back(problemOf("S3_elastic", "S3_elastic", 1, {energy(1)}));
  all.push_back(
      problemOf("S3_inelastic", "S3_inelastic", 1.0 / 30,
                {{"mean sum of squares [m^2]", "sum of squared penetration [m^2]", 1e-18}}));
  all.push_back(
      problemOf("S8_gas", "S8_gas", 0.5,
                {{"position 2.0 s [m]", "largest error of a position [m]", 1e-11, 1, true}}, 2));
}

void addImpacts(std::vector<Problem>& all) {
  const Question position{"position [m]", "largest error of a position [m]", 1e-13, 1, true};
  const Question velocity{"velocity [m/s]", "error of the velocity [m/s]", 1e-13};
  all.push_back(problemOf("I19_corner", "I19_corner", kAtTheEnd, {velocity}));
  for (const char* scene : {"I13_oblique", "I5_cradle1", "I5_cradle2", "T13_break31",
                            "T13_break314", "S9_ratio3", "S9_ratio1000"}) {
    all.push_back(problemOf(scene, scene, kAtTheEnd, {position}));
  }
}

void addContacts(std::vector<Problem>& all) {
  const auto atTheEnd = [&all](const char* scene, const char* figure, const char* axis) {
    all.push_back(problemOf(scene, scene, kAtTheEnd, {{figure, axis, 1e-12, 1, true}}));
  };
  for (const char* scene : {"I8_below", "I8_at", "I8_above", "I8_steep"}) {
    atTheEnd(scene, "way [m]", "error of the way after 10 s [m]");
  }
  atTheEnd("N10_top", "axis [rad]", "error of the axis after 2 s [rad]");
  atTheEnd("I14_pushed", "box position [m]", "error of the place of the box [m]");
  atTheEnd("I15_masse", "position [m]", "error of the place after 5 s [m]");
  // Their judges look for the moment of a hit, between two looks: as far apart as the longest steps
  // of others.
  all.push_back(problemOf("S7_domino", "S7_domino", 1.0 / 30,
                          {{"time [s]", "error of the time of the hit [s]", 1e-9}}));
  all.push_back(problemOf("S10_rocking", "S10_rocking", 1.0 / 30,
                          {{"impact time [s]", "error of the time of the impact [s]", 1e-9},
                           {"next angle [rad]", "error of the next largest angle [rad]", 1e-8}}));
}

void addStacks(std::vector<Problem>& all) {
  const std::vector<Question> still{{"drift [m]", "largest drift sideways [m]", 1e-9, 1, true},
                                    {"deepest [m]", "largest penetration [m]", 1e-9, 1, true}};
  for (const char* scene : {"G_stack10", "G_stack20", "G_stack40", "I_1000on1", "I_alternating"}) {
    all.push_back(problemOf(scene, scene, 1, still));
    all.back().condition = "stands [1]";
  }
}

}  // namespace

std::vector<Problem> allProblems() {
  std::vector<Problem> all;
  addOneBody(all);
  addGases(all);
  addStacks(all);
  addImpacts(all);
  addContacts(all);
  return all;
}

}  // namespace carom::scenes
