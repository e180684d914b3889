// The small exact solver for contacts: against all active sets tried one by one, and on problems
// that make careless pivoting fail.

#include <cmath>
#include <vector>

#include "carom/core/errors.hpp"
#include "carom/core/random.hpp"
#include "carom/impulse/linear_complementarity.hpp"
#include "support/catch.hpp"

using namespace carom;
using namespace carom_test;

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// B^T B for a random B of the given rank: positive semi-definite.
DenseMatrix randomGram(Random& random, int n, int rank) {
  DenseMatrix B(rank, n), M(n, n);
  for (int i = 0; i < rank; ++i) {
    for (int j = 0; j < n; ++j) B(i, j) = random.between(-1, 1);
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < rank; ++k) M(i, j) += B(k, i) * B(k, j);
    }
  }
  return M;
}

std::vector<Real> product(const DenseMatrix& M, const std::vector<Real>& z) {
  std::vector<Real> w(at(M.rows()));
  for (int i = 0; i < M.rows(); ++i) {
    for (int j = 0; j < M.columns(); ++j) w[at(i)] += M(i, j) * z[at(j)];
  }
  return w;
}

// Largest violation of z >= 0, w >= 0, z w = 0.
Real violation(const DenseMatrix& M, const std::vector<Real>& q, const std::vector<Real>& z) {
  const std::vector<Real> w = product(M, z);
  Real worst = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Real speed = w[i] + q[i];
    worst = std::max({worst, -z[i], -speed, std::min(z[i], std::abs(speed))});
  }
  return worst;
}

// Gauss-Jordan with full pivoting on the equations of an active set; empty if singular.
std::vector<Real> solved(const DenseMatrix& M, const std::vector<Real>& q, unsigned set) {
  std::vector<int> active;
  for (int i = 0; i < M.rows(); ++i) {
    if (set >> i & 1) active.push_back(i);
  }
  const int n = static_cast<int>(active.size());
  DenseMatrix t(n, n + 1);
  std::vector<int> rowOf(at(n), -1);
  std::vector<bool> used(at(n), false);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) t(i, j) = M(active[at(i)], active[at(j)]);
    t(i, n) = -q[at(active[at(i)])];
  }
  for (int step = 0; step < n; ++step) {
    int row = -1, column = -1;
    Real best = 1e-10;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        if (used[at(i)] || rowOf[at(j)] >= 0 || std::abs(t(i, j)) <= best) continue;
        best = std::abs(t(i, j)), row = i, column = j;
      }
    }
    if (row < 0) return {};
    used[at(row)] = true;
    rowOf[at(column)] = row;
    for (int i = 0; i < n; ++i) {
      if (i == row) continue;
      const Real factor = t(i, column) / t(row, column);
      for (int j = 0; j <= n; ++j) t(i, j) -= factor * t(row, j);
    }
  }
  std::vector<Real> z(at(M.rows()), 0);
  for (int j = 0; j < n; ++j) z[at(active[at(j)])] = t(rowOf[at(j)], n) / t(rowOf[at(j)], j);
  return z;
}

// Every active set: the least violation that any of them reaches, and its z.
std::vector<Real> byBruteForce(const DenseMatrix& M, const std::vector<Real>& q) {
  std::vector<Real> best(q.size(), 0);
  for (unsigned set = 1; set < 1u << M.rows(); ++set) {
    const std::vector<Real> z = solved(M, q, set);
    if (!z.empty() && violation(M, q, z) < violation(M, q, best)) best = z;
  }
  return best;
}

}  // namespace

TEST_CASE("contacts that part need no impulse") {
  const Complementarity result = solveComplementarity(DenseMatrix(2, 2), std::vector<Real>{0, 3});
  CHECK(result.status == ComplementarityStatus::solved);
  CHECK(result.z == std::vector<Real>{0, 0});
  CHECK(result.pivots == 0);
  CHECK(solveComplementarity(DenseMatrix(0, 0), {}).z.empty());
}

TEST_CASE("one contact is stopped; of two the second may come free by itself") {
  DenseMatrix M(1, 1);
  M(0, 0) = 4;
  CHECK(solveComplementarity(M, std::vector<Real>{-6}).z == std::vector<Real>{1.5});
  // Pushing the first away pulls the second away twice as fast as it approaches.
  DenseMatrix N(2, 2);
  N(0, 0) = N(1, 1) = 2, N(0, 1) = N(1, 0) = 1;
  const Complementarity result = solveComplementarity(N, std::vector<Real>{-4, -1});
  CHECK(result.z == std::vector<Real>{2, 0});
}

TEST_CASE("random problems up to eight contacts agree with all active sets tried one by one") {
  Random random(1965);
  for (int i = 0; i < 600; ++i) {
    const int n = random.integer(1, 8);
    const DenseMatrix M = randomGram(random, n, n + 2);
    std::vector<Real> q(at(n));
    for (Real& x : q) x = random.between(-1, 1);
    const Complementarity result = solveComplementarity(M, q);
    INFO("seed 1965, problem " << i << " of " << n);
    REQUIRE(result.status == ComplementarityStatus::solved);
    REQUIRE(violation(M, q, result.z) < 1e-12);
    const std::vector<Real> expected = byBruteForce(M, q);
    Real size = 0;
    for (const Real z : expected) size = std::max(size, z);
    for (int k = 0; k < n; ++k) {
      REQUIRE(std::abs(result.z[at(k)] - expected[at(k)]) < 1e-9 * (1 + size));
    }
  }
}

