#include "carom/precision/relative_to_origin.hpp"

#include "grading/fields_precision.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, relativeToOrigin, (const CellPosition& position, const CellPosition& origin),
           (position, origin))
