#include "carom/solver/substep.hpp"

#include "grading/fields_solver.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(void, substep,
           (std::span<MovingBody> bodies, std::span<ContactRow> rows, std::span<Velocity> moved,
            const SubstepPlan& plan),
           (bodies, rows, moved, plan))
