// The suite `impulse`: how many impulses a second, and how right friction is for its time.
//
// First the functions of the layer on a thousand random pairs of bodies, in cache. Then, as a
// diagram of error against time, six ways to do friction on three motions whose end is known in
// closed form: a block that stops (case I6), a ball that begins to roll (I7), a massé shot (I15).
// Beside them, where they are installed, Bullet and ODE.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>

#include "bench/bench.hpp"
#include "bench/friction_methods.hpp"
#include "bench/friction_peers.hpp"
#include "carom/core/cross.hpp"
#include "carom/core/random.hpp"
#include "carom/impulse/impulse_2d.hpp"
#include "carom/impulse/impulse_3d.hpp"
#include "carom/impulse/linear_complementarity.hpp"
#include "carom/impulse/passive_impact.hpp"
#include "carom/impulse/simultaneous_impacts.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::BodyContact;
using carom::Contact;
using carom::MovingBody;
using carom::Real;
using carom::Vector2;
using carom::Vector3;
using carom::bench::Case;
using carom::bench::FrictionMethod;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::TableScene;
using carom::bench::Timing;

namespace {

constexpr std::size_t kPairs = 1024;
constexpr Real kAccepted = 1e-9;  // the error at which methods are compared [m]

// --- Impulses of many pairs

struct Pair {
  MovingBody a, b;
  Contact contact;
  carom::PlanarBody flatA, flatB;
  carom::PlanarContact flat;
};

MovingBody randomBody(carom::Random& random) {
  MovingBody body;
  body.mass.inverseMass = random.between(0.5, 2);
  carom::Matrix3 half;
  for (int i = 0; i < 3; ++i) half.col(i) = random.vector();
  body.mass.inverseInertia = half * half.transpose() + carom::Matrix3::Identity();
  body.velocity = {random.vector(), random.vector()};
  return body;
}

// Pairs that approach, so that every impulse is one.
std::vector<Pair> randomPairs() {
  carom::Random random(1);
  std::vector<Pair> pairs;
  while (pairs.size() < kPairs) {
    Pair p{randomBody(random),
           randomBody(random),
           {random.direction(), random.vector(), random.vector()},
           {},
           {},
           {}};
    if (relativeVelocity(p.a, p.b, p.contact).dot(p.contact.normal) >= 0) continue;
    const auto flatten = [](const MovingBody& body) {
      const Vector3& v = body.velocity.linear;
      return carom::PlanarBody{{body.mass.inverseMass, body.mass.inverseInertia(2, 2)},
                               {{v.x(), v.y()}, body.velocity.angular.z()}};
    };
    p.flatA = flatten(p.a), p.flatB = flatten(p.b);
    p.flat = {p.contact.normal.head<2>().normalized(), p.contact.armA.head<2>(),
              p.contact.armB.head<2>()};
    pairs.push_back(p);
  }
  return pairs;
}

// Calls f for each pair; the sum keeps it from being removed.
template <class F>
Case onPairs(const char* name, const std::vector<Pair>& pairs, F f) {
  return {name, pairs.size(), [&pairs, f] {
            Real sum = 0;
            for (const Pair& p : pairs) sum += f(p);
            keep(sum);
          }};
}

// A positive definite problem of n contacts.
Case complementarityCase(int n) {
  carom::Random random(static_cast<std::uint64_t>(n));
  carom::DenseMatrix half(n + 2, n), M(n, n);
  std::vector<Real> q;
  for (int i = 0; i < n + 2; ++i) {
    for (int j = 0; j < n; ++j) half(i, j) = random.between(-1, 1);
  }
  for (int i = 0; i < n; ++i) {
    q.push_back(random.between(-1, 0.3));
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n + 2; ++k) M(i, j) += half(k, i) * half(k, j);
    }
  }
  return {"pivoting, " + std::to_string(n) + " contacts", 1,
          [M, q] { keep(carom::solveComplementarity(M, q).z[0]); }};
}

// Touching balls in a row, the first of which comes in.
Case cradleCase(int n) {
  std::vector<MovingBody> balls(static_cast<std::size_t>(n));
  std::vector<BodyContact> contacts;
  for (int i = 0; i < n; ++i) {
    MovingBody& ball = balls[static_cast<std::size_t>(i)];
    ball.mass = {1, 2.5 * carom::Matrix3::Identity()};
    ball.velocity.linear = {i == 0 ? 1.0 : 0.0, 0, 0};
    if (i == 0) continue;
    contacts.push_back({i - 1, i, {{1, 0, 0}, {1, 0, 0}, {-1, 0, 0}}, {.restitution = 1}});
  }
  return {"cradle of " + std::to_string(n) + " balls", 1, [balls, contacts] {
            std::vector<MovingBody> moved = balls;
            keep(carom::simultaneousImpacts(moved, contacts).rounds);
            keep(moved.back().velocity.linear.x());
          }};
}

