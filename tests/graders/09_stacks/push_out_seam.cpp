#include "push_out.hpp"

#include "grading/fields_solver.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<Velocity>, pushOut,
           (std::span<const MovingBody> bodies, std::span<const ContactRow> rows, Real share,
            int sweeps),
           (bodies, rows, share, sweeps))
