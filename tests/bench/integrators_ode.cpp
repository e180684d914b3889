// A body that turns freely in ODE.

#include <ode/ode.h>

#include "bench/integrators_peers.hpp"

namespace carom::bench {

PeerAttitude turnInOde(const PeerRotor& rotor, int steps) {
  [[maybe_unused]] static const int once = dInitODE2(0);
  dWorldID world = dWorldCreate();
  dBodyID body = dBodyCreate(world);
  dMass mass;
  dMassSetParameters(&mass, 1, 0, 0, 0, rotor.moments[0], rotor.moments[1], rotor.moments[2], 0, 0,
                     0);
  dBodySetMass(body, &mass);
  dBodySetAngularVel(body, rotor.spin[0], rotor.spin[1], rotor.spin[2]);
  dBodySetFiniteRotationMode(body, 1);
  for (int i = 0; i < steps; ++i) dWorldStep(world, rotor.duration / steps);
  const dReal* q = dBodyGetQuaternion(body);
  const PeerAttitude result{{q[0], q[1], q[2], q[3]}};
  dWorldDestroy(world);
  return result;
}

}  // namespace carom::bench
