#include "monte_carlo_error.hpp"

#include "grading/seam.hpp"
#include "monte_carlo_error_fields.hpp"

CAROM_SEAM(std::vector<DartError>, monteCarloError,
           (const TriangleMesh& mesh, std::span<const int> sampleCounts, int seeds),
           (mesh, sampleCounts, seeds))
