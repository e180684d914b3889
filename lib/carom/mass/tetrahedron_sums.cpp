#include "carom/mass/tetrahedron_sums.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "carom/mass/four_double_doubles.hpp"
#include "carom/mass/four_lanes.hpp"

namespace carom {
namespace {

// How many fours are added plainly before the block is added with compensation: few enough that a
// block loses less than 64 units in the last place, enough that compensation costs nothing.
constexpr std::size_t kFoursPerBlock = 64;

constexpr std::size_t kLargestIndex = std::numeric_limits<std::int32_t>::max();

template <class S>
struct Point {
  S x, y, z;
};

// Adds the tetrahedron (origin, a, b, c); corners are relative to the origin. On the diagonal half
// of a.x² + b.x² + c.x² + sx² is added, which takes fewer operations (Eberly 2002); complete()
// makes up for it.
template <class S>
CAROM_INLINE void addTetrahedron(TetrahedronSums<S>& sums, const Point<S>& a, const Point<S>& b,
                                 const Point<S>& c) {
  // The normal from the edges, which are short, so that its products do not cancel.
  const S ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const S wx = c.x - a.x, wy = c.y - a.y, wz = c.z - a.z;
  const S nx = uy * wz - uz * wy;
  const S ny = uz * wx - ux * wz;
  const S nz = ux * wy - uy * wx;
  const S v = a.x * nx + a.y * ny + a.z * nz;

  const S sx = a.x + b.x + c.x, sy = a.y + b.y + c.y, sz = a.z + b.z + c.z;
  sums.v += v;
  sums.x += v * sx;
  sums.y += v * sy;
  sums.z += v * sz;
  sums.xx += v * (a.x * a.x + b.x * (a.x + b.x) + c.x * sx);
  sums.yy += v * (a.y * a.y + b.y * (a.y + b.y) + c.y * sy);
  sums.zz += v * (a.z * a.z + b.z * (a.z + b.z) + c.z * sz);
  sums.xy += v * (a.x * a.y + b.x * b.y + c.x * c.y + sx * sy);
  sums.yz += v * (a.y * a.z + b.y * b.z + c.y * c.z + sy * sz);
  sums.zx += v * (a.z * a.x + b.z * b.x + c.z * c.x + sz * sx);
}

template <class S>
void complete(TetrahedronSums<S>& sums) {
  sums.xx += sums.xx;
  sums.yy += sums.yy;
  sums.zz += sums.zz;
}

// Calls f on each of the ten sums of several sets at once.
template <class F, class... Sets>
CAROM_INLINE void forEachSum(const F& f, Sets&... sets) {
  f(sets.v...);
  f(sets.x...);
  f(sets.y...);
  f(sets.z...);
  f(sets.xx...);
  f(sets.yy...);
  f(sets.zz...);
  f(sets.xy...);
  f(sets.yz...);
  f(sets.zx...);
}

// total + error += term, where error collects what rounding takes from total (Knuth's TwoSum).
template <class S>
CAROM_INLINE void addCompensated(S& total, S& error, const S& term) {
  const S sum = total + term;
  const S part = sum - total;
  error += (total - (sum - part)) + (term - part);
  total = sum;
}

// Triangles [begin, end) of a mesh as bare arrays: what the loop below reads.
struct Arrays {
  const Real* vertices = nullptr;           // three a vertex
  const std::int32_t* triangles = nullptr;  // three a triangle
  std::size_t triangleCount = 0;
  std::uint32_t lastVertex = 0;
};

// Two doubles that lie one after the other.
using Two = Real __attribute__((vector_size(16)));
CAROM_INLINE Two two(const Real* first) {
  Two result;
  std::memcpy(&result, first, sizeof result);
  return result;
}

// a - b, rounded or exactly.
CAROM_INLINE void subtract(Four& result, const Four& a, const Four& b) {
  result = a - b;
}
CAROM_INLINE void subtract(FourDoubleDoubles& result, const Four& a, const Four& b) {
  result = twoSums(a, -b);
}

// One corner of four triangles, relative to the origin.
template <class S>
CAROM_INLINE void gather(Point<S>& corner, const Real* vertices, const std::int32_t* index,
                         const Point<Four>& origin) {
  const Real* p = vertices + 3 * std::size_t(index[0]);
  const Real* q = vertices + 3 * std::size_t(index[3]);
  const Real* r = vertices + 3 * std::size_t(index[6]);
  const Real* s = vertices + 3 * std::size_t(index[9]);
#if defined(__clang__) || __GNUC__ >= 12
  // x and y of a vertex are loaded together; picking them apart is less work than loading each.
  const Four pr = __builtin_shufflevector(two(p), two(r), 0, 1, 2, 3);
  const Four qs = __builtin_shufflevector(two(q), two(s), 0, 1, 2, 3);
  subtract(corner.x, __builtin_shufflevector(pr, qs, 0, 4, 2, 6), origin.x);
  subtract(corner.y, __builtin_shufflevector(pr, qs, 1, 5, 3, 7), origin.y);
#else
  subtract(corner.x, Four{p[0], q[0], r[0], s[0]}, origin.x);
  subtract(corner.y, Four{p[1], q[1], r[1], s[1]}, origin.y);
#endif
  subtract(corner.z, Four{p[2], q[2], r[2], s[2]}, origin.z);
}

// Adds the tetrahedra of four triangles.
template <class S>
CAROM_INLINE void addFour(TetrahedronSums<S>& sums, const Arrays& mesh, const std::int32_t* index,
                          const Point<Four>& origin) {
  Point<S> a;
  Point<S> b;
  Point<S> c;
  gather(a, mesh.vertices, index, origin);
  gather(b, mesh.vertices, index + 1, origin);
  gather(c, mesh.vertices, index + 2, origin);
  addTetrahedron(sums, a, b, c);
}

// True if every index names a vertex: neither it nor its distance to the last one is negative. In
// unsigned numbers, which may wrap around, negative means that the highest bit is set.
CAROM_INLINE bool inRange(const std::int32_t* first, const std::int32_t* last,
                          std::uint32_t lastVertex) {
  std::uint32_t signs = 0;
  for (const std::int32_t* index = first; index != last; ++index) {
    const auto number = static_cast<std::uint32_t>(*index);
    signs |= number | (lastVertex - number);
  }
  return (signs >> 31) == 0;
}

// The sums over all whole fours, lane by lane with their errors; false if an index names no vertex.
CAROM_INLINE bool sumFours(const Arrays& mesh, const Point<Four>& origin,
                           TetrahedronSums<Four>& total, TetrahedronSums<Four>& error) {
  const std::size_t fours = mesh.triangleCount / kLanes;
  for (std::size_t block = 0; block < fours; block += kFoursPerBlock) {
    const std::size_t count = std::min(kFoursPerBlock, fours - block);
    const std::int32_t* index = mesh.triangles + 3 * kLanes * block;
    if (!inRange(index, index + 3 * kLanes * count, mesh.lastVertex)) return false;
    TetrahedronSums<Four> sums;
    for (std::size_t i = 0; i < count; ++i, index += 3 * kLanes) {
      addFour(sums, mesh, index, origin);
    }
    forEachSum(
        [](Four & t, Four & e, const Four& s)
            __attribute__((always_inline)) { addCompensated(t, e, s); },
        total, error, sums);
  }
  return true;
}

bool sumFoursBaseline(const Arrays& mesh, const Point<Four>& origin, TetrahedronSums<Four>& total,
                      TetrahedronSums<Four>& error) {
  return sumFours(mesh, origin, total, error);
}

#if CAROM_HAS_TWINS
CAROM_AVX2 bool sumFoursAvx2(const Arrays& mesh, const Point<Four>& origin,
                             TetrahedronSums<Four>& total, TetrahedronSums<Four>& error) {
  return sumFours(mesh, origin, total, error);
}

CAROM_AVX512 bool sumFoursAvx512(const Arrays& mesh, const Point<Four>& origin,
                                 TetrahedronSums<Four>& total, TetrahedronSums<Four>& error) {
  return sumFours(mesh, origin, total, error);
}
#endif

bool sumFoursBest(const Arrays& mesh, const Point<Four>& origin, TetrahedronSums<Four>& total,
                  TetrahedronSums<Four>& error) {
#if CAROM_HAS_TWINS
  if (lanesOfThisMachine() == Lanes::avx512) return sumFoursAvx512(mesh, origin, total, error);
  if (lanesOfThisMachine() == Lanes::avx2) return sumFoursAvx2(mesh, origin, total, error);
#endif
  return sumFoursBaseline(mesh, origin, total, error);
}

// The sums over all whole fours with twice the digits; the indices have been checked.
CAROM_INLINE void sumFoursExactly(const Arrays& mesh, const Point<Four>& origin,
                                  TetrahedronSums<FourDoubleDoubles>& sums) {
  const std::int32_t* const end = mesh.triangles + 3 * kLanes * (mesh.triangleCount / kLanes);
  for (const std::int32_t* index = mesh.triangles; index != end; index += 3 * kLanes) {
    addFour(sums, mesh, index, origin);
  }
}

void sumFoursExactlyBaseline(const Arrays& mesh, const Point<Four>& origin,
                             TetrahedronSums<FourDoubleDoubles>& sums) {
  sumFoursExactly(mesh, origin, sums);
}

#if CAROM_HAS_TWINS
CAROM_AVX2 void sumFoursExactlyAvx2(const Arrays& mesh, const Point<Four>& origin,
                                    TetrahedronSums<FourDoubleDoubles>& sums) {
  sumFoursExactly(mesh, origin, sums);
}

CAROM_AVX512 void sumFoursExactlyAvx512(const Arrays& mesh, const Point<Four>& origin,
                                        TetrahedronSums<FourDoubleDoubles>& sums) {
  sumFoursExactly(mesh, origin, sums);
}
#endif

void sumFoursExactlyBest(const Arrays& mesh, const Point<Four>& origin,
                         TetrahedronSums<FourDoubleDoubles>& sums) {
#if CAROM_HAS_TWINS
  if (lanesOfThisMachine() == Lanes::avx512) return sumFoursExactlyAvx512(mesh, origin, sums);
  if (lanesOfThisMachine() == Lanes::avx2) return sumFoursExactlyAvx2(mesh, origin, sums);
#endif
  sumFoursExactlyBaseline(mesh, origin, sums);
}

Arrays arraysOf(const TriangleMesh& mesh) {
  static_assert(sizeof(Vector3) == 3 * sizeof(Real), "vertices lie without gaps");
  return {mesh.vertices.front().data(), mesh.triangles.front().data(), mesh.triangles.size(),
          static_cast<std::uint32_t>(std::min(mesh.vertices.size() - 1, kLargestIndex))};
}

}  // namespace

TetrahedronSums<Real> sumTetrahedra(const TriangleMesh& mesh, const Vector3& origin) {
  const Arrays arrays = arraysOf(mesh);
  const Point<Four> corner{Four{} + origin.x(), Four{} + origin.y(), Four{} + origin.z()};
  TetrahedronSums<Four> total;
  TetrahedronSums<Four> error;
  const bool valid = sumFoursBest(arrays, corner, total, error);

  // The last one to three triangles.
  TetrahedronSums<Real> sums;
  const std::size_t done = arrays.triangleCount / kLanes * kLanes;
  if (!valid || !inRange(arrays.triangles + 3 * done, arrays.triangles + 3 * arrays.triangleCount,
                         arrays.lastVertex)) {
    requireUsable(mesh);
  }
  for (std::size_t t = done; t < mesh.triangles.size(); ++t) {
    Point<Real> corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 r = mesh.vertices[std::size_t(mesh.triangles[t][k])] - origin;
      corners[k] = {r.x(), r.y(), r.z()};
    }
    addTetrahedron(sums, corners[0], corners[1], corners[2]);
  }

