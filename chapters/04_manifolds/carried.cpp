// What does a contact point remember from one step to the next?
//
// A crate slides over the edge of a table, and its contact is found anew in every step: corners of
// the crate on the table's top, and at the end edges of the crate across the table's edge. Each
// point takes over the impulse of the point with its name. Beside it: what it would get by its
// place in the list.

#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "carom/manifold/contact_ids.hpp"
#include "carom_io/table.hpp"
#include "carry_impulses.hpp"

using carom::FeatureKind;
using carom::FeaturePair;
using carom::Real;

struct Point {
  std::string name;
  FeaturePair features;
  Real impulse = 0;  // of the step before [N s]
};

std::vector<std::uint32_t> idsOf(const std::vector<Point>& points) {
  std::vector<FeaturePair> pairs;
  for (const Point& p : points) pairs.push_back(p.features);
  return carom::contactIds(pairs);
}

Point corner(std::uint32_t number, Real impulse) {
  return {"corner " + std::to_string(number) + " on the top",
          {{FeatureKind::vertex, number}, {FeatureKind::face, 5}},
          impulse};
}

Point crossing(std::uint32_t number) {
  return {"edge " + std::to_string(number) + " across the table's edge",
          {{FeatureKind::edge, number}, {FeatureKind::edge, 2}},
          0};
}

int main() {
  // Corners 1 and 2 slide over the edge; the clipped contact begins with another point than before.
  const std::vector<Point> before = {corner(0, 3), corner(1, 1), corner(2, 1.5), corner(3, 2.5)};
  const std::vector<Point> after = {crossing(4), crossing(6), corner(3, 0), corner(0, 0)};
  std::vector<Real> impulses;
  for (const Point& p : before) impulses.push_back(p.impulse);

  const std::vector<Real> carried = carom::carryImpulses(idsOf(before), impulses, idsOf(after));
  carom::io::Table table;
  table.column("point").column("by its name [N s]", carom::io::fixed(1));
  table.column("by its place [N s]", carom::io::fixed(1));
  for (std::size_t i = 0; i < after.size(); ++i) {
    table.row({after[i].name, carried[i], impulses[i]});
  }
  std::cout << "A crate slides over the edge of a table: what each point starts the step with\n\n"
            << table;
}
