// How fast does the error of a method fall when the steps get shorter?
//
// A body cones: its axis moves round a cone, and its angular velocity, measured in its own axes,
// turns with it. Three methods follow it for ten seconds, with more and more steps. The first takes
// the angular velocity at the beginning of each step, the second in the middle, the third at three
// moments.

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "angle_between.hpp"
#include "carom/core/elementary.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/integrate_body_rate.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "turning_errors.hpp"

using carom::Quaternion;
using carom::Real;
using carom::TurningError;
using carom::Vector3;
using carom::io::fixed;
using carom::io::scientific;

namespace {

constexpr Real kHalfAngle = 0.1;  // of the cone [rad]
constexpr Real kRate = 20;        // of the axis round the cone [rad/s]
constexpr Real kDuration = 10;    // [s]

//! [cone]
// Body to world at a time, and the angular velocity in the axes of the body [rad/s].
Quaternion orientation(Real t) {
  const Real s = carom::sine(kHalfAngle / 2);
  return {carom::cosine(kHalfAngle / 2), s * carom::cosine(kRate * t), s * carom::sine(kRate * t),
          0};
}
Vector3 bodyRate(Real t) {
  const Real w = kRate * carom::sine(kHalfAngle);
  const Real s = carom::sine(kHalfAngle / 2);
  return {-w * carom::sine(kRate * t), w * carom::cosine(kRate * t), -2 * kRate * s * s};
}
//! [cone]

//! [methods]
Quaternion beginning(const Quaternion& q, Real t, Real dt) {
  return carom::hamiltonProduct(q, carom::quaternionExponential(bodyRate(t) * dt));
}
Quaternion middle(const Quaternion& q, Real t, Real dt) {
  return carom::hamiltonProduct(q, carom::quaternionExponential(bodyRate(t + dt / 2) * dt));
}
Quaternion threeRates(const Quaternion& q, Real t, Real dt) {
  std::array<Vector3, 3> rates;
  for (std::size_t i = 0; i < 3; ++i) rates[i] = bodyRate(t + carom::kGaussPoints[i] * dt);
  return carom::integrateBodyRate(q, rates, dt);
}
//! [methods]

struct Method {
  std::string name;
  carom::TurningStep step;
  Real order;
};
const std::array<Method, 3> kMethods = {
    {{"beginning", beginning, 1}, {"middle", middle, 2}, {"three rates", threeRates, 6}}};

// The exponent by which the error falls between the last two rows.
Real order(const std::vector<TurningError>& table) {
  const TurningError& a = table[table.size() - 2];
  const TurningError& b = table.back();
  return std::log(a.error / b.error) / std::log(a.dt / b.dt);
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const std::vector<int> counts = {125, 250, 500, 1000, 2000};
  carom::io::Plot plot("Errors after ten seconds on a cone");
  plot.describe(
      "Errors of three methods against the step, on logarithmic axes: three straight lines.");
  plot.xAxis("step [s]", carom::io::Scale::Logarithmic);
  plot.yAxis("error [rad]", carom::io::Scale::Logarithmic);

  std::vector<std::vector<TurningError>> tables;
  for (const Method& method : kMethods) {
    tables.push_back(carom::turningErrors(method.step, orientation(0), orientation(kDuration),
                                          kDuration, counts));
    std::vector<Real> steps, errors;
    for (const TurningError& row : tables.back()) {
      steps.push_back(row.dt);
      errors.push_back(row.error);
    }
    plot.curve(method.name, steps, errors, {.marks = true});
    plot.slope("", method.order, steps.front(), errors.front());
  }

  std::cout << "Error after ten seconds [rad], by the angular velocity that a step takes\n\n";
  carom::io::Table all;
  all.column("steps").column("dt [s]", scientific(3));
  for (const Method& method : kMethods) all.column(method.name, scientific(2));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    all.row(
        {counts[i], tables[0][i].dt, tables[0][i].error, tables[1][i].error, tables[2][i].error});
  }
  std::cout << all << "\nOrder, from the last two rows\n\n";
  carom::io::Table orders;
  orders.column("method").column("order", fixed(2));
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    orders.row({kMethods[m].name, order(tables[m])});
  }

  // Along the way, with the smallest step: does the error grow, or cancel?
  std::cout << orders << "\nError along the way [rad], 2000 steps\n\n";
  carom::io::Table way;
  way.column("time [s]", fixed(1));
  for (const Method& method : kMethods) way.column(method.name, scientific(2));
  std::array<Quaternion, 3> q = {orientation(0), orientation(0), orientation(0)};
  const int steps = counts.back();
  for (int i = 0; i < steps; ++i) {
    const Real dt = kDuration / steps;
    for (std::size_t m = 0; m < kMethods.size(); ++m) q[m] = kMethods[m].step(q[m], i * dt, dt);
    if ((i + 1) % (steps / 5) != 0) continue;
    const Quaternion exact = orientation((i + 1) * dt);
    way.row({(i + 1) * dt, carom::angleBetween(exact, q[0]), carom::angleBetween(exact, q[1]),
             carom::angleBetween(exact, q[2])});
  }
  std::cout << way;
  plot.writeSvg(folder / "order_of_turning.svg");
}
