#pragma once
// What the tests of rotations share: reference values, distances, random rotations.

#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "carom/core/real.hpp"
#include "carom/rotation/quaternion.hpp"
#include "support/catch.hpp"

namespace rotation_test {

using carom::Matrix3;
using carom::Quaternion;
using carom::Real;
using carom::Vector3;

inline constexpr Real kPi = 3.14159265358979323846;

/// A case of tests/cases/rotation.json.
inline nlohmann::json caseNamed(const std::string& name) {
  std::ifstream file(std::string(CAROM_CASES_DIR) + "/rotation.json");
  return nlohmann::json::parse(file).at(name);
}

/// Numbers are kept as text with all their digits.
inline Real number(const nlohmann::json& text) {
  return std::stod(text.get<std::string>());
}

inline Vector3 vector(const nlohmann::json& texts) {
  return {number(texts.at(0)), number(texts.at(1)), number(texts.at(2))};
}

inline Quaternion quaternion(const nlohmann::json& texts) {
  return {number(texts.at(0)), number(texts.at(1)), number(texts.at(2)), number(texts.at(3))};
}

inline Matrix3 matrix(const nlohmann::json& rows) {
  Matrix3 R;
  R.row(0) = vector(rows.at(0)).transpose();
  R.row(1) = vector(rows.at(1)).transpose();
  R.row(2) = vector(rows.at(2)).transpose();
  return R;
}

/// The largest difference of two components.
inline Real distance(const Quaternion& a, const Quaternion& b) {
  return std::max(std::max(std::abs(a.w - b.w), std::abs(a.x - b.x)),
                  std::max(std::abs(a.y - b.y), std::abs(a.z - b.z)));
}

/// The same between rotations: q and -q are one.
inline Real distanceOfRotations(const Quaternion& a, const Quaternion& b) {
  return std::min(distance(a, b), distance(a, {-b.w, -b.x, -b.y, -b.z}));
}

/// Of vectors the length of their difference, of matrices the largest difference of two entries.
template <class A, class B>
Real distance(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  if constexpr (A::ColsAtCompileTime == 1) {
    return (a.eval() - b.eval()).norm();
  } else {
    return (a.eval() - b.eval()).cwiseAbs().maxCoeff();
  }
}

inline long double norm(const Quaternion& q) {
  using Long = long double;
  return std::sqrt(Long(q.w) * q.w + Long(q.x) * q.x + Long(q.y) * q.y + Long(q.z) * q.z);
}

/// The angle of the turn that leads from one orientation to another [rad].
inline Real angleBetween(const Quaternion& a, const Quaternion& b) {
  const long double na = norm(a), nb = norm(b);
  const auto chord = [&](int sign) {
    const long double w = a.w / na - sign * b.w / nb, x = a.x / na - sign * b.x / nb;
    const long double y = a.y / na - sign * b.y / nb, z = a.z / na - sign * b.z / nb;
    return std::sqrt(w * w + x * x + y * y + z * z);
  };
  return static_cast<Real>(4 * std::asin(std::min(chord(1), chord(-1)) / 2));
}

/// How far R^T R is from the unit matrix.
inline Real orthogonalityError(const Matrix3& R) {
  return (R.transpose() * R - Matrix3::Identity()).cwiseAbs().maxCoeff();
}

/// Random numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  Real between(Real low, Real high) {
    return low + (high - low) * (static_cast<Real>(engine_() >> 11) * 0x1p-53);
  }
  Vector3 inBox(Real size) {
    const Real x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }
  /// Uniform over all rotations: four numbers in a ball, brought to norm 1.
  Quaternion rotation() {
    for (;;) {
      const Real w = between(-1, 1), x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
      const Real size = std::sqrt(w * w + x * x + y * y + z * z);
      if (size > 0.1 && size < 1) return {w / size, x / size, y / size, z / size};
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rotation_test
