// W2 and scene F: bodies that turn freely. W3: tops.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "bench/integrators_methods.hpp"
#include "bench/integrators_peers.hpp"
#include "bench/integrators_sections.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/errors.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/exact_rotor.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/motion/kicked_rotor.hpp"
#include "carom/motion/rk4_rotor.hpp"
#include "carom/motion/split_rotor.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom_io/table.hpp"
#ifdef CAROM_BENCH_ODEINT
#include "bench/integrators_odeint.hpp"
#endif

namespace carom::bench {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// The angle between two attitudes [rad]; infinite if one is none.
Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const Real sum = a.w + a.x + a.y + a.z;
  if (!std::isfinite(sum)) return kInfinity;
  return quaternionLogarithm(hamiltonProduct(conjugate(b), a)).norm();
}

struct Scene {
  const char* name;
  Vector3 moments;
  Vector3 spin;
  int duration;  // [s]
  Quaternion end;
  const char* file;  // of the diagram; empty: none
  const char* title;
};

std::vector<Scene> scenes() {
  const auto quaternion = [](const char* id, const char* key) {
    return Quaternion{caseNumber(id, key, 0), caseNumber(id, key, 1), caseNumber(id, key, 2),
                      caseNumber(id, key, 3)};
  };
  return {{"N7, a body of three unlike moments",
           {1, 2, 3},
           {2, 0, 1.5},
           10,
           quaternion("N7", "q_10"),
           "free_rotor.svg",
           "A free body of moments 1, 2, 3: error of the attitude after 10 s"},
          {"N8, the tennis racket",
           {1, 2, 3},
           {0.001, 5, 0},
           10,
           quaternion("N8", "q_10"),
           "free_rotor_racket.svg",
           "A tennis racket, thrown up about its middle axis: error of the attitude after 10 s"},
          {"N9, a round body", {2, 2, 1}, {1, 0, 4}, 10, quaternion("N9", "q"), "", ""},
          {"F, a box about its middle axis",
           {13, 10, 5},
           {0.01, 5, 0.01},
           100,
           quaternion("F", "q"),
           "free_rotor_box.svg",
           "A box of 1 x 2 x 3 m about its middle axis: error of the attitude after 100 s"}};
}

// Steps of a free body from its start to the end; not a number if a step refuses the state.
template <class Step>
Quaternion stepped(const Scene& scene, int steps, const Step& step) {
  RotorState s = {{1, 0, 0, 0}, scene.spin};
  const Real dt = Real(scene.duration) / steps;
  try {
    for (int i = 0; i < steps; ++i) s = step(s, dt);
  } catch (const InvalidInput&) {
    return {kInfinity, 0, 0, 0};
  }
  return s.q_WB;
}

