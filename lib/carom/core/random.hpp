#pragma once
// Random numbers that are the same on every machine.
//
// Method: SplitMix64 (Steele, Lea and Flood 2014): a counter with a large odd step, scrambled.
// Why not <random>: its engines are specified bit by bit but its distributions are not, so that a
// seed would give other points with another standard library.
// Not handled: cryptography; streams that must not overlap (choose seeds at random).

#include <cmath>
#include <cstdint>

#include "carom/core/real.hpp"

namespace carom {

/// A seeded stream of pseudo-random numbers. \ingroup core
class Random {
 public:
  /// Starts the stream.
  /// \param seed any number; the same seed gives the same stream everywhere
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// The next 64 random bits.
  /// \return any 64-bit number, all equally likely
  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// The next number between two bounds.
  /// \param low smallest value
  /// \param high bound that is (almost) never reached
  /// \return low + (high - low) u with u in [0, 1), a multiple of 2^-53
  Real between(Real low, Real high) {
    constexpr Real kStep = 0x1p-53;  // as fine as a double in [1/2, 1) is
    return low + (high - low) * (static_cast<Real>(bits() >> 11) * kStep);
  }

  /// The next whole number between two bounds.
  /// \param low smallest value
  /// \param high largest value, not below low
  /// \return a number from low to high, all equally likely but for one part in 2^32
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }

  /// A point in a cube about the origin.
  /// \param size half the edge of the cube [any unit]
  /// \return three numbers between -size and size
  Vector3 vector(Real size = 1) {
    const Real x = between(-size, size);
    const Real y = between(-size, size);
    const Real z = between(-size, size);
    return {x, y, z};
  }

  /// A direction, all equally likely: a point in a ball, brought to length one.
  /// \return a unit vector
  Vector3 direction() {
    for (;;) {
      const Vector3 v = vector();
      const Real squared = v.squaredNorm();
      if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace carom
