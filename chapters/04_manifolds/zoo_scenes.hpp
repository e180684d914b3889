#pragma once
// Fifteen pairs of bodies, one on the other.

#include <string>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/detection/shapes.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/rotation/hamilton_product.hpp"
#include "carom_io/recorder.hpp"

/// The scenes of the program manifold_zoo.
namespace zoo {

using carom::Quaternion;
using carom::Real;
using carom::Vector3;

inline constexpr Real kDeep = 0.01;                 ///< how deep B is in A [m]
inline constexpr Real kHalf = 0.3;                  ///< half edges and radii [m]
inline constexpr Real kRoot2 = 1.4142135623730951;  ///< the diagonal of a square of 1 m [m]
inline constexpr Real kRoot3 = 1.7320508075688772;  ///< the diagonal of a cube of 1 m [m]

/// A kind of body.
struct Kind {
  std::string name;          ///< what it is called
  carom::Shape shape;        ///< what collides
  carom::io::Shape picture;  ///< what is drawn
};

/// One body on another.
struct Scene {
  std::string how;        ///< B is on A
  Kind a;                 ///< below
  Kind b;                 ///< above
  Real height;            ///< of B's origin over the top of A, if they only touched [m]
  Quaternion turnA = {};  ///< orientation of A, world from body
  Quaternion turnB = {};  ///< orientation of B, world from body
  Real top = 0;           ///< of A over its origin [m]
  Real slide = 0.2;       ///< how far B moves about in the picture [m]
};

/// The fifteen pairs. \return the pairs, in the order of the table
inline std::vector<Scene> scenes() {
  const Kind ball{"ball", carom::makeBall(kHalf), carom::io::Ball{kHalf}};
  const Kind box{"box", carom::makeBox({kHalf, kHalf, kHalf}), carom::io::Box{{0.6, 0.6, 0.6}}};
  const Kind slab{"slab", carom::makeBox({0.7, 0.7, 0.2}), carom::io::Box{{1.4, 1.4, 0.4}}};
  const Kind capsule{"capsule", carom::makeCapsule(0.2, 0.3), carom::io::Capsule{0.2, 0.6}};
  const Kind cylinder{"cylinder", carom::makeCylinder(kHalf, 0.25),
                      carom::io::Cylinder{kHalf, 0.5}};
  const std::vector<Vector3> four = {{0.5, 0, 0}, {-0.3, 0.4, 0}, {-0.3, -0.4, 0}, {0, 0, 0.6}};
  const Kind gem{"hull", carom::hullOfPoints(four),
                 carom::io::Mesh{carom::tetrahedronMesh(four[0], four[1], four[2], four[3])}};
  const Vector3 leg(0.1, 0.3, 0.2), left(-0.4, 0, 0), right(0.4, 0, 0);
  const Kind legs{"two legs",
                  carom::makeCompound({{carom::makeBox(leg), {carom::Matrix3::Identity(), left}},
                                       {carom::makeBox(leg), {carom::Matrix3::Identity(), right}}}),
                  carom::io::Mesh{carom::joined(carom::boxMesh(left - leg, left + leg),
                                                carom::boxMesh(right - leg, right + leg))}};
  const Kind floor{"half-space", carom::makeHalfSpace(Vector3::UnitZ(), Vector3::Zero()),
                   carom::io::Plane{1.8, 0.3}};

  const auto about = [](const Vector3& axis, Real angle) {
    const auto [s, c] = carom::sineCosine(angle / 2);
    return Quaternion{c, s * axis.x(), s * axis.y(), s * axis.z()};
  };
  constexpr Real eighth = 0.78539816339744831;  // of a turn [rad]
  const Quaternion level,
      x45 = about(Vector3::UnitX(), eighth), y45 = about(Vector3::UnitY(), eighth),
      y90 = about(Vector3::UnitY(), 2 * eighth), z45 = about(Vector3::UnitZ(), eighth);
  const Quaternion corner =
      carom::hamiltonProduct(about(Vector3::UnitY(), carom::arctangent(1 / kRoot2)), x45);
  return {{"on a point", floor, ball, kHalf},
          {"flat", floor, box, kHalf},
          {"on a corner", floor, box, kRoot3 * kHalf, level, corner},
          {"lying", floor, cylinder, kHalf, level, y90},
          {"lying", slab, capsule, 0.2, level, y90, 0.2},
          {"on an edge", slab, box, kRoot2 * kHalf, level, x45, 0.2},
          {"flat, turned", slab, box, kHalf, level, z45, 0.2},
          {"flat", slab, gem, 0, level, level, 0.2},
          {"standing", slab, cylinder, 0.25, level, level, 0.2},
          {"standing", slab, legs, 0.2, level, level, 0.2},
          {"flat, turned", box, box, kHalf, level, z45, kHalf, 0},
          {"edge on edge", box, box, kRoot2 * kHalf, y45, x45, kRoot2 * kHalf, 0},
          {"on a line", capsule, ball, kHalf, y90, level, 0.2, 0},
          {"standing", cylinder, cylinder, 0.25, level, level, 0.25},
          {"on a ball", ball, box, kHalf, level, level, kHalf, 0}};
}

}  // namespace zoo
