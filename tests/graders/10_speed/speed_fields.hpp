#pragma once
// How the types of chapter 10 cross the pipe.

#include "grading/wire.hpp"
#include "lanes_solver.hpp"
#include "merge_found.hpp"
#include "soa_layout.hpp"
#include "sweeps_by_order.hpp"

namespace carom::grading {

template <>
struct Fields<LaneValues> {
  static constexpr auto list = fieldList("x", &LaneValues::x);
};

template <>
struct Fields<WholeBody> {
  static constexpr auto list = fieldList(
      "name", &WholeBody::name, "position", &WholeBody::position, "velocity", &WholeBody::velocity,
      "orientation", &WholeBody::orientation, "angularVelocity", &WholeBody::angularVelocity,
      "inverseMass", &WholeBody::inverseMass, "inverseInertia", &WholeBody::inverseInertia,
      "friction", &WholeBody::friction, "restitution", &WholeBody::restitution);
};

template <>
struct Fields<BodyBlock> {
  static constexpr auto list =
      fieldList("position", &BodyBlock::position, "velocity", &BodyBlock::velocity, "inverseMass",
                &BodyBlock::inverseMass);
};

template <>
struct Fields<BodySpeeds> {
  static constexpr auto list = fieldList("x", &BodySpeeds::x);
};

template <>
struct Fields<SweepsByOrder> {
  static constexpr auto list =
      fieldList("height", &SweepsByOrder::height, "upwards", &SweepsByOrder::upwards, "byColor",
                &SweepsByOrder::byColor);
};

template <>
struct Fields<FoundImpact> {
  static constexpr auto list = fieldList("time", &FoundImpact::time, "bodyA", &FoundImpact::bodyA,
                                         "bodyB", &FoundImpact::bodyB);
};

template <>
struct Fields<RowBlock> {
  static constexpr auto list = fieldList(
      "bodyA", &RowBlock::bodyA, "bodyB", &RowBlock::bodyB, "alongA", &RowBlock::alongA, "alongB",
      &RowBlock::alongB, "changeA", &RowBlock::changeA, "changeB", &RowBlock::changeB, "mass",
      &RowBlock::mass, "target", &RowBlock::target, "impulse", &RowBlock::impulse);
};

}  // namespace carom::grading
