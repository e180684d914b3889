#include "carom/toi/toi_rotating.hpp"

#include "grading/fields_toi.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(TimeOfImpact, toiRotating,
           (std::span<const Vector3> a, const Sweep& A, std::span<const Vector3> b, const Sweep& B,
            Real duration, Real tolerance, int maxSteps),
           (a, A, b, B, duration, tolerance, maxSteps))
