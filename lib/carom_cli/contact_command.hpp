#pragma once
// `carom contact A B`: do two mesh files touch, and where?

#include <string>
#include <vector>

/// The program `carom`.
namespace carom::cli {

/// What `carom contact` was asked for. \ingroup cli
struct ContactRequest {
  std::string fileA;          ///< path of the first mesh file
  std::string fileB;          ///< path of the second mesh file
  std::vector<double> poseA;  ///< nothing, or x y z [m], or x y z and a quaternion w x y z
  std::vector<double> poseB;  ///< the same for B
  bool json = false;          ///< one JSON object instead of text
};

/// Prints whether two solids overlap, their signed distance, the normal from A to B and the points
/// of contact; problems go to standard error.
///
/// A file holds one convex solid, or several that do not share a vertex: the parts of a compound.
/// \param request what was asked for
/// \return exit code: 0, or 1 when a file cannot be read, or a part is no convex solid
/// \ingroup cli
int runContact(const ContactRequest& request);

}  // namespace carom::cli
