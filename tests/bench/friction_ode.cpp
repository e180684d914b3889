// A ball that slides over a table in ODE.

#include <ode/ode.h>

#include "bench/friction_peers.hpp"

namespace carom::bench {

PeerPlace slideInOde(const PeerScene& scene, int steps) {
  [[maybe_unused]] static const int once = dInitODE2(0);
  dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, 0, -scene.gravity);
  dJointGroupID contacts = dJointGroupCreate(0);
  dGeomID table = dCreatePlane(nullptr, 0, 0, 1, 0);
  dGeomID sphere = dCreateSphere(nullptr, 1);
  dBodyID ball = dBodyCreate(world);
  dMass mass;
  const double inertia = scene.turns ? 0.4 : 1e12;
  dMassSetParameters(&mass, 1, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
  dBodySetMass(ball, &mass);
  dBodySetPosition(ball, 0, 0, 1);
  dBodySetLinearVel(ball, scene.velocity[0], scene.velocity[1], scene.velocity[2]);
  dBodySetAngularVel(ball, scene.spin[0], scene.spin[1], scene.spin[2]);
  dGeomSetBody(sphere, ball);
  for (int i = 0; i < steps; ++i) {
    dContact contact{};
    contact.surface.mode = dContactApprox1;
    contact.surface.mu = scene.friction;
    if (dCollide(sphere, table, 1, &contact.geom, sizeof(dContact)) > 0) {
      dJointAttach(dJointCreateContact(world, contacts, &contact), ball, nullptr);
    }
    dWorldStep(world, scene.duration / steps);
    dJointGroupEmpty(contacts);
  }
  const dReal* place = dBodyGetPosition(ball);
  const PeerPlace result{place[0], place[1]};
  dGeomDestroy(sphere);
  dGeomDestroy(table);
  dJointGroupDestroy(contacts);
  dWorldDestroy(world);
  return result;
}

}  // namespace carom::bench