Race raceOf(const Scene& scene) {
  Race race(scene.name, "rad", scene.duration);
  const auto error = [end = scene.end](const Quaternion& q) { return angleBetween(q, end); };
  const RotorState start = {{1, 0, 0, 0}, scene.spin};
  const Vector3 moments = scene.moments;
  const std::vector<int> rates = {15, 60, 240, 960, 3840};

  const auto each = [&](const char* name, std::vector<int> some, auto step) {
    for (const int rate : some) {
      const int steps = rate * scene.duration;
      race.add(
          name, false, "dt", 1.0 / rate,
          [scene, steps, step] { return stepped(scene, steps, step); }, error);
    }
  };
  each("explicit gyroscopic step", rates,
       [moments](const RotorState& s, Real dt) { return engineStep(moments, s, dt, false); });
  each("implicit gyroscopic step", rates,
       [moments](const RotorState& s, Real dt) { return engineStep(moments, s, dt, true); });
  each("Buss, order 2", rates,
       [moments](const RotorState& s, Real dt) { return bussStep(moments, s, dt); });
  each("implicit midpoint", rates,
       [moments](const RotorState& s, Real dt) { return midpointStep(moments, s, dt); });
  each("RK4 on the quaternion", rates,
       [moments](const RotorState& s, Real dt) { return rk4Rotor(moments, s, 0, dt); });
  const SplitRotor split(moments);
  each("splitting, order 2", rates,
       [split](const RotorState& s, Real dt) { return split.step2(s, dt); });
  each("splitting, order 4", {4, 15, 60, 240, 960},
       [split](const RotorState& s, Real dt) { return split.step4(s, dt); });
  for (const int rate : {4, 15, 60, 240, 960}) {
    const int steps = rate * scene.duration;
    race.add(
        "splitting, order 4, in one run", false, "dt", 1.0 / rate,
        [split, start, rate, steps] { return split.steps4(start, 1.0 / rate, steps).q_WB; }, error);
  }
  each("exact, stepped and rounded", {1, 15, 60},
       [moments](const RotorState& s, Real dt) { return FreeRotor(moments, s).at(dt); });
  // The time is read from memory each time, so that nothing is computed beforehand.
  static volatile Real duration;
  duration = scene.duration;
  const FreeRotor rotor(moments, start);
  race.add(
      "exact, one query (carom)", false, "query", 0, [rotor] { return rotor.at(duration).q_WB; },
      error);
  if (moments[0] == moments[1]) {
    race.add(
        "exact, round bodies (carom)", false, "query", 0,
        [moments, start] {
          return exactRotor({moments[0], moments[2]}, start, duration).q_WB;
        },
        error);
  }

#ifdef CAROM_BENCH_ODEINT
  using Seven = OdeintState<7>;
  const Vector3 c((moments[1] - moments[2]) / moments[0], (moments[2] - moments[0]) / moments[1],
                  (moments[0] - moments[1]) / moments[2]);
  const auto flow = [c0 = c[0], c1 = c[1], c2 = c[2]](const Seven& y, Seven& d, double) {
    const double wx = y[4], wy = y[5], wz = y[6];
    d[0] = (-y[1] * wx - y[2] * wy - y[3] * wz) / 2;
    d[1] = (y[0] * wx + y[2] * wz - y[3] * wy) / 2;
    d[2] = (y[0] * wy + y[3] * wx - y[1] * wz) / 2;
    d[3] = (y[0] * wz + y[1] * wy - y[2] * wx) / 2;
    d[4] = c0 * wy * wz;
    d[5] = c1 * wz * wx;
    d[6] = c2 * wx * wy;
  };
  const Seven first = {1, 0, 0, 0, scene.spin[0], scene.spin[1], scene.spin[2]};
  const auto attitude = [](const Seven& y) { return Quaternion{y[0], y[1], y[2], y[3]}; };
  for (const int rate : rates) {
    const int steps = rate * scene.duration;
    race.add(
        "odeint RK4", true, "dt", 1.0 / rate,
        [=] { return attitude(odeintRk4<7>(flow, first, duration, steps)); }, error);
  }
  const std::vector<std::pair<const char*, OdeintMethod>> methods = {
      {"odeint dopri5", OdeintMethod::dopri5},
      {"odeint fehlberg78", OdeintMethod::fehlberg78},
      {"odeint bulirsch_stoer", OdeintMethod::bulirschStoer}};
  for (const auto& [name, method] : methods) {
    for (const Real tolerance : {1e-4, 1e-7, 1e-10, 1e-13, 1e-15}) {
      race.add(
          name, true, "tolerance", tolerance,
          [=, method = method] {
            return attitude(odeintAdaptive<7>(method, flow, first, duration, tolerance));
          },
          error);
    }
  }
#endif
#if defined(CAROM_BENCH_BULLET) || defined(CAROM_BENCH_ODE)
  const PeerRotor peer{{moments[0], moments[1], moments[2]},
                       {scene.spin[0], scene.spin[1], scene.spin[2]},
                       Real(scene.duration)};
  const auto fromPeer = [](const PeerAttitude& a) {
    return Quaternion{a.q[0], a.q[1], a.q[2], a.q[3]};
  };
  const std::vector<int> peerRates = {60, 240, 960};
#endif
#ifdef CAROM_BENCH_BULLET
  const std::vector<std::pair<const char*, BulletTerm>> terms = {
      {"Bullet, implicit term", BulletTerm::implicitBody},
      {"Bullet, explicit term", BulletTerm::explicitTerm}};
  for (const auto& [name, term] : terms) {
    for (const int rate : peerRates) {
      const int steps = rate * scene.duration;
      race.add(
          name, true, "dt", 1.0 / rate,
          [=, term = term] { return fromPeer(turnInBullet(peer, steps, term)); }, error);
    }
  }
#endif
#ifdef CAROM_BENCH_ODE
  for (const int rate : peerRates) {
    const int steps = rate * scene.duration;
    race.add(
        "ODE", true, "dt", 1.0 / rate, [=] { return fromPeer(turnInOde(peer, steps)); }, error);
  }
#endif
  return race;
}

