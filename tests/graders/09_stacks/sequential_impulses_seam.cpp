#include "carom/solver/sequential_impulses.hpp"

#include "grading/fields_solver.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(void, sequentialImpulses,
           (std::span<MovingBody> bodies, std::span<ContactRow> rows, int sweeps),
           (bodies, rows, sweeps))
