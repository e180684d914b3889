// Steps by themselves, in nanoseconds; ten thousand bodies beside a copy; and the orders.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <limits>
#include <numbers>

#include "bench/integrators_methods.hpp"
#include "bench/integrators_sections.hpp"
#include "carom/core/elementary.hpp"
#include "carom/motion/composition.hpp"
#include "carom/motion/embedded_step.hpp"
#include "carom/motion/exact_rotor.hpp"
#include "carom/motion/extrapolation.hpp"
#include "carom/motion/free_rotor.hpp"
#include "carom/motion/many_bodies.hpp"
#include "carom/motion/measure_order.hpp"
#include "carom/motion/own_clock.hpp"
#include "carom/motion/rk4.hpp"
#include "carom/motion/rk4_rotor.hpp"
#include "carom/motion/split_rotor.hpp"
#include "carom/motion/splitting.hpp"
#include "carom/motion/velocity_verlet.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom_io/table.hpp"

namespace carom::bench {
namespace {

// --- Orders

using Pair2 = Vector2;

// A problem in the plane (or along a line in it), and its end in closed form.
struct OrderProblem {
  const char* name;
  Vector2 position, velocity;
  Real duration;
  Vector2 end, endVelocity;
  std::function<Vector2(Real, const Vector2&, const Vector2&)> force;
  bool ofPosition;
};

std::vector<OrderProblem> orderProblems() {
  // Kepler's equation for e = 0.1 at t = 5.
  constexpr Real e = 0.1;
  Real E = 5;
  for (int i = 0; i < 50; ++i) E -= (E - e * sine(E) - 5) / (1 - e * cosine(E));
  const Real r = 1 - e * cosine(E), b = std::sqrt(1 - e * e);
  // Case N14: exp(-t/4) (cos wt + sin wt / 4w).
  const Real w = std::sqrt(15.0) / 4, slower = std::exp(-1.25);
  return {{"spring",
           {1, 0},
           {0, 0},
           5,
           {cosine(5), 0},
           {-sine(5), 0},
           [](Real, const Vector2& x, const Vector2&) -> Vector2 { return -x; },
           true},
          {"Duffing",
           {1, 0},
           {0, 0},
           5,
           {caseNumber("N13", "x"), 0},
           {caseNumber("N13", "v"), 0},
           [](Real, const Vector2& x, const Vector2&) -> Vector2 {
             return {-x[0] - x[0] * x[0] * x[0], 0};
           },
           true},
          {"planet",
           {1 - e, 0},
           {0, std::sqrt((1 + e) / (1 - e))},
           5,
           {cosine(E) - e, b * sine(E)},
           {-sine(E) / r, b * cosine(E) / r},
           [](Real, const Vector2& x, const Vector2&) -> Vector2 {
             const Real r2 = x.squaredNorm();
             return -x / (r2 * std::sqrt(r2));
           },
           true},
          {"spring with a brake",
           {1, 0},
           {0, 0},
           5,
           {slower * (cosine(5 * w) + sine(5 * w) / (4 * w)), 0},
           {-slower * sine(5 * w) / w, 0},
           [](Real, const Vector2& x, const Vector2& v) -> Vector2 { return -x - v / 2; },
           false}};
}

struct OrderMethod {
  const char* name;
  Real theory;
  bool ofPosition;  // needs a force of the position alone
  int first;        // steps of the coarsest run
  std::function<void(FixedState<Vector2>&, const OrderProblem&, int steps)> run;
};

std::vector<OrderMethod> orderMethods() {
  using S = FixedState<Vector2>;
  const auto fixed = [](const char* name, Real theory, int first, auto step) {
    return OrderMethod{name, theory, false, first, [step](S& s, const OrderProblem& p, int n) {
                         const Real h = p.duration / n;
                         for (int i = 0; i < n; ++i) step(s, i * h, h, p.force);
                       }};
  };
  const auto composed = [](const char* name, Real theory, int first,
                           std::span<const Real> weights) {
    return OrderMethod{
        name, theory, true, first, [weights](S& s, const OrderProblem& p, int n) {
          CarefulMotion<Vector2> m = {s.position, s.velocity, Vector2::Zero(), Vector2::Zero()};
          const auto f = [&](Real t, const Vector2& x) { return p.force(t, x, x); };
          const Real h = p.duration / n;
          for (int i = 0; i < n; ++i) composedStep(m, i * h, h, weights, f);
          s = {m.position, m.velocity};
        }};
  };
  const auto split = [](const char* name, Real theory, int first, const Splitting& method) {
    return OrderMethod{name, theory, true, first, [method](S& s, const OrderProblem& p, int n) {
                         const auto f = [&](Real t, const Vector2& x) { return p.force(t, x, x); };
                         splitSteps(s.position, s.velocity, 0, p.duration / n, n, method, f);
                       }};
  };
  const auto extrapolated = [](const char* name, Real theory, int first, int answers) {
    return OrderMethod{name, theory, true, first, [answers](S& s, const OrderProblem& p, int n) {
                         const auto f = [&](Real t, const Vector2& x) { return p.force(t, x, x); };
                         extrapolatedSteps(s.position, s.velocity, 0, p.duration / n, n, answers,
                                           f);
                       }};
  };
  return {fixed("explicit Euler", 1, 4096,
                [](S& s, Real t, Real h, const auto& f) { explicitEulerStep(s, t, h, f); }),
          fixed("semi-implicit Euler", 1, 4096,
                [](S& s, Real t, Real h, const auto& f) { semiImplicitEulerStep(s, t, h, f); }),
          fixed("source, listing 7.2", 1, 4096,
                [](S& s, Real t, Real h, const auto& f) { sourceVerletStep(s, t, h, f); }),
          fixed("source, listing 7.3", 1, 4096,
                [](S& s, Real t, Real h, const auto& f) { sourceVelocityVerletStep(s, t, h, f); }),
          fixed("velocity Verlet", 2, 256,
                [](S& s, Real t, Real h, const auto& f) { velocityVerletStep(s, t, h, f); }),
          fixed("RK4", 4, 128, [](S& s, Real t, Real h, const auto& f) { rk4Step(s, t, h, f); }),
          fixed("Dormand and Prince 5", 5, 24,
                [](S& s, Real t, Real h, const auto& f) {
                  const Acceleration a = [&](Real time, const Coordinates& x,
                                             const Coordinates& v) -> Coordinates {
                    return f(time, Vector2(x), Vector2(v));
                  };
                  const State end = embeddedStep({s.position, s.velocity}, t, h, a).end;
                  s = {end.position, end.velocity};
                }),
          composed("Yoshida 4", 4, 128, kYoshida4Weights),
          composed("Yoshida 6", 6, 64, kYoshida6Weights),
          composed("Kahan and Li 6", 6, 32, kKahanLi6Weights),
          composed("Kahan and Li 8", 8, 14, kKahanLi8Weights),
          split("Blanes and Moan 4", 4, 64, kBlanesMoan4),
          split("Blanes and Moan 6", 6, 10, kBlanesMoan6),
          extrapolated("extrapolated Verlet, 3 answers", 6, 16, 3)};
}

// The order from the finest two runs whose errors are well above rounding, and the order before it.
struct Orders {
  Real last = 0, before = 0, error = 0;
};

Orders ordersOf(int first, const std::function<Real(int)>& errorOf) {
  constexpr int kMostSteps = 1 << 15;
  Orders orders;
  Real coarse = errorOf(first);
  for (int n = 2 * first; n <= kMostSteps; n *= 2) {
    const Real fine = errorOf(n);
    // A hundred roundings, and more of them in longer runs.
    if (fine < 1e-14 * std::sqrt(Real(n)) && n > 2 * first) break;
    orders.before = orders.last;
    orders.last = measureOrder({2, coarse}, {1, fine});
    orders.error = fine;
    coarse = fine;
  }
  return orders;
}

struct RotorMethod {
  const char* name;
  Real theory;
  int first;
  std::function<RotorState(const Vector3&, const RotorState&, Real)> step;
};

std::vector<RotorMethod> rotorMethods() {
  return {
      {"explicit gyroscopic step", 1, 2048,
       [](const Vector3& I, const RotorState& s, Real h) { return engineStep(I, s, h, false); }},
      {"implicit gyroscopic step", 1, 2048,
       [](const Vector3& I, const RotorState& s, Real h) { return engineStep(I, s, h, true); }},
      {"Buss, order 2", 2, 256, bussStep},
      {"implicit midpoint", 2, 256, midpointStep},
      {"RK4 on the quaternion", 4, 128,
       [](const Vector3& I, const RotorState& s, Real h) { return rk4Rotor(I, s, 0, h); }},
      {"splitting, order 2", 2, 128,
       [](const Vector3& I, const RotorState& s, Real h) { return SplitRotor(I).step2(s, h); }},
      {"splitting, order 4", 4, 32,
       [](const Vector3& I, const RotorState& s, Real h) { return SplitRotor(I).step4(s, h); }}};
}

}  // namespace

void measuredOrders(Figures& figures) {
  io::Table table;
  table.column("method").column("theory", io::fixed(0));
  const std::vector<OrderProblem> problems = orderProblems();
  for (const OrderProblem& p : problems) table.column(p.name);
  Real worst = 0;
  const auto enter = [&](const char* method, const char* problem, Real theory,
                         const Orders& orders) {
    worst = std::max(worst, std::abs(orders.last - theory));
    figures.rows.push_back({{"suite", "integrators"},
                            {"scene", "measured order"},
                            {"engine", method},
                            {"version", CAROM_VERSION},
                            {"problem", problem},
                            {"order", orders.last},
                            {"order_before", orders.before},
                            {"error", orders.error},
                            {"theory", theory}});
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", orders.last);
    return std::string(text);
  };
  for (const OrderMethod& m : orderMethods()) {
    std::vector<io::Cell> cells = {m.name, m.theory};
    for (const OrderProblem& p : problems) {
      if (m.ofPosition && !p.ofPosition) {
        cells.emplace_back(std::string("-"));
        continue;
      }
      const Orders orders = ordersOf(m.first, [&](int n) {
        FixedState<Vector2> s = {p.position, p.velocity};
        m.run(s, p, n);
        return std::hypot((s.position - p.end).norm(), (s.velocity - p.endVelocity).norm());
      });
      cells.emplace_back(enter(m.name, p.name, m.theory, orders));
    }
    table.row(cells);
  }
  std::cout << "\nMeasured orders\n\n" << table;

  io::Table turns;
  turns.column("method").column("theory", io::fixed(0));
  const std::vector<std::pair<const char*, RotorState>> starts = {
      {"N7", {{1, 0, 0, 0}, {2, 0, 1.5}}},
      {"about the longest", {{1, 0, 0, 0}, {0.3, 1.2, -0.4}}},
      {"about no axis", {{0.6, 0, 0.8, 0}, {1, 1, 1}}}};
  for (const auto& start : starts) turns.column(start.first);
  const Vector3 I(1, 2, 3);
  for (const RotorMethod& m : rotorMethods()) {
    std::vector<io::Cell> cells = {m.name, m.theory};
    for (const auto& [name, from] : starts) {
      const Quaternion end = FreeRotor(I, from).at(2).q_WB;
      const Orders orders = ordersOf(m.first, [&, from = from](int n) {
        RotorState s = from;
        for (int i = 0; i < n; ++i) s = m.step(I, s, 2.0 / n);
        return quaternionLogarithm(hamiltonProduct(conjugate(end), s.q_WB)).norm();
      });
      cells.emplace_back(enter(m.name, name, m.theory, orders));
    }
    turns.row(cells);
  }
  std::cout << '\n' << turns << "\nFurthest from theory: " << worst << '\n';
  figures.targets.push_back({{"diagram", "orders"},
                             {"what", "furthest from theory"},
                             {"reached", worst},
                             {"target", 0.1},
                             {"met", worst <= 0.1}});
}

void singleSteps(const Options& options, Figures& figures) {
  constexpr int kBodies = 10000;
  constexpr Real kDt = 1.0 / 60;
  const Vector3 moments(13, 10, 5);
  const RotorState start = {{1, 0, 0, 0}, {0.01, 5, 0.01}};
  std::vector<Case> cases;
  const auto add = [&](const char* name, std::size_t items, std::function<void()> run) {
    cases.push_back({name, items, std::move(run)});
  };

  // Each call begins where the last one ended, as in a simulation.
  const FreeRotor rotor(moments, start);
  const SplitRotor split(moments);
  add("FreeRotor, a query", 1, [&, t = 0.0]() mutable {
    t = t < 100 ? t + kDt : 0;
    keep(rotor.at(t).q_WB);
  });
  add("FreeRotor, made and asked", 1, [&, s = start]() mutable {
    s = FreeRotor(moments, s).at(kDt);
    keep(s);
  });
  add("exactRotor", 1, [&, t = 0.0]() mutable {
    t = t < 100 ? t + kDt : 0;
    keep(exactRotor({2, 1}, start, t).q_WB);
  });
  add("SplitRotor::step2", 1, [&, s = start]() mutable {
    s = split.step2(s, kDt);
    keep(s);
  });
  add("SplitRotor::step4", 1, [&, s = start]() mutable {
    s = split.step4(s, kDt);
    keep(s);
  });
  add("SplitRotor::steps4, of a hundred", 100, [&, s = start]() mutable {
    s = split.steps4(s, kDt, 100);
    keep(s);
  });
  add("rk4Rotor", 1, [&, s = start]() mutable {
    s = rk4Rotor(moments, s, 0, kDt);
    if (!(s.angularVelocity.squaredNorm() < 1000)) s = start;
    keep(s);
  });

  // Ten thousand bodies: three coordinates and three velocities each.
  constexpr std::size_t kNumbers = 3 * kBodies;
  std::vector<Real> x(kNumbers, 1), v(kNumbers, 2), a(kNumbers, 0.5), x2(kNumbers), v2(kNumbers);
  add("copy of 10000 bodies", kBodies, [&] {
    std::memcpy(x2.data(), x.data(), kNumbers * sizeof(Real));
    std::memcpy(v2.data(), v.data(), kNumbers * sizeof(Real));
    keep(x2[0]), keep(v2[0]);
  });
  const auto everyAxis = [&](Real gravity) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto from = static_cast<std::size_t>(axis) * kBodies;
      stepFalling(std::span(x).subspan(from, kBodies), std::span(v).subspan(from, kBodies),
                  axis == 2 ? gravity : 0, kDt);
    }
    keep(x[0]);
  };
  add("step of 10000 free bodies", kBodies, [&, everyAxis] { everyAxis(0); });
  add("step of 10000 falling bodies", kBodies, [&, everyAxis] { everyAxis(-9.81); });
  add("both halves of 10000 steps", kBodies, [&] {
    beginSteps(x, v, a, kDt);
    endSteps(v, a, -kDt);  // the velocities stay in range however often this runs
    keep(x[0]);
  });
  const Acceleration weight = [](Real, const Coordinates& p, const Coordinates&) -> Coordinates {
    return Coordinates::Constant(p.size(), -9.81);
  };
  State plain = {Coordinates::Zero(kNumbers), Coordinates::Zero(kNumbers)};
  add("velocityVerlet, plain, of 10000 bodies", kBodies, [&] {
    plain = velocityVerlet(plain, 0, kDt, weight);
    keep(plain.position[0]);
  });

  const std::vector<Timing> timings = measure(cases, options);
  io::Table table;
  table.column("what").column("ns", io::significant(4));
  Real copy = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    table.row({cases[i].name, timings[i].median});
    figures.rows.push_back({{"suite", "integrators"},
                            {"scene", "single steps"},
                            {"engine", cases[i].name},
                            {"version", CAROM_VERSION},
                            {"threads", 1},
                            {"ns", timings[i].median},
                            {"least", timings[i].least},
                            {"most", timings[i].most}});
    if (cases[i].name == "copy of 10000 bodies") copy = timings[i].median;
  }
  std::cout << '\n' << table;
  const auto target = [&](const char* name, Real asked, Real unit, const char* what) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].name != name) continue;
      const Real reached = timings[i].median / unit;
      figures.targets.push_back({{"diagram", "steps"},
                                 {"what", what},
                                 {"reached", reached},
                                 {"target", asked},
                                 {"met", reached <= asked}});
    }
  };
  target("FreeRotor, a query", 500, 1, "a query of the free rotor [ns]");
  target("SplitRotor::step2", 200, 1, "a symplectic step of order 2 [ns]");
  target("SplitRotor::step4", 200, 1, "a symplectic step of order 4 [ns]");
  target("SplitRotor::steps4, of a hundred", 200, 1,
         "a symplectic step of order 4, in a run of many [ns]");
  target("step of 10000 free bodies", 2, copy, "10000 free bodies, in copies of their state");
  target("step of 10000 falling bodies", 2, copy, "10000 falling bodies, in copies of their state");
}

}  // namespace carom::bench
