#include "carom/toi/swept_balls.hpp"

#include "grading/fields_toi.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(TimeOfImpact, sweptBalls, (const MovingBall& a, const MovingBall& b, Real duration),
           (a, b, duration))
