#include "carom/mass/monte_carlo_mass.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(MonteCarloMass, monteCarloMass,
           (const TriangleMesh& mesh, Real density, int samples, std::uint64_t seed),
           (mesh, density, samples, seed))
