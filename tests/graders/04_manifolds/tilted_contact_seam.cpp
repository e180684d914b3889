#include "tilted_contact.hpp"

#include "grading/seam.hpp"
#include "tilted_contact_fields.hpp"

CAROM_SEAM(std::vector<TiltedContact>, tiltedContact,
           (Real halfWidth, Real depth, std::span<const Real> tilts), (halfWidth, depth, tilts))
