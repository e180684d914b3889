#pragma once
// Engines that follow a free body, each behind one function in a library of its own.

#define CAROM_PEER __attribute__((visibility("default")))

namespace carom::bench {

/// A body that nothing acts on, in plain numbers. It begins with its axes along those of the world.
struct PeerRotor {
  double moments[3];  ///< principal moments of inertia [kg m^2]
  double spin[3];     ///< angular velocity [rad/s, body]
  double duration;    ///< of the motion [s]
};

/// How a body lies: w, x, y, z.
struct PeerAttitude {
  double q[4];
};

/// Bullet's gyroscopic terms.
enum class BulletTerm { implicitBody, implicitWorld, explicitTerm };

/// The end of the motion in Bullet, after steps of equal length.
CAROM_PEER PeerAttitude turnInBullet(const PeerRotor& rotor, int steps, BulletTerm term);

/// The end of the motion in ODE.
CAROM_PEER PeerAttitude turnInOde(const PeerRotor& rotor, int steps);

}  // namespace carom::bench