  // The four lanes are added in a fixed order, compensated as well.
  TetrahedronSums<Real> rest;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    forEachSum(
        [lane](Real& s, Real& r, const Four& t, const Four& e) {
          addCompensated(s, r, Real(t[lane]));
          r += e[lane];
        },
        sums, rest, total, error);
  }
  forEachSum([](Real& s, const Real& r) { s += r; }, sums, rest);
  complete(sums);
  return sums;
}

TetrahedronSums<DoubleDouble> sumTetrahedraExactly(const TriangleMesh& mesh,
                                                   const Vector3& origin) {
  requireUsable(mesh);
  const Point<Four> corner{Four{} + origin.x(), Four{} + origin.y(), Four{} + origin.z()};
  TetrahedronSums<FourDoubleDoubles> fours;
  sumFoursExactlyBest(arraysOf(mesh), corner, fours);

  // The last one to three triangles, and the four lanes.
  TetrahedronSums<DoubleDouble> sums;
  for (std::size_t t = mesh.triangles.size() / kLanes * kLanes; t < mesh.triangles.size(); ++t) {
    Point<DoubleDouble> corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      // The difference of two doubles is exact as two doubles.
      const Vector3& vertex = mesh.vertices[std::size_t(mesh.triangles[t][k])];
      corners[k] = {exactDifference(vertex.x(), origin.x()),
                    exactDifference(vertex.y(), origin.y()),
                    exactDifference(vertex.z(), origin.z())};
    }
    addTetrahedron(sums, corners[0], corners[1], corners[2]);
  }
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    forEachSum([lane](DoubleDouble& s, const FourDoubleDoubles& f) { s += f.lane(lane); }, sums,
               fours);
  }
  complete(sums);
  return sums;
}

}  // namespace carom
