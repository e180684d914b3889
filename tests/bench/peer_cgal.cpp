#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <memory>

#include "bench/peers.hpp"
#include "oracle/exact_mass.hpp"

namespace carom::bench {
namespace {

template <class Kernel>
std::shared_ptr<CGAL::Surface_mesh<typename Kernel::Point_3>> surfaceOf(const TriangleMesh& mesh) {
  const auto surface = std::make_shared<CGAL::Surface_mesh<typename Kernel::Point_3>>();
  using Vertex = typename CGAL::Surface_mesh<typename Kernel::Point_3>::Vertex_index;
  for (const Vector3& v : mesh.vertices) surface->add_vertex({v.x(), v.y(), v.z()});
  for (const auto& [a, b, c] : mesh.triangles) {
    surface->add_face(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b)),
                      Vertex(static_cast<unsigned>(c)));
  }
  return surface;
}

}  // namespace

std::function<Real()> cgalExactVolume(const TriangleMesh& mesh) {
  const auto surface = surfaceOf<CGAL::Exact_predicates_exact_constructions_kernel>(mesh);
  return [surface] {
    // The numbers are formulas until somebody asks for their value.
    return CGAL::to_double(CGAL::exact(CGAL::Polygon_mesh_processing::volume(*surface)));
  };
}

std::function<Real()> cgalInexactVolume(const TriangleMesh& mesh) {
  const auto surface = surfaceOf<CGAL::Exact_predicates_inexact_constructions_kernel>(mesh);
  return [surface] { return CGAL::Polygon_mesh_processing::volume(*surface); };
}

std::function<MassErrors(const MassProperties&)> exactJudge(const TriangleMesh& mesh) {
  const auto exact = std::make_shared<carom_test::ExactBody>(carom_test::weighExactly(mesh));
  const Real size = carom_test::sizeOf(mesh);
  return [exact, size](const MassProperties& body) {
    if (!std::isfinite(body.volume) || !body.center.allFinite() || !body.inertia.allFinite()) {
      const Real none = std::numeric_limits<Real>::infinity();
      return MassErrors{none, none, none};
    }
    const auto errors = carom_test::errorsOf(body.volume, body.center, body.inertia, *exact, size);
    return MassErrors{errors.volume, errors.center, errors.inertia};
  };
}

}  // namespace carom::bench
