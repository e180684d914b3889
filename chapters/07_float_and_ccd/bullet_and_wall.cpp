// Which way of looking stops a bullet?
//
// A thousand balls of 5 cm fly at a wall of 2 cm or past it, sixty steps a second. Three ways: look
// at the end of each step; look as often as the rule for sub-steps asks; or ask for the first
// contact. How many get through, and how often did each way have to measure the gap?

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/sub_steps.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::ImpactStatus;
using carom::Real;
using carom::Sweep;
using carom::TimeOfImpact;
using carom::Vector3;

const carom::Ball kBullet{0.05};       // [m]
const carom::Box kWall{{0.01, 5, 5}};  // half lengths [m]
const Real kStep = 1.0 / 60;           // [s]

TimeOfImpact atTheEnd(const Sweep& bullet) {
  return contactBySubSteps(kBullet, bullet, kWall, {}, kStep, 1, 1e-9);
}

//! [rule]
TimeOfImpact byTheRule(const Sweep& bullet) {
  const Real half = 0.01;  // of the thinner body: nobody passes unseen
  const int parts = subStepsFor(kBullet, bullet, kWall, {}, kStep, half);
  if (parts == 0) return {};
  return contactBySubSteps(kBullet, bullet, kWall, {}, kStep, parts, 1e-9);
}
//! [rule]

//! [first]
TimeOfImpact first(const Sweep& bullet) {
  return firstContact(kBullet, bullet, kWall, {}, kStep);
}
//! [first]

struct Outcome {
  int aimed = 0;    // at the wall, of a thousand
  int through = 0;  // of those
  Real looks = 0;   // in a step, on average
};

Outcome fire(TimeOfImpact (*way)(const Sweep&), Real speed) {
  carom::Random random(3);
  Outcome outcome;
  int steps = 0;
  for (int i = 0; i < 1000; ++i) {
    Vector3 direction = random.direction();
    direction.x() = std::abs(direction.x()) + 0.2;
    direction.normalize();
    const Vector3 target{0, random.between(-12, 12), random.between(-4.5, 4.5)};
    const bool aimed = std::abs(target.y()) < 4.5;
    Sweep bullet;
    bullet.velocity = speed * direction;
    bullet.start.p_WB = target - random.between(0.2, 2) * direction;
    bool stopped = false;
    while (!stopped && bullet.start.p_WB.x() < 0.06) {
      const TimeOfImpact hit = way(bullet);
      outcome.looks += hit.steps + 1;
      ++steps;
      stopped = hit.status != ImpactStatus::kNoHit;
      bullet.start = poseAt(bullet, kStep);
    }
    if (aimed) ++outcome.aimed;
    if (aimed && !stopped) ++outcome.through;
  }
  outcome.looks /= steps;
  return outcome;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::io::Table table;
  table.column("speed [m/s]").column("through: ends").column("rule").column("first");
  table.column("looks: ends", carom::io::fixed(1)).column("rule", carom::io::fixed(1));
  table.column("first", carom::io::fixed(1));
  carom::io::Plot plot("Looks in a step");
  plot.xAxis("speed [m/s]", carom::io::Scale::Logarithmic);
  plot.yAxis("looks at the gap, on average", carom::io::Scale::Logarithmic);
  plot.describe("The rule's looks grow with the speed, to thousands. First contact needs three.");
  std::vector<Real> speeds, rule, advances;
  int aimed = 0;
  for (const Real speed : {50.0, 100.0, 350.0, 1000.0, 3000.0, 10000.0}) {
    const Outcome a = fire(atTheEnd, speed), b = fire(byTheRule, speed), c = fire(first, speed);
    table.row({speed, a.through, b.through, c.through, a.looks, b.looks, c.looks});
    aimed = c.aimed;
    speeds.push_back(speed);
    rule.push_back(b.looks);
    advances.push_back(c.looks);
  }
  std::cout << "A thousand bullets at a wall of 2 cm, " << aimed << " of them well aimed\n\n"
            << table;
  plot.curve("sub-steps by the rule", speeds, rule, {.marks = true});
  plot.curve("first contact", speeds, advances, {.marks = true});
  plot.writeSvg(folder / "bullet_and_wall.svg");

  // One of them at 350 m/s, a hundred times slower.
  carom::io::Recording recording("A bullet and a wall", "Looked at once in a step, it passes.");
  recording.addBody("bullet", carom::io::Ball{0.05}, {.trail = true});
  recording.addFixed("wall", carom::io::Box{Vector3(0.02, 2, 2)}, {}, {.opacity = 0.5});
  recording.setParameter("looked at");
  for (const bool stops : {false, true}) {
    recording.beginCase(stops ? "first contact" : "ends of steps");
    Sweep bullet;
    bullet.start.p_WB = {-3, -0.4, 0};
    bullet.velocity = {350, 50, 0};
    const TimeOfImpact hit = first(bullet);
    for (int i = 0; i <= 100; ++i) {
      const Real t = i * kStep / 100;
      Vector3 place = poseAt(bullet, stops ? std::min(t, hit.time) : t).p_WB;
      if (stops && t > hit.time) place += (t - hit.time) * Vector3(-350, 50, 0);
      recording.addFrame({.time = 100 * t, .poses = {{place}}});
    }
  }
  recording.writeHtml(folder / "bullet_and_wall.html");
}
