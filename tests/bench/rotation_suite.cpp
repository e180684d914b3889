// The suite `rotation`: following a body that turns, processor time against error.
//
// The body cones: its axis moves round a cone, and its angular velocity, seen in its own axes,
// turns with it (cases R8b and, for a constant angular velocity, R8). Where it faces after ten
// seconds is known in closed form.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "bench/bench.hpp"
#include "bench/turning_methods.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#ifdef CAROM_BENCH_ODEINT
#include "bench/peer_odeint.hpp"
#endif

using carom::Quaternion;
using carom::Real;
using carom::Vector3;
using carom::bench::Case;
using carom::bench::Json;
using carom::bench::keep;
using carom::bench::Options;
using carom::bench::Timing;

namespace {

constexpr Real kHalfAngle = 0.1;  // of the cone [rad]
constexpr Real kTurn = 20;        // of the axis round the cone [rad/s]
constexpr Real kDuration = 10;    // [s]
constexpr Real kAccepted = 1e-6;  // the error at which methods are compared [rad]

// How often the angular velocity was asked for.
struct Counter {
  mutable std::size_t calls = 0;
};

struct Coning {
  const Counter* counter = nullptr;
  Real sineOfCone = std::sin(kHalfAngle);
  Real sineOfHalf = std::sin(kHalfAngle / 2);

  Vector3 operator()(Real t) const {
    if (counter) ++counter->calls;
    const Real w = kTurn * sineOfCone;
    return {-w * std::sin(kTurn * t), w * std::cos(kTurn * t),
            -2 * kTurn * sineOfHalf * sineOfHalf};
  }
  Quaternion orientation(Real t) const {
    return {std::cos(kHalfAngle / 2), sineOfHalf * std::cos(kTurn * t),
            sineOfHalf * std::sin(kTurn * t), 0};
  }
};

struct Constant {
  Vector3 operator()(Real) const {
    return {3, -4, 12};
  }
  Quaternion orientation(Real t) const {
    return carom::quaternionExponential(t * (*this)(0));
  }
};

template <class Motion>
using Step = Quaternion (*)(const Motion&, const Quaternion&, Real, Real);

template <class Motion>
struct Method {
  const char* name;
  Step<Motion> step;
};

template <class Motion>
std::vector<Method<Motion>> methods() {
  namespace bench = carom::bench;
  return {{"sum", bench::eulerStep<Motion>},
          {"sum, normalised", bench::eulerNormalisedStep<Motion>},
          {"turn, rate at the start", bench::startStep<Motion>},
          {"turn, rate in the middle", bench::middleStep<Motion>},
          {"turn, middle, in float", bench::floatMiddleStep<Motion>},
          {"Runge-Kutta 4", bench::rungeKutta4Step<Motion>},
          {"turn, Magnus 4", bench::magnus4Step<Motion>},
          {"turn, commutator-free 4", bench::commutatorFree4Step<Motion>},
          {"turn, Magnus 6 (carom)", bench::magnus6Step<Motion>}};
}

template <class Motion>
Quaternion follow(const Motion& motion, Step<Motion> step, int steps) {
  const Real h = kDuration / steps;
  Quaternion q = motion.orientation(0);
  for (int i = 0; i < steps; ++i) q = step(motion, q, i * h, h);
  return q;
}

// Angle between two orientations [rad]; the sum's result is not of length one.
template <class Motion>
Real errorOf(const Motion& motion, const Quaternion& end) {
  return carom::quaternionLogarithm(
             carom::hamiltonProduct(carom::conjugate(motion.orientation(kDuration)), end))
      .norm();
}

struct Point {
  Real setting = 0;      // step [s] or tolerance
  Real evaluations = 0;  // of the angular velocity, per simulated second
  Real error = 0;        // [rad]
  Timing time;           // per simulated second [ns]
};

struct Curve {
  std::string name;
  bool peer = false;
  std::vector<Point> points;
};

// Time and error of every method with every step.
std::vector<Curve> race(const Options& options) {
  const Coning motion;
  std::vector<Curve> curves;
  std::vector<Case> cases;
  const auto enter = [&](Curve& curve, Real setting, auto run) {
    const Counter counter;
    Coning counted;
    counted.counter = &counter;
    const Quaternion end = run(counted);
    curve.points.push_back(
        {setting, static_cast<Real>(counter.calls) / kDuration, errorOf(motion, end), Timing{}});
    // Time per simulated second: ten of them in one call.
    cases.push_back(
        {curve.name, static_cast<std::size_t>(kDuration), [motion, run] { keep(run(motion)); }});
  };
  for (const auto& method : methods<Coning>()) {
    Curve curve{method.name, false, {}};
    // From steps that are too long to such as show where rounding takes over.
    const bool rough = curve.name.starts_with("sum") || curve.name.ends_with("start");
    const bool slow = rough || curve.name.find("middle") != std::string::npos;
    for (int steps = rough ? 1024 : 64; steps <= (slow ? 1 << 20 : 1 << 16); steps *= 4) {
      enter(curve, kDuration / steps,
            [step = method.step, steps](const Coning& m) { return follow(m, step, steps); });
    }
    curves.push_back(curve);
  }
#ifdef CAROM_BENCH_ODEINT
  Curve curve{"odeint, Fehlberg 7(8)", true, {}};
  for (const Real tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
    enter(curve, tolerance, [tolerance](const Coning& m) {
      return carom::bench::fehlberg78(m, m.orientation(0), kDuration, tolerance);
    });
  }
  curves.push_back(curve);
#endif
  const std::vector<Timing> timings = carom::bench::measure(cases, options);
  std::size_t next = 0;
  for (Curve& c : curves) {
    for (Point& point : c.points) point.time = timings[next++];
  }
  return curves;
}

// What a method needs for the accepted error, between its points; 0 if it never gets there.
Real needed(const Curve& curve, const std::function<Real(const Point&)>& cost) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const Point &a = curve.points[i - 1], &b = curve.points[i];
    if (!(a.error > kAccepted && b.error <= kAccepted)) continue;
    const Real part = std::log(a.error / kAccepted) / std::log(a.error / b.error);
    return cost(a) * std::pow(cost(b) / cost(a), part);
  }
  return 0;
}

