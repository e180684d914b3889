#include "carom/solver/contact_patch.hpp"

#include <algorithm>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/impulse/positive_solve.hpp"

namespace carom {

namespace {

// A row of an impulse that acts at two arms, or, without a direction, of a torque.
PushRow makeRow(const Vector3& direction, const Vector3& turnA, const Vector3& turnB,
                const MovingBody& a, const MovingBody& b) {
  PushRow row;
  row.direction = direction;
  row.turnA = turnA;
  row.turnB = turnB;
  row.spinA = a.mass.inverseInertia * turnA;
  row.spinB = b.mass.inverseInertia * turnB;
  return row;
}

// How much a unit impulse along one row changes the velocity along another.
Real coupling(const PushRow& p, const PushRow& q, Real inverseMasses) {
  return inverseMasses * p.direction.dot(q.direction) + p.turnA.dot(q.spinA) + p.turnB.dot(q.spinB);
}

// Where the pressure is centred: by the impulses to start with, or evenly.
PatchPoint centreOf(const ContactPatch& patch, Real& radius) {
  Real sum = 0;
  for (int i = 0; i < patch.count; ++i) sum += patch.points[i].impulse;
  PatchPoint centre;
  const auto weight = [&](int i) {
    return sum > 0 ? patch.points[i].impulse / sum : Real(1) / patch.count;
  };
  if (patch.count == 1) {
    radius = 0;
    return patch.points[0];
  }
  for (int i = 0; i < patch.count; ++i) {
    centre.armA += weight(i) * patch.points[i].armA;
    centre.armB += weight(i) * patch.points[i].armB;
    centre.before += weight(i) * patch.points[i].before;
    centre.drift += weight(i) * patch.points[i].drift;
  }
  radius = 0;
  for (int i = 0; i < patch.count; ++i) {
    radius += weight(i) * (patch.points[i].armB - centre.armB).norm();
  }
  return centre;
}

// Pressure that is a plane over the points, of which the even one is the first part.
void preparePlane(const ContactPatch& patch, Real masses, ContactBlock& block) {
  const Vector3& n = patch.normal;
  Vector3 mean = Vector3::Zero();
  for (int i = 0; i < patch.count; ++i) mean += patch.points[i].armB / patch.count;
  Real farthest = 0;
  Vector3 x = Vector3::Zero();
  for (int i = 0; i < patch.count; ++i) {
    const Vector3 arm = patch.points[i].armB - mean;
    const Vector3 flat = arm - n.dot(arm) * n;
    if (flat.norm() <= farthest) continue;
    farthest = flat.norm();
    x = flat / farthest;
  }
  if (!(farthest > 0)) return;
  const Vector3 y = cross(n, x);
  Matrix3 S = Matrix3::Zero();
  std::array<Vector3, 4> columns;  // what each point does to all planes
  for (int i = 0; i < patch.count; ++i) {
    const Vector3 arm = (patch.points[i].armB - mean) / farthest;
    block.places[i] = {1, x.dot(arm), y.dot(arm)};
  }
  for (int i = 0; i < patch.count; ++i) {
    columns[i] = Vector3::Zero();
    for (int j = 0; j < patch.count; ++j) {
      columns[i] += coupling(block.normals[i], block.normals[j], masses) * block.places[j];
    }
    S += block.places[i] * columns[i].transpose();
  }
  if (!(S(0, 0) > 0)) return;
  block.evenMass = 1 / S(0, 0);
  // Points on a line have no breadth, and then nothing tilts about it.
  constexpr Real kNothing = 1e-9;
  if (S(2, 2) <= kNothing * S(1, 1)) {
    S.row(2).setZero();
    S.col(2).setZero();
    S(2, 2) = S(1, 1);
    for (Vector3& place : block.places) place.z() = 0;
  }
  const Real det = S.col(0).dot(cross(Vector3(S.col(1)), Vector3(S.col(2))));
  const PositiveSolve solve(S);
  if (solve.positive() && det > kNothing * S(0, 0) * S(1, 1) * S(2, 2)) {
    block.plane = solve.inverse();
  } else {
    block.plane(0, 0) = block.evenMass;
  }
}

}  // namespace

ContactBlock prepareBlock(const ContactPatch& patch, std::span<const MovingBody> bodies) {
  const MovingBody& a = bodies[patch.bodyA];
  const MovingBody& b = bodies[patch.bodyB];
  const Real masses = a.mass.inverseMass + b.mass.inverseMass;
  const Vector3& n = patch.normal;
  ContactBlock block;
  block.bodyA = patch.bodyA;
  block.bodyB = patch.bodyB;
  block.count = patch.count;
  for (int i = 0; i < patch.count; ++i) {
    const PatchPoint& point = patch.points[i];
    PushRow& row = block.normals[i];
    row = makeRow(n, cross(point.armA, n), cross(point.armB, n), a, b);
    row.drift = n.dot(point.drift);
    const Real inverse = coupling(row, row, masses);
    block.masses[i] = inverse > 0 ? 1 / inverse : 0;
    block.targets[i] = point.target;
    block.impulses[i] = point.impulse;
  }
  if (patch.count > 1) preparePlane(patch, masses, block);
  if (!(patch.friction > 0) || !(masses > 0)) return block;

  // Friction acts at the centre of pressure.
  const PatchPoint centre = centreOf(patch, block.radius);
  const Real sign = std::copysign(1.0, n.z());
  const Real p = -1 / (sign + n.z()), q = n.x() * n.y() * p;  // Duff and others 2017
  const Vector3 tangents[2] = {{1 + sign * n.x() * n.x() * p, sign * q, -sign * n.x()},
                               {q, sign + n.y() * n.y() * p, -n.y()}};
  for (int k = 0; k < 2; ++k) {
    const Vector3& t = tangents[k];
    block.tangents[k] = makeRow(t, cross(centre.armA, t), cross(centre.armB, t), a, b);
    block.tangents[k].drift = t.dot(centre.drift);
    block.rub[k] = t.dot(patch.rub);
  }
  block.rubs = 2;
  block.friction = patch.friction;
  if (block.radius > 0) {
    const Vector3 lever = block.radius * n;
    block.tangents[2] = makeRow(Vector3::Zero(), lever, lever, a, b);
    block.rub[2] = patch.twist / block.radius;
    block.rubs = 3;
  }
  Matrix3 S = Matrix3::Identity();
  for (int i = 0; i < block.rubs; ++i) {
    for (int j = 0; j < block.rubs; ++j) {
      S(i, j) = coupling(block.tangents[i], block.tangents[j], masses);
    }
  }
  block.matrix = S;
  // The sum of the diagonal bounds what any impulse can do to the slip along itself.
  Real trace = 0;
  for (int i = 0; i < block.rubs; ++i) trace += S(i, i);
  block.lightest = 1 / trace;
  const PositiveSolve solve(S);
  block.inverse =
      solve.positive() ? solve.inverse() : Matrix3(block.lightest * Matrix3::Identity());

  for (int k = 0; k < block.rubs; ++k) {
    const PushRow& row = block.tangents[k];
    block.slipBefore[k] = speedAtEnd(row, a, b) - row.drift - row.direction.dot(centre.before);
  }
  block.slips = block.slipBefore.norm() > patch.slowest;
  return block;
}

void storeImpulses(const ContactBlock& block, ContactPatch& patch) {
  patch.rub = Vector3::Zero();
  patch.twist = 0;
  for (int i = 0; i < block.count; ++i) patch.points[i].impulse = block.impulses[i];
  for (int k = 0; k < std::min(block.rubs, 2); ++k) {
    patch.rub += block.rub[k] * block.tangents[k].direction;
  }
  if (block.rubs == 3) patch.twist = block.radius * block.rub[2];
}

void warmStart(const ContactBlock& block, std::span<MovingBody> bodies) {
  MovingBody& a = bodies[block.bodyA];
  MovingBody& b = bodies[block.bodyB];
  for (int i = 0; i < block.count; ++i) pushAlong(block.normals[i], block.impulses[i], a, b);
  for (int k = 0; k < block.rubs; ++k) pushAlong(block.tangents[k], block.rub[k], a, b);
}

Vector3 slipOf(const ContactBlock& block, std::span<const MovingBody> bodies) {
  Vector3 slip = Vector3::Zero();
  for (int k = 0; k < block.rubs; ++k) {
    const PushRow& row = block.tangents[k];
    slip[k] = speedAtEnd(row, bodies[block.bodyA], bodies[block.bodyB]);
  }
  return slip;
}

Real centreShift(const ContactBlock& block, const ContactPatch& patch) {
  if (block.rubs < 3) return 0;
  Real before = 0, after = 0;
  for (int i = 0; i < patch.count; ++i) {
    before += patch.points[i].impulse;
    after += block.impulses[i];
  }
  if (!(after > 0)) return 0;
  Vector3 shift = Vector3::Zero();
  for (int i = 0; i < patch.count; ++i) {
    const Real even = Real(1) / patch.count;
    const Real weight = before > 0 ? patch.points[i].impulse / before : even;
    shift += (block.impulses[i] / after - weight) * patch.points[i].armB;
  }
  return shift.norm() / block.radius;
}

Real stopTime(const ContactBlock& block, std::span<const MovingBody> bodies, Real duration) {
  constexpr Real kNever = std::numeric_limits<Real>::infinity();
  if (!block.slips) return kNever;
  const Vector3 after = slipOf(block, bodies);
  const Real ahead = block.slipBefore.dot(after);
  if (ahead > 0) return kNever;
  const Real start = block.slipBefore.squaredNorm();
  return duration * (start / (start - ahead));
}

bool atLimit(const ContactBlock& block) {
  Real pressed = 0;
  for (int i = 0; i < block.count; ++i) pressed += block.impulses[i];
  constexpr Real kAlmost = 1 - 1e-12;  // the solution is on the cone but for rounding
  return block.rubs == 0 || block.rub.norm() >= kAlmost * block.friction * pressed;
}

}  // namespace carom
