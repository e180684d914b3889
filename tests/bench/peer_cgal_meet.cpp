#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include <memory>

#include "bench/narrowphase_peers.hpp"

namespace carom::bench {
namespace {

template <class Kernel>
std::vector<typename Kernel::Triangle_2> bodies(const std::vector<Vector2>& corners) {
  const auto point = [&](std::size_t i) {
    return typename Kernel::Point_2(corners[i].x(), corners[i].y());
  };
  std::vector<typename Kernel::Triangle_2> all;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    all.emplace_back(point(i), point(i + 1), point(i + 2));
  }
  return all;
}

template <class Kernel>
std::vector<typename Kernel::Tetrahedron_3> bodies(const std::vector<Vector3>& corners) {
  const auto point = [&](std::size_t i) {
    return typename Kernel::Point_3(corners[i].x(), corners[i].y(), corners[i].z());
  };
  std::vector<typename Kernel::Tetrahedron_3> all;
  for (std::size_t i = 0; i + 3 < corners.size(); i += 4) {
    all.emplace_back(point(i), point(i + 1), point(i + 2), point(i + 3));
  }
  return all;
}

template <class Kernel, class Point>
MeetMethod method(const char* name, const SimplexPairs<Point>& pairs) {
  using Bodies = decltype(bodies<Kernel>(pairs.a));
  const auto a = std::make_shared<Bodies>(bodies<Kernel>(pairs.a));
  const auto b = std::make_shared<Bodies>(bodies<Kernel>(pairs.b));
  return {name, [a, b](std::size_t i) { return CGAL::do_intersect((*a)[i], (*b)[i]); }};
}

template <class Point>
std::vector<MeetMethod> methods(const SimplexPairs<Point>& pairs) {
  return {method<CGAL::Simple_cartesian<double>>("CGAL, doubles", pairs),
          method<CGAL::Exact_predicates_inexact_constructions_kernel>("CGAL Epick", pairs),
          method<CGAL::Exact_predicates_exact_constructions_kernel>("CGAL Epeck", pairs)};
}

}  // namespace

std::vector<MeetMethod> cgalMeet(const SimplexPairs<Vector2>& pairs) {
  return methods(pairs);
}
std::vector<MeetMethod> cgalMeet(const SimplexPairs<Vector3>& pairs) {
  return methods(pairs);
}

}  // namespace carom::bench
