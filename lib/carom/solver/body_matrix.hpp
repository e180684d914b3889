#pragma once
// How are the equations of a tower solved at once?
//
// The question as numbers: one unknown velocity per body, six numbers, and a matrix of blocks of
// six by six: one per body, and two per pair of bodies that touch. A tower of N boxes has N blocks
// in the diagonal and its neighbours beside them, and all others are zero.
// Method: elimination, a body at a time. Eliminating a body links all its neighbours to one
// another; the body with the fewest neighbours goes first (minimum degree), so that a chain stays a
// chain and costs N, a wall of N boxes about N sqrt(N). What is linked in the end is found before
// any number is: the same pattern serves for all matrices of an island.
// Why bodies and not contacts: there are more contacts than bodies, and four points of a face are
// one too many; in the matrix of the bodies they only add.
// Source: Tinney and Walker 1967 (order); George and Liu, Computer Solution of Large Sparse
// Positive Definite Systems, 1981 (pattern before numbers); Baraff 1996 for chains.
// Not handled: pivoting between bodies, which matrices with large blocks in the diagonal do not
// need; a block that cannot be inverted is reported.

#include <cstdint>
#include <span>
#include <vector>

#include "carom/core/real.hpp"

namespace carom {

/// Six numbers of a body: along the axes, then about them. \ingroup solver
using BodyVector = Eigen::Matrix<Real, 6, 1>;
/// How six numbers of one body make six of another. \ingroup solver
using BodyBlock = Eigen::Matrix<Real, 6, 6>;

/// Two bodies that have something to do with each other. \ingroup solver
struct BodyLink {
  int first = 0;   ///< number of a body
  int second = 0;  ///< number of another
  /// \return whether both links are between the same bodies, named in the same order
  bool operator==(const BodyLink&) const = default;
};

/// A sparse matrix of blocks, and its factors. \ingroup solver
class BodyMatrix {
 public:
  /// Takes memory. \param bodies the most in one matrix \param links the most between them, those
  /// that factors fill in included
  void reserve(int bodies, int links);

  /// Takes the pattern and chooses the order. Does nothing if it has this pattern already.
  /// \param bodies how many \param links pairs of different bodies; may name a pair twice
  void analyse(int bodies, std::span<const BodyLink> links);

  /// \return products of two blocks that one factorisation costs
  std::int64_t work() const {
    return work_;
  }

  /// Makes all blocks zero.
  void clear();

  /// The block of a body with itself. \param body its number \return block, to be added to
  BodyBlock& diagonal(int body);

  /// The two blocks of a link.
  struct Sides {
    BodyBlock& firstSecond;  ///< row of the first body, column of the second
    BodyBlock& secondFirst;  ///< row of the second, column of the first
  };
  /// The blocks of a link, to be added to. Where factor() is told that the matrix is symmetric only
  /// `firstSecond` and its transpose in `secondFirst` are the same; both have to be given.
  /// \param link its place among those given to analyse() \return both blocks
  Sides between(int link);

  /// Takes the matrix apart; its blocks are replaced by the factors.
  /// \param symmetric whether it is; costs half, then \return false if a block has no inverse
  bool factor(bool symmetric);

  /// Solves for one right side. \param x right side by body; receives the solution
  void solve(std::span<BodyVector> x) const;

 private:
  void order();
  void locateLinks();

  int bodies_ = 0;
  std::vector<BodyLink> links_;
  std::vector<std::vector<int>> near_;   // neighbours that are left, ascending
  std::vector<std::vector<int>> later_;  // of each position: positions of what it is linked to
  std::vector<int> merged_;
  std::vector<int> position_;      // of a body
  std::vector<int> bodyAt_;        // of a position
  std::vector<int> start_;         // of each position: its first slot
  std::vector<int> column_;        // of each slot: the later position
  std::vector<int> slotOf_;        // of each link
  std::vector<BodyBlock> pivots_;  // by position; inverses after factor()
  std::vector<BodyBlock> upper_;   // by slot: row of the earlier
  std::vector<BodyBlock> lower_;   // by slot: row of the later
  mutable std::vector<BodyVector> permuted_;
  std::int64_t work_ = 0;
};

}  // namespace carom
