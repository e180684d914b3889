// Grader of 01.turning_errors: methods whose error is known beforehand (one that does nothing, one that
// turns by the same angle whenever it is called), a note of every call, and three methods of known
// order on a coning motion, whose orientation has a closed form.

#include "turning_errors.hpp"

#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "grading/grade.hpp"
#include "turning_errors_fields.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Quaternion kNone{1, 0, 0, 0};

Quaternion aboutZ(Real angle) {
  return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
}

// A method that turns by a fixed angle about z, however long the step is.
TurningStep turnsBy(Real angle) {
  return [angle](const Quaternion& q, Real, Real) { return hamiltonProduct(aboutZ(angle), q); };
}

// --- A cone: the axis of the body moves round a cone of half angle a, at W rad/s.
constexpr Real kA = 0.1;
constexpr Real kW = 20;

Quaternion coneAt(Real t) {
  const Real s = std::sin(kA / 2);
  return {std::cos(kA / 2), s * std::cos(kW * t), s * std::sin(kW * t), 0};
}
// Angular velocity in the axes of the body [rad/s].
Vector3 coneRate(Real t) {
  const Real s = std::sin(kA / 2);
  return {-kW * std::sin(kA) * std::sin(kW * t), kW * std::sin(kA) * std::cos(kW * t),
          -2 * kW * s * s};
}

Quaternion turnedBy(const Quaternion& q, const Vector3& rate, Real dt) {
  return hamiltonProduct(q, quaternionExponential(rate * dt));
}
Quaternion rateAtBeginning(const Quaternion& q, Real t, Real dt) {
  return turnedBy(q, coneRate(t), dt);
}
Quaternion rateInTheMiddle(const Quaternion& q, Real t, Real dt) {
  return turnedBy(q, coneRate(t + dt / 2), dt);
}
// Two Gauss points and the swing between them: the Magnus expansion to order four.
Quaternion twoRates(const Quaternion& q, Real t, Real dt) {
  const Real first = 0.5 - std::sqrt(3.0) / 6;
  const Vector3 early = coneRate(t + first * dt), late = coneRate(t + (1 - first) * dt);
  const Vector3 swing = std::sqrt(3.0) / 12 * dt * cross(early, late);
  return turnedBy(q, (early + late) / 2 + swing, dt);
}

constexpr Real kDuration = 0.7;  // [s], not a whole number of rounds
using Counts = std::vector<int>;

std::vector<TurningError> measured(const TurningStep& step, const Counts& counts) {
  return turningErrors(step, coneAt(0), coneAt(kDuration), kDuration, counts);
}

// The exponent p of error = c dt^p: slope of the straight line through the logarithms.
Real order(const std::vector<TurningError>& table) {
  Real sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
  const Real n = static_cast<Real>(table.size());
  for (const auto& row : table) {
    const Real x = std::log(row.dt), y = std::log(row.error);
    sumX += x;
    sumY += y;
    sumXX += x * x;
    sumXY += x * y;
  }
  return (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
}

std::vector<Real> column(const std::vector<TurningError>& table, Real TurningError::*which) {
  std::vector<Real> numbers;
  for (const auto& row : table) numbers.push_back(row.*which);
  return numbers;
}
std::vector<int> stepsOf(const std::vector<TurningError>& table) {
  std::vector<int> numbers;
  for (const auto& row : table) numbers.push_back(row.steps);
  return numbers;
}

// The times and the steps that a method is called with, one after the other.
std::vector<Real> callsOf(Real duration, const Counts& counts) {
  std::vector<Real> calls;
  const TurningStep note = [&calls](const Quaternion& q, Real time, Real dt) {
    calls.push_back(time);
    calls.push_back(dt);
    return q;
  };
  turningErrors(note, kNone, kNone, duration, counts);
  return calls;
}

std::vector<Real> errorsOf(const TurningStep& step, const Quaternion& start, const Quaternion& end,
                           const Counts& counts) {
  return column(turningErrors(step, start, end, 1, counts), &TurningError::error);
}

}  // namespace

