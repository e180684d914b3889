#include "carom/precision/orient2d_filtered.hpp"

#include "grading/fields_precision.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(FilteredSign, orient2dFiltered, (const Vector2& a, const Vector2& b, const Vector2& c),
           (a, b, c))
