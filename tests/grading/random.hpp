#pragma once
// The same random inputs on every machine.

#include <cmath>
#include <cstdint>

#include "carom/core/real.hpp"

namespace carom::grading {

/// A small generator (splitmix64; Steele, Lea and Flood 2014) whose numbers do not depend on the C++ library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// A number in [low, high).
  Real uniform(Real low, Real high) {
    return low + (high - low) * (static_cast<Real>(bits() >> 11) * 0x1p-53);
  }

  /// A point in the cube [-size, size]^3.
  Vector3 vector(Real size = 1) {
    const Real x = uniform(-size, size);
    const Real y = uniform(-size, size);
    const Real z = uniform(-size, size);
    return {x, y, z};
  }

  /// A direction: a unit vector, uniform on the sphere.
  Vector3 direction() {
    for (;;) {
      const Vector3 v = vector();
      const Real squared = v.squaredNorm();
      if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
    }
  }

  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace carom::grading
