#pragma once
// How a row of the measurement crosses the pipe, and how methods are worded in a message.

#include <string>

#include "energy_drift.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<EnergyDrift> {
  static constexpr auto list = fieldList("dt", &EnergyDrift::dt, "largest", &EnergyDrift::largest,
                                         "drift", &EnergyDrift::drift);
};

/// The method as words, so that a message can be read.
inline std::string inWords(StepMethod method) {
  switch (method) {
    case StepMethod::kExplicitEuler:
      return "explicit Euler";
    case StepMethod::kSemiImplicitEuler:
      return "semi-implicit Euler";
    case StepMethod::kVelocityVerlet:
      return "velocity Verlet";
    case StepMethod::kRk4:
      return "RK4";
  }
  return "no method";
}

}  // namespace carom::grading
