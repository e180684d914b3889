#include "energy_drift.hpp"

#include "energy_drift_fields.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<EnergyDrift>, energyDrift,
           (StepMethod method, std::span<const Real> lengths, int steps), (method, lengths, steps))
