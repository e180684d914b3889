#pragma once
// Where was everything at any moment, when the steps were long and not of our choosing?
//
// Method: an embedded pair of high order chooses its steps, as in rk_adaptive.hpp; and each step
// keeps a polynomial in time, made of the slopes that it has looked at, which is nearly as good
// between the ends as the step is at its end.
// Why: pictures want equal times, contacts want the moment of touching, and high order wants long
// steps. The polynomial serves all three.
// Why order 8: at twelve digits it takes a tenth of the looks at the forces that order 5 takes. For
// three digits order 5 is the better bargain.
// Source: Dormand and Prince 1980 and 1981; Hairer, Nørsett and Wanner, Solving Ordinary
// Differential Equations I, 1993, II.6 (polynomials) and II.10 (order 8 with the estimates of order
// 5 and 3).
// Not handled: stiff problems, where the steps become as short as stability asks; and a choice of
// the first step better than a guess that the control puts right.

#include <vector>

#include "carom/motion/adaptive.hpp"

namespace carom {

/// Which pair of methods chooses the steps. \ingroup motion
enum class Pair {
  kOrder5,  ///< Dormand and Prince, 5 with 4; the polynomial is of order 4
  kOrder8,  ///< Dormand and Prince, 8 with 5 and 3; the polynomial is of order 7
};

/// A motion that can be asked for any time that it covers. \ingroup motion
class Trajectory {
 public:
  /// Follows a motion from one time to another.
  /// \param state positions and velocities at the start
  /// \param time at the start [s]
  /// \param end when to stop; earlier than `time` runs backwards [s]
  /// \param acceleration a(t, x, v)
  /// \param tolerance what error is allowed per step
  /// \param pair which pair of methods
  /// \throws InvalidInput if a number is not finite, the counts of positions, velocities and
  /// accelerations differ, or the tolerance is impossible
  Trajectory(const State& state, Real time, Real end, const Acceleration& acceleration,
             const Tolerance& tolerance = {}, Pair pair = Pair::kOrder8);

  /// The state at a time. \param time between the start and where the run came to [s]
  /// \return positions and velocities
  /// \throws InvalidInput if the run does not cover that time
  State at(Real time) const;

  /// How the run went, and the state where it came to. \return status, time, state and counts
  const AdaptiveRun& run() const {
    return run_;
  }

  /// How often it looked at the forces. \return the number of calls
  int evaluations() const {
    return evaluations_;
  }

 private:
  // The polynomial of one step, y0 + s (p1 + (1-s) (p2 + s (p3 + (1-s) (...)))), s from 0 to 1.
  struct Piece {
    Real start = 0;
    Real dt = 0;
    std::vector<Coordinates> terms;  // of positions and velocities in one column
  };

  template <class Method>
  void follow(const Method& method, Real end, const Acceleration& acceleration,
              const Tolerance& tolerance);

  Real start_ = 0;
  State first_;
  AdaptiveRun run_;
  int evaluations_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace carom
