#pragma once
// How the types of chapter 5 cross the pipe, and how rules are worded in a message.

#include <string>

#include "carom/impulse/body_motion.hpp"
#include "carom/impulse/combine_restitution.hpp"
#include "carom/impulse/drag_force.hpp"
#include "carom/impulse/rolling_friction.hpp"
#include "carom/impulse/spinning_friction.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

template <>
struct Fields<Velocity> {
  static constexpr auto list =
      fieldList("linear", &Velocity::linear, "angular", &Velocity::angular);
};

template <>
struct Fields<PlanarVelocity> {
  static constexpr auto list =
      fieldList("linear", &PlanarVelocity::linear, "angular", &PlanarVelocity::angular);
};

template <>
struct Fields<BodyMass> {
  static constexpr auto list =
      fieldList("inverseMass", &BodyMass::inverseMass, "inverseInertia", &BodyMass::inverseInertia);
};

template <>
struct Fields<PlanarBodyMass> {
  static constexpr auto list = fieldList("inverseMass", &PlanarBodyMass::inverseMass,
                                         "inverseInertia", &PlanarBodyMass::inverseInertia);
};

template <>
struct Fields<MovingBody> {
  static constexpr auto list =
      fieldList("mass", &MovingBody::mass, "velocity", &MovingBody::velocity);
};

template <>
struct Fields<PlanarBody> {
  static constexpr auto list =
      fieldList("mass", &PlanarBody::mass, "velocity", &PlanarBody::velocity);
};

template <>
struct Fields<OrientedBody> {
  static constexpr auto list = fieldList("inverseMass", &OrientedBody::inverseMass,
                                         "inverseInertia", &OrientedBody::inverseInertia, "R_WB",
                                         &OrientedBody::R_WB, "velocity", &OrientedBody::velocity);
};

template <>
struct Fields<Contact> {
  static constexpr auto list =
      fieldList("normal", &Contact::normal, "armA", &Contact::armA, "armB", &Contact::armB);
};

template <>
struct Fields<PlanarContact> {
  static constexpr auto list = fieldList("normal", &PlanarContact::normal, "armA",
                                         &PlanarContact::armA, "armB", &PlanarContact::armB);
};

template <>
struct Fields<AirDrag> {
  static constexpr auto list =
      fieldList("wind", &AirDrag::wind, "density", &AirDrag::density, "coefficient",
                &AirDrag::coefficient, "area", &AirDrag::area);
};

template <>
struct Fields<RollingContact> {
  static constexpr auto list =
      fieldList("angularVelocity", &RollingContact::angularVelocity, "normal",
                &RollingContact::normal, "inertia", &RollingContact::inertia, "normalImpulse",
                &RollingContact::normalImpulse, "arm", &RollingContact::arm);
};

template <>
struct Fields<SpinningContact> {
  static constexpr auto list =
      fieldList("spin", &SpinningContact::spin, "inertia", &SpinningContact::inertia,
                "normalImpulse", &SpinningContact::normalImpulse, "friction",
                &SpinningContact::friction, "radius", &SpinningContact::radius);
};

/// The rule as a word, so that a message can be read.
inline std::string inWords(RestitutionRule rule) {
  switch (rule) {
    case RestitutionRule::average:
      return "average";
    case RestitutionRule::product:
      return "product";
    case RestitutionRule::minimum:
      return "minimum";
    case RestitutionRule::maximum:
      return "maximum";
    case RestitutionRule::geometricMean:
      return "geometricMean";
  }
  return "no rule";
}

}  // namespace carom::grading
