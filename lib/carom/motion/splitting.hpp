#pragma once
// How few looks at the force will do, if drifts and kicks may be of any lengths?
//
// Method: drift, kick, drift, kick, ... as in composition.hpp, but the lengths need not be those of
// whole steps of Verlet. Because the energy of motion is a square of the velocity, some of the
// errors that a composition has to cancel are zero by themselves; the freedom that is left over is
// used to make the others small.
// Why: for the same number of forces the errors are ten to a thousand times smaller than those of
// compositions of that order. Symplectic and reversible as they are.
// Why many steps at once: a step that ends with a kick ends where the next one begins with one. The
// two are one, and so is the look at the force.
// Source: Blanes and Moan, Journal of Computational and Applied Mathematics 142, 2002, the methods
// SRKN6b and SRKN14a.
// Not handled: forces that depend on the velocity; energies of motion that are no square.

#include <array>
#include <span>

#include "carom/core/real.hpp"

namespace carom {

/// A way to take turns between two motions. One of the lists has one part more than the other: it
/// begins and ends the step. Each list adds up to one, and reads the same backwards.
/// \ingroup motion
struct Splitting {
  std::span<const Real> drifts;  ///< lengths of the motions without force, in units of dt [1]
  std::span<const Real> kicks;   ///< lengths of the changes of velocity, in units of dt [1]
};

/// The numbers of the splittings below. \ingroup motion
namespace splitting_lengths {

/// Order 4. \ingroup motion
inline constexpr std::array<Real, 6> kDrifts4 = {0.245298957184271,  0.604872665711080,
                                                 -0.350171622895351, -0.350171622895351,
                                                 0.604872665711080,  0.245298957184271};
/// Order 4. \ingroup motion
inline constexpr std::array<Real, 7> kKicks4 = {
    0.0829844064174052,  0.396309801498368, -0.0390563049223486, 0.1195241940131508,
    -0.0390563049223486, 0.396309801498368, 0.0829844064174052};
/// Order 6. \ingroup motion
inline constexpr std::array<Real, 15> kDrifts6 = {
    0.0378593198406116,   0.102635633102435, -0.0258678882665587,  0.314241403071447,
    -0.130144459517415,   0.106417700369543, -0.00879424312851058, 0.20730506905689536,
    -0.00879424312851058, 0.106417700369543, -0.130144459517415,   0.314241403071447,
    -0.0258678882665587,  0.102635633102435, 0.0378593198406116};
/// Order 6. \ingroup motion
inline constexpr std::array<Real, 14> kKicks6 = {
    0.09171915262446165, 0.183983170005006,  -0.05653436583288827,  0.004914688774712854,
    0.143761127168358,   0.328567693746804,  -0.196411466486454234, -0.196411466486454234,
    0.328567693746804,   0.143761127168358,  0.004914688774712854,  -0.05653436583288827,
    0.183983170005006,   0.09171915262446165};

}  // namespace splitting_lengths

/// Order 4, six forces a step. \ingroup motion
inline constexpr Splitting kBlanesMoan4 = {splitting_lengths::kDrifts4, splitting_lengths::kKicks4};

/// Order 6, fourteen forces a step. \ingroup motion
inline constexpr Splitting kBlanesMoan6 = {splitting_lengths::kDrifts6, splitting_lengths::kKicks6};

/// Takes turns between any two motions for many steps. Where two parts of the same kind meet, at the
/// end of a step, they become one.
/// \tparam Drift called as drift(length) [s]
/// \tparam Kick called as kick(length, done) with the sum of all drifts before [s]
/// \param method the lengths
/// \param dt length of a step; negative runs backwards [s]
/// \param count how many steps; nothing happens for zero or less
/// \param drift does the motion without force
/// \param kick does the change of velocity
/// \ingroup motion
template <class Drift, class Kick>
void takeTurns(const Splitting& method, Real dt, int count, Drift&& drift, Kick&& kick) {
  if (count <= 0) return;
  const auto &a = method.drifts, &b = method.kicks;
  const bool kicksFirst = b.size() > a.size();
  const std::size_t last = kicksFirst ? a.size() : b.size();
  if (kicksFirst) {
    kick(b[0] * dt, Real(0));
  } else {
    drift(a[0] * dt);
  }
  for (int step = 0; step < count; ++step) {
    Real done = kicksFirst ? 0 : a[0];  // drifts in this step [1]
    for (std::size_t i = 1; i <= last; ++i) {
      const bool joins = i == last && step + 1 < count;
      if (kicksFirst) {
        drift(a[i - 1] * dt);
        done += a[i - 1];
        kick((joins ? b[last] + b[0] : b[i]) * dt, (step + done) * dt);
      } else {
        kick(b[i - 1] * dt, (step + done) * dt);
        drift((joins ? a[last] + a[0] : a[i]) * dt);
        done += a[i];
      }
    }
  }
}

/// Steps positions and velocities, in place. It allocates nothing that `acceleration` does not.
/// \tparam V a number or a vector: anything that can be multiplied by a Real and added
/// \tparam Force called as acceleration(time, position), answers something that converts to V
/// \param position at the start; is changed to that at the end [m]
/// \param velocity at the start; is changed to that at the end [m/s]
/// \param time at the start [s]
/// \param dt length of a step; negative runs backwards [s]
/// \param count how many steps
/// \param method the lengths, for example kBlanesMoan6
/// \param acceleration a(t, x) [m/s^2]
/// \ingroup motion
template <class V, class Force>
void splitSteps(V& position, V& velocity, Real time, Real dt, int count, const Splitting& method,
                Force&& acceleration) {
  takeTurns(
      method, dt, count, [&](Real h) { position += h * velocity; },
      [&](Real h, Real done) { velocity += h * acceleration(time + done, position); });
}

}  // namespace carom
