#include "carom/motion/trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

#include "carom/core/checks.hpp"
#include "carom/motion/embedded_pairs.hpp"
#include "carom/motion/step_control.hpp"

namespace carom {
namespace {

// Positions and velocities in one column: y = (x, v), y' = (v, a).
Coordinates joined(const State& s) {
  Coordinates y(2 * s.position.size());
  y << s.position, s.velocity;
  return y;
}

State parted(const Coordinates& y) {
  const Eigen::Index n = y.size() / 2;
  return {y.head(n), y.tail(n)};
}

template <class Row>
Coordinates weighted(const Row& weights, std::span<const Coordinates> slopes) {
  Coordinates sum = Coordinates::Zero(slopes[0].size());
  for (std::size_t j = 0; j < slopes.size(); ++j) {
    if (weights[j] != 0) sum += weights[j] * slopes[j];
  }
  return sum;
}

}  // namespace

Trajectory::Trajectory(const State& state, Real time, Real end, const Acceleration& acceleration,
                       const Tolerance& tolerance, Pair pair)
    : start_(time), first_(state) {
  requireUsable(state, time, end - time);
  requireUsable(tolerance);
  run_.state = state;
  run_.time = time;
  if (pair == Pair::kOrder5) {
    follow(kDormandPrince5, end, acceleration, tolerance);
  } else {
    follow(kDormandPrince8, end, acceleration, tolerance);
  }
}

template <class Method>
void Trajectory::follow(const Method& method, Real end, const Acceleration& acceleration,
                        const Tolerance& tolerance) {
  constexpr std::size_t kStep = std::tuple_size_v<decltype(method.error)>;
  constexpr std::size_t kAll = std::tuple_size_v<decltype(method.nodes)>;
  std::array<Coordinates, kAll> slopes;
  Coordinates y = joined(run_.state);
  detail::StepControl control(run_.time, end, tolerance.maxSteps, method.order);

  const auto look = [&](std::size_t i, const Coordinates& at) {
    const State s = parted(at);
    const Real time = run_.time + method.nodes[i] * control.dt();
    slopes[i] = joined({s.velocity, accelerationAt(acceleration, time, s.position, s.velocity)});
    ++evaluations_;
  };
  const auto lookAlong = [&](std::size_t i) -> Coordinates {
    const Coordinates at =
        y +
        control.dt() * weighted(method.stages[i], std::span<const Coordinates>(slopes).first(i));
    look(i, at);
    return at;
  };

  look(0, y);
  while (control.goesOn(run_)) {
    Coordinates next = y;
    for (std::size_t i = 1; i < kStep; ++i) next = lookAlong(i);

    const auto used = std::span<const Coordinates>(slopes).first(kStep);
    const Real dt = control.dt();
    const Coordinates off = dt * weighted(method.error, used);
    const Coordinates lowOff = dt * weighted(method.lowError, used);
    const Real ratio = detail::ratioOf(detail::meanSquare(off, y, next, tolerance),
                                       detail::meanSquare(lowOff, y, next, tolerance));
    if (control.rejects(run_, ratio)) continue;

    for (std::size_t i = kStep; i < kAll; ++i) lookAlong(i);
    Piece piece = {run_.time, dt, {}};
    const Coordinates rise = next - y;
    const Coordinates bend = dt * slopes[0] - rise;
    piece.terms = {y, rise, bend, rise - dt * slopes[kStep - 1] - bend};
    for (const auto& row : method.dense) piece.terms.push_back(dt * weighted(row, slopes));
    pieces_.push_back(piece);

    control.advance(run_, ratio);
    y = next;
    slopes[0] = slopes[kStep - 1];
  }
  run_.state = parted(y);
}

State Trajectory::at(Real time) const {
  requireFinite(time, "time");
  const bool forwards = run_.time >= start_;
  if (time < std::min(start_, run_.time) || time > std::max(start_, run_.time)) {
    reject(
        "time", toText(time),
        "must be between " + toText(start_) + " and " + toText(run_.time) + ", where the run is");
  }
  if (pieces_.empty()) return first_;
  // The last piece that begins before this time.
  const auto later = std::upper_bound(
      pieces_.begin() + 1, pieces_.end(), time,
      [&](Real t, const Piece& p) { return forwards ? t < p.start : t > p.start; });
  const Piece& piece = *(later - 1);

  const Real s = (time - piece.start) / piece.dt;
  Coordinates y = piece.terms.back();
  for (std::size_t i = piece.terms.size() - 1; i > 0; --i) {
    y = piece.terms[i - 1] + (i % 2 == 1 ? s : 1 - s) * y;
  }
  return parted(y);
}

}  // namespace carom
