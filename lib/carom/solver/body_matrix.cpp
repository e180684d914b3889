#include "carom/solver/body_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "carom/core/expect.hpp"

namespace carom {

namespace {

constexpr int kSize = 6;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// C -= A B. Columns one after the other, so that a compiler sees six independent sums.
void subtractProduct(const BodyBlock& A, const BodyBlock& B, BodyBlock& C) {
  for (int j = 0; j < kSize; ++j) {
    for (int k = 0; k < kSize; ++k) {
      const Real b = B(k, j);
      for (int i = 0; i < kSize; ++i) C(i, j) -= A(i, k) * b;
    }
  }
}

void multiply(const BodyBlock& A, const BodyBlock& B, BodyBlock& C) {
  C.setZero();
  for (int j = 0; j < kSize; ++j) {
    for (int k = 0; k < kSize; ++k) {
      const Real b = B(k, j);
      for (int i = 0; i < kSize; ++i) C(i, j) += A(i, k) * b;
    }
  }
}

void subtractProduct(const BodyBlock& A, const BodyVector& x, BodyVector& y) {
  for (int k = 0; k < kSize; ++k) {
    for (int i = 0; i < kSize; ++i) y[i] -= A(i, k) * x[k];
  }
}

// The inverse by Gauss and Jordan, the largest number of a column first.
bool invert(BodyBlock& A) {
  BodyBlock inverse = BodyBlock::Identity();
  for (int k = 0; k < kSize; ++k) {
    int best = k;
    for (int i = k + 1; i < kSize; ++i) {
      if (std::abs(A(i, k)) > std::abs(A(best, k))) best = i;
    }
    const Real pivot = A(best, k);
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot)) return false;
    if (best != k) {
      A.row(k).swap(A.row(best));
      inverse.row(k).swap(inverse.row(best));
    }
    const Real scale = 1 / pivot;
    for (int j = 0; j < kSize; ++j) {
      A(k, j) *= scale;
      inverse(k, j) *= scale;
    }
    for (int i = 0; i < kSize; ++i) {
      if (i == k) continue;
      const Real part = A(i, k);
      if (part == 0) continue;
      for (int j = 0; j < kSize; ++j) {
        A(i, j) -= part * A(k, j);
        inverse(i, j) -= part * inverse(k, j);
      }
    }
  }
  A = inverse;
  return true;
}

// At least so many lists, with room for the neighbours that bodies of a pile usually have: the next
// island has others, and would ask for memory by ones and twos for long.
void makeLists(std::vector<std::vector<int>>& lists, std::size_t count) {
  constexpr std::size_t kUsual = 32;
  while (lists.size() < count) lists.emplace_back().reserve(kUsual);
}

}  // namespace

void BodyMatrix::reserve(int bodies, int links) {
  const std::size_t n = at(bodies), m = at(links);
  links_.reserve(m);
  makeLists(near_, n);
  makeLists(later_, n);
  merged_.reserve(n);
  for (std::vector<int>* ofBodies : {&position_, &bodyAt_}) ofBodies->reserve(n);
  start_.reserve(n + 1);
  for (std::vector<int>* ofLinks : {&column_, &slotOf_}) ofLinks->reserve(m);
  pivots_.reserve(n);
  upper_.reserve(m);
  lower_.reserve(m);
  permuted_.reserve(n);
}

void BodyMatrix::analyse(int bodies, std::span<const BodyLink> links) {
  if (bodies == bodies_ && std::equal(links.begin(), links.end(), links_.begin(), links_.end())) {
    return;
  }
  bodies_ = bodies;
  links_.assign(links.begin(), links.end());
  order();
  locateLinks();
}

