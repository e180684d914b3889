#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <memory>

#include "bench/precision_peers.hpp"

namespace carom::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::shared_ptr<std::vector<Kernel::Point_2>> pointsOf(const std::vector<Vector2>& points) {
  const auto all = std::make_shared<std::vector<Kernel::Point_2>>();
  for (const Vector2& p : points) all->emplace_back(p.x(), p.y());
  return all;
}

}  // namespace

std::function<int()> cgalSides(const std::vector<Vector2>& points) {
  return [all = pointsOf(points)] {
    int sum = 0;
    for (std::size_t i = 0; i + 2 < all->size(); i += 3) {
      sum += CGAL::orientation((*all)[i], (*all)[i + 1], (*all)[i + 2]);
    }
    return sum;
  };
}

std::function<int()> cgalCircles(const std::vector<Vector2>& points) {
  return [all = pointsOf(points)] {
    int sum = 0;
    for (std::size_t i = 0; i + 3 < all->size(); i += 4) {
      sum += CGAL::side_of_oriented_circle((*all)[i], (*all)[i + 1], (*all)[i + 2], (*all)[i + 3]);
    }
    return sum;
  };
}

std::function<int()> cgalPlanes(const std::vector<Vector3>& points) {
  const auto all = std::make_shared<std::vector<Kernel::Point_3>>();
  for (const Vector3& p : points) all->emplace_back(p.x(), p.y(), p.z());
  return [all] {
    int sum = 0;
    for (std::size_t i = 0; i + 3 < all->size(); i += 4) {
      sum += CGAL::orientation((*all)[i], (*all)[i + 1], (*all)[i + 2], (*all)[i + 3]);
    }
    return sum;
  };
}

}  // namespace carom::bench
