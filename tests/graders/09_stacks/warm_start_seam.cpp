#include "carom/solver/warm_start.hpp"

#include "grading/fields_solver.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(void, warmStart,
           (std::span<MovingBody> bodies, std::span<ContactRow> rows,
            std::span<const KeptImpulse> kept, Real ratio),
           (bodies, rows, kept, ratio))