void BodyMatrix::order() {
  const std::size_t n = at(bodies_);
  makeLists(near_, n);
  makeLists(later_, n);
  for (std::size_t i = 0; i < n; ++i) near_[i].clear();
  for (const BodyLink& link : links_) {
    CAROM_EXPECT(link.first != link.second, "a link is between two different bodies");
    near_[at(link.first)].push_back(link.second);
    near_[at(link.second)].push_back(link.first);
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<int>& list = near_[i];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  constexpr int kLeft = -1;
  position_.assign(n, kLeft);
  bodyAt_.resize(n);
  work_ = 0;
  for (int place = 0; place < bodies_; ++place) {
    int best = kLeft;
    for (int i = 0; i < bodies_; ++i) {
      if (position_[at(i)] != kLeft) continue;
      if (best == kLeft || near_[at(i)].size() < near_[at(best)].size()) best = i;
    }
    position_[at(best)] = place;
    bodyAt_[at(place)] = best;
    const std::vector<int>& around = near_[at(best)];
    for (const int i : around) {
      // Its neighbours become neighbours of one another.
      std::vector<int>& list = near_[at(i)];
      merged_.clear();
      std::set_union(list.begin(), list.end(), around.begin(), around.end(),
                     std::back_inserter(merged_));
      merged_.erase(std::remove_if(merged_.begin(), merged_.end(),
                                   [&](int k) { return k == i || k == best; }),
                    merged_.end());
      list.assign(merged_.begin(), merged_.end());  // each keeps its memory
    }
    const auto degree = static_cast<std::int64_t>(around.size());
    work_ += degree * (degree + 1) + 1;
  }
  start_.assign(n + 1, 0);
  column_.clear();
  for (int place = 0; place < bodies_; ++place) {
    std::vector<int>& list = later_[at(place)];
    list.clear();
    for (const int body : near_[at(bodyAt_[at(place)])]) list.push_back(position_[at(body)]);
    std::sort(list.begin(), list.end());
    column_.insert(column_.end(), list.begin(), list.end());
    start_[at(place) + 1] = static_cast<int>(column_.size());
  }
  if (pivots_.size() < n) pivots_.resize(n);
  if (upper_.size() < column_.size()) {
    upper_.resize(column_.size());
    lower_.resize(column_.size());
  }
  if (permuted_.size() < n) permuted_.resize(n);
}

void BodyMatrix::locateLinks() {
  slotOf_.resize(links_.size());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const int p = position_[at(links_[i].first)], q = position_[at(links_[i].second)];
    const auto from = column_.begin() + start_[at(std::min(p, q))];
    const auto to = column_.begin() + start_[at(std::min(p, q)) + 1];
    slotOf_[i] = static_cast<int>(std::lower_bound(from, to, std::max(p, q)) - column_.begin());
  }
}

void BodyMatrix::clear() {
  for (int i = 0; i < bodies_; ++i) pivots_[at(i)].setZero();
  for (std::size_t i = 0; i < column_.size(); ++i) {
    upper_[i].setZero();
    lower_[i].setZero();
  }
}

BodyBlock& BodyMatrix::diagonal(int body) {
  return pivots_[at(position_[at(body)])];
}

BodyMatrix::Sides BodyMatrix::between(int link) {
  const std::size_t slot = at(slotOf_[at(link)]);
  const BodyLink& names = links_[at(link)];
  const bool firstEarlier = position_[at(names.first)] < position_[at(names.second)];
  return firstEarlier ? Sides{upper_[slot], lower_[slot]} : Sides{lower_[slot], upper_[slot]};
}

bool BodyMatrix::factor(bool symmetric) {
  BodyBlock scaled;
  for (int k = 0; k < bodies_; ++k) {
    if (!invert(pivots_[at(k)])) return false;
    const int from = start_[at(k)], to = start_[at(k) + 1];
    for (int s = from; s < to; ++s) {
      const int i = column_[at(s)];
      multiply(symmetric ? BodyBlock(upper_[at(s)].transpose()) : lower_[at(s)], pivots_[at(k)],
               scaled);
      lower_[at(s)] = scaled;
      subtractProduct(scaled, upper_[at(s)], pivots_[at(i)]);
      // Both lists ascend, and all that k is linked to is linked to i.
      int mine = start_[at(i)];
      for (int t = s + 1; t < to; ++t) {
        while (column_[at(mine)] != column_[at(t)]) ++mine;
        subtractProduct(scaled, upper_[at(t)], upper_[at(mine)]);
      }
    }
    if (symmetric) continue;
    // The other half: rows of what comes later, columns of i.
    for (int s = from; s < to; ++s) {
      int mine = start_[at(column_[at(s)])];
      for (int t = s + 1; t < to; ++t) {
        while (column_[at(mine)] != column_[at(t)]) ++mine;
        subtractProduct(lower_[at(t)], upper_[at(s)], lower_[at(mine)]);
      }
    }
  }
  return true;
}

void BodyMatrix::solve(std::span<BodyVector> x) const {
  for (int k = 0; k < bodies_; ++k) permuted_[at(k)] = x[at(bodyAt_[at(k)])];
  for (int k = 0; k < bodies_; ++k) {
    for (int s = start_[at(k)]; s < start_[at(k) + 1]; ++s) {
      subtractProduct(lower_[at(s)], permuted_[at(k)], permuted_[at(column_[at(s)])]);
    }
  }
  for (int k = bodies_ - 1; k >= 0; --k) {
    BodyVector right = permuted_[at(k)];
    for (int s = start_[at(k)]; s < start_[at(k) + 1]; ++s) {
      subtractProduct(upper_[at(s)], permuted_[at(column_[at(s)])], right);
    }
    BodyVector solution = BodyVector::Zero();
    for (int j = 0; j < kSize; ++j) {
      for (int i = 0; i < kSize; ++i) solution[i] += pivots_[at(k)](i, j) * right[j];
    }
    permuted_[at(k)] = solution;
  }
  for (int k = 0; k < bodies_; ++k) x[at(bodyAt_[at(k)])] = permuted_[at(k)];
}

}  // namespace carom
