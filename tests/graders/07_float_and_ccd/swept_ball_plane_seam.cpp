#include "carom/toi/swept_ball_plane.hpp"

#include "grading/fields_toi.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(TimeOfImpact, sweptBallPlane,
           (const MovingBall& ball, const Vector3& acceleration, const HalfSpace& plane,
            Real duration),
           (ball, acceleration, plane, duration))
