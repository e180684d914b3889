#include "carom/impulse/apply_impulse.hpp"

#include "grading/fields_impulse.hpp"
#include "grading/seam.hpp"

#if defined(CAROM_SEAM_LAZY)
namespace carom::grading {

// The lazy answer of a function that gives nothing back: it leaves both bodies as they are.
template <>
void lazyAnswer<void>(const OrientedBody&, const Vector3&, const OrientedBody&, const Vector3&,
                      const Vector3&) {}

}  // namespace carom::grading
#endif

CAROM_SEAM(void, applyImpulse,
           (OrientedBody & a, const Vector3& armA, OrientedBody& b, const Vector3& armB,
            const Vector3& impulse),
           (a, armA, b, armB, impulse))
