#pragma once
// Reference values of group D from tests/cases/detection.json, random numbers that are the same on
// every machine, and random bodies.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "carom/core/real.hpp"
#include "carom/detection/pose.hpp"

namespace carom_test {

using nlohmann::json;

// One case of group D. Numbers are strings, so that no digit is lost on the way.
inline json detectionCase(const std::string& id) {
  std::ifstream file(std::string(CAROM_CASES_DIR) + "/detection.json");
  return json::parse(file).at(id);
}

inline double readNumber(const json& value) {
  return std::strtod(value.get<std::string>().c_str(), nullptr);
}

inline carom::Vector3 readVector(const json& value) {
  return {readNumber(value.at(0)), readNumber(value.at(1)), readNumber(value.at(2))};
}

inline carom::Matrix3 readMatrix(const json& value) {
  carom::Matrix3 m;
  for (int i = 0; i < 3; ++i) m.row(i) = readVector(value.at(static_cast<std::size_t>(i)));
  return m;
}

// The generator of the case book: a 64-bit linear congruence, of which the top 31 bits count.
class CaseNumbers {
 public:
  explicit CaseNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ = 6364136223846793005u * state_ + 1442695040888963407u;
    return state_ >> 33;
  }
  // In [low, high), in steps of 2^-31 of the range.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next()) * 0x1p-31);
  }
  carom::Vector3 vectorBetween(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return {x, y, z};
  }
  // All directions equally likely.
  carom::Vector3 direction() {
    while (true) {
      const carom::Vector3 v = vectorBetween(-1, 1);
      if (v.squaredNorm() < 1 && v.squaredNorm() > 0.01) return v.normalized();
    }
  }
  // Any orientation, position within a cube of half side `reach`.
  carom::Pose pose(double reach) {
    while (true) {
      const double w = between(-1, 1), x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
      const double squared = w * w + x * x + y * y + z * z;
      if (squared < 1 && squared > 0.01) {
        return carom::poseOf({w, x, y, z}, vectorBetween(-reach, reach));
      }
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace carom_test