// The rest of what scene F asks: what is kept, and the symplectic steps over a million.
void sceneF(const Scene& scene, Figures& figures) {
  const Vector3& I = scene.moments;
  const RotorState start = {{1, 0, 0, 0}, scene.spin};
  const FreeRotor rotor(I, start);
  const Real energy = rotationEnergy(I, start.angularVelocity);
  const Vector3 L = angularMomentum(I, start);
  struct Kept {
    Real energy = 0, size = 0, direction = 0;
  };
  const auto look = [&](const RotorState& s, Kept& kept) {
    const Vector3 now = angularMomentum(I, s);
    const auto worst = [](Real& most, Real value) { most = std::max(most, std::abs(value)); };
    worst(kept.energy, rotationEnergy(I, s.angularVelocity) / energy - 1);
    worst(kept.size, now.norm() / L.norm() - 1);
    worst(kept.direction, cross(now, L).norm() / L.squaredNorm());
  };
  Kept query, stepped;
  RotorState s = start;
  for (int i = 1; i <= 6000; ++i) {
    look(rotor.at(i / 60.0), query);
    s = FreeRotor(I, s).at(1.0 / 60);
    look(s, stepped);
  }
  const Real steppedError = angleBetween(s.q_WB, scene.end);
  const Real queryError = angleBetween(rotor.at(100).q_WB, scene.end);

  // The energy of the symplectic steps: the largest error in the first and the last tenth.
  const SplitRotor split(I);
  Real early[2] = {0, 0}, late[2] = {0, 0};
  RotorState a = start, b = start;
  for (int i = 0; i < 1000000; ++i) {
    a = split.step2(a, 1.0 / 60);
    b = split.step4(b, 1.0 / 60);
    if (i >= 100000 && i < 900000) continue;
    Kept now[2];
    look(a, now[0]);
    look(b, now[1]);
    for (int k = 0; k < 2; ++k) {
      Real& most = i < 100000 ? early[k] : late[k];
      most = std::max(most, now[k].energy);
    }
  }
  io::Table table;
  table.column("scene F, 100 s at 60 a second").column("reached", io::scientific(1));
  table.column("asked for", io::scientific(0));
  const auto enter = [&](const char* what, Real reached, Real asked) {
    table.row({what, reached, asked});
    figures.targets.push_back({{"diagram", "scene F"},
                               {"what", what},
                               {"reached", reached},
                               {"target", asked},
                               {"met", reached <= asked}});
  };
  enter("attitude from the anchor [rad]", queryError, 1e-10);
  enter("attitude, stepped and rounded [rad]", steppedError, 1e-8);
  enter("energy from the anchor", query.energy, 1e-13);
  enter("|L| from the anchor", query.size, 1e-13);
  enter("direction of L from the anchor", query.direction, 1e-12);
  enter("energy, stepped", stepped.energy, 1e-13);
  enter("|L|, stepped", stepped.size, 1e-13);
  enter("direction of L, stepped", stepped.direction, 1e-12);
  std::cout << '\n' << table;
  for (int k = 0; k < 2; ++k) {
    const char* name = k == 0 ? "splitting, order 2" : "splitting, order 4";
    std::cout << name << ", energy error over 1e6 steps: first tenth " << early[k]
              << ", last tenth " << late[k] << '\n';
    figures.targets.push_back({{"diagram", "scene F"},
                               {"what", std::string(name) + ", energy over 1e6 steps"},
                               {"first_tenth", early[k]},
                               {"last_tenth", late[k]},
                               {"met", late[k] < 1.1 * early[k]}});
  }
}

