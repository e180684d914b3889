#include "carom/detection/aabb_overlap.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Verdict, aabbOverlap, (const Aabb<3>& a, const Aabb<3>& b), (a, b))
