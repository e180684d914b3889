#include "carom/precision/compensated_sum.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(Real, compensatedSum, (std::span<const Real> terms), (terms))
