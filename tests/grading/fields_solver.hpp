#pragma once
// How the types of chapters 9 and 10 that belong to the solver cross the pipe.

#include "carom/solver/color_graph.hpp"
#include "carom/solver/contact_row.hpp"
#include "carom/solver/soft_contact.hpp"
#include "carom/solver/substep.hpp"
#include "carom/solver/warm_start.hpp"
#include "grading/fields_impulse.hpp"

namespace carom::grading {

template <>
struct Fields<ContactRow> {
  static constexpr auto list = fieldList("bodyA", &ContactRow::bodyA, "bodyB", &ContactRow::bodyB,
                                         "contact", &ContactRow::contact, "name", &ContactRow::name,
                                         "separation", &ContactRow::separation, "target",
                                         &ContactRow::target, "impulse", &ContactRow::impulse);
};

template <>
struct Fields<ColorEdge> {
  static constexpr auto list = fieldList("a", &ColorEdge::a, "b", &ColorEdge::b);
};

template <>
struct Fields<KeptImpulse> {
  static constexpr auto list =
      fieldList("name", &KeptImpulse::name, "impulse", &KeptImpulse::impulse);
};

template <>
struct Fields<SoftContact> {
  static constexpr auto list =
      fieldList("biasRate", &SoftContact::biasRate, "massScale", &SoftContact::massScale,
                "impulseScale", &SoftContact::impulseScale);
};

template <>
struct Fields<SubstepPlan> {
  static constexpr auto list = fieldList("gravity", &SubstepPlan::gravity, "dt", &SubstepPlan::dt,
                                         "count", &SubstepPlan::count, "soft", &SubstepPlan::soft);
};

}  // namespace carom::grading
