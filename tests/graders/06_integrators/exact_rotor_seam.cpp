#include "carom/motion/exact_rotor.hpp"

#include "grading/fields_motion.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(RotorState, exactRotor,
           (const RoundMoments& moments, const RotorState& start, Real time),
           (moments, start, time))
