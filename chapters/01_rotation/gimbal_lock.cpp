// What is lost when the pitch comes to a right angle?
//
// Rates of roll, pitch and yaw make an angular velocity through a matrix whose determinant is
// cos(pitch). The program follows that matrix towards the lock, and shows three rings that come to
// lie in one plane.

#include <Eigen/SVD>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <vector>

#include "carom/core/cross.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/euler_rates.hpp"
#include "carom/rotation/euler_to_matrix.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::EulerAngles;
using carom::Matrix3;
using carom::Real;
using carom::Vector3;

constexpr Real kDegree = std::numbers::pi / 180;  // [rad]

//! [rates]
// How large the three rates together must be, for the worst angular velocity of 1 rad/s [rad/s].
Real ratesNeeded(Real pitch) {
  const Matrix3 E = carom::eulerRateMatrix({.roll = 0.2, .pitch = pitch, .yaw = -0.4});
  const Eigen::JacobiSVD<Matrix3> svd(E);
  return 1 / svd.singularValues()(2);
}
//! [rates]

void printRates(std::ostream& out) {
  carom::io::Table table;
  table.column("pitch [deg]", carom::io::significant(9));
  table.column("determinant", carom::io::scientific(3));
  table.column("rates needed [rad/s]", carom::io::scientific(3));
  for (Real degrees : {0.0, 30.0, 60.0, 80.0, 89.0, 89.9, 89.99, 89.9999}) {
    const Matrix3 E = carom::eulerRateMatrix({0.2, degrees * kDegree, -0.4});
    const Real det = E.col(0).dot(carom::cross(E.col(1), E.col(2)));
    table.row({degrees, det, ratesNeeded(degrees * kDegree)});
  }
  out << table;
}

//! [same]
// At pitch 90 degrees only yaw - roll counts: these three are one orientation.
void printLock(std::ostream& out) {
  const Real pitch = 90 * kDegree;
  carom::io::Table table;
  table.column("roll [rad]", carom::io::fixed(1)).column("yaw [rad]", carom::io::fixed(1));
  table.column("distance from the first matrix", carom::io::significant(1));
  const Matrix3 first = carom::eulerToMatrix({0.3, pitch, 0.5});
  for (const EulerAngles& angles : {EulerAngles{0.3, pitch, 0.5}, EulerAngles{0.0, pitch, 0.2},
                                    EulerAngles{-1.0, pitch, -0.8}, EulerAngles{0.3, pitch, 0.6}}) {
    const Real distance = (carom::eulerToMatrix(angles) - first).norm();
    table.row({angles.roll, angles.yaw, distance < 1e-15 ? 0 : distance});
  }
  out << table;
}
//! [same]

// A circle in the plane of two unit vectors.
carom::io::Polyline ring(Real radius, const Vector3& u, const Vector3& v) {
  carom::io::Polyline line;
  for (int i = 0; i <= 64; ++i) {
    const auto [s, c] = carom::sineCosine(2 * std::numbers::pi * i / 64);
    line.points.push_back(radius * (c * u + s * v));
  }
  return line;
}

void record(const std::filesystem::path& file) {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  carom::io::Recording recording(
      "Gimbal lock",
      "Three rings, one inside the other, carry an arrow. The pitch goes to a right angle; then "
      "turning the outer ring and turning the inner one move the arrow in the same way.");
  recording.addBody("yaw ring", ring(1.2, y, z), {.color = carom::io::kBlue});
  recording.addBody("pitch ring", ring(1.1, x, y), {.color = carom::io::kVermilion});
  recording.addBody("roll ring", ring(1.0, x, z), {.color = carom::io::kGreen});
  recording.addBody("arrow", carom::io::Box{Vector3(1.4, 0.12, 0.3)},
                    {.color = carom::io::kOrange});
  recording.addChannel("roll", "rad");
  recording.addChannel("pitch", "rad");
  recording.addChannel("yaw", "rad");
  recording.addChannel("determinant", "");
  for (int i = 0; i <= 480; ++i) {
    const Real t =
        i / 60.0;  // [s]: 0 to 2 pitch, 2 to 5 roll there and back, 5 to 8 yaw there and back
    const auto swing = [](Real s) {
      return s <= 0 || s >= 3 ? 0.0 : carom::sine(2 * std::numbers::pi * s / 3);
    };
    const EulerAngles angles{swing(t - 2), std::min(t / 2, 1.0) * 90 * kDegree, swing(t - 5)};
    const Matrix3 yaw = carom::eulerToMatrix({0, 0, angles.yaw});
    const Matrix3 pitch = carom::eulerToMatrix({0, angles.pitch, angles.yaw});
    const Matrix3 roll = carom::eulerToMatrix(angles);
    const auto pose = [](const Matrix3& R) {
      return carom::io::Pose{Vector3::Zero(), carom::matrixToQuaternion(R)};
    };
    recording.addFrame({t,
                        {pose(yaw), pose(pitch), pose(roll), pose(roll)},
                        {angles.roll, angles.pitch, angles.yaw, carom::cosine(angles.pitch)},
                        {}});
  }
  recording.writeHtml(file);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  std::cout << "How fast the angles must change for an angular velocity of 1 rad/s\n\n";
  printRates(std::cout);
  std::cout << "\nThree sets of angles at pitch 90 degrees, and a fourth one that differs\n\n";
  printLock(std::cout);

  std::vector<Real> degrees, rates;
  for (Real d = 0; d <= 89.5; d += 0.5) {
    degrees.push_back(d);
    rates.push_back(ratesNeeded(d * kDegree));
  }
  carom::io::Plot plot("The price of an angular velocity of 1 rad/s in Euler angles");
  plot.xAxis("pitch [degrees]").yAxis("rates of the angles [rad/s]", carom::io::Scale::Logarithmic);
  plot.curve("worst direction", degrees, rates);
  plot.writeSvg(folder / "gimbal_lock.svg");
  record(folder / "gimbal_lock.html");
}
