#pragma once
// Scenes for the graders of chapter 9: columns, and a bar on two feet.

#include <string>
#include <vector>

#include "carom/solver/box_column.hpp"
#include "grading/fields_solver.hpp"
#include "grading/grade.hpp"

namespace carom::grading {

using Reals = std::vector<Real>;

/// A column whose boxes all have the speed -1 m/s, or what is said.
inline BoxColumn falling(const Reals& masses, Real speed = -1) {
  BoxColumn column = boxColumn(masses);
  pullDown(column.bodies, speed);
  return column;
}

/// A bar of 1 m over the ground, body 0, with two feet 20 cm apart under its middle: each of them
/// takes most of the load from the other.
inline BoxColumn barOnFeet(Real mass, const Vector3& velocity, Real turning) {
  BoxColumn scene;
  scene.bodies.resize(2);
  MovingBody& bar = scene.bodies[1];
  bar.mass.inverseMass = 1 / mass;
  bar.mass.inverseInertia = 12 / mass * Matrix3::Identity();
  bar.velocity = {velocity, {0, turning, 0}};
  for (const Real side : {-0.1, 0.1}) {
    ContactRow row;
    row.bodyB = 1;
    row.contact.armB = {side, 0, 0};
    row.name = side < 0 ? 1 : 2;
    scene.rows.push_back(row);
  }
  return scene;
}

inline Reals impulsesOf(const BoxColumn& scene) {
  Reals all;
  for (const ContactRow& row : scene.rows) all.push_back(row.impulse);
  return all;
}

/// Upward speeds of all bodies but the ground.
inline Reals speedsOf(const BoxColumn& scene) {
  Reals all;
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    all.push_back(scene.bodies[i].velocity.linear.z());
  }
  return all;
}

}  // namespace carom::grading
