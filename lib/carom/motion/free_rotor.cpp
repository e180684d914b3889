#include "carom/motion/free_rotor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom/core/checks.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/length.hpp"
#include "carom/rotation/conjugate.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/quaternion_exponential.hpp"
#include "carom/rotation/renormalize.hpp"

namespace carom {
namespace {

constexpr Real kPi = std::numbers::pi;

// Near enough to a steady rotation that no double can show the difference: L along the axes across
// is smaller than this share of it.
constexpr Real kSteadyShare = 1e-140;

Real squared(Real x) {
  return x * x;
}

// The root x^(1/2^n).
Real rootOfRoots(Real x, int n) {
  for (int i = 0; i < n; ++i) x = std::sqrt(x);
  return x;
}

}  // namespace

FreeRotor::FreeRotor(const Vector3& moments, const RotorState& anchor, Real time)
    : moments_(moments), anchor_(anchor), time_(time) {
  requireMoments(moments);
  requireUsable(anchor);
  requireFinite(time, "time");
  anchor_.q_WB = renormalize(anchor.q_WB);
  const Vector3& w = anchor.angularVelocity;
  const Vector3 momentum = moments.cwiseProduct(w);
  size_ = length(momentum);
  requireFinite(size_, "angular momentum");

  // 2 E I_j - L^2 for axis j, as a sum of differences of moments: it says on which side of the
  // motion about the middle axis the body is.
  const auto excess = [&](int j) {
    Real sum = 0;
    for (int i = 0; i < 3; ++i) sum += moments[i] * (moments[j] - moments[i]) * w[i] * w[i];
    return sum;
  };
  std::array<int, 3> sorted = {0, 1, 2};
  // Of equal ones the first goes first: a sort that is stable takes memory.
  std::sort(sorted.begin(), sorted.end(), [&](int i, int j) {
    return moments[i] != moments[j] ? moments[i] < moments[j] : i < j;
  });
  // Axis 2 is the middle one, axis 3 the one about which L goes round in the body.
  const bool aboutSmallest = excess(sorted[1]) >= 0;
  axes_ = {sorted[aboutSmallest ? 2 : 0], sorted[1], sorted[aboutSmallest ? 0 : 2]};
  handed_ = (axes_[1] - axes_[0] + 3) % 3 == 1 ? 1 : -1;
  const Real I1 = moments[axes_[0]], I2 = moments[axes_[1]], I3 = moments[axes_[2]];
  const Vector3 L = handed_ * Vector3(momentum[axes_[0]], momentum[axes_[1]], momentum[axes_[2]]);
  const Real D1 = std::abs(excess(axes_[0])), D2 = std::abs(excess(axes_[1])),
             D3 = std::abs(excess(axes_[2]));
  requireFinite(D1, "energy times inertia");
  requireFinite(D3, "energy times inertia");

  const Real across = std::max(std::abs(L[0]), std::abs(L[1]));
  const int zeros = (L[0] == 0) + (L[1] == 0) + (L[2] == 0);
  steady_ = zeros >= 2 || I1 == I3 || across <= kSteadyShare * size_ || D1 == 0 || D3 == 0;
  if (steady_) return;

  // Amplitudes of L, from 2 E and L^2.
  const Real sign = L[2] >= 0 ? 1 : -1;
  amplitudes_ = {std::sqrt(I1 * (D3 / std::abs(I1 - I3))), std::sqrt(I2 * (D3 / std::abs(I2 - I3))),
                 sign * std::sqrt(I3 * (D1 / std::abs(I1 - I3)))};

  // The two rates whose mean is the rate of the phase; the second is zero on the border between
  // motions about the smallest and about the largest axis, where the period is infinite.
  const Real fast = std::sqrt(D1 / I1 * (std::abs(I2 - I3) / (I2 * I3)));
  const Real slow = std::sqrt(D2 / I1 * (std::abs(I1 - I3) / (I2 * I3)));
  const Real k = std::min(std::sqrt(std::abs(I1 - I2) / std::abs(I2 - I3) * (D3 / D1)), 1.0);
  elliptic_ = JacobiElliptic(std::clamp(slow / fast, kSteadyShare, 1.0), k);
  phaseRate_ = (I3 > I1 ? sign : -sign) * fast * elliptic_.mean();
  phase_ = elliptic_.phaseOf(L[1] / amplitudes_[1], L[0] / amplitudes_[0]);

  const Real nu = I3 / I1 * (std::abs(I1 - I2) / std::abs(I2 - I3));
  prepareTurn(k, nu, I3 / I1 * (D1 / D3));
  Real sum = 1, slopeSum = 0;
  for (int n = 1; n <= terms_; ++n) {
    sum += even_[static_cast<std::size_t>(n - 1)];
    slopeSum += n * odd_[static_cast<std::size_t>(n - 1)];
  }
  turnRate_ = size_ / I1 + sign * phaseRate_ * 2 * slopeSum / sum;

  frame_ = hamiltonProduct(anchor_.q_WB, conjugate(poseAt(0).q));
}

// The coefficients of theta_4(z - i x) = 1 + sum of even_n cos 2nz + i odd_n sin 2nz, in which
// even_n +- odd_n = 2 (-1)^n q^(n^2) e^(+-2nx). The nome q and e^x follow from the means, without a
// logarithm: as the modulus goes to zero, q goes to its square over 16, and x to the argument of a
// hyperbolic tangent, both doubling at each mean.
//   k      modulus of the motion
//   slope  sc^2 at the imaginary argument of the turn, I3 D1 / (I1 D3): this is what x stands for
//   nu     slope times k^2, found without it: I3 (I1 - I2) / (I1 (I2 - I3))
void FreeRotor::prepareTurn(Real k, Real nu, Real slope) {
  // With q e^(2x) = r both x and K' - x lead to r; the nearer one is found without loss.
  const bool fromZero = slope * k < 1;
  Real t = fromZero ? std::sqrt(slope / (1 + slope)) : 1 / std::sqrt(1 + nu);
  Real rest = fromZero ? 1 / (1 + slope) : nu / (1 + nu);  // 1 - t^2
  Real c = k;                                              // sqrt(a^2 - b^2) at each mean
  int n = 0;
  for (; n < elliptic_.steps(); ++n) {
    const Real beta = elliptic_.b(n) / elliptic_.a(n);
    const Real below = 1 + beta * t * t;
    rest *= (rest + squared(t * c / elliptic_.a(n))) / squared(below);
    t *= (1 + beta) / below;
    c = c * c / (4 * elliptic_.a(n + 1));
  }
  const Real q = rootOfRoots(squared(c / elliptic_.a(n)) / 16, n);
  const Real shrink = rootOfRoots(rest / squared(1 + t), n);  // e^(-2x), or e^(-2(K' - x))
  const Real r = fromZero ? q / shrink : shrink;
  const Real s = fromZero ? shrink * shrink : (r > 0 ? squared(q / r) : 0);  // e^(-4x)

  Real factor = -r, power = s, qPower = 1;  // (-1)^n q^(n(n-1)) r^n, s^n, q^(2n)
  terms_ = 0;
  while (terms_ < kMostTerms && std::abs(factor) > 1e-19) {
    even_[static_cast<std::size_t>(terms_)] = factor * (1 + power);
    odd_[static_cast<std::size_t>(terms_)] = factor * (1 - power);
    qPower *= q * q;
    factor *= -r * qPower;
    power *= s;
    ++terms_;
  }
}

FreeRotor::Pose FreeRotor::poseAt(Real elapsed) const {
  const Real phase = phase_ + phaseRate_ * elapsed;
  const EllipticFunctions e = elliptic_.at(phase);
  const Vector3 L = amplitudes_.cwiseProduct(Vector3(e.cn, e.sn, e.dn));

  // The theta function, with cos 2nz and sin 2nz by adding angles.
  const SineCosine step = sineCosine(2 * phase);
  Real cosine = 1, sine = 0, real = 1, imaginary = 0;
  for (int n = 0; n < terms_; ++n) {
    const Real next = cosine * step.cosine - sine * step.sine;
    sine = sine * step.cosine + cosine * step.sine;
    cosine = next;
    real += even_[static_cast<std::size_t>(n)] * cosine;
    imaginary += odd_[static_cast<std::size_t>(n)] * sine;
  }
  if (amplitudes_[2] > 0) imaginary = -imaginary;
  const Real size = std::sqrt(real * real + imaginary * imaginary);
  const SineCosine steady = sineCosine(turnRate_ * elapsed);
  const Real c = (steady.cosine * real - steady.sine * imaginary) / size;
  const Real s = (steady.sine * real + steady.cosine * imaginary) / size;

  // The frame of L: z along L, and axis 3 of the body in the half plane of x and z, then turned.
  const Vector3 z = L / length(L);
  const Real across = std::sqrt(z[0] * z[0] + z[1] * z[1]);
  const Vector3 x(-z[2] * (z[0] / across), -z[2] * (z[1] / across), across);
  const Vector3 y(z[1] / across, -z[0] / across, 0);
  const Vector3 turnedX = c * x - s * y, turnedY = s * x + c * y;

  Matrix3 R;
  Vector3 momentum;
  for (int j = 0; j < 3; ++j) {
    const int axis = axes_[static_cast<std::size_t>(j)];
    R.col(axis) = handed_ * Vector3(turnedX[j], turnedY[j], z[j]);
    momentum[axis] = handed_ * L[j];
  }
  return {matrixToQuaternion(R), momentum};
}

RotorState FreeRotor::at(Real time) const {
  requireFinite(time, "time");
  const Real elapsed = time - time_;
  if (steady_) {
    const Quaternion turn = quaternionExponential(anchor_.angularVelocity * elapsed);
    return {renormalize(hamiltonProduct(anchor_.q_WB, turn)), anchor_.angularVelocity};
  }
  const Pose pose = poseAt(elapsed);
  return {renormalize(hamiltonProduct(frame_, pose.q)), pose.momentum.cwiseQuotient(moments_)};
}

Real FreeRotor::period() const {
  return steady_ ? 0 : 2 * kPi / std::abs(phaseRate_);
}

}  // namespace carom
