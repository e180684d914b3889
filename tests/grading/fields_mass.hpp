#pragma once
// How the types of chapter 2 cross the pipe.

#include "carom/mass/check_mesh.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/monte_carlo_mass.hpp"
#include "carom/mass/principal_axes.hpp"
#include "carom/mass/triangle_mesh.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<TriangleMesh> {
  static constexpr auto list =
      fieldList("vertices", &TriangleMesh::vertices, "triangles", &TriangleMesh::triangles);
};

template <>
struct Fields<MassProperties> {
  static constexpr auto list =
      fieldList("volume", &MassProperties::volume, "mass", &MassProperties::mass, "center",
                &MassProperties::center, "inertia", &MassProperties::inertia);
};

template <>
struct Fields<MonteCarloMass> {
  static constexpr auto list =
      fieldList("body", &MonteCarloMass::body, "samples", &MonteCarloMass::samples, "inside",
                &MonteCarloMass::inside, "relativeError", &MonteCarloMass::relativeError);
};

template <>
struct Fields<PrincipalAxes> {
  static constexpr auto list =
      fieldList("moments", &PrincipalAxes::moments, "axes", &PrincipalAxes::axes);
};

// The message is left out: how a sentence is worded is not graded, and must not set two answers
// apart.
template <>
struct Fields<MeshProblem> {
  static constexpr auto list =
      fieldList("kind", &MeshProblem::kind, "vertex", &MeshProblem::vertex, "triangle",
                &MeshProblem::triangle, "edge", &MeshProblem::edge);
};

}  // namespace carom::grading
