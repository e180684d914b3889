// How heavy is a whole train of gears to turn?
//
// Discs of 2 kg mesh with each other. A motor turns the first one with 1 N m: how fast does it
// speed up? Beside the moment of inertia that it feels stands what the recipe for compounds would
// give, and the energy after a second, counted gear by gear.

#include <iostream>
#include <string>
#include <vector>

#include "carom_io/table.hpp"
#include "geared_inertia.hpp"

using carom::GearWheel;
using carom::Real;

constexpr Real kMass = 2;          // of each disc [kg]
constexpr Real kToothWidth = 0.1;  // radius over number of teeth [m]
constexpr Real kTorque = 1;        // of the motor [N m]

// Discs side by side along x, their rims touching.
std::vector<GearWheel> trainOf(const std::vector<int>& teeth) {
  std::vector<GearWheel> train;
  Real x = 0, before = 0;
  for (const int n : teeth) {
    const Real radius = n * kToothWidth;
    if (!train.empty()) x += before + radius;
    train.push_back({n, kMass * radius * radius / 2, kMass, {x, 0}});
    before = radius;
  }
  return train;
}

// The recipe for parts of one rigid body: moved to the first axle and added.
Real asOneBody(const std::vector<GearWheel>& train) {
  Real sum = 0;
  for (const GearWheel& gear : train) {
    sum += gear.inertia + gear.mass * (gear.axle - train.front().axle).squaredNorm();
  }
  return sum;
}

// Gear by gear, each at its own rate.
Real energyOf(const std::vector<GearWheel>& train, Real firstRate) {
  Real sum = 0;
  for (const GearWheel& gear : train) {
    const Real rate = firstRate * train.front().teeth / gear.teeth;
    sum += gear.inertia * rate * rate / 2;
  }
  return sum;
}

int main() {
  carom::io::Table table;
  table.column("teeth").column("felt", carom::io::fixed(3));
  table.column("rigid", carom::io::fixed(3));
  table.column("rad/s^2", carom::io::fixed(4));
  table.column("work [J]", carom::io::fixed(4));
  table.column("energy [J]", carom::io::fixed(4));
  const std::vector<std::vector<int>> trains = {{10},         {10, 40},     {40, 10},
                                                {10, 20, 40}, {10, 40, 10}, {10, 10, 10, 10}};
  for (const std::vector<int>& teeth : trains) {
    const std::vector<GearWheel> train = trainOf(teeth);
    const Real felt = carom::gearedInertia(train);
    const Real acceleration = kTorque / felt;
    std::string name;
    for (const int n : teeth) name += (name.empty() ? "" : " - ") + std::to_string(n);
    // In one second the first gear turns by half its acceleration.
    table.row({name, felt, asOneBody(train), acceleration, kTorque * acceleration / 2,
               energyOf(train, acceleration)});
  }
  std::cout << "A motor turns the first gear with 1 N m. Inertia that it feels, and as\n"
               "if it were one rigid body [kg m^2]; work and energy after 1 s\n\n"
            << table;
}
