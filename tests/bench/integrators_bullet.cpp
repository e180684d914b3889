// A body that turns freely in Bullet.

#include <btBulletDynamicsCommon.h>

#include "bench/integrators_peers.hpp"

namespace carom::bench {

PeerAttitude turnInBullet(const PeerRotor& rotor, int steps, BulletTerm term) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, 0));

  btSphereShape shape(1);
  btRigidBody body(btRigidBody::btRigidBodyConstructionInfo(
      1, nullptr, &shape, btVector3(rotor.moments[0], rotor.moments[1], rotor.moments[2])));
  body.setDamping(0, 0);
  body.setActivationState(DISABLE_DEACTIVATION);
  body.setFlags(term == BulletTerm::implicitBody    ? BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY
                : term == BulletTerm::implicitWorld ? BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD
                                                    : BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT);
  body.setAngularVelocity(btVector3(rotor.spin[0], rotor.spin[1], rotor.spin[2]));
  world.addRigidBody(&body);
  for (int i = 0; i < steps; ++i) world.stepSimulation(rotor.duration / steps, 0);
  const btQuaternion q = body.getWorldTransform().getRotation();
  world.removeRigidBody(&body);
  return {{q.w(), q.x(), q.y(), q.z()}};
}

}  // namespace carom::bench
