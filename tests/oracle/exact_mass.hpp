#pragma once
// The mass properties of a mesh in rational numbers, which round nothing, and how far an answer is
// from them.
//
// The integrals are Eberly's (Polyhedral Mass Properties, 2002): surface integrals of polynomials
// in one coordinate after the other, not the sums over tetrahedra that the library uses. Needs
// CGAL.

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "carom/mass/triangle_mesh.hpp"

namespace carom_test {

using carom::Matrix3;
using carom::Real;
using carom::TriangleMesh;
using carom::Vector3;
using Rational = CGAL::Exact_rational;

struct ExactBody {
  Rational volume = 0;
  std::array<Rational, 3> center;
  std::array<std::array<Rational, 3>, 3> inertia;  // density 1, about the centre
};

using Point = std::array<Rational, 3>;

inline ExactBody weighExactly(const TriangleMesh& mesh) {
  // ∫ 1, ∫ x_i, ∫ x_i², ∫ x_i x_(i+1) over the solid.
  Rational volume = 0;
  std::array<Rational, 3> first = {0, 0, 0};
  std::array<Rational, 3> square = {0, 0, 0};
  std::array<Rational, 3> product = {0, 0, 0};
  for (const auto& triangle : mesh.triangles) {
    std::array<Point, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& v = mesh.vertices[static_cast<std::size_t>(triangle[k])];
      p[k] = {Rational(v.x()), Rational(v.y()), Rational(v.z())};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      // Component i of the normal, twice the area long.
      const Rational n =
          (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
      const Rational &w0 = p[0][i], &w1 = p[1][i], &w2 = p[2][i];
      const Rational f1 = w0 + w1 + w2;
      const Rational f2 = w0 * w0 + w1 * (w0 + w1) + w2 * f1;
      const Rational f3 = w0 * w0 * w0 + w1 * (w0 * w0 + w1 * (w0 + w1)) + w2 * f2;
      if (i == 0) volume += n * f1 / 6;
      first[i] += n * f2 / 24;
      square[i] += n * f3 / 60;
      Rational g = 0;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Rational& w = p[corner][i];
        g += p[corner][j] * (f2 + w * (f1 + w));
      }
      product[i] += n * g / 120;
    }
  }
  ExactBody body;
  body.volume = volume;
  for (std::size_t i = 0; i < 3; ++i) body.center[i] = first[i] / volume;
  for (std::size_t i = 0; i < 3; ++i) {
    square[i] -= volume * body.center[i] * body.center[i];
    product[i] -= volume * body.center[i] * body.center[(i + 1) % 3];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    body.inertia[i][i] = square[j] + square[(i + 2) % 3];
    body.inertia[i][j] = body.inertia[j][i] = -product[i];
  }
  return body;
}

// |got - exact| as a double; the difference is taken exactly.
inline Real distance(Real got, const Rational& exact) {
  return std::abs(CGAL::to_double(Rational(got) - exact));
}

inline Real sizeOf(const TriangleMesh& mesh) {
  Vector3 low = mesh.vertices.front();
  Vector3 high = low;
  for (const Vector3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

struct Errors {
  Real volume = 0;   // relative
  Real center = 0;   // relative to the size of the body
  Real inertia = 0;  // relative to the largest entry
};

inline Errors errorsOf(Real volume, const Vector3& center, const Matrix3& inertia,
                       const ExactBody& exact, Real size) {
  Errors errors;
  errors.volume = distance(volume, exact.volume) / CGAL::to_double(exact.volume);
  Real largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    errors.center = std::max(errors.center, distance(center[row], exact.center[i]));
    for (std::size_t j = 0; j < 3; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      errors.inertia =
          std::max(errors.inertia, distance(inertia(row, column), exact.inertia[i][j]));
      largest = std::max(largest, std::abs(CGAL::to_double(exact.inertia[i][j])));
    }
  }
  errors.center /= size;
  errors.inertia /= largest;
  return errors;
}

inline Errors errorsOf(Real volume, const Vector3& center, const Matrix3& inertia,
                       const TriangleMesh& mesh) {
  return errorsOf(volume, center, inertia, weighExactly(mesh), sizeOf(mesh));
}

}  // namespace carom_test
