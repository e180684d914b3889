#include "carom/mass/signed_volume.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Real, signedVolume, (const TriangleMesh& mesh), (mesh))