// --- W3

const Vector3 kTop(0.3, 0.3, 0.1);
constexpr Real kWeight = 9.81 * 0.5;  // times 1 kg: m g l [N m]

// The torque of the weight about the point: l e3 x R^T (0, 0, -m g), in the axes of the top.
Vector3 weightOf(const Quaternion& q) {
  const Real ux = 2 * (q.x * q.z - q.w * q.y), uy = 2 * (q.y * q.z + q.w * q.x);
  return {kWeight * uy, -kWeight * ux, 0};
}

struct TopEnd {
  Real tilt = 0, turned = 0;  // [rad]
};

// Where the axis of a top points: how far from upright, and how far round.
TopEnd endOf(const Quaternion& q, const Vector3& first) {
  if (!std::isfinite(q.w + q.x + q.y + q.z)) return {kInfinity, kInfinity};
  const Vector3 axis = rotatePoint(q, {0, 0, 1});
  return {arctangent2(std::hypot(axis.x(), axis.y()), axis.z()),
          arctangent2(first.x() * axis.y() - first.y() * axis.x(),
                      first.x() * axis.x() + first.y() * axis.y())};
}

Real topEnergy(const RotorState& s) {
  const Quaternion& q = s.q_WB;
  return rotationEnergy(kTop, s.angularVelocity) +
         kWeight * (q.w * q.w - q.x * q.x - q.y * q.y + q.z * q.z);
}

RotorState releasedTop() {
  return {{cosine(0.25), sine(0.25), 0, 0}, {0, 0, 40}};
}

