// The sparse matrix of an island: its solutions are put back into the equations.

#include <algorithm>
#include <cmath>
#include <vector>

#include "carom/core/random.hpp"
#include "carom/solver/body_matrix.hpp"
#include "support/catch.hpp"

namespace {

using namespace carom;

BodyBlock randomBlock(Random& random) {
  BodyBlock block;
  for (int j = 0; j < 6; ++j) {
    for (int i = 0; i < 6; ++i) block(i, j) = random.between(-1, 1);
  }
  return block;
}

// A matrix and all that was put into it.
struct Filled {
  int bodies = 0;
  std::vector<BodyLink> links;
  std::vector<BodyBlock> diagonal;
  std::vector<BodyBlock> firstSecond, secondFirst;
};

Filled fill(int bodies, const std::vector<BodyLink>& links, bool symmetric, BodyMatrix& matrix) {
  Random random(42);
  Filled filled{bodies, links, {}, {}, {}};
  matrix.analyse(bodies, links);
  matrix.clear();
  std::vector<Real> weight(static_cast<std::size_t>(bodies), 1);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const BodyBlock B = randomBlock(random);
    const BodyBlock C = symmetric ? BodyBlock(B.transpose()) : randomBlock(random);
    filled.firstSecond.push_back(B);
    filled.secondFirst.push_back(C);
    const BodyMatrix::Sides sides = matrix.between(static_cast<int>(i));
    sides.firstSecond += B;
    sides.secondFirst += C;
    weight[static_cast<std::size_t>(links[i].first)] += 6;
    weight[static_cast<std::size_t>(links[i].second)] += 6;
  }
  for (int i = 0; i < bodies; ++i) {
    const BodyBlock A = randomBlock(random);
    BodyBlock D = symmetric ? BodyBlock((A + A.transpose()) / 2) : A;
    D += 7 * weight[static_cast<std::size_t>(i)] * BodyBlock::Identity();
    filled.diagonal.push_back(D);
    matrix.diagonal(i) += D;
  }
  return filled;
}

// Largest error of the equations.
Real residual(const Filled& filled, const std::vector<BodyVector>& x,
              const std::vector<BodyVector>& right) {
  std::vector<BodyVector> left;
  for (std::size_t i = 0; i < x.size(); ++i) left.push_back(filled.diagonal[i] * x[i]);
  for (std::size_t i = 0; i < filled.links.size(); ++i) {
    const auto p = static_cast<std::size_t>(filled.links[i].first);
    const auto q = static_cast<std::size_t>(filled.links[i].second);
    left[p] += filled.firstSecond[i] * x[q];
    left[q] += filled.secondFirst[i] * x[p];
  }
  Real worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, (left[i] - right[i]).cwiseAbs().maxCoeff());
  }
  return worst;
}

std::vector<BodyVector> rightSide(int bodies) {
  Random random(7);
  std::vector<BodyVector> right;
  for (int i = 0; i < bodies; ++i) right.push_back(randomBlock(random).col(0));
  return right;
}

std::vector<BodyLink> chain(int bodies) {
  std::vector<BodyLink> links;
  // From the middle outwards, so that the order of the numbers is no help.
  for (int i = 0; i + 1 < bodies; ++i) links.push_back({(i + 1) * 7 % bodies, i * 7 % bodies});
  return links;
}

std::vector<BodyLink> grid(int side) {
  std::vector<BodyLink> links;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      if (i + 1 < side) links.push_back({i * side + j, (i + 1) * side + j});
      if (j + 1 < side) links.push_back({i * side + j + 1, i * side + j});
    }
  }
  return links;
}

void check(int bodies, const std::vector<BodyLink>& links, bool symmetric, BodyMatrix& matrix) {
  const Filled filled = fill(bodies, links, symmetric, matrix);
  REQUIRE(matrix.factor(symmetric));
  const std::vector<BodyVector> right = rightSide(bodies);
  std::vector<BodyVector> x = right;
  matrix.solve(x);
  CHECK(residual(filled, x, right) < 1e-14);
}

}  // namespace

TEST_CASE("the solution of a sparse system satisfies its equations") {
  BodyMatrix matrix;  // one for all: nothing of the last pattern may be left
  for (const bool symmetric : {true, false}) {
    INFO(symmetric);
    check(1, {}, symmetric, matrix);
    check(2, {{1, 0}}, symmetric, matrix);
    check(40, chain(40), symmetric, matrix);
    check(36, grid(6), symmetric, matrix);
    check(3, {{0, 1}, {1, 0}, {2, 1}, {0, 2}}, symmetric, matrix);
    check(40, chain(40), symmetric, matrix);
  }
}

TEST_CASE("random islands of all densities are solved") {
  Random random(11);
  for (int island = 0; island < 20; ++island) {
    const int bodies = random.integer(2, 20);
    std::vector<BodyLink> links;
    const int count = random.integer(1, 3 * bodies);
    for (int i = 0; i < count; ++i) {
      const int p = random.integer(0, bodies - 1);
      const int q = random.integer(0, bodies - 1);
      if (p != q) links.push_back({p, q});
    }
    INFO("island " << island);
    BodyMatrix matrix;
    check(bodies, links, island % 2 == 0, matrix);
  }
}

TEST_CASE("a tower costs as many products as it has bodies, and a wall of them little more") {
  BodyMatrix matrix;
  const auto workOf = [&](int bodies, const std::vector<BodyLink>& links) {
    matrix.analyse(bodies, links);
    return matrix.work();
  };
  // One inverse and two products for each body but the last: nothing is filled.
  CHECK(workOf(10, chain(10)) == 28);
  CHECK(workOf(1000, chain(1000)) == 2998);
  std::vector<BodyLink> star;
  for (int i = 1; i < 1000; ++i) star.push_back({0, i});
  CHECK(workOf(1000, star) == 2998);
  const std::int64_t small = workOf(100, grid(10)), large = workOf(400, grid(20));
  CHECK(large < 12 * small);  // dense: 64 times
}

TEST_CASE("a block that has no inverse is told") {
  BodyMatrix matrix;
  matrix.analyse(2, std::vector<BodyLink>{{0, 1}});
  matrix.clear();
  matrix.diagonal(0) = BodyBlock::Identity();
  CHECK_FALSE(matrix.factor(true));
}
