#pragma once
// How does one instruction work on several numbers at once?
//
// Method: Lanes<T, N> holds N numbers of one kind, and its operators work on all of them, each lane
// for itself: what is in one lane never depends on what is in another. A function that is written
// over a type S does the same sums for S = double and S = Lanes<double, 4>, in the same order, and
// so ends in the same bits; the plain version is the wide one with a single lane.
// Instead of a branch on numbers there is select(): both sides are computed, and each lane takes
// the one that it needs.
// Why not whole vectors of space in a register: three of four lanes are used then, and sums across
// lanes cost more than they save.
// Source: vectors as numbers as in deal.II (VectorizedArray); vector extensions of GCC and clang.
// Not handled: lanes in the signature of a function that is not inlined, whose convention depends
// on the flags; the operators here are therefore inlined always.

#include "carom/core/real.hpp"

namespace carom {

/// \cond
namespace detail {

// The attribute is lost if the type stands in a class that is overloaded on (g++ 12).
template <class T, int N>
struct LaneVector {
  typedef T Type __attribute__((vector_size(N * sizeof(T))));
};

}  // namespace detail
/// \endcond

/// N numbers side by side; N a power of two that the machine has registers for. \ingroup core
template <class T, int N>
struct Lanes {
  /// What the compiler calls it. \ingroup core
  using Vector = typename detail::LaneVector<T, N>::Type;
  Vector v;  ///< the numbers
};

/// What kind of number S is made of, and how many. \ingroup core
template <class S>
struct LaneTraits {
  using Number = S;                 ///< one lane
  static constexpr int kCount = 1;  ///< lanes
};

/// The same for lanes. \ingroup core
template <class T, int N>
struct LaneTraits<Lanes<T, N>> {
  using Number = T;                 ///< one lane
  static constexpr int kCount = N;  ///< lanes
};

/// \cond
#define CAROM_LANES_INLINE [[gnu::always_inline]] inline
#define CAROM_LANES_OPERATOR(op)                                                  \
  template <class T, int N>                                                       \
  CAROM_LANES_INLINE Lanes<T, N> operator op(Lanes<T, N> a, Lanes<T, N> b) {      \
    return {a.v op b.v};                                                          \
  }                                                                               \
  template <class T, int N>                                                       \
  CAROM_LANES_INLINE Lanes<T, N>& operator op##=(Lanes<T, N>& a, Lanes<T, N> b) { \
    a.v = a.v op b.v;                                                             \
    return a;                                                                     \
  }
CAROM_LANES_OPERATOR(+)
CAROM_LANES_OPERATOR(-)
CAROM_LANES_OPERATOR(*)
CAROM_LANES_OPERATOR(/)
#undef CAROM_LANES_OPERATOR
template <class T, int N>
CAROM_LANES_INLINE Lanes<T, N> operator-(Lanes<T, N> a) {
  return {-a.v};
}
template <class T, int N>
CAROM_LANES_INLINE auto operator>(Lanes<T, N> a, Lanes<T, N> b) {
  return a.v > b.v;
}
template <class T, int N, class Mask>
CAROM_LANES_INLINE Lanes<T, N> select(Mask mask, Lanes<T, N> a, Lanes<T, N> b) {
  return {mask ? a.v : b.v};
}
CAROM_LANES_INLINE float select(bool mask, float a, float b) {
  return mask ? a : b;
}
CAROM_LANES_INLINE double select(bool mask, double a, double b) {
  return mask ? a : b;
}
template <class T, int N>
CAROM_LANES_INLINE Lanes<T, N> squareRoot(Lanes<T, N> a) {
  Lanes<T, N> root;
  for (int i = 0; i < N; ++i) {
    if constexpr (sizeof(T) == sizeof(float)) {
      root.v[i] = __builtin_sqrtf(a.v[i]);
    } else {
      root.v[i] = __builtin_sqrt(a.v[i]);
    }
  }
  return root;
}
CAROM_LANES_INLINE float squareRoot(float a) {
  return __builtin_sqrtf(a);
}
CAROM_LANES_INLINE double squareRoot(double a) {
  return __builtin_sqrt(a);
}
/// \endcond

/// The larger one in each lane. \param a numbers \param b numbers \return max(a, b); b if a is none
/// \ingroup core
template <class S>
CAROM_LANES_INLINE S larger(S a, S b) {
  return select(a > b, a, b);
}

/// The smaller one in each lane. \param a numbers \param b numbers \return min(a, b)
/// \ingroup core
template <class S>
CAROM_LANES_INLINE S smaller(S a, S b) {
  return select(b > a, a, b);
}

/// The same number in all lanes. \param x any \return lanes \ingroup core
template <class S>
CAROM_LANES_INLINE S everywhere(typename LaneTraits<S>::Number x) {
  if constexpr (LaneTraits<S>::kCount == 1) {
    return x;
  } else {
    S all;
    for (int i = 0; i < LaneTraits<S>::kCount; ++i) all.v[i] = x;
    return all;
  }
}

/// Numbers that lie side by side. \param from the first one, aligned as lanes are \return lanes
/// \ingroup core
template <class S>
CAROM_LANES_INLINE S loaded(const typename LaneTraits<S>::Number* from) {
  if constexpr (LaneTraits<S>::kCount == 1) {
    return *from;
  } else {
    return {*reinterpret_cast<const typename S::Vector*>(from)};
  }
}

/// Writes numbers side by side. \param lanes what to write \param to the first place, aligned as
/// lanes are \ingroup core
template <class S>
CAROM_LANES_INLINE void store(S lanes, typename LaneTraits<S>::Number* to) {
  if constexpr (LaneTraits<S>::kCount == 1) {
    *to = lanes;
  } else {
    *reinterpret_cast<typename S::Vector*>(to) = lanes.v;
  }
}

/// \cond
template <class T>
CAROM_LANES_INLINE void transposeLanes(Lanes<T, 4>* r) {
  using V = typename Lanes<T, 4>::Vector;
  const V a = __builtin_shufflevector(r[0].v, r[1].v, 0, 4, 1, 5);
  const V b = __builtin_shufflevector(r[2].v, r[3].v, 0, 4, 1, 5);
  const V c = __builtin_shufflevector(r[0].v, r[1].v, 2, 6, 3, 7);
  const V d = __builtin_shufflevector(r[2].v, r[3].v, 2, 6, 3, 7);
  r[0].v = __builtin_shufflevector(a, b, 0, 1, 4, 5);
  r[1].v = __builtin_shufflevector(a, b, 2, 3, 6, 7);
  r[2].v = __builtin_shufflevector(c, d, 0, 1, 4, 5);
  r[3].v = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}
template <class T>
CAROM_LANES_INLINE void transposeLanes(Lanes<T, 8>* r) {
  using V = typename Lanes<T, 8>::Vector;
  V s[8], t[8];
  for (int i = 0; i < 4; ++i) {
    const V p = r[2 * i].v, q = r[2 * i + 1].v;
    s[2 * i] = __builtin_shufflevector(p, q, 0, 8, 1, 9, 4, 12, 5, 13);
    s[2 * i + 1] = __builtin_shufflevector(p, q, 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const V p = s[4 * i + j], q = s[4 * i + j + 2];
      t[4 * i + 2 * j] = __builtin_shufflevector(p, q, 0, 1, 8, 9, 4, 5, 12, 13);
      t[4 * i + 2 * j + 1] = __builtin_shufflevector(p, q, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (int i = 0; i < 4; ++i) {
    r[i].v = __builtin_shufflevector(t[i], t[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[i + 4].v = __builtin_shufflevector(t[i], t[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
}
/// \endcond

}  // namespace carom
