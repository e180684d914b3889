#include "scenes/scene.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "carom/core/cross.hpp"
#include "carom/detection/hull_of_points.hpp"
#include "carom/mass/box_inertia.hpp"
#include "carom/mass/mass_properties.hpp"
#include "carom/mass/principal_axes.hpp"
#include "carom/rotation/matrix_to_quaternion.hpp"
#include "carom/rotation/quaternion_to_matrix.hpp"

namespace carom::scenes {
namespace {

// A hull as triangles: each face as a fan from its first corner.
TriangleMesh meshOf(const ConvexHull& hull) {
  TriangleMesh mesh;
  mesh.vertices = hull.vertices;
  for (const HullFace& face : hull.faces) {
    const auto corner = [&](int i) {
      return hull.halfEdges[static_cast<std::size_t>(face.firstHalfEdge + i)].origin;
    };
    for (int i = 1; i + 1 < face.count; ++i) {
      mesh.triangles.push_back({corner(0), corner(i), corner(i + 1)});
    }
  }
  return mesh;
}

Vector3 worldSpin(const Body& body, const State& state) {
  const Matrix3 R_WB = poseOfState(state).R_WB;
  const Vector3 inBody = R_WB.transpose() * state.angularVelocity;
  return R_WB * body.moments.cwiseProduct(inBody);
}

}  // namespace

Body ballBody(Real radius, Real mass) {
  Body body{.shape = makeBall(radius)};
  body.mass = mass;
  body.moments = Vector3::Constant(0.4 * mass * radius * radius);
  return body;
}

Body boxBody(const Vector3& halfExtents, Real mass) {
  Body body{.shape = makeBox(halfExtents)};
  body.mass = mass;
  body.moments = boxInertia(mass, 2 * halfExtents).diagonal();
  return body;
}

Body planeBody(const Vector3& normal, const Vector3& point) {
  Body body{.shape = makeHalfSpace(normal, point)};
  body.moves = false;
  return body;
}

Body placedHull(std::span<const Vector3> points, Real density) {
  const MassProperties raw = massPropertiesOfGoodMesh(meshOf(hullOfPoints(points)), density);
  const PrincipalAxes principal = principalAxes(raw.inertia);
  std::vector<Vector3> moved;
  for (const Vector3& p : points) moved.push_back(principal.axes.transpose() * (p - raw.center));
  Body body{.shape = hullOfPoints(moved)};
  body.mass = raw.mass;
  body.moments = principal.moments;
  body.start.position = raw.center;
  body.start.orientation = matrixToQuaternion(principal.axes);
  return body;
}

Body hullBody(std::span<const Vector3> points, Real density) {
  Body body = placedHull(points, density);
  body.start = State();
  return body;
}

std::vector<Body> room(const Vector3& low, const Vector3& high) {
  std::vector<Body> walls;
  for (int axis = 0; axis < 3; ++axis) {
    walls.push_back(planeBody(Vector3::Unit(axis), low));
    walls.push_back(planeBody(-Vector3::Unit(axis), high));
  }
  return walls;
}

std::vector<State> startOf(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies) states.push_back(body.start);
  return states;
}

Pose poseOfState(const State& state) {
  return poseOf(state.orientation, state.position);
}

Real kineticEnergy(const Scene& scene, std::span<const State> bodies) {
  Real sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (!body.moves) continue;
    sum += body.mass * bodies[i].velocity.squaredNorm() / 2;
    sum += bodies[i].angularVelocity.dot(worldSpin(body, bodies[i])) / 2;
  }
  return sum;
}

Momentum momentum(const Scene& scene, std::span<const State> bodies) {
  Momentum sum;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    const Vector3 own = scene.bodies[i].mass * bodies[i].velocity;
    sum.total += own;
    sum.size += own.norm();
  }
  return sum;
}

Momentum angularMomentum(const Scene& scene, std::span<const State> bodies) {
  Momentum sum;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (!body.moves) continue;
    const Vector3& x = bodies[i].position;
    const Vector3 p = body.mass * bodies[i].velocity;
    const Vector3 own = cross(x, p) + worldSpin(body, bodies[i]);
    sum.total += own;
    sum.size += own.norm();
  }
  return sum;
}

std::uint64_t hashOf(const Scene& scene, std::span<const State> bodies) {
  std::uint64_t hash = 0xCBF29CE484222325u;  // FNV-1a, a word at a time
  const auto mix = [&hash](Real number) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001B3u;
    hash ^= hash >> 32;
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!scene.bodies[i].moves) continue;
    const State& state = bodies[i];
    const Quaternion& q = state.orientation;
    for (const Vector3& v : {state.position, state.velocity, state.angularVelocity}) {
      for (int k = 0; k < 3; ++k) mix(v[k]);
    }
    for (const Real number : {q.w, q.x, q.y, q.z}) mix(number);
  }
  return hash;
}

}  // namespace carom::scenes
