// What do a million steps of turning do to a rotation?
//
// A body turns with a constant angular velocity for 1000 s in steps of 1 ms. Five ways to make a
// step are compared with the closed form: how far the orientation is off, and how far it has left
// the set of rotations.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/rotation/axis_angle_to_matrix.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_orientation.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/orthonormalize.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"

using carom::Matrix3;
using carom::Quaternion;
using carom::Real;
using carom::Vector3;

constexpr Real kStep = 1e-3;             // [s]
constexpr int kDecades = 6;              // a million steps
const Vector3 kOmega(0.6, -0.48, 0.64);  // [rad/s, world]: length 1.0

//! [steps]
// The sum that a beginner writes: q + dt/2 omega q.
Quaternion naiveStep(const Quaternion& q) {
  const Quaternion rate = carom::hamiltonProduct({0, kOmega.x(), kOmega.y(), kOmega.z()}, q);
  const Real h = kStep / 2;
  return {q.w + h * rate.w, q.x + h * rate.x, q.y + h * rate.y, q.z + h * rate.z};
}

// The product that is exact for a constant angular velocity, and nothing after it.
Quaternion productStep(const Quaternion& q) {
  return carom::hamiltonProduct(carom::quaternionExponential(kOmega * kStep), q);
}
//! [steps]

// Angle between an orientation, made a rotation first, and the closed form after a time [rad].
Real angleError(const Quaternion& q, Real time) {
  const Quaternion exact = carom::quaternionExponential(kOmega * time);
  const Quaternion difference =
      carom::hamiltonProduct(carom::renormalize(q), carom::conjugate(exact));
  return carom::quaternionLogarithm(difference).norm();
}

Real normError(const Quaternion& q) {
  return std::abs(std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) - 1);
}

struct Track {
  std::string name;
  std::vector<Real> off = {};    // how far from being a rotation, after 1, 10, 100, ... steps
  std::vector<Real> angle = {};  // how far from the closed form [rad]
};

template <class State, class Step, class Off, class Orientation>
Track follow(const char* name, State state, Step step, Off off, Orientation orientation) {
  Track track{name};
  int next = 1;
  for (int i = 1; i <= 1000000; ++i) {
    state = step(state);
    if (i == next) {
      track.off.push_back(off(state));
      track.angle.push_back(angleError(orientation(state), i * kStep));
      next *= 10;
    }
  }
  return track;
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const auto same = [](const Quaternion& q) { return q; };
  const Matrix3 turn = carom::axisAngleToMatrix(kOmega, kOmega.norm() * kStep);
  const auto matrixError = [](const Matrix3& R) {
    return (R.transpose() * R - Matrix3::Identity()).norm();
  };
  const auto fromMatrix = [](const Matrix3& R) {
    return carom::matrixToQuaternion(carom::orthonormalize(R));
  };
  const std::vector<Track> tracks = {
      follow("sum", Quaternion{}, naiveStep, normError, same),
      follow(
          "sum, renormalised", Quaternion{},
          [](const Quaternion& q) { return carom::renormalize(naiveStep(q)); }, normError, same),
      follow("product", Quaternion{}, productStep, normError, same),
      follow(
          "product, renormalised", Quaternion{},
          [](const Quaternion& q) { return carom::integrateOrientation(q, kOmega, kStep); },
          normError, same),
      follow(
          "matrix product", Matrix3(Matrix3::Identity()),
          [&turn](const Matrix3& R) { return Matrix3(turn * R); }, matrixError, fromMatrix)};

  carom::io::Table table;
  table.column("way").column("off after 1e3", carom::io::scientific(0));
  table.column("off after 1e6", carom::io::scientific(0));
  table.column("angle after 1e3 [rad]", carom::io::scientific(0));
  table.column("angle after 1e6 [rad]", carom::io::scientific(0));
  std::vector<Real> steps;
  for (Real n = 1; n < 2e6; n *= 10) steps.push_back(n);
  carom::io::Plot plot("A million steps of turning");
  plot.xAxis("steps of 1 ms", carom::io::Scale::Logarithmic);
  plot.yAxis("distance from being a rotation", carom::io::Scale::Logarithmic);
  for (const Track& track : tracks) {
    table.row(
        {track.name, track.off[3], track.off[kDecades], track.angle[3], track.angle[kDecades]});
    std::vector<Real> shown = track.off;
    for (Real& value : shown) value = std::max(value, 1e-17);  // a logarithmic axis has no zero
    plot.curve(track.name, steps, shown, {.marks = true});
  }
  std::cout << table;
  plot.writeSvg(folder / "spin_drift.svg");
}