Json timeOfImpulses(const Options& options) {
  const std::vector<Pair> pairs = randomPairs();
  const carom::ImpactLaw law{.restitution = 0.5, .friction = 0.4};
  std::vector<Case> cases;
  cases.push_back(onPairs("impulse2d", pairs, [](const Pair& p) {
    return carom::impulse2d(p.flatA, p.flatB, p.flat, 0.5);
  }));
  cases.push_back(onPairs("impulse3d", pairs, [](const Pair& p) {
    return carom::impulse3d(p.a, p.b, p.contact, 0.5);
  }));
  cases.push_back(onPairs("impulse3d, and applied", pairs, [](const Pair& p) {
    MovingBody a = p.a, b = p.b;
    const Real j = carom::impulse3d(a, b, p.contact, 0.5);
    changeVelocities(a, b, p.contact, j * p.contact.normal);
    return a.velocity.linear.x() + b.velocity.angular.y();
  }));
  cases.push_back(onPairs("passiveImpact, and applied", pairs, [law](const Pair& p) {
    MovingBody a = p.a, b = p.b;
    changeVelocities(a, b, p.contact, passiveImpact(a, b, p.contact, law).impulse);
    return a.velocity.linear.x() + b.velocity.angular.y();
  }));
  cases.push_back(onPairs("coulombImpact, and applied", pairs, [law](const Pair& p) {
    MovingBody a = p.a, b = p.b;
    changeVelocities(a, b, p.contact, coulombImpact(a, b, p.contact, law).impulse);
    return a.velocity.linear.x() + b.velocity.angular.y();
  }));
  for (const int n : {4, 8, 12, 16}) cases.push_back(complementarityCase(n));
  for (const int n : {5, 20}) cases.push_back(cradleCase(n));

  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  carom::io::Table table;
  table.column("what").column("ns", carom::io::significant(4));
  table.column("million a second", carom::io::significant(3));
  Json rows = Json::array();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    table.row({cases[i].name, timings[i].median, 1000 / timings[i].median});
    rows.push_back({{"suite", "impulse"},
                    {"scene", "single problems"},
                    {"engine", cases[i].name},
                    {"version", CAROM_VERSION},
                    {"threads", 1},
                    {"ns", timings[i].median},
                    {"least", timings[i].least},
                    {"most", timings[i].most}});
  }
  std::cout << table << '\n';
  return rows;
}

// --- W13: friction, error against time

struct Known {
  TableScene scene;
  Vector2 end;       // where the centre is at the end [m]
  const char* file;  // of the diagram
};

std::vector<Known> knownMotions() {
  const Real g = 9.81;
  MovingBody block, ball;
  block.mass.inverseMass = ball.mass.inverseMass = 1;
  ball.mass.inverseInertia = 2.5 * carom::Matrix3::Identity();
  block.velocity.linear = {4, 0, 0};
  MovingBody masse = ball;
  ball.velocity.linear = {7, 0, 0};
  masse.velocity = {{2, 0, 0}, {-30, 10, 0}};

  // Closed forms: v0^2/(2 mu g); 12 v0^2/(49 mu g), then 5/7 v0; a parabola, then v0 - 2/7 u0.
  const Real rolls = 2 * 7 / (7 * 0.2 * g);
  const Vector2 slip(-8, -30), v0(2, 0), v1 = v0 - 2 * slip / 7;
  const Real turns = 2 * slip.norm() / (7 * 0.2 * g);
  return {{{"a block stops", block, true, 0.3, g, 2}, {16 / (2 * 0.3 * g), 0}, "friction_block"},
          {{"a ball begins to roll", ball, false, 0.2, g, 2},
           {12 * 49 / (49 * 0.2 * g) + 5 * (2 - rolls), 0},
           "friction_ball"},
          {{"a massé shot", masse, false, 0.2, g, 5},
           turns * (v0 + v1) / 2 + (5 - turns) * v1,
           "friction_masse"}};
}

struct Point {
  Real step = 0;   // [s]
  Real error = 0;  // [m]
  Timing time;     // per simulated second [ns]
};

struct Curve {
  std::string name;
  bool peer = false;
  std::vector<Point> points;
};

// A way to get from the start of a scene to its end in equal steps.
struct Method {
  const char* name;
  std::function<Vector2(const TableScene&, int steps)> run;
  bool peer = false;
};

#if defined(CAROM_BENCH_BULLET) || defined(CAROM_BENCH_ODE)
using PeerSlide = carom::bench::PeerPlace (*)(const carom::bench::PeerScene&, int);

Method peer(const char* name, PeerSlide slide) {
  const auto run = [slide](const TableScene& scene, int steps) {
    const carom::Velocity& v = scene.start.velocity;
    const auto end = slide({{v.linear.x(), v.linear.y(), v.linear.z()},
                            {v.angular.x(), v.angular.y(), v.angular.z()},
                            !scene.block,
                            scene.friction,
                            scene.gravity,
                            scene.duration},
                           steps);
    return Vector2(end.x, end.y);
  };
  return {name, run, true};
}
#endif

