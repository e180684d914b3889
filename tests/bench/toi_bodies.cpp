#include "bench/toi_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "bench/toi_peers.hpp"
#include "carom/core/random.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/toi/first_contact.hpp"
#include "carom/toi/sub_steps.hpp"
#include "carom/toi/toi_rotating.hpp"
#include "carom_io/table.hpp"

namespace carom::bench {
namespace {

struct Family {
  std::string name;
  Real distance;  // of the centres at the start
  Real speed;     // in the second that is searched
  Real turn;      // of each body in that second, at most [rad]
};

// Bullet turns no body by more than a quarter of pi in a step, so one family stays below that.
const std::array<Family, 4> kFamilies = {{{"not turning", 4, 4, 0},
                                          {"turning", 4, 4, 0.7},
                                          {"turning fast", 4, 4, 3},
                                          {"turning in place", 2.1, 0.5, 3}}};

// Two hulls of 32 corners.
struct Scene {
  std::vector<Vector3> cornersA, cornersB;
  Shape a, b;
  Sweep A, B;
  Quaternion startA, startB;
};

std::vector<Vector3> corners(Random& random, const Vector3& halfAxes) {
  std::vector<Vector3> points;
  for (int i = 0; i < 32; ++i) points.push_back(halfAxes.cwiseProduct(random.direction()));
  return points;
}

Scene anyScene(Random& random, const Family& family) {
  Scene s;
  s.cornersA = corners(random, {1, 0.8, 0.6});
  s.cornersB = corners(random, {1, 0.9, 0.5});
  s.a = hullOfPoints(s.cornersA);
  s.b = hullOfPoints(s.cornersB);
  const Vector3 to = family.distance * random.direction();
  const auto place = [&](Sweep& sweep, Quaternion& q, const Vector3& at) {
    const Vector3 axis = random.direction();
    q = integrateOrientation({1, 0, 0, 0}, axis, random.between(-3, 3));
    sweep.start = poseOf(q, at);
    const Real rate = family.turn * random.between(0, 1);
    sweep.angularVelocity = rate * random.direction();
  };
  place(s.A, s.startA, Vector3::Zero());
  place(s.B, s.startB, to);
  s.B.velocity = family.speed * (0.4 * random.direction() - to.normalized());
  return s;
}

struct Answer {
  bool met = false;
  Real time = 0;
};

struct Method {
  std::string name;
  bool peer = false;
  std::function<Answer(const Scene&)> search;
};

Answer answerOf(const TimeOfImpact& t) {
  return {t.status != ImpactStatus::kNoHit, t.time};
}

#ifdef CAROM_BENCH_BULLET
Answer inBullet(const Scene& s) {
  const auto posesOf = [](const Sweep& sweep, const Quaternion& q) {
    PeerSweep peer;
    const Quaternion end = integrateOrientation(q, sweep.angularVelocity, 1);
    const Vector3 there = sweep.start.p_WB + sweep.velocity;
    peer.start = {
        sweep.start.p_WB.x(), sweep.start.p_WB.y(), sweep.start.p_WB.z(), q.w, q.x, q.y, q.z};
    peer.end = {there.x(), there.y(), there.z(), end.w, end.x, end.y, end.z};
    return peer;
  };
  const PeerImpact found = hullsInBullet(
      s.cornersA.front().data(), static_cast<int>(s.cornersA.size()), posesOf(s.A, s.startA),
      s.cornersB.front().data(), static_cast<int>(s.cornersB.size()), posesOf(s.B, s.startB));
  return {found.hit, found.time};
}
#endif

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const Real tolerance : {0.0, 1e-9, 1e-6, 1e-3}) {
    all.push_back({"second order", false, [tolerance](const Scene& s) {
                     return answerOf(firstContact(s.a, s.A, s.b, s.B, 1, {.tolerance = tolerance}));
                   }});
  }
  for (const Real tolerance : {1e-9, 1e-6, 1e-3}) {
    all.push_back({"fastest corner", false, [tolerance](const Scene& s) {
                     return answerOf(toiRotating(s.cornersA, s.A, s.cornersB, s.B, 1, tolerance));
                   }});
  }
  for (const int parts : {256, 32, 4}) {
    all.push_back({"sub-steps", false, [parts](const Scene& s) {
                     return answerOf(contactBySubSteps(s.a, s.A, s.b, s.B, 1, parts, 1e-9));
                   }});
  }
#ifdef CAROM_BENCH_BULLET
  all.push_back({"Bullet", true, inBullet});
#endif
  return all;
}