Race topRace() {
  constexpr int kDuration = 2;
  Race race("N11, a top that nods", "rad", kDuration);
  const RotorState start = releasedTop();
  const Vector3 first = rotatePoint(start.q_WB, {0, 0, 1});
  const Real theta = caseNumber("N11", "theta"), phi = caseNumber("N11", "phi");
  const auto error = [=](const Quaternion& q) {
    const TopEnd end = endOf(q, first);
    return std::max(std::abs(end.tilt - theta),
                    std::abs(std::remainder(end.turned - phi, 2 * std::numbers::pi)));
  };
  const SplitRotor body(kTop);
  const Torque weight = [](Real, const RotorState& s) { return weightOf(s.q_WB); };
  static volatile Real duration;
  duration = kDuration;

  const auto composed = [&](const char* name, std::span<const Real> weights,
                            const std::vector<int>& counts) {
    for (const int steps : counts) {
      race.add(
          name, false, "dt", Real(kDuration) / steps,
          [=] {
            RotorState s = start;
            const Real dt = duration / steps;
            for (int i = 0; i < steps; ++i) {
              s = kickedRotor(body, s, i * dt, dt, weights, weight);
            }
            return s.q_WB;
          },
          error);
    }
  };
  composed("kicked, Verlet", kVerletWeights, {64, 256, 1024, 4096});
  composed("kicked, Yoshida 4", kYoshida4Weights, {32, 128, 512, 2048});
  composed("kicked, Yoshida 6", kYoshida6Weights, {16, 32, 64, 128, 256, 512});
  composed("kicked, Kahan and Li 6", kKahanLi6Weights, {8, 16, 32, 64, 128, 256});
  composed("kicked, Kahan and Li 8", kKahanLi8Weights, {8, 16, 32, 64, 128});
  const auto split = [&](const char* name, const Splitting& method,
                         const std::vector<int>& counts) {
    for (const int steps : counts) {
      race.add(
          name, false, "dt", Real(kDuration) / steps,
          [=] { return kickedRotor(body, start, 0, duration / steps, steps, method, weight).q_WB; },
          error);
    }
  };
  split("kicked, Blanes and Moan 4 (carom)", kBlanesMoan4, {8, 16, 32, 64, 256, 1024});
  split("kicked, Blanes and Moan 6 (carom)", kBlanesMoan6, {4, 8, 16, 32, 64, 128, 256});
  for (const int steps : {2, 4, 6, 9, 13, 18, 25}) {
    race.add(
        "extrapolated kicks, order 12 (carom)", false, "dt", Real(kDuration) / steps,
        [=] { return extrapolatedRotor(body, start, 0, duration / steps, steps, 6, weight).q_WB; },
        error);
  }
  for (const int steps : {64, 256, 1024, 4096}) {
    race.add(
        "RK4 on the quaternion", false, "dt", Real(kDuration) / steps,
        [=] {
          RotorState s = start;
          const Real dt = duration / steps;
          for (int i = 0; i < steps; ++i) s = rk4Rotor(kTop, s, i * dt, dt, weight);
          return s.q_WB;
        },
        error);
  }
#ifdef CAROM_BENCH_ODEINT
  using Seven = OdeintState<7>;
  const auto flow = [](const Seven& y, Seven& d, double) {
    const double wx = y[4], wy = y[5], wz = y[6];
    d[0] = (-y[1] * wx - y[2] * wy - y[3] * wz) / 2;
    d[1] = (y[0] * wx + y[2] * wz - y[3] * wy) / 2;
    d[2] = (y[0] * wy + y[3] * wx - y[1] * wz) / 2;
    d[3] = (y[0] * wz + y[1] * wy - y[2] * wx) / 2;
    const Vector3 torque = weightOf({y[0], y[1], y[2], y[3]});
    d[4] = (torque.x() - (kTop.z() - kTop.y()) * wy * wz) / kTop.x();
    d[5] = (torque.y() - (kTop.x() - kTop.z()) * wz * wx) / kTop.y();
    d[6] = torque.z() / kTop.z();
  };
  const Seven at = {start.q_WB.w, start.q_WB.x, 0, 0, 0, 0, 40};
  const auto attitude = [](const Seven& y) { return Quaternion{y[0], y[1], y[2], y[3]}; };
  for (const int steps : {64, 256, 1024, 4096}) {
    race.add(
        "odeint RK4", true, "dt", Real(kDuration) / steps,
        [=] { return attitude(odeintRk4<7>(flow, at, duration, steps)); }, error);
  }
  const std::vector<std::pair<const char*, OdeintMethod>> methods = {
      {"odeint dopri5", OdeintMethod::dopri5},
      {"odeint fehlberg78", OdeintMethod::fehlberg78},
      {"odeint bulirsch_stoer", OdeintMethod::bulirschStoer}};
  for (const auto& [name, method] : methods) {
    for (const Real tolerance : {1e-5, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15}) {
      race.add(
          name, true, "tolerance", tolerance,
          [=, method = method] {
            return attitude(odeintAdaptive<7>(method, flow, at, duration, tolerance));
          },
          error);
    }
  }
#endif
  return race;
}