std::vector<Method> allMethods() {
  std::vector<Method> methods;
  const std::vector<std::pair<FrictionMethod, const char*>> ours = {
      {FrictionMethod::source, "source, factor 1 + c"},
      {FrictionMethod::pyramid, "pyramid in the cone"},
      {FrictionMethod::box, "box around the cone"},
      {FrictionMethod::cone, "projected on the cone"},
      {FrictionMethod::exact, "exact stick or slip"},
      {FrictionMethod::located, "event located (carom)"}};
  for (const auto& [method, name] : ours) {
    methods.push_back({name, [method = method](const TableScene& scene, int steps) {
                         return carom::bench::slideOverTable(scene, method, steps);
                       }});
  }
#ifdef CAROM_BENCH_BULLET
  methods.push_back(peer("Bullet", carom::bench::slideInBullet));
#endif
#ifdef CAROM_BENCH_ODE
  methods.push_back(peer("ODE", carom::bench::slideInOde));
#endif
  return methods;
}

// Rates of steps; none of them ends a step exactly when sliding ends.
const std::vector<int> kRates = {15, 30, 60, 120, 240, 480, 960, 1920, 3840};

std::vector<Curve> race(const Known& known, const Options& options) {
  std::vector<Curve> curves;
  std::vector<Case> cases;
  for (const Method& method : allMethods()) {
    Curve curve{method.name, method.peer, {}};
    for (const int rate : kRates) {
      const TableScene& scene = known.scene;
      const int steps = static_cast<int>(std::lround(scene.duration * rate));
      const auto run = [scene, slide = method.run, steps] { return slide(scene, steps); };
      curve.points.push_back({scene.duration / steps, (run() - known.end).norm(), {}});
      cases.push_back(
          {method.name, static_cast<std::size_t>(scene.duration), [run] { keep(run().x()); }});
    }
    curves.push_back(curve);
  }
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  std::size_t next = 0;
  for (Curve& curve : curves) {
    for (Point& point : curve.points) point.time = timings[next++];
  }
  return curves;
}

void draw(const Known& known, const std::vector<Curve>& curves, const Options& options) {
  carom::io::Plot plot(std::string("Friction: ") + known.scene.name);
  plot.describe(
      "One curve per method, one mark per step from 1/15 to 1/3840 s. Methods that step over the "
      "end of sliding are of the first order; the one that locates it is at rounding at once.");
  plot.size(980, 560).xAxis("time per simulated second [us]", carom::io::Scale::Logarithmic);
  plot.yAxis("error of the position [m]", carom::io::Scale::Logarithmic).yRange(1e-20, 100);
  std::size_t i = 0;
  Real left = std::numeric_limits<Real>::infinity(), right = 0;
  for (const Curve& curve : curves) {
    std::vector<Real> x, y;
    for (const Point& point : curve.points) {
      x.push_back(point.time.median / 1000);
      y.push_back(std::clamp(point.error, 1e-17, 100.0));
      left = std::min(left, x.back()), right = std::max(right, x.back());
    }
    plot.curve(curve.name, x, y, carom::bench::styleOf(i++, curve.peer));
  }
  const Real edge = std::pow(10, std::floor(std::log10(left)));
  plot.xRange(edge, std::pow(10, std::ceil(std::log10(right))));
  plot.curve("target: 1e-9 m", {left, right}, {kAccepted, kAccepted},
             {.dashed = true, .width = 1, .color = carom::io::Color{90, 90, 90}});
  carom::bench::sign(plot, edge * 1.3, 1e-17, 0.1);
  const auto file = options.plots / (std::string(known.file) + ".svg");
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "impulse"}, {"circumstances", carom::bench::circumstances(options)}};
  std::cout << carom::bench::circumstancesInALine() << "\n\n";
  Json rows = timeOfImpulses(options);
  if (!options.plots.empty()) std::filesystem::create_directories(options.plots);

  for (const Known& known : knownMotions()) {
    const std::vector<Curve> curves = race(known, options);
    carom::io::Table table;
    table.column("method").column("error at 1/60 s [m]", carom::io::scientific(1));
    table.column("at 1/960 s [m]", carom::io::scientific(1));
    table.column("us per s at 1/60 s", carom::io::significant(3));
    for (const Curve& curve : curves) {
      const Point *sixty = nullptr, *fine = nullptr;
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Point& p = curve.points[i];
        if (kRates[i] == 60) sixty = &p;
        if (kRates[i] == 960) fine = &p;
        rows.push_back({{"suite", "impulse"},
                        {"scene", known.scene.name},
                        {"engine", curve.name},
                        {"version", CAROM_VERSION},
                        {"dt", p.step},
                        {"threads", 1},
                        {"sim_s", known.scene.duration},
                        {"cpu_s", p.time.median * 1e-9 * known.scene.duration},
                        {"least", p.time.least * 1e-9 * known.scene.duration},
                        {"most", p.time.most * 1e-9 * known.scene.duration},
                        {"error", {{"position", p.error}}}});
      }
      table.row({curve.name, sixty->error, fine->error, sixty->time.median / 1000});
    }
    std::cout << known.scene.name << "\n\n" << table << '\n';
    if (!options.plots.empty()) draw(known, curves, options);
  }
  figures["rows"] = rows;
  carom::bench::writeJson(options, figures);
}