TEST_CASE("redundant contacts: a table with more legs than it needs") {
  // Rank 3 for up to 12 contacts, and speeds that bodies can have: q = B^T v.
  Random random(4);
  for (int i = 0; i < 400; ++i) {
    const int n = random.integer(4, 12);
    DenseMatrix B(3, n), M(n, n);
    std::vector<Real> q(at(n), 0);
    const Vector3 v(random.between(-1, 1), random.between(-1, 1), -1);
    for (int j = 0; j < n; ++j) {
      B(0, j) = random.integer(-2, 2);
      B(1, j) = random.integer(-2, 2);
      B(2, j) = 1;
      for (int k = 0; k < 3; ++k) q[at(j)] += B(k, j) * v(k);
    }
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c) {
        for (int k = 0; k < 3; ++k) M(r, c) += B(k, r) * B(k, c);
      }
    }
    const Complementarity result = solveComplementarity(M, q);
    INFO("seed 4, problem " << i << " of " << n);
    REQUIRE(result.status == ComplementarityStatus::solved);
    REQUIRE(violation(M, q, result.z) < 1e-12);
    REQUIRE(result.residual < 1e-12);
    // The speeds afterwards are the same for every solution; only the shares are not.
    int pushing = 0;
    for (const Real z : result.z) pushing += z > 0;
    REQUIRE(pushing <= 3);
  }
}

TEST_CASE("ties do not make it go round in circles") {
  // All contacts alike: every choice is a tie.
  for (int n = 2; n <= 16; ++n) {
    DenseMatrix M(n, n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) M(i, j) = 1;
    }
    const Complementarity result = solveComplementarity(M, std::vector<Real>(at(n), -1));
    REQUIRE(result.status == ComplementarityStatus::solved);
    Real sum = 0;
    for (const Real z : result.z) sum += z;
    CHECK(std::abs(sum - 1) < 1e-14);
    CHECK(result.pivots <= 3 * n);
  }
  // Beale's and Kostreva's examples cycle for rules without order; as complementarity problems of
  // contacts their like are M with zero rows and equal ratios.
  DenseMatrix M(4, 4);
  const Real rows[4][4] = {{1, -1, 0, 0}, {-1, 2, -1, 0}, {0, -1, 2, -1}, {0, 0, -1, 1}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) M(i, j) = rows[i][j];
  }
  const std::vector<Real> q = {-1, 1, -1, 1};  // a free chain that is squeezed at two places
  const Complementarity result = solveComplementarity(M, q);
  REQUIRE(result.status == ComplementarityStatus::solved);
  CHECK(violation(M, q, result.z) < 1e-14);
}

TEST_CASE("what has no solution is said to have none") {
  DenseMatrix M(2, 2);  // nothing can stop the second
  M(0, 0) = 1;
  CHECK(solveComplementarity(M, std::vector<Real>{-1, -1}).status == ComplementarityStatus::ray);
  CHECK(solveComplementarity(M, std::vector<Real>{-1, -1}).z.empty());
}

TEST_CASE("masses of many decades do not matter") {
  Random random(12);
  for (int i = 0; i < 200; ++i) {
    const int n = 6;
    const DenseMatrix even = randomGram(random, n, n + 2);
    std::vector<Real> scale(at(n)), q(at(n));
    DenseMatrix M(n, n);
    for (int k = 0; k < n; ++k) scale[at(k)] = std::pow(10, random.between(-6, 6));
    for (int r = 0; r < n; ++r) {
      q[at(r)] = scale[at(r)] * random.between(-1, 1);
      for (int c = 0; c < n; ++c) M(r, c) = scale[at(r)] * even(r, c) * scale[at(c)];
    }
    const Complementarity result = solveComplementarity(M, q);
    INFO("seed 12, problem " << i);
    REQUIRE(result.status == ComplementarityStatus::solved);
    REQUIRE(result.residual < 1e-12);
  }
}

TEST_CASE("mirrored contacts get the same impulse to the last bit") {
  Random random(13);
  for (int i = 0; i < 500; ++i) {
    DenseMatrix M(3, 3);
    const Real side = random.between(0.1, 0.9), across = random.between(-0.5, 0.5);
    M(0, 0) = M(1, 1) = 2, M(2, 2) = random.between(1, 3);
    M(0, 1) = M(1, 0) = across;
    M(0, 2) = M(2, 0) = M(1, 2) = M(2, 1) = side;
    const Real q = random.between(-1, -0.1);
    const std::vector<Real> z =
        solveComplementarity(M, std::vector<Real>{q, q, random.between(-1, 1)}).z;
    INFO("seed 13, problem " << i);
    REQUIRE(z[0] == z[1]);
  }
}

TEST_CASE("matrices that do not fit are refused") {
  CHECK_THROWS_WITH(solveComplementarity(DenseMatrix(2, 3), std::vector<Real>{1, 1}),
                    ContainsSubstring("2 x 3 must be square"));
  CHECK_THROWS_AS(solveComplementarity(DenseMatrix(2, 2), std::vector<Real>{1}), InvalidInput);
  CHECK_THROWS_AS(solveComplementarity(DenseMatrix(1, 1), std::vector<Real>{NAN}), InvalidInput);
}
