#include <ode/ode.h>

#include <algorithm>

#include "bench/broadphase_engines.hpp"

namespace carom::bench {
namespace {

// A geom of our own kind: its box is what it is told, so that ODE need not compute any.
struct Told {
  dReal box[6];
};

void boxOf(dGeomID geom, dReal out[6]) {
  const auto* told = static_cast<const Told*>(dGeomGetClassData(geom));
  std::copy(told->box, told->box + 6, out);
}

dColliderFn* noCollider(int) {
  return nullptr;
}

int toldClass() {
  static const int number = [] {
    dInitODE2(0);
    dGeomClass its = {};
    its.bytes = sizeof(Told);
    its.collider = noCollider;
    its.aabb = boxOf;
    return dCreateGeomClass(&its);
  }();
  return number;
}

// One space for all; bits keep pairs of immovable bodies out.
struct Ode : BroadEngine {
  dSpaceID space;
  std::vector<dGeomID> geoms;
  std::vector<std::pair<std::int32_t, std::int32_t>> found;

  explicit Ode(dSpaceID its) : space(its) {}
  ~Ode() override {
    dSpaceDestroy(space);
  }
  static void tell(dGeomID geom, const double* box) {
    auto* told = static_cast<Told*>(dGeomGetClassData(geom));
    // ODE's order is low and high of each axis.
    for (int k = 0; k < 3; ++k) {
      told->box[2 * k] = box[k];
      told->box[2 * k + 1] = box[k + 3];
    }
  }
  void add(const std::vector<double>& boxes, const std::vector<char>& immovable) override {
    for (std::size_t i = 0; i < immovable.size(); ++i) {
      geoms.push_back(dCreateGeom(toldClass()));
      tell(geoms.back(), &boxes[6 * i]);
      dGeomSetData(geoms.back(), reinterpret_cast<void*>(i));
      dGeomSetCategoryBits(geoms.back(), immovable[i] ? 2 : 1);
      dGeomSetCollideBits(geoms.back(), immovable[i] ? 1 : 3);
      dSpaceAdd(space, geoms.back());
    }
    step(boxes.data(), {});
  }
  static void met(void* self, dGeomID a, dGeomID b) {
    const auto i = reinterpret_cast<std::intptr_t>(dGeomGetData(a));
    const auto j = reinterpret_cast<std::intptr_t>(dGeomGetData(b));
    static_cast<Ode*>(self)->found.emplace_back(static_cast<std::int32_t>(std::min(i, j)),
                                                static_cast<std::int32_t>(std::max(i, j)));
  }
  void step(const double* boxes, const std::vector<std::int32_t>& awake) override {
    for (const std::int32_t i : awake) {
      tell(geoms[i], boxes + 6 * i);
      // Its box is to be asked for again.
      dGeomSetPosition(geoms[i], 0, 0, 0);
    }
    found.clear();
    dSpaceCollide(space, this, met);
  }
  void pairs(std::vector<std::pair<std::int32_t, std::int32_t>>& out) override {
    out = found;
  }
};

}  // namespace

std::unique_ptr<BroadEngine> odeHash(int low, int high) {
  toldClass();
  dSpaceID space = dHashSpaceCreate(nullptr);
  dHashSpaceSetLevels(space, low, high);
  return std::make_unique<Ode>(space);
}

std::unique_ptr<BroadEngine> odeSweep() {
  toldClass();
  return std::make_unique<Ode>(dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ));
}

}  // namespace carom::bench
