#include "carom/solver/lcp_small.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(std::vector<Real>, lcpSmall,
           (std::span<const Real> matrix, std::span<const Real> speeds), (matrix, speeds))
