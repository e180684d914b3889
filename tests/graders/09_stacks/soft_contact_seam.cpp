#include "carom/solver/soft_contact.hpp"

#include "grading/fields_solver.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(SoftContact, softContact, (Real frequency, Real dampingRatio, Real dt),
           (frequency, dampingRatio, dt))
