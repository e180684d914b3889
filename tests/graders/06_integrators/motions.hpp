#pragma once
// Motions that are known exactly, which the graders of this chapter ask about.

#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "grading/fields_motion.hpp"
#include "grading/random.hpp"

namespace carom::grading {

inline constexpr const char* kRounding = "a few roundings of numbers of this size";

/// A column as one writes it.
inline Coordinates column(std::initializer_list<Real> numbers) {
  Coordinates x(static_cast<Eigen::Index>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), x.data());
  return x;
}

/// A force for n coordinates. Who asks with fewer or more gets no numbers, and no crash.
inline Acceleration forceOn(Eigen::Index n, Acceleration answer) {
  return [n, answer = std::move(answer)](Real t, const Coordinates& x,
                                         const Coordinates& v) -> Coordinates {
    if (x.size() != n || v.size() != n) {
      return Coordinates::Constant(n, std::numeric_limits<Real>::quiet_NaN());
    }
    return answer(t, x, v);
  };
}

/// Everything falls with the same acceleration.
inline Acceleration falling(Coordinates a) {
  const Eigen::Index n = a.size();
  return forceOn(n, [a = std::move(a)](Real, const Coordinates&, const Coordinates&) { return a; });
}

/// A spring for each coordinate, with this angular frequency.
inline Acceleration springs(Eigen::Index n, Real omega) {
  return forceOn(n, [omega](Real, const Coordinates& x, const Coordinates&) -> Coordinates {
    return -omega * omega * x;
  });
}

/// The energy of springs, per unit of mass.
inline Real energyOfSprings(const State& s, Real omega) {
  return s.velocity.squaredNorm() / 2 + omega * omega * s.position.squaredNorm() / 2;
}

/// A motion that somebody has made up, x = (size sin(rate t + phase), ...), and a force that makes
/// it come true. The force depends on time, place and velocity: whoever asks at another moment,
/// place or velocity than those of the motion gets another answer.
struct MadeUp {
  Coordinates size, rate, phase;
  Real stiffness = 0, brake = 0;

  MadeUp(Random& random, Eigen::Index n, bool braked = true) : size(n), rate(n), phase(n) {
    for (Eigen::Index i = 0; i < n; ++i) {
      size[i] = random.between(0.5, 2);
      rate[i] = random.between(0.5, 2);
      phase[i] = random.between(0, 6);
    }
    stiffness = random.between(1, 3);
    if (braked) brake = random.between(0.5, 2);
  }

  Coordinates angle(Real t) const {
    return t * rate + phase;
  }
  Coordinates position(Real t) const {
    return size.cwiseProduct(Coordinates(angle(t).array().sin()));
  }
  Coordinates velocity(Real t) const {
    return size.cwiseProduct(rate).cwiseProduct(Coordinates(angle(t).array().cos()));
  }
  Coordinates acceleration(Real t) const {
    return -rate.cwiseProduct(rate).cwiseProduct(position(t));
  }
  State at(Real t) const {
    return {position(t), velocity(t)};
  }
  Acceleration force() const {
    return forceOn(
        size.size(), [*this](Real t, const Coordinates& x, const Coordinates& v) -> Coordinates {
          return acceleration(t) - stiffness * (x - position(t)) - brake * (v - velocity(t));
        });
  }
};

}  // namespace carom::grading
