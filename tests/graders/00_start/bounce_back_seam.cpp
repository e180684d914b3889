#include "bounce_back.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(Real, restitutionForHeight, (Real dropHeight, Real returnHeight),
           (dropHeight, returnHeight))
