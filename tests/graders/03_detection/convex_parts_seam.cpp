#include "carom/detection/convex_parts.hpp"

#include "grading/fields_detection.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Verdict, convexParts,
           (std::span<const std::vector<Vector2>> partsA,
            std::span<const std::vector<Vector2>> partsB),
           (partsA, partsB))
