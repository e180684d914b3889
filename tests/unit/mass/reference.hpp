#pragma once
// What the tests of the mass layer share: reference values from tests/cases/mass.json, and
// distances.

#include <algorithm>
#include <string>

#include "carom/core/real.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/triangle_mesh.hpp"
#include "support/cases.hpp"

namespace carom_test {

// One case of group M.
inline json massCase(const std::string& id) {
  return readCase("mass", id);
}

inline carom::Matrix3 matrix(const json& value) {
  carom::Matrix3 m;
  for (int i = 0; i < 3; ++i) m.row(i) = vector(value.at(static_cast<std::size_t>(i)));
  return m;
}

inline double relativeError(double got, double expected) {
  return std::abs(got - expected) / std::abs(expected);
}

// Largest difference of two vectors or matrices, relative to the largest entry expected.
template <class M>
double relativeError(const M& got, const M& expected) {
  return (got - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
}

// Size of a mesh: the longest side of its bounding box.
inline double sizeOf(const carom::TriangleMesh& mesh) {
  carom::Vector3 low = mesh.vertices.front();
  carom::Vector3 high = low;
  for (const carom::Vector3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

// The wrong way that case M7 measures: the same sums about the world's origin, shifted at the end.
inline carom::MassProperties weighAboutWorldOrigin(const carom::TriangleMesh& mesh) {
  double v = 0;
  carom::Vector3 moment = carom::Vector3::Zero();
  carom::Matrix3 C = carom::Matrix3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const auto [a, b, c] = carom::cornersOf(mesh, triangle);
    const double det = a.x() * (b.y() * c.z() - b.z() * c.y()) +
                       a.y() * (b.z() * c.x() - b.x() * c.z()) +
                       a.z() * (b.x() * c.y() - b.y() * c.x());
    const carom::Vector3 s = a + b + c;
    v += det / 6;
    moment += det / 24 * s;
    C +=
        det / 120 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  carom::MassProperties body;
  body.volume = body.mass = v;
  body.center = moment / v;
  C -= v * body.center * body.center.transpose();
  body.inertia = C.trace() * carom::Matrix3::Identity() - C;
  return body;
}

}  // namespace carom_test
