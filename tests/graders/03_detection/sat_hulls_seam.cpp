#include "carom/detection/sat_hulls.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(SeparatingAxis, satHulls,
           (const ConvexHull& a, const Pose& A, const ConvexHull& b, const Pose& B), (a, A, b, B))
