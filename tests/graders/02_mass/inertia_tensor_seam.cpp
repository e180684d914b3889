#include "carom/mass/inertia_tensor.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(Matrix3, inertiaTensor, (const TriangleMesh& mesh, Real density), (mesh, density))
