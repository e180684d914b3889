#include "carom/rotation/hamilton_product.hpp"

#include "grading/fields_rotation.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Quaternion, hamiltonProduct, (const Quaternion& q, const Quaternion& r), (q, r))
