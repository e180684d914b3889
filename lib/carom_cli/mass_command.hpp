#pragma once
// `carom mass FILE`: what a mesh file weighs, and what is wrong with it.

#include <string>

/// \defgroup cli The program carom
/// What the library does, from a shell.

/// The program `carom`.
namespace carom::cli {

/// The ways of weighing a mesh. \ingroup cli
enum class MassMethod {
  Tetrahedra,  ///< signed tetrahedra: exact up to rounding
  MonteCarlo,  ///< random points in the bounding box, always the same ones
  Surface,     ///< the centre of the skin, which is not that of the solid
};

/// What `carom mass` was asked for. \ingroup cli
struct MassRequest {
  std::string file;                            ///< path of the mesh file
  double density = 1;                          ///< [kg/m^3]; 1 unless given: mass is volume
  MassMethod method = MassMethod::Tetrahedra;  ///< how to weigh
  bool json = false;                           ///< one JSON object instead of text
  bool selfIntersections = true;               ///< refuse a surface that cuts or touches itself
};

/// Weighs a mesh file and prints the result to standard output, problems to standard error.
/// \param request what was asked for; the density is finite and positive
/// \return exit code: 0, or 1 when the file cannot be read or the mesh is no solid
/// \ingroup cli
int runMass(const MassRequest& request);

}  // namespace carom::cli
