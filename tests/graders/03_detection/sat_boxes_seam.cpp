#include "carom/detection/sat_boxes.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(SeparatingAxis, satBoxes, (const Box& a, const Pose& A, const Box& b, const Pose& B),
           (a, A, b, B))