// W1: time against error.
void draw(const std::vector<Curve>& curves, const std::filesystem::path& file) {
  carom::io::Plot plot("A body that cones: time against error after ten seconds");
  plot.describe(
      "One curve per method, one mark per step. The methods of a higher order fall "
      "steeper; that of order six reaches rounding first.");
  plot.size(980, 560).xAxis("time per simulated second [us]", carom::io::Scale::Logarithmic);
  plot.yAxis("error [rad]", carom::io::Scale::Logarithmic).yRange(1e-20, 10);
  std::size_t i = 0;
  Real left = 1e300, right = 0;
  for (const Curve& curve : curves) {
    std::vector<Real> x, y;
    for (const Point& point : curve.points) {
      x.push_back(point.time.median / 1000);
      y.push_back(std::clamp(point.error, 1e-17, 10.0));
      left = std::min(left, x.back()), right = std::max(right, x.back());
    }
    plot.curve(curve.name, x, y, carom::bench::styleOf(i++, curve.peer));
  }
  const Real edge = std::pow(10, std::floor(std::log10(left)));
  plot.xRange(edge, std::pow(10, std::ceil(std::log10(right))));
  plot.curve("accepted: 1e-6 rad", {left, right}, {kAccepted, kAccepted},
             {.dashed = true, .width = 1, .color = carom::io::Color{90, 90, 90}});
  carom::bench::sign(plot, edge * 1.3, 1e-17, 0.1);
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
}

// Errors of a constant angular velocity, for steps from a millisecond to ten seconds.
Json constantRate() {
  const Constant motion;
  const std::vector<int> counts = {1, 10, 100, 1000, 10000};
  carom::io::Table table;
  table.column("method");
  for (const int steps : counts) {
    table.column(std::to_string(steps) + (steps == 1 ? " step" : " steps"),
                 carom::io::scientific(1));
  }
  Json rows = Json::array();
  for (const auto& method : methods<Constant>()) {
    std::vector<carom::io::Cell> cells = {method.name};
    for (const int steps : counts) {
      const Real error = errorOf(motion, follow(motion, method.step, steps));
      cells.emplace_back(error);
      rows.push_back({{"suite", "rotation"},
                      {"scene", "R8, constant angular velocity"},
                      {"engine", method.name},
                      {"dt", kDuration / steps},
                      {"error", {{"angle", error}}}});
    }
    table.row(cells);
  }
  std::cout << "\nConstant angular velocity of 13 rad/s, error after 10 s [rad]\n\n" << table;
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = carom::bench::readOptions(argc, argv);
  Json figures{{"suite", "rotation"}, {"circumstances", carom::bench::circumstances(options)}};
#ifdef CAROM_BENCH_ODEINT
  figures["circumstances"]["boost"] = BOOST_LIB_VERSION;
#else
  std::cout << "Boost.odeint is left out: install libboost-dev\n";
#endif
  std::cout << carom::bench::circumstancesInALine() << '\n';
  Json rows = constantRate();

  const std::vector<Curve> curves = race(options);
  carom::io::Table table;
  table.column("method").column("step or tolerance", carom::io::scientific(1));
  table.column("rates per s", carom::io::significant(4));
  table.column("us per s", carom::io::significant(3))
      .column("error [rad]", carom::io::scientific(1));
  carom::io::Table summary;
  summary.column("method").column("rates per s", carom::io::fixed(0));
  summary.column("us per s", carom::io::fixed(2)).column("over Magnus 6", carom::io::fixed(1));
  const auto rates = [](const Point& p) { return p.evaluations; };
  const auto time = [](const Point& p) { return p.time.median / 1000; };
  Real best = 0;
  for (const Curve& curve : curves) {
    if (curve.name == "turn, Magnus 6 (carom)") best = needed(curve, rates);
  }
  Json ratios = Json::object();
  for (const Curve& curve : curves) {
    for (const Point& p : curve.points) {
      table.row({curve.name, p.setting, p.evaluations, time(p), p.error});
      rows.push_back({{"suite", "rotation"},
                      {"scene", "R8b, coning"},
                      {"engine", curve.name},
                      {"version", CAROM_VERSION},
                      {curve.peer ? "tolerance" : "dt", p.setting},
                      {"threads", 1},
                      {"sim_s", kDuration},
                      {"cpu_s", p.time.median * 1e-9 * kDuration},
                      {"least", p.time.least * 1e-9 * kDuration},
                      {"most", p.time.most * 1e-9 * kDuration},
                      {"counters", {{"rates", p.evaluations * kDuration}}},
                      {"error", {{"angle", p.error}}}});
    }
    const Real r = needed(curve, rates);
    if (r == 0) continue;
    summary.row({curve.name, r, needed(curve, time), r / best});
    ratios[curve.name] = {
        {"rates_per_s", r}, {"us_per_s", needed(curve, time)}, {"rates_over_magnus_6", r / best}};
  }
  std::cout << "\nConing\n\n" << table << "\nFor an error of 1e-6 rad\n\n" << summary;
  figures["rows"] = rows;
  figures["at_1e-6_rad"] = ratios;
  carom::bench::writeJson(options, figures);
  if (!options.plots.empty()) {
    std::filesystem::create_directories(options.plots);
    draw(curves, options.plots / "rotation_time_error.svg");
  }
}