TEST_CASE("rows") {
  const Counts counts{4, 1, 10, 5};
  GRADE(stepsOf(turningErrors(turnsBy(0.1), kNone, kNone, 2, counts)), counts,
        within(0, "counts are whole numbers"), given("counts", counts),
        about("the column 'steps' of the table"));
  GRADE(column(turningErrors(turnsBy(0.1), kNone, kNone, 2, counts), &TurningError::dt),
        (std::vector<Real>{0.5, 2, 0.2, 0.4}), within(1e-15, "one division"),
        given("duration", 2.0, "s"), given("counts", counts), unit("s"),
        about("the column 'dt' of the table"));
}

TEST_CASE("times") {
  const Counts two{2, 4};
  GRADE(callsOf(2, two), (std::vector<Real>{0, 1, 1, 1, 0, 0.5, 0.5, 0.5, 1, 0.5, 1.5, 0.5}),
        within(1e-14, "i times dt, rounded once"), given("duration", 2.0, "s"),
        given("counts", two), unit("s"),
        about("time and dt of every call of the method, in order"));
  const Counts one{1};
  GRADE(callsOf(3, one), (std::vector<Real>{0, 3}), within(1e-14, "i times dt, rounded once"),
        given("duration", 3.0, "s"), given("counts", one), unit("s"),
        about("time and dt of every call of the method, in order"));
}

TEST_CASE("error") {
  const Counts counts{1, 2, 5, 10};
  GRADE(
      errorsOf(turnsBy(0.1), kNone, kNone, counts), (std::vector<Real>{0.1, 0.2, 0.5, 1}),
      within(1e-14, "ten products of quaternions"), given("counts", counts), unit("rad"),
      about(
          "errors of a method that turns by 0.1 rad in every step, when the body should not turn"));
  const Quaternion end = aboutZ(0.7);
  GRADE(errorsOf(turnsBy(0), kNone, end, counts), (std::vector<Real>{0.7, 0.7, 0.7, 0.7}),
        within(1e-14, "ten products of quaternions"), given("end", end), given("counts", counts),
        unit("rad"), about("errors of a method that never turns, when the body turns by 0.7 rad"));
  const Quaternion other{-end.w, -end.x, -end.y, -end.z};
  GRADE(errorsOf(turnsBy(0.2), kNone, other, counts), (std::vector<Real>{0.5, 0.3, 0.3, 1.3}),
        within(1e-14, "ten products of quaternions"), given("end", other), given("counts", counts),
        unit("rad"),
        about("errors of a method that turns by 0.2 rad in every step, when the body turns by 0.7 "
              "rad; q and -q are the same orientation"));
}

TEST_CASE("order") {
  const Counts counts{40, 80, 160, 320};
  constexpr const char* kWhy = "the next power of dt still shows at the longest step";
  GRADE(order(measured(rateAtBeginning, counts)), 1, within(0.1, kWhy), given("counts", counts),
        about("the slope of the errors when each step takes the rate at its beginning"));
  GRADE(order(measured(rateInTheMiddle, counts)), 2, within(0.1, kWhy), given("counts", counts),
        about("the slope of the errors when each step takes the rate in its middle"));
  GRADE(order(measured(twoRates, counts)), 4, within(0.15, kWhy), given("counts", counts),
        about("the slope of the errors of a method of order four"));
}

PROBES() {
  const Counts counts{3, 1, 7, 20};
  for (const Real angle : {0.05, -0.11}) {
    PROBE(turningErrors(turnsBy(angle), kNone, aboutZ(0.3), 2, counts));
  }
  PROBE(measured(rateAtBeginning, counts));
  PROBE(measured(rateInTheMiddle, counts));
  // An error that only a careful instrument sees; alone, or beside larger numbers it would not show.
  PROBE(errorsOf(turnsBy(1e-10), kNone, kNone, {7}).at(0));
}
