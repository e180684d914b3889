#include "carom/mass/center_of_mass.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Vector3, centerOfMass, (const TriangleMesh& mesh), (mesh))
