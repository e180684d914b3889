#pragma once
// A ball on a table in other engines, for the suite `impulse`. Each is a shared library that sees
// nothing of ours but this file.

namespace carom::bench {

/// A ball of 1 kg and radius 1 m that touches the plane z = 0.
struct PeerScene {
  double velocity[3] = {0, 0, 0};  ///< [m/s]
  double spin[3] = {0, 0, 0};      ///< [rad/s]
  bool turns = true;               ///< false: nothing can turn it, so it slides like a block
  double friction = 0;             ///< mu of the pair [1]
  double gravity = 9.81;           ///< [m/s^2]
  double duration = 1;             ///< [s]
};

/// Where the centre is at the end.
struct PeerPlace {
  double x = 0;  ///< [m]
  double y = 0;  ///< [m]
};

/// Bullet in double precision, sequential impulses with its defaults, sleeping off.
[[gnu::visibility("default")]] PeerPlace slideInBullet(const PeerScene& scene, int steps);

/// ODE, dWorldStep, friction as a box of mu times the normal force.
[[gnu::visibility("default")]] PeerPlace slideInOde(const PeerScene& scene, int steps);

}  // namespace carom::bench
