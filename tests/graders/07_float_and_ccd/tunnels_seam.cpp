#include "carom/toi/tunnels.hpp"

#include "grading/seam.hpp"

CAROM_SEAM(bool, tunnels, (Real lengthA, Real lengthB, Real speed, Real dt),
           (lengthA, lengthB, speed, dt))
