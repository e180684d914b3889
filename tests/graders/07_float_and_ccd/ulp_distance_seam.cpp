#include "carom/precision/ulp_distance.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(std::uint64_t, ulpDistance, (Real a, Real b), (a, b))
