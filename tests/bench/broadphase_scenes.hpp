#pragma once
// Boxes that move, for the suite `broadphase`: the same for every engine.

#include <cmath>
#include <string>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/detection/aabb.hpp"

namespace carom::bench {

/// What moves how.
enum class BroadScene {
  gas,     ///< bodies of 0.5 to 1 m, 8 m^3 for each, all flying at up to 2 m/s
  pile,    ///< cubes of 1 m that lean on each other and tremble by a millimetre, on a floor
  mixed,   ///< a few large among many small ones, from 0.2 m to 20 m, flying
  resting  ///< as the gas, but one in a hundred flies and the others sleep
};

/// Its name in figures. \param scene which \return one word
inline const char* nameOf(BroadScene scene) {
  constexpr const char* kNames[] = {"gas", "pile", "mixed", "resting"};
  return kNames[static_cast<int>(scene)];
}

/// Bodies as boxes, moving in steps of 1/60 s.
class MovingBoxes {
 public:
  /// \param scene which \param count how many bodies
  MovingBoxes(BroadScene scene, int count) : scene_(scene), random_(1000 + count) {
    boxes.resize(6 * static_cast<std::size_t>(count));
    ways.resize(count, Vector3::Zero());
    immovable.resize(count, 0);
    size = std::cbrt(8.0 * count) / 2;
    const int edge = static_cast<int>(std::ceil(std::cbrt(count)));
    for (int i = 0; i < count; ++i) {
      Vector3 center = random_.vector(size), half = Vector3::Constant(0.5);
      const Vector3 way = random_.vector(2.0 / 60);
      for (int k = 0; k < 3; ++k) half(k) = random_.between(0.25, 0.5);
      bool flies = true;
      if (scene == BroadScene::pile) {
        center = Vector3(i % edge - edge / 2, i / edge % edge - edge / 2, i / edge / edge) * 0.99;
        half = Vector3::Constant(0.5);
      } else if (scene == BroadScene::mixed) {
        // As many of each size as keeps their volumes alike.
        half *= 0.4 / std::cbrt(random_.between(1e-6, 1));
        half = half.cwiseMin(10);
      } else if (scene == BroadScene::resting) {
        flies = i % 100 == 0;
      }
      if (scene == BroadScene::pile && i == 0) {
        immovable[0] = 1;
        center = Vector3(0, 0, -50.4);
        half = Vector3(1000, 1000, 50);
        flies = false;
      }
      if (flies) {
        awake.push_back(i);
        ways[i] = way;
      }
      put(i, center - half, center + half);
    }
    if (scene == BroadScene::pile) rest_ = boxes;
  }

  /// Moves all that is awake on by a step.
  void step() {
    for (const std::int32_t i : awake) {
      Vector3 low(boxes[6 * i], boxes[6 * i + 1], boxes[6 * i + 2]);
      Vector3 high(boxes[6 * i + 3], boxes[6 * i + 4], boxes[6 * i + 5]);
      if (scene_ == BroadScene::pile) {
        const Vector3 tremble = random_.vector(1e-3);
        for (int k = 0; k < 3; ++k) {
          low(k) = rest_[6 * i + k] + tremble(k);
          high(k) = rest_[6 * i + k + 3] + tremble(k);
        }
      } else {
        // Back from the walls.
        for (int k = 0; k < 3; ++k) {
          if (low(k) + high(k) > 2 * size) ways[i](k) = -std::abs(ways[i](k));
          if (low(k) + high(k) < -2 * size) ways[i](k) = std::abs(ways[i](k));
        }
        low += ways[i];
        high += ways[i];
      }
      put(i, low, high);
    }
  }

  std::vector<double> boxes;        ///< six numbers for each body [m]
  std::vector<Vector3> ways;        ///< displacement in a step [m]
  std::vector<char> immovable;      ///< those that never move
  std::vector<std::int32_t> awake;  ///< those that may move
  Real size = 0;                    ///< centres are within +-size [m]

 private:
  void put(int i, const Vector3& low, const Vector3& high) {
    for (int k = 0; k < 3; ++k) {
      boxes[6 * i + k] = low(k);
      boxes[6 * i + 3 + k] = high(k);
    }
  }
  BroadScene scene_;
  Random random_;
  std::vector<double> rest_;
};

}  // namespace carom::bench
