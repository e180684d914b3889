#pragma once
// Apart, touching or overlapping: the three cases of the source's figure 4.
//
// Every test of the chapter answers with this word, so that the plain versions, the fast ones and
// the exact judge can be compared without a tolerance. Touching is a verdict of its own, because
// that is where methods differ: it needs one axis (or one distance) that is exactly zero.

/// \defgroup detection Detection: chapter 3
/// Shapes, and whether, where and how deeply two of them overlap.

namespace carom {

/// How two closed solids stand to each other. \ingroup detection
enum class Verdict {
  separated,    ///< no common point
  touching,     ///< common points, but none inside both
  overlapping,  ///< a point lies inside both
};

}  // namespace carom
