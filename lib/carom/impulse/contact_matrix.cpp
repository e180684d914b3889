#include "carom/impulse/contact_matrix.hpp"

#include "carom/core/cross.hpp"

namespace carom {

namespace {

// -[r] I^-1 [r]: column i is (I^-1 (r x e_i)) x r.
Matrix3 turningPart(const Matrix3& inverseInertia, const Vector3& arm) {
  Matrix3 torques;  // of unit impulses along x, y, z
  // clang-format off
  torques <<       0, -arm.z(),  arm.y(),
             arm.z(),        0, -arm.x(),
            -arm.y(),  arm.x(),        0;
  // clang-format on
  return torques.transpose() * inverseInertia * torques;
}

}  // namespace

Matrix3 contactMatrix(const BodyMass& a, const BodyMass& b, const Contact& contact) {
  const Matrix3 K = (a.inverseMass + b.inverseMass) * Matrix3::Identity() +
                    turningPart(a.inverseInertia, contact.armA) +
                    turningPart(b.inverseInertia, contact.armB);
  return (K + K.transpose()) / 2;
}

Matrix2 contactMatrix(const PlanarBodyMass& a, const PlanarBodyMass& b,
                      const PlanarContact& contact) {
  Matrix2 K = (a.inverseMass + b.inverseMass) * Matrix2::Identity();
  const auto add = [&K](Real inverseInertia, const Vector2& r) {
    K(0, 0) += inverseInertia * r.y() * r.y();
    K(1, 1) += inverseInertia * r.x() * r.x();
    K(0, 1) -= inverseInertia * r.x() * r.y();
  };
  add(a.inverseInertia, contact.armA);
  add(b.inverseInertia, contact.armB);
  K(1, 0) = K(0, 1);
  return K;
}

Real impactEnergyChange(const Matrix3& K, const Vector3& u, const Vector3& impulse) {
  return impulse.dot(u + K * impulse / 2);
}

Real impactEnergyChange(const Matrix2& K, const Vector2& u, const Vector2& impulse) {
  return impulse.dot(u + K * impulse / 2);
}

}  // namespace carom
