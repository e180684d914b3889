#include "carom/broadphase/sorted_sweep.hpp"

#include <algorithm>

namespace carom {

// The axis with the largest variance of the centres; another one than now only if twice as large.
int SortedSweep::bestAxis() const {
  Vector3 sum = Vector3::Zero(), squares = Vector3::Zero();
  for (const Placed& placed : sorted_) {
    // Infinite sides count as far away; so no infinity meets its opposite.
    const Vector3 low = placed.box.low.cwiseMax(-1e100).cwiseMin(1e100);
    const Vector3 high = placed.box.high.cwiseMax(-1e100).cwiseMin(1e100);
    const Vector3 center = low + high;
    sum += center;
    squares += center.cwiseProduct(center);
  }
  const Vector3 mean = sum / static_cast<Real>(sorted_.size());
  const Vector3 spread = squares - mean.cwiseProduct(sum);
  int best = axis_;
  for (int k = 0; k < 3; ++k) {
    if (spread(k) > 2 * spread(axis_) && spread(k) > spread(best)) best = k;
  }
  return best;
}

void SortedSweep::sortAnew() {
  ++sorts_;
  std::sort(sorted_.begin(), sorted_.end(), [this](const Placed& a, const Placed& b) {
    if (a.box.low(axis_) != b.box.low(axis_)) return a.box.low(axis_) < b.box.low(axis_);
    return a.index < b.index;
  });
}

void SortedSweep::update(std::span<const Aabb<3>> boxes) {
  const bool isNew = boxes.size() != sorted_.size();
  if (isNew) {
    sorted_.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) sorted_[i].index = static_cast<std::int32_t>(i);
  }
  if (boxes.empty()) return;
  for (Placed& placed : sorted_) placed.box = boxes[placed.index];
  const int axis = bestAxis();
  if (isNew || axis != axis_) {
    axis_ = axis;
    return sortAnew();
  }
  // Each box moves down past those that begin later. More than a few exchanges for each box, and a
  // sort from scratch is cheaper.
  std::int64_t left = 4 * static_cast<std::int64_t>(boxes.size());
  for (std::size_t i = 1; i < sorted_.size(); ++i) {
    const Placed moving = sorted_[i];
    std::size_t place = i;
    for (; place > 0 && sorted_[place - 1].box.low(axis_) > moving.box.low(axis_); --place) {
      sorted_[place] = sorted_[place - 1];
    }
    sorted_[place] = moving;
    exchanges_ += static_cast<std::int64_t>(i - place);
    left -= static_cast<std::int64_t>(i - place);
    if (left < 0) return sortAnew();
  }
}

}  // namespace carom
