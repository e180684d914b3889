#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <algorithm>

#include "bench/broadphase_engines.hpp"

namespace carom::bench {
namespace {

// Its own filters keep pairs of immovable bodies out, as its world sets them. The proxies are left to
// the end of the program: to take each out of a pile looks through all pairs.
struct Bullet : BroadEngine {
  std::unique_ptr<btBroadphaseInterface> phase;
  std::vector<btBroadphaseProxy*> proxies;

  explicit Bullet(std::unique_ptr<btBroadphaseInterface> its) : phase(std::move(its)) {}
  static btVector3 corner(const double* at) {
    return btVector3(at[0], at[1], at[2]);
  }
  void add(const std::vector<double>& boxes, const std::vector<char>& immovable) override {
    for (std::size_t i = 0; i < immovable.size(); ++i) {
      const int group = immovable[i] ? 2 : 1, mask = immovable[i] ? ~2 : ~0;
      proxies.push_back(phase->createProxy(corner(&boxes[6 * i]), corner(&boxes[6 * i + 3]), 0,
                                           nullptr, group, mask, nullptr));
      proxies.back()->m_clientObject = reinterpret_cast<void*>(i);
    }
    phase->calculateOverlappingPairs(nullptr);
  }
  void step(const double* boxes, const std::vector<std::int32_t>& awake) override {
    for (const std::int32_t i : awake) {
      phase->setAabb(proxies[i], corner(boxes + 6 * i), corner(boxes + 6 * i + 3), nullptr);
    }
    phase->calculateOverlappingPairs(nullptr);
  }
  void pairs(std::vector<std::pair<std::int32_t, std::int32_t>>& out) override {
    btBroadphasePairArray& array = phase->getOverlappingPairCache()->getOverlappingPairArray();
    for (int k = 0; k < array.size(); ++k) {
      const auto a = reinterpret_cast<std::intptr_t>(array[k].m_pProxy0->m_clientObject);
      const auto b = reinterpret_cast<std::intptr_t>(array[k].m_pProxy1->m_clientObject);
      out.emplace_back(static_cast<std::int32_t>(std::min(a, b)),
                       static_cast<std::int32_t>(std::max(a, b)));
    }
  }
};

}  // namespace

std::unique_ptr<BroadEngine> bulletTree() {
  return std::make_unique<Bullet>(std::make_unique<btDbvtBroadphase>());
}

std::unique_ptr<BroadEngine> bulletSweep(double size, int bodies) {
  const btVector3 far(size, size, size);
  return std::make_unique<Bullet>(std::make_unique<bt32BitAxisSweep3>(
      -far, far, static_cast<unsigned int>(bodies + 2), nullptr, true));
}

}  // namespace carom::bench
