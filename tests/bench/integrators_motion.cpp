// W4: pendulum, air and planets. W5: what many steps do to the energy.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "bench/integrators_methods.hpp"
#include "bench/integrators_sections.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/extrapolation.hpp"
#include "carom/motion/fixed_pair.hpp"
#include "carom/motion/fixed_steps.hpp"
#include "carom/motion/jacobi_elliptic.hpp"
#include "carom/motion/own_clock.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/simulate.hpp"
#include "carom/motion/splitting.hpp"
#include "carom/motion/trajectory.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/motion/yoshida.hpp"
#include "carom_io/table.hpp"
#ifdef CAROM_BENCH_ODEINT
#include "bench/integrators_odeint.hpp"
#endif

namespace carom::bench {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// A vector of n numbers; for one coordinate too, so that all problems are written alike.
template <int n>
using Column = Eigen::Matrix<Real, n, 1>;

// A system of n coordinates: where it begins, what moves it, for how long, and what its end should
// be. All methods use the sine of the C library here: what is compared is the methods.
template <int n, class Force>
struct Problem {
  const char* name;
  const char* unit;
  Column<n> position, velocity;
  int duration;     // [s], for the figures per second
  Real exactly;     // [s], the same or a number that is not whole
  Force force;      // force(t, x, v)
  bool ofPosition;  // alone, and not of the velocity
  std::function<Real(const Column<n>&)> error;
};

template <int n, class P>
void plainMethods(Race& race, const P& p, const std::vector<int>& counts) {
  const Acceleration plain = [p](Real t, const Coordinates& x,
                                 const Coordinates& v) -> Coordinates {
    return p.force(t, Column<n>(x), Column<n>(v));
  };
  const auto each = [&](const char* name, const Step& step) {
    for (const int steps : counts) {
      race.add(
          name, false, "dt", p.exactly / steps,
          [=] {
            const State s{p.position, p.velocity};
            return Column<n>(simulate(step, s, 0, p.exactly / steps, steps, plain).position);
          },
          p.error);
    }
  };
  each("velocityVerlet, plain", velocityVerlet);
  each("rk4, plain", rk4);
  if (p.ofPosition) each("yoshida6, plain", yoshida6);
  for (const Pair pair : {Pair::kOrder5, Pair::kOrder8}) {
    const char* name = pair == Pair::kOrder5 ? "Trajectory, order 5" : "Trajectory, order 8";
    for (const Real tolerance : {1e-4, 1e-7, 1e-10, 1e-13, 1e-15}) {
      race.add(
          name, false, "tolerance", tolerance,
          [=] {
            const State s{p.position, p.velocity};
            const Tolerance asked{tolerance, tolerance, 10000000};
            return Column<n>(Trajectory(s, 0, p.exactly, plain, asked, pair).run().state.position);
          },
          p.error);
    }
  }
}

// Fixed steps without allocation. \param counts of steps for a second-order method
template <int n, class P>
void fixedMethods(Race& race, const P& p, const std::vector<int>& counts) {
  const auto each = [&](const char* name, int fewer, auto step) {
    for (const int count : counts) {
      const int steps = std::max(count / fewer, 1);
      race.add(
          name, false, "dt", p.exactly / steps,
          [=] {
            FixedState<Column<n>> s = {p.position, p.velocity};
            const Real dt = p.exactly / steps;
            for (int i = 0; i < steps; ++i) step(s, i * dt, dt, p.force);
            return s.position;
          },
          p.error);
    }
  };
  using S = FixedState<Column<n>>;
  each("explicit Euler", 1,
       [](S& s, Real t, Real dt, const auto& f) { explicitEulerStep(s, t, dt, f); });
  each("source, listing 7.2", 1,
       [](S& s, Real t, Real dt, const auto& f) { sourceVerletStep(s, t, dt, f); });
  each("source, listing 7.3", 1,
       [](S& s, Real t, Real dt, const auto& f) { sourceVelocityVerletStep(s, t, dt, f); });
  each("semi-implicit Euler", 1,
       [](S& s, Real t, Real dt, const auto& f) { semiImplicitEulerStep(s, t, dt, f); });
  if (!p.ofPosition) {
    each("velocity Verlet", 1,
         [](S& s, Real t, Real dt, const auto& f) { velocityVerletStep(s, t, dt, f); });
  }
  each("RK4", 4, [](S& s, Real t, Real dt, const auto& f) { rk4Step(s, t, dt, f); });
}

// The pairs of Trajectory without what it keeps for the times between.
template <int n, class P>
void fixedPairs(Race& race, const P& p) {
  using Y = Column<2 * n>;
  const auto flow = [p](Real t, const Y& y) __attribute__((always_inline)) {
    const Column<n> x = y.template head<n>(), v = y.template tail<n>();
    const Column<n> a = p.force(t, x, v);
    Y slope;
    for (int i = 0; i < n; ++i) slope[i] = v[i], slope[n + i] = a[i];
    return slope;
  };
  Y first;
  first << p.position, p.velocity;
  const std::vector<Real> tolerances = {1e-4, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15};
  for (const Real tolerance : tolerances) {
    race.add(
        "Dormand and Prince 5, fixed size", false, "tolerance", tolerance,
        [=] {
          const Tolerance asked{tolerance, tolerance, 10000000};
          const auto run = fixedPair<kDormandPrince5, 2 * n>(first, 0, p.exactly, asked, flow);
          return Column<n>(run.y.template head<n>());
        },
        p.error);
  }
  for (const Real tolerance : tolerances) {
    race.add(
        "Dormand and Prince 8, fixed size (carom)", false, "tolerance", tolerance,
        [=] {
          const Tolerance asked{tolerance, tolerance, 10000000};
          const auto run = fixedPair<kDormandPrince8, 2 * n>(first, 0, p.exactly, asked, flow);
          return Column<n>(run.y.template head<n>());
        },
        p.error);
  }
}

// Methods for forces of the position alone. \param looks at the force, per run
template <int n, class P>
void symplecticMethods(Race& race, const P& p, const std::vector<int>& looks) {
  const auto force = [p](Real t, const Column<n>& x) { return p.force(t, x, x); };
  const auto composed = [&](const char* name, std::span<const Real> weights) {
    for (const int count : looks) {
      const int steps = std::max(count / static_cast<int>(weights.size()), 1);
      race.add(
          name, false, "dt", p.exactly / steps,
          [=] {
            Column<n> x = p.position, v = p.velocity;
            const Real dt = p.exactly / steps;
            for (int i = 0; i < steps; ++i) composedStep(x, v, i * dt, dt, weights, force);
            return x;
          },
          p.error);
    }
  };
  composed("velocity Verlet", kVerletWeights);
  composed("Yoshida 4", kYoshida4Weights);
  composed("Yoshida 6", kYoshida6Weights);
  composed("Kahan and Li 8", kKahanLi8Weights);
  const auto split = [&](const char* name, const Splitting& method) {
    const auto stages = static_cast<int>(std::min(method.drifts.size(), method.kicks.size()));
    for (const int count : looks) {
      const int steps = std::max(count / stages, 1);
      race.add(
          name, false, "dt", p.exactly / steps,
          [=] {
            Column<n> x = p.position, v = p.velocity;
            splitSteps(x, v, 0, p.exactly / steps, steps, method, force);
            return x;
          },
          p.error);
    }
  };
  split("Blanes and Moan 4 (carom)", kBlanesMoan4);
  split("Blanes and Moan 6 (carom)", kBlanesMoan6);
  constexpr int kAnswers = 6;  // order 12
  for (const int count : looks) {
    const int steps = std::max(count / (kAnswers * (kAnswers + 1) / 2), 1);
    race.add(
        "extrapolated Verlet, order 12 (carom)", false, "dt", p.exactly / steps,
        [=] {
          Column<n> x = p.position, v = p.velocity;
          extrapolatedSteps(x, v, 0, p.exactly / steps, steps, kAnswers, force);
          return x;
        },
        p.error);
  }
}

#ifdef CAROM_BENCH_ODEINT
template <int n, class P>
void odeintMethods(Race& race, const P& p, const std::vector<int>& counts, bool many = false) {
  constexpr std::size_t m = static_cast<std::size_t>(n);
  const auto flow = [p](const OdeintState<2 * m>& y, OdeintState<2 * m>& d, double t) {
    const Column<n> a = p.force(t, Column<n>(y.data()), Column<n>(y.data() + m));
    for (std::size_t i = 0; i < m; ++i) d[i] = y[m + i], d[m + i] = a[static_cast<int>(i)];
  };
  OdeintState<2 * m> first;
  for (std::size_t i = 0; i < m; ++i) {
    first[i] = p.position[static_cast<int>(i)], first[m + i] = p.velocity[static_cast<int>(i)];
  }
  const auto place = [](const OdeintState<2 * m>& y) { return Column<n>(y.data()); };
  for (const int count : counts) {
    const int steps = std::max(count / 4, 1);
    race.add(
        "odeint RK4", true, "dt", p.exactly / steps,
        [=] { return place(odeintRk4<2 * m>(flow, first, p.exactly, steps)); }, p.error);
  }
  if (p.ofPosition) {
    const auto force = [p](const OdeintState<m>& q, OdeintState<m>& dp) {
      const Column<n> x(q.data());
      const Column<n> a = p.force(0, x, x);
      for (std::size_t i = 0; i < m; ++i) dp[i] = a[static_cast<int>(i)];
    };
    for (const int count : counts) {
      const int steps = std::max(count / 6, 1);
      race.add(
          "odeint symplectic_rkn_sb3a", true, "dt", p.exactly / steps,
          [=] { return place(odeintSymplectic<m>(force, first, p.exactly, steps)); }, p.error);
    }
  }
  const std::vector<std::pair<const char*, OdeintMethod>> methods = {
      {"odeint dopri5", OdeintMethod::dopri5},
      {"odeint fehlberg78", OdeintMethod::fehlberg78},
      {"odeint bulirsch_stoer", OdeintMethod::bulirschStoer}};
  for (const auto& [name, method] : methods) {
    if (method == OdeintMethod::bulirschStoer && !many) continue;
    for (const Real tolerance : {1e-4, 1e-7, 1e-9, 1e-11, 1e-13, 1e-15}) {
      race.add(
          name, true, "tolerance", tolerance,
          [=, method = method] {
            return place(odeintAdaptive<2 * m>(method, flow, first, p.exactly, tolerance));
          },
          p.error);
    }
  }
}
#endif

// Distance from where it should be; infinite if it is nowhere.
Real distance(Real d) {
  return std::isfinite(d) ? std::abs(d) : kInfinity;
}

void finish(Race& race, const Options& options, Figures& figures) {
  race.time(options);
  race.print({1e-3, 1e-6, 1e-9, 1e-12});
  race.write(figures.rows);
}

const char* const kDescription =
    "One curve per method, one mark per step or tolerance, grey for Boost.odeint. The listings of "
    "the source fall with slope one, Verlet with two, the others as steep as their order. The "
    "closed form is one mark at rounding.";

void pendulums(const Options& options, Figures& figures) {
  // Two heights of the case: an everyday swing, and one that nearly stands.
  for (const int row : {1, 2}) {
    const Real top = caseNumber("N6", "rows", row, 0), end = caseNumber("N6", "rows", row, 2);
    const auto force = [](Real, const Column<1>& x, const Column<1>&) {
      return Column<1>(-9.81 * std::sin(x[0]));
    };
    const char* name = row == 1 ? "N6, a pendulum from 1.5 rad" : "N6, a pendulum from 3 rad";
    const Problem<1, decltype(force)> p = {
        name,           "rad", Column<1>(top),
        Column<1>(0.0), 10,    10,
        force,          true,  [end](const Column<1>& x) { return distance(x[0] - end); }};
    Race race(p.name, p.unit, p.duration);
    fixedMethods<1>(race, p, {600, 2400, 9600, 38400});
    symplecticMethods<1>(race, p, {300, 400, 600, 1200, 1800, 2400, 3600, 9600});
    fixedPairs<1>(race, p);
    if (row == 1) plainMethods<1>(race, p, {600, 2400, 9600});
    // Closed form: theta = 2 asin(k sn(K - w t)), the functions prepared beforehand.
    const Real k = std::sin(top / 2), w = std::sqrt(9.81);
    const JacobiElliptic f(std::cos(top / 2), k);
    static volatile Real time;
    time = 10;
    race.add(
        "closed form (carom)", false, "query", 0,
        [=] {
          const Real phase = std::numbers::pi / 2 - w * time * f.mean();
          return Column<1>(2 * std::asin(k * f.at(phase).sn));
        },
        p.error);
#ifdef CAROM_BENCH_ODEINT
    odeintMethods<1>(race, p, {600, 2400, 9600, 38400});
#endif
    finish(race, options, figures);
    judge(figures, "W4", race, p.name, 1e-6, 1e4, 2);
    judge(figures, "W4", race, p.name, 1e-12, 1e4, 1.5);
    if (!options.plots.empty() && row == 1) {
      race.draw(options.plots / "pendulum.svg",
                "A pendulum let go at 1.5 rad: error of its angle after 10 s", kDescription, 1e-6,
                1e-16);
    }
  }
}

void falling(const Options& options, Figures& figures) {
  const auto oneForce = [](Real, const Column<1>&, const Column<1>& v) {
    return Column<1>(9.81 - 0.05 * v[0] * std::abs(v[0]));
  };
  const Real fallen = caseNumber("N2", "drop_x");
  const Problem<1, decltype(oneForce)> drop = {
      "N2, a fall through air",
      "m",
      Column<1>(0.0),
      Column<1>(0.0),
      5,
      5,
      oneForce,
      false,
      [fallen](const Column<1>& x) { return distance(x[0] - fallen); }};
  Race one(drop.name, drop.unit, drop.duration);
  fixedMethods<1>(one, drop, {50, 200, 800, 3200, 12800});
  fixedPairs<1>(one, drop);
  plainMethods<1>(one, drop, {50, 800});
  static volatile Real time;
  time = 5;
  one.add(
      "closed form (carom)", false, "query", 0,
      [] {
        // vt^2/g log cosh(g t/vt), written so that nothing overflows.
        const Real vt2 = 9.81 / 0.05, u = 9.81 * time / std::sqrt(vt2);
        return Column<1>(vt2 / 9.81 * (u + std::log1p(std::exp(-2 * u)) - std::numbers::ln2));
      },
      drop.error);
#ifdef CAROM_BENCH_ODEINT
  odeintMethods<1>(one, drop, {50, 200, 800, 3200, 12800});
#endif
  finish(one, options, figures);
  judge(figures, "W4", one, drop.name, 1e-9, 1e4, 0);

  const auto force = [](Real, const Column<2>&, const Column<2>& v) {
    const Real speed = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    return Column<2>(-0.01 * speed * v[0], -9.81 - 0.01 * speed * v[1]);
  };
  const Real range = caseNumber("N3", "range"), flight = caseNumber("N3", "flight_time");
  const Problem<2, decltype(force)> ball = {
      "N3, a ball thrown through air",
      "m",
      Column<2>(0, 0),
      Column<2>(50 * std::sqrt(0.5), 50 * std::sqrt(0.5)),
      5,
      flight,
      force,
      false,
      [range](const Column<2>& x) { return distance((x - Column<2>(range, 0)).norm()); }};
  Race race(ball.name, ball.unit, ball.duration);
  fixedMethods<2>(race, ball, {50, 200, 800, 3200, 12800});
  fixedPairs<2>(race, ball);
  plainMethods<2>(race, ball, {50, 200, 800, 3200});
#ifdef CAROM_BENCH_ODEINT
  odeintMethods<2>(race, ball, {50, 200, 800, 3200, 12800});
#endif
  finish(race, options, figures);
  judge(figures, "W4", race, ball.name, 1e-9, 0, 0);
  if (!options.plots.empty()) {
    race.draw(options.plots / "drag.svg",
              "A ball thrown through air: error of where it lands, after 5.27 s", kDescription,
              1e-9, 1e-16);
  }
}

void planets(const Options& options, Figures& figures) {
  const auto force = [](Real, const Column<2>& x, const Column<2>&) {
    const Real r2 = x[0] * x[0] + x[1] * x[1];
    return Column<2>(-x / (r2 * std::sqrt(r2)));
  };
  constexpr Real e = 0.6;
  const Column<2> end(caseNumber("N5", "e_0.6", 0), caseNumber("N5", "e_0.6", 1));
  const Problem<2, decltype(force)> p = {
      "N5, a planet, e = 0.6",
      "a",
      Column<2>(1 - e, 0),
      Column<2>(0, std::sqrt((1 + e) / (1 - e))),
      1000,
      1000,
      force,
      true,
      [end](const Column<2>& x) { return distance((x - end).norm()); }};
  Race race(p.name, p.unit, p.duration);
  fixedMethods<2>(race, p, {100000, 800000});
  symplecticMethods<2>(race, p, {50000, 100000, 200000, 400000, 800000});
  // The same compositions with every sum compensated.
  for (const int looks : {100000, 200000, 400000, 800000}) {
    const int steps = looks / 17;
    race.add(
        "Kahan and Li 8, compensated", false, "dt", 1000.0 / steps,
        [=] {
          CarefulMotion<Column<2>> m = {p.position, p.velocity, Column<2>::Zero(),
                                        Column<2>::Zero()};
          const auto pull = [&](Real t, const Column<2>& x) { return p.force(t, x, x); };
          const Real dt = p.exactly / steps;
          for (int i = 0; i < steps; ++i) {
            composedStep(m, i * dt, dt, kKahanLi8Weights, pull);
          }
          return m.position;
        },
        p.error);
  }
  for (const int perTurn : {12, 18, 24, 30, 37, 48}) {
    race.add(
        "Kahan and Li 8, own clock (carom)", false, "dt", 2 * std::numbers::pi / perTurn,
        [=] {
          const auto field = [](const Column<2>& x) -> Pull<Column<2>> {
            const Real r2 = x[0] * x[0] + x[1] * x[1], r = std::sqrt(r2);
            return {-x / (r2 * r), 1 / r};
          };
          ClockedMotion<Column<2>> m = withClock(p.position, p.velocity, field);
          followToTime(m, p.exactly, 2 * std::numbers::pi / perTurn, kKahanLi8Weights, field);
          return m.position;
        },
        p.error);
  }
  fixedPairs<2>(race, p);
  plainMethods<2>(race, p, {100000});
  static volatile Real time;
  time = 1000;
  race.add(
      "closed form (carom)", false, "query", 0,
      [] {
        // Kepler's equation M = E - e sin E, by Newton's method.
        const Real M = std::remainder(time, 2 * std::numbers::pi);
        Real E = M + std::copysign(0.85 * e, M);
        for (int i = 0; i < 20; ++i) {
          const Real step = (E - e * std::sin(E) - M) / (1 - e * std::cos(E));
          E -= step;
          if (std::abs(step) < 1e-9) break;
        }
        return Column<2>(std::cos(E) - e, 0.8 * std::sin(E));
      },
      p.error);
#ifdef CAROM_BENCH_ODEINT
  odeintMethods<2>(race, p, {100000, 200000, 400000, 1600000}, true);
#endif
  finish(race, options, figures);
  judge(figures, "W4", race, p.name, 3e-7, 1e4, 0);
  judge(figures, "W4", race, p.name, 1e-9, 1e4, 0);
  if (!options.plots.empty()) {
    race.draw(options.plots / "kepler.svg",
              "A planet, e = 0.6: error of its place after 1000 s, 159 turns", kDescription, 1e-9,
              1e-16);
  }
}

// --- W5

Real pendulumEnergy(Real x, Real v) {
  return v * v / (2 * 9.81) - std::cos(x);
}

// Follows the energy of a pendulum: the largest error, as time goes by and at the end, and the
// slope. The slope is the difference of two means, of the first and of the last third, with a
// weight that is smooth to all orders, so that the swinging cancels and what is left is drift.
class EnergyWatch {
 public:
  EnergyWatch(Real start, int steps) : start_(start), steps_(steps) {}
  void look(int i, Real energy) {
    const Real error = (energy - start_) / std::abs(start_);
    if (!(std::abs(error) <= most_)) most_ = std::isfinite(error) ? std::abs(error) : kInfinity;
    if (i >= next_) {
      times_.push_back(i), sofar_.push_back(most_);
      next_ = next_ + std::max(next_ / 4, 1);
    }
    const Real third = steps_ / 3.0;
    const Real s = i < third ? i / third : (i - 2 * third) / third;
    if (s <= 0 || s >= 1) return;
    const Real weight = std::exp(-1 / (s * (1 - s)));
    const int k = i < third ? 0 : 1;
    sum_[k] += weight * error, weights_[k] += weight;
  }
  Real most() const {
    return most_;
  }
  // Drift of the relative energy per swing, of which one takes `period` steps.
  Real slope(Real period) const {
    return (sum_[1] / weights_[1] - sum_[0] / weights_[0]) / (2 * steps_ / 3.0 / period);
  }
  const std::vector<Real>& times() const {
    return times_;
  }
  const std::vector<Real>& sofar() const {
    return sofar_;
  }