// N10, and the energy over a million nutations of N11.
void topsForLong(Figures& figures) {
  const SplitRotor body(kTop);
  const Torque weight = [](Real, const RotorState& s) { return weightOf(s.q_WB); };

  const SineCosine half = sineCosine(std::numbers::pi / 12);
  RotorState s = {{half.cosine, half.sine, 0, 0}, Vector3::Zero()};
  const Real slow = caseNumber("N10", "slow");
  const Vector3 up = rotatePoint(conjugate(s.q_WB), {0, 0, 1});
  s.angularVelocity = slow * Vector3(up.x(), up.y(), 0) + Vector3(0, 0, 60);
  const Vector3 first = rotatePoint(s.q_WB, {0, 0, 1});
  Real worst = 0;
  constexpr int kRate = 100;
  for (int i = 0; i < 100 * kRate; ++i) {
    s = kickedRotor(body, s, Real(i) / kRate, 1.0 / kRate, 1, kBlanesMoan6, weight);
    worst = std::max(worst, std::abs(endOf(s.q_WB, first).tilt - std::numbers::pi / 6));
  }
  const Real off =
      std::remainder(endOf(s.q_WB, first).turned - slow * 100, 2 * std::numbers::pi) / 100;

  s = releasedTop();
  const Real before = topEnergy(s);
  const Real dt = caseNumber("N11", "nutation_period") / 8;
  Real early = 0, late = 0;
  constexpr int kNutations = 1000000;
  for (int i = 0; i < kNutations; ++i) {
    s = kickedRotor(body, s, 0, dt, 8, kBlanesMoan6, weight);
    Real& most = i < kNutations / 10 ? early : late;
    if (i < kNutations / 10 || i >= kNutations / 10 * 9) {
      most = std::max(most, std::abs(topEnergy(s) / before - 1));
    }
  }
  // No drift is what rounding alone does: one for each turn and kick, of either sign.
  const Real walk = 1.1e-16 * std::sqrt(Real(kNutations) * 8 * 29);
  std::cout << "\nN10, 100 s of steady precession at " << kRate << " steps a second: tilt off by "
            << worst << " rad, precession by " << off << " rad/s\n"
            << "N11, 1e6 nutations in 8 steps each: energy error in the first tenth " << early
            << ", in the last " << late << '\n';
  figures.targets.push_back({{"diagram", "W3"},
                             {"what", "N10, tilt and rate of precession over 100 s"},
                             {"reached", std::max(worst, std::abs(off))},
                             {"target", 1e-10},
                             {"met", std::max(worst, std::abs(off)) <= 1e-10}});
  figures.targets.push_back({{"diagram", "W3"},
                             {"what", "N11, energy over 1e6 nutations"},
                             {"first_tenth", early},
                             {"last_tenth", late},
                             {"walk_of_rounding", walk},
                             {"met", late < std::max(1.1 * early, 3 * walk)}});
}

}  // namespace

void freeRotors(const Options& options, Figures& figures) {
  for (const Scene& scene : scenes()) {
    Race race = raceOf(scene);
    race.time(options);
    race.print({1e-3, 1e-6, 1e-9, 1e-12});
    race.write(figures.rows);
    if (scene.duration == 10) {
      judge(figures, "W2", race, scene.name, 1e-6, 20, 0);
      judge(figures, "W2", race, scene.name, 1e-12, 70, 0);
    } else {
      judge(figures, "scene F", race, scene.name, 1e-6, 0, 0);
      sceneF(scene, figures);
    }
    if (!options.plots.empty() && scene.file[0] != 0) {
      race.draw(options.plots / scene.file, scene.title,
                "One curve per method, one mark per step or tolerance, grey for other libraries. "
                "The exact answer is one mark at rounding, far left of all that step; engines "
                "never come below a hundredth of a radian.",
                1e-6, 1e-16);
    }
  }
}

void heavyTops(const Options& options, Figures& figures) {
  Race race = topRace();
  race.time(options);
  race.print({1e-3, 1e-6, 1e-9, 1e-12});
  race.write(figures.rows);
  judge(figures, "W3", race, "N11", 1e-6, 0, 3);
  judge(figures, "W3", race, "N11", 1e-12, 0, 3);
  topsForLong(figures);
  if (!options.plots.empty()) {
    race.draw(options.plots / "heavy_top.svg",
              "A top that is let go and nods: error of its axis after 2 s",
              "One curve per method, one mark per step or tolerance, grey for Boost.odeint. Kicks "
              "between exact turns fall as their order says; those of Blanes and Moan lie lowest.",
              1e-9, 1e-16);
  }
}

}  // namespace carom::bench
