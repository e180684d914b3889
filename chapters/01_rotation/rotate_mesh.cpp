// Do four ways to write one rotation do the same to a mesh?
//
// A bottle is turned by Euler angles, by axis and angle, by a quaternion, and by the quaternion's
// matrix; the corners must agree. Then slerp() turns it slowly, and the source's matrix shows what
// a wrong entry looks like.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <vector>

#include "carom/core/elementary.hpp"
#include "carom/mass/meshes.hpp"
#include "carom/mass/signed_volume.hpp"
#include "carom/rotation/axis_angle_to_matrix.hpp"
#include "carom/rotation/euler_to_matrix.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/quaternion_logarithm.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom/rotation/slerp.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::EulerAngles;
using carom::Matrix3;
using carom::Quaternion;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector3;

TriangleMesh bottle() {
  const std::vector<carom::Vector2> profile = {{0, -0.5},  {0.28, -0.5}, {0.3, -0.4}, {0.3, 0.1},
                                               {0.1, 0.3}, {0.1, 0.5},   {0, 0.5}};
  return carom::latheMesh(profile, 24);
}

template <class Map>
TriangleMesh mapped(TriangleMesh mesh, Map map) {
  for (Vector3& vertex : mesh.vertices) vertex = map(vertex);
  return mesh;
}

Real largestDistance(const TriangleMesh& a, const TriangleMesh& b) {
  Real largest = 0;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    largest = std::max(largest, (a.vertices[i] - b.vertices[i]).norm());
  }
  return largest;
}

//! [source]
// Equation (2) of the source, its first entry cos(yaw) sin(pitch) instead of cos(yaw) cos(pitch).
Matrix3 sourceMatrix(const EulerAngles& angles) {
  Matrix3 R = carom::eulerToMatrix(angles);
  R(0, 0) = carom::cosine(angles.yaw) * carom::sine(angles.pitch);
  return R;
}
//! [source]

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const TriangleMesh mesh = bottle();

  //! [four]
  const EulerAngles angles{.roll = 0.9, .pitch = -0.5, .yaw = 1.2};
  const Matrix3 R = carom::eulerToMatrix(angles);
  const Quaternion q = carom::matrixToQuaternion(R);
  const Vector3 rotation = carom::quaternionLogarithm(q);  // axis times angle [rad]
  const Matrix3 rodrigues = carom::axisAngleToMatrix(rotation, rotation.norm());
  const Matrix3 fromQuaternion = carom::quaternionToMatrix(q);
  //! [four]

  const TriangleMesh byEuler = mapped(mesh, [&](const Vector3& v) { return Vector3(R * v); });
  carom::io::Table table;
  table.column("way").column("volume [m^3]", carom::io::fixed(12));
  table.column("farthest corner from the first way [m]", carom::io::fixed(12));
  const auto add = [&](const char* way, const TriangleMesh& turned) {
    table.row({way, carom::signedVolume(turned), largestDistance(turned, byEuler)});
  };
  add("Euler angles", byEuler);
  add("axis and angle", mapped(mesh, [&](const Vector3& v) { return Vector3(rodrigues * v); }));
  add("quaternion", mapped(mesh, [&](const Vector3& v) { return carom::rotatePoint(q, v); }));
  add("matrix of the quaternion",
      mapped(mesh, [&](const Vector3& v) { return Vector3(fromQuaternion * v); }));
  add("the source's matrix (2)",
      mapped(mesh, [&](const Vector3& v) { return Vector3(sourceMatrix(angles) * v); }));
  std::cout << "A bottle of " << mesh.triangles.size() << " triangles and "
            << carom::io::Cell(carom::signedVolume(mesh)).text(carom::io::fixed(12)) << " m^3\n\n"
            << table;

  carom::io::Recording recording(
      "A bottle turned by slerp",
      "The solid bottle turns from its first orientation to the last one by the shortest way, at "
      "constant speed. The other bottle has the shape that the wrong matrix gives it.");
  recording.addBody("turned by slerp", carom::io::Mesh{mesh},
                    {.color = carom::io::kGreen, .axes = true});
  recording.addFixed(
      "the source's matrix",
      carom::io::Mesh{
          mapped(mesh, [&](const Vector3& v) { return Vector3(sourceMatrix(angles) * v); })},
      {Vector3(1.2, 0, 0), {}}, {.color = carom::io::kVermilion});
  for (int i = 0; i <= 180; ++i) {
    const Real t = std::min(1.0, i / 120.0);
    recording.addFrame({i / 60.0, {{Vector3::Zero(), carom::slerp(Quaternion{}, q, t)}}, {}, {}});
  }
  recording.writeHtml(folder / "rotate_mesh.html");
}