 private:
  Real start_;
  int steps_;
  Real most_ = 0;
  int next_ = 1;
  std::vector<Real> times_, sofar_;
  Real sum_[2] = {0, 0}, weights_[2] = {0, 0};
};

struct DriftMethod {
  const char* name;
  bool peer;
  // Makes steps of a length and shows each state to the watch, if there is one.
  std::function<Real(int steps, Real dt, EnergyWatch* watch)> run;
};

template <class Step>
DriftMethod fixedDrift(const char* name, Step step) {
  return {name, false, [step](int steps, Real dt, EnergyWatch* watch) {
            const auto force = [](Real, Real x, Real) { return -9.81 * std::sin(x); };
            FixedState<Real> s = {1, 0};
            for (int i = 1; i <= steps; ++i) {
              step(s, dt, force);
              if (watch) watch->look(i, pendulumEnergy(s.position, s.velocity));
            }
            return s.position;
          }};
}

template <class Step>
DriftMethod positionDrift(const char* name, bool peer, Step step) {
  return {name, peer, [step](int steps, Real dt, EnergyWatch* watch) {
            Real x = 1, v = 0;
            for (int i = 1; i <= steps; ++i) {
              step(x, v, dt);
              if (watch) watch->look(i, pendulumEnergy(x, v));
            }
            return x;
          }};
}

std::vector<DriftMethod> driftMethods() {
  const auto sinus = [](Real, Real x) { return -9.81 * std::sin(x); };
  const auto composed = [sinus](const char* name, std::span<const Real> weights) {
    return positionDrift(
        name, false, [=](Real& x, Real& v, Real dt) { composedStep(x, v, 0, dt, weights, sinus); });
  };
  const auto split = [sinus](const char* name, const Splitting& method) {
    return positionDrift(
        name, false, [=](Real& x, Real& v, Real dt) { splitSteps(x, v, 0, dt, 1, method, sinus); });
  };
  const auto careful = [sinus](const char* name, std::span<const Real> weights) {
    return DriftMethod{name, false, [=](int steps, Real dt, EnergyWatch* watch) {
                         CarefulMotion<Real> m = {1, 0, 0, 0};
                         for (int i = 1; i <= steps; ++i) {
                           composedStep(m, 0, dt, weights, sinus);
                           if (watch) watch->look(i, pendulumEnergy(m.position, m.velocity));
                         }
                         return m.position;
                       }};
  };
  std::vector<DriftMethod> methods;
  using S = FixedState<Real>;
  methods.push_back(fixedDrift(
      "explicit Euler", [](S& s, Real dt, const auto& f) { explicitEulerStep(s, 0, dt, f); }));
  methods.push_back(fixedDrift(
      "source, listing 7.2", [](S& s, Real dt, const auto& f) { sourceVerletStep(s, 0, dt, f); }));
  methods.push_back(fixedDrift("semi-implicit Euler", [](S& s, Real dt, const auto& f) {
    semiImplicitEulerStep(s, 0, dt, f);
  }));
  methods.push_back(fixedDrift(
      "velocity Verlet", [](S& s, Real dt, const auto& f) { velocityVerletStep(s, 0, dt, f); }));
  methods.push_back(fixedDrift("RK4", [](S& s, Real dt, const auto& f) { rk4Step(s, 0, dt, f); }));
  methods.push_back(composed("Yoshida 4", kYoshida4Weights));
  methods.push_back(composed("Yoshida 6", kYoshida6Weights));
  methods.push_back(split("Blanes and Moan 4", kBlanesMoan4));
  methods.push_back(split("Blanes and Moan 6", kBlanesMoan6));
  methods.push_back(composed("Kahan and Li 8", kKahanLi8Weights));
  methods.push_back(careful("Kahan and Li 8, compensated", kKahanLi8Weights));
#ifdef CAROM_BENCH_ODEINT
  namespace odeint = boost::numeric::odeint;
  methods.push_back({"odeint RK4", true, [](int steps, Real dt, EnergyWatch* watch) {
                       odeint::runge_kutta4<OdeintState<2>> stepper;
                       OdeintState<2> y = {1, 0};
                       const auto flow = [](const OdeintState<2>& s, OdeintState<2>& d, double) {
                         d[0] = s[1], d[1] = -9.81 * std::sin(s[0]);
                       };
                       for (int i = 1; i <= steps; ++i) {
                         stepper.do_step(flow, y, 0, dt);
                         if (watch) watch->look(i, pendulumEnergy(y[0], y[1]));
                       }
                       return y[0];
                     }});
  methods.push_back(
      {"odeint symplectic_rkn_sb3a", true, [](int steps, Real dt, EnergyWatch* watch) {
         odeint::symplectic_rkn_sb3a_mclachlan<OdeintState<1>> stepper;
         OdeintState<1> q = {1}, v = {0};
         const auto force = [](const OdeintState<1>& x, OdeintState<1>& d) {
           d[0] = -9.81 * std::sin(x[0]);
         };
         for (int i = 1; i <= steps; ++i) {
           stepper.do_step(force, q, v, 0.0, dt);
           if (watch) watch->look(i, pendulumEnergy(q[0], v[0]));
         }
         return q[0];
       }});
#endif
  return methods;
}

}  // namespace

