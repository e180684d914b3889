#include "carom/detection/ball_ball.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(BallGap, ballBall,
           (const Vector3& centerA, Real radiusA, const Vector3& centerB, Real radiusB),
           (centerA, radiusA, centerB, radiusB))
