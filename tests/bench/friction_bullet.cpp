// A ball that slides over a table in Bullet.

#include <btBulletDynamicsCommon.h>

#include "bench/friction_peers.hpp"

namespace carom::bench {

PeerPlace slideInBullet(const PeerScene& scene, int steps) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, 0, -scene.gravity));

  btStaticPlaneShape plane(btVector3(0, 0, 1), 0);
  btRigidBody table(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  table.setFriction(1);  // Bullet multiplies the two
  btSphereShape sphere(1);
  btRigidBody ball(
      btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &sphere, btVector3(0.4, 0.4, 0.4)));
  ball.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, 0, 1)));
  ball.setFriction(scene.friction);
  ball.setDamping(0, 0);
  ball.setActivationState(DISABLE_DEACTIVATION);
  ball.setLinearVelocity(btVector3(scene.velocity[0], scene.velocity[1], scene.velocity[2]));
  ball.setAngularVelocity(btVector3(scene.spin[0], scene.spin[1], scene.spin[2]));
  if (!scene.turns) ball.setAngularFactor(0);
  world.addRigidBody(&table);
  world.addRigidBody(&ball);
  for (int i = 0; i < steps; ++i) world.stepSimulation(scene.duration / steps, 0);
  const btVector3& place = ball.getWorldTransform().getOrigin();
  world.removeRigidBody(&ball);
  world.removeRigidBody(&table);
  return {place.x(), place.y()};
}

}  // namespace carom::bench