void translations(const Options& options, Figures& figures) {
  pendulums(options, figures);
  falling(options, figures);
  planets(options, figures);
}

void energyDrift(const Options& options, Figures& figures) {
  constexpr int kSteps = 1000000;
  constexpr Real kDt = 1.0 / 60;
  const Real period = caseNumber("N15", "period") / kDt, start = pendulumEnergy(1, 0);
  const std::vector<DriftMethod> methods = driftMethods();

  // Error against time of the processor, for 1e5 steps of the case and as long in other steps.
  Race race("N15, energy of a pendulum over 1667 s", "of the energy", 1667);
  for (const DriftMethod& m : methods) {
    for (const int rate : {15, 30, 60, 120, 240}) {
      const int steps = rate * 5000 / 3;
      EnergyWatch watch(start, steps);
      m.run(steps, 1.0 / rate, &watch);
      race.add(
          m.name, m.peer, "dt", 1.0 / rate, [=] { return m.run(steps, 1.0 / rate, nullptr); },
          [&](Real) { return watch.most(); });
    }
  }
  finish(race, options, figures);
  judge(figures, "W5", race, "N15", 1e-6, 0, 0);
  judge(figures, "W5", race, "N15", 1e-11, 0, 0);

  // The case itself, ten times as long: how the error grows.
  io::Plot plot("A pendulum at 60 steps a second: the largest error of its energy so far");
  plot.describe(
      "Explicit Euler and the listing of the source leave at once, Runge and Kutta's method grows "
      "steadily; the symplectic ones stay where they are, the lower the higher their order.");
  plot.size(1000, 640).xAxis("time [s]", io::Scale::Logarithmic).xRange(0.01, 1e5);
  plot.yAxis("largest error of the energy, relative", io::Scale::Logarithmic).yRange(1e-17, 100);
  io::Table table;
  table.column("N15, 1e6 steps at 60 a second").column("1e5 steps", io::scientific(1));
  table.column("1e6 steps", io::scientific(1)).column("drift per swing", io::scientific(1));
  std::size_t color = 0;
  for (const DriftMethod& m : methods) {
    EnergyWatch watch(start, kSteps);
    m.run(kSteps, kDt, &watch);
    Real early = 0;
    std::vector<Real> x, y;
    for (std::size_t i = 0; i < watch.times().size(); ++i) {
      if (watch.times()[i] <= kSteps / 10) early = watch.sofar()[i];
      if (!(watch.sofar()[i] < 100)) continue;
      x.push_back(watch.times()[i] * kDt);
      y.push_back(std::max(watch.sofar()[i], 1e-17));
    }
    const bool failed = !(watch.most() < kInfinity);
    const Real slope = watch.slope(period);
    table.row({m.name, early, watch.most(), slope});
    Json row = {{"suite", "integrators"},
                {"scene", "N15, 1e6 steps at 60 a second"},
                {"engine", m.name},
                {"version", CAROM_VERSION},
                {"dt", kDt},
                {"max_energy_error_1e5", early}};
    if (failed) {
      row["failed"] = true;
    } else {
      row["max_energy_error_1e6"] = watch.most();
      row["drift_per_swing"] = slope;
    }
    figures.rows.push_back(row);
    io::CurveStyle style = styleOf(color, m.peer);
    style.marks = false;
    style.dashed = !m.peer && color >= 9;  // the colours begin again
    if (!m.peer) ++color;
    plot.curve(m.name, x, y, style);
    if (std::string(m.name) == "Kahan and Li 8, compensated") {
      figures.targets.push_back({{"diagram", "W5"},
                                 {"what", "drift of the energy per swing"},
                                 {"reached", std::abs(slope)},
                                 {"target", 1e-16},
                                 {"met", std::abs(slope) <= 1e-16}});
    }
  }
  std::cout << '\n' << table;

  // A million swings of a spring: what Verlet keeps exactly, kept to 1e-13 by compensated sums.
  constexpr Real h = 0.1;
  CarefulMotion<Real> spring = {1, 0, 0, 0};
  Real worst = 0;
  for (int i = 0; i < 62831853; ++i) {
    composedStep(spring, 0, h, kVerletWeights, [](Real, Real x) { return -x; });
    const Real x = spring.position, v = spring.velocity;
    worst = std::max(worst, std::abs(x * x + v * v * (1 - h * h / 4) - 1));
  }
  std::cout << "\nN4, 1e6 swings of a spring: what Verlet keeps is kept to " << worst << '\n';
  figures.targets.push_back({{"diagram", "W5"},
                             {"what", "N4, compensated, 1e6 periods"},
                             {"reached", worst},
                             {"target", 1e-13},
                             {"met", worst <= 1e-13}});
  if (options.plots.empty()) return;
  const auto file = options.plots / "energy_in_time.svg";
  plot.writeSvg(file);
  std::cout << "wrote " << file.string() << '\n';
  race.draw(options.plots / "energy_drift.svg",
            "A pendulum for 1667 s: largest error of its energy against time of the processor",
            "One curve per method, one mark per step from 1/15 to 1/240 s, grey for Boost.odeint.",
            1e-11, 1e-17);
}

}  // namespace carom::bench