struct Result {
  std::string family, name;
  bool peer = false;
  Real microseconds = 0;  // a query
  Real median = 0;        // error of the time of those that meet, in motions
  Real worst = 0;         // the same
  int missed = 0, invented = 0;
};

}  // namespace

Json raceBodies(const Options& options) {
  constexpr int kPairs = 300;
  std::vector<Result> results;
  io::Table table;
  table.column("pairs").column("method").column("us", io::significant(3));
  table.column("median error", io::scientific(1)).column("worst", io::scientific(1));
  table.column("missed").column("invented");
  Json rows = Json::array();
  for (const Family& family : kFamilies) {
    Random random(5);
    std::vector<Scene> scenes;
    std::vector<Answer> truth;  // by the plain way, to a picometre
    int meet = 0;
    while (scenes.size() < kPairs) {
      Scene s = anyScene(random, family);
      const TimeOfImpact plain = toiRotating(s.cornersA, s.A, s.cornersB, s.B, 1, 1e-12, 1000000);
      if (plain.status == ImpactStatus::kOverlapping) continue;
      truth.push_back(answerOf(plain));
      meet += truth.back().met;
      scenes.push_back(std::move(s));
    }
    std::vector<Case> cases;
    const std::vector<Method> all = methods();
    for (const Method& method : all) {
      cases.push_back({method.name, scenes.size(), [&scenes, &method] {
                         for (const Scene& s : scenes) keep(method.search(s));
                       }});
    }
    const std::vector<Timing> timings = measure(cases, options);
    for (std::size_t m = 0; m < all.size(); ++m) {
      Result r;
      r.family = family.name, r.name = all[m].name, r.peer = all[m].peer;
      r.microseconds = timings[m].median / 1000;
      std::vector<Real> errors;
      for (std::size_t i = 0; i < scenes.size(); ++i) {
        const Answer found = all[m].search(scenes[i]);
        if (truth[i].met && !found.met) ++r.missed;
        if (!truth[i].met && found.met) ++r.invented;
        if (truth[i].met && found.met) errors.push_back(std::abs(found.time - truth[i].time));
      }
      std::sort(errors.begin(), errors.end());
      if (!errors.empty()) r.median = errors[errors.size() / 2], r.worst = errors.back();
      table.row({r.family, r.name, r.microseconds, r.median, r.worst, r.missed, r.invented});
      rows.push_back({{"suite", "toi"},
                      {"scene", r.family},
                      {"method", r.name},
                      {"peer", r.peer},
                      {"microseconds", r.microseconds},
                      {"medianError", r.median},
                      {"worstError", r.worst},
                      {"missed", r.missed},
                      {"invented", r.invented},
                      {"pairs", kPairs},
                      {"meet", meet}});
      results.push_back(std::move(r));
    }
  }
  std::cout << "solids: 32 corners each, error of the time as a share of the motion\n\n"
            << table << '\n';

  if (!options.plots.empty()) {
    io::Plot plot("First contact of two hulls of 32 corners that turn");
    plot.describe("Median error of the time over the time of a query, one curve for each method.");
    plot.xAxis("time of a query [us]", io::Scale::Logarithmic);
    plot.yAxis("median error of the time", io::Scale::Logarithmic).yRange(1e-17, 1);
    std::size_t color = 0;
    Real least = 1e9;
    for (const char* name : {"second order", "fastest corner", "sub-steps", "Bullet"}) {
      std::vector<Real> x, y;
      bool peer = false;
      for (const Result& r : results) {
        if (r.family != "turning" || r.name != name) continue;
        x.push_back(r.microseconds);
        y.push_back(std::max(r.median, 1e-16));
        least = std::min(least, r.microseconds);
        peer = r.peer;
      }
      if (x.empty()) continue;
      io::CurveStyle style = styleOf(color++, peer);
      style.marks = true;
      plot.curve(name, x, y, style);
    }
    sign(plot, least, 1e-15, 0.2);
    const auto file = options.plots / "first_contact.svg";
    plot.writeSvg(file);
    std::cout << "wrote " << file.string() << '\n';
  }
  return rows;
}

}  // namespace carom::bench
