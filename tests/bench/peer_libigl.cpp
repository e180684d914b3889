#include <igl/moments.h>

#include <Eigen/Dense>
#include <memory>

#include "bench/peers.hpp"

namespace carom::bench {

std::function<MassProperties()> libiglMoments(const TriangleMesh& mesh) {
  struct Arrays {
    Eigen::MatrixXd V;
    Eigen::MatrixXi F;
  };
  const auto arrays = std::make_shared<Arrays>();
  arrays->V.resize(static_cast<Eigen::Index>(mesh.vertices.size()), 3);
  arrays->F.resize(static_cast<Eigen::Index>(mesh.triangles.size()), 3);
  for (Eigen::Index v = 0; v < arrays->V.rows(); ++v) {
    arrays->V.row(v) = mesh.vertices[static_cast<std::size_t>(v)].transpose();
  }
  for (Eigen::Index t = 0; t < arrays->F.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      arrays->F(t, k) = mesh.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
    }
  }
  return [arrays] {
    double volume = 0;
    Eigen::Vector3d first;
    Eigen::Matrix3d inertia;
    igl::moments(arrays->V, arrays->F, volume, first, inertia);
    MassProperties body;
    body.volume = body.mass = volume;
    body.center = first / volume;
    body.inertia = inertia;
    return body;
  };
}

}  // namespace carom::bench
