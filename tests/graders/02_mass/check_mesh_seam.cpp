#include "carom/mass/check_mesh.hpp"

#include "grading/fields_mass.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<MeshProblem>, checkMesh, (const TriangleMesh& mesh), (mesh))
