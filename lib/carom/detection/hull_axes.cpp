#include "carom/detection/hull_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "carom/core/cross.hpp"

namespace carom::detail {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
// Sines below this make a cross product whose rounding is looked after.
constexpr Real kSmallSine = 0.05;
// Edges at a smaller sine are parallel: a face normal is as good as a tie.
constexpr Real kParallelSine = 1e-12;
// Of an edge whose faces lie nearly back to back (cosine of their normals below this: they meet at
// an angle of 1.4e-3), rounding decides which way is out.
constexpr Real kKnifeEdge = -1 + 1e-6;
// Gaps are sums of a dozen products of coordinates; each rounds by 1.1e-16 of the largest.
constexpr Real kRounding = 32 * 1.1102230246251565e-16;

// Two doubles at once, which every processor that Carom runs on can compare without a branch.
using Two = Real __attribute__((vector_size(2 * sizeof(Real))));

// One gap that has been computed. Without initial values: lists of it lie on the stack.
struct Candidate {
  Real gap;
  AxisKind kind;
  std::int32_t featureA;
  std::int32_t featureB;
  Vector3 normal;  // from A to B, frame of A
};

// Before the one candidate comes the other: A before B, low numbers before high ones.
bool precedes(const Candidate& x, const Candidate& y) {
  if (x.kind != y.kind) return x.kind < y.kind;
  if (x.kind == AxisKind::faceOfB) return x.featureB < y.featureB;
  if (x.featureA != y.featureA) return x.featureA < y.featureA;
  return x.featureB < y.featureB;
}

// The gaps that tie with the best one; few, because most are ruled out before they get here.
class Candidates {
 public:
  explicit Candidates(Real tie) : tie_(tie) {}

  Real best() const {
    return best_;
  }
  void add(const Candidate& candidate) {
    if (candidate.gap < best_ - tie_) return;
    best_ = std::max(best_, candidate.gap);
    if (count_ == kMost) {
      int kept = 0;
      for (int i = 0; i < count_; ++i) {
        if (list_[i].gap >= best_ - tie_) list_[kept++] = list_[i];
      }
      count_ = kept;
      if (count_ == kMost) {
        // Dozens of gaps in one tie, as between concentric bodies of many faces, or needles thinner
        // than a tie: the last by the rule goes, whatever the order of the search was.
        Candidate* last = std::max_element(list_, list_ + count_, precedes);
        if (precedes(candidate, *last)) *last = candidate;
        return;
      }
    }
    list_[count_++] = candidate;
  }
  // The best of one kind by a rule, of those within a tie; null if there are none.
  template <class Better>
  const Candidate* choose(AxisKind kind, const Better& better) const {
    const Candidate* chosen = nullptr;
    for (int i = 0; i < count_; ++i) {
      if (list_[i].kind != kind || list_[i].gap < best_ - tie_) continue;
      if (chosen == nullptr || better(list_[i], *chosen)) chosen = &list_[i];
    }
    return chosen;
  }

 private:
  static constexpr int kMost = 32;
  Real tie_;
  Real best_ = -kInfinity;
  int count_ = 0;
  Candidate list_[kMost];
};

// An array without initial values, which lies on the stack unless a body is unusually large.
template <class T, int kUsual>
class Scratch {
 public:
  explicit Scratch(int count) {
    if (count > kUsual) {
      large_.resize(static_cast<std::size_t>(count));
      data_ = large_.data();
    }
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  T* data() {
    return data_;
  }
  T& operator[](int i) {
    return data_[i];
  }
  const T& operator[](int i) const {
    return data_[i];
  }

 private:
  T usual_[kUsual];
  std::vector<T> large_;
  T* data_ = usual_;
};

using Numbers = Scratch<std::int32_t, 128>;

// The heights of one point over all faces of a hull, and the faces that it stands over, or, where
// that is lower, over which it reaches a threshold.
struct Heights {
  explicit Heights(int faceCount) : values(faceCount), above(faceCount + 1) {}

  Real operator[](int face) const {
    return values[face];
  }

  Scratch<Real, 128> values;
  Numbers above;
  int aboveCount = 0;
};

// Measures a point over each face, two faces at a time, and lists what it reaches. Of four faces
// seldom one is reached, so that one branch for all of them is foreseen.
void measure(const HullView& hull, const Vector3& point, Real threshold, Heights& heights) {
  const Two x = {point.x(), point.x()};
  const Two y = {point.y(), point.y()};
  const Two z = {point.z(), point.z()};
  const auto overTwo = [&](const HullFace* face) {
    const HullFace &p = face[0], &q = face[1];
    return Two{p.normal.x(), q.normal.x()} * x + Two{p.normal.y(), q.normal.y()} * y +
           Two{p.normal.z(), q.normal.z()} * z - Two{p.offset, q.offset};
  };
  const Real least = std::min(threshold, Real(0));
  Real* const values = heights.values.data();
  std::int32_t* const above = heights.above.data();
  const HullFace* const faces = hull.faces;
  const int faceCount = hull.faceCount;
  int count = 0;
  const auto list = [&](int f) {
    above[count] = f;
    count += values[f] >= least ? 1 : 0;
  };
  int f = 0;
  for (; f + 3 < faceCount; f += 4) {
    const Two first = overTwo(faces + f), second = overTwo(faces + f + 2);
    std::memcpy(values + f, &first, sizeof first);
    std::memcpy(values + f + 2, &second, sizeof second);
    const Two most = first > second ? first : second;
    if (std::max(most[0], most[1]) < least) continue;
    for (int k = f; k < f + 4; ++k) list(k);
  }
  for (; f < faceCount; ++f) {
    values[f] = faces[f].normal.dot(point) - faces[f].offset;
    list(f);
  }
  heights.aboveCount = count;
}

// The face over which the point is highest, the first of several.
int highestFace(const Heights& heights, int faceCount) {
  const Real* values = &heights.values[0];
  Two most = {-kInfinity, -kInfinity};
  int f = 0;
  for (; f + 1 < faceCount; f += 2) {
    Two next;
    std::memcpy(&next, values + f, sizeof next);
    most = next > most ? next : most;
  }
  Real largest = std::max(most[0], most[1]);
  if (f < faceCount) largest = std::max(largest, values[f]);
  int highest = 0;
  while (highest + 1 < faceCount && values[highest] != largest) ++highest;
  return highest;
}

// The point itself if it lies in the hull, else where the way to the centroid enters it.
Vector3 pulledInside(const HullView& hull, const Vector3& point, const Heights& heights) {
  Real part = 1;
  for (int k = 0; k < heights.aboveCount; ++k) {
    const int f = heights.above[k];
    if (heights[f] <= 0) continue;
    const Real inside = hull.faces[f].normal.dot(hull.centroid) - hull.faces[f].offset;
    part = std::min(part, inside / (inside - heights[f]));
  }
  return part == 1 ? point : Vector3(hull.centroid + part * (point - hull.centroid));
}

// The first few faces that have been tried, so that they are not tried twice.
class Tried {
 public:
  void add(int face) {
    if (count_ < kMost) faces_[count_++] = face;
  }
  bool has(int face) const {
    for (int i = 0; i < count_; ++i) {
      if (faces_[i] == face) return true;
    }
    return false;
  }

 private:
  static constexpr int kMost = 3;
  int faces_[kMost];
  int count_ = 0;
};

class Search {
 public:
  explicit Search(const HullPair& pair)
      : pair_(pair),
        tie_(kAxisTie * pair.size),
        faces_(tie_),
        edges_(tie_),
        onA_(pair.a.faceCount),
        onB_(pair.b.faceCount) {}

  HullAxis run(const HullHint* hint, Real limit) {
    // Within a tie of the limit another gap may be chosen in the end, one that is below it.
    const Real enough = limit + tie_;
    if (hint == nullptr || !beginWith(*hint, enough)) beginAtCentroids(enough);
    if (best() > enough) return answer(false);

    // All faces that the points do not rule out, then all edges.
    Alive aliveA(pair_.a.faceCount), aliveB(pair_.b.faceCount);
    collect(pair_.a, onA_, pointsOfB_, aliveA);
    for (int k = 0; k < aliveA.count; ++k) {
      const int f = aliveA.faces[k];
      if (aliveA.below[k] == 0 && !triedA_.has(f)) tryFaceOfA(f);
    }
    collect(pair_.b, onB_, pointsOfA_, aliveB);
    for (int k = 0; k < aliveB.count; ++k) {
      const int f = aliveB.faces[k];
      if (aliveB.below[k] == 0 && !triedB_.has(f)) tryFaceOfB(f);
    }
    if (best() > enough) return answer(false);
    tryEdges(aliveA, aliveB);
    return answer(true);
  }

  // The axis of given features; nothing if edges do not cross on the Gauss map.
  std::optional<HullAxis> runOn(const HullHint& hint) {
    if (hint.kind == AxisKind::faceOfA) {
      tryFaceOfA(hint.featureA);
    } else if (hint.kind == AxisKind::faceOfB) {
      tryFaceOfB(hint.featureB);
    } else {
      const Arc arcA = arcOfA(hint.featureA), arcB = arcOfB(hint.featureB);
      if (!arcsCross(arcA, arcB)) return std::nullopt;
      tryEdgePair(arcA, arcB);
      if (edges_.best() == -kInfinity) return std::nullopt;  // parallel
    }
    return answer(false);
  }

 private:
  Real best() const {
    return std::max(faces_.best(), edges_.best());
  }
  // A gap that does not reach this cannot be chosen any more.
  Real threshold() const {
    return best() - tie_;
  }

  // A few points of a body that lie around the contact, in the frame of the other one.
  struct Points {
    static constexpr int kMost = 4;
    Vector3 point[kMost];
    int count = 0;

    void add(const Vector3& x) {
      if (count < kMost) point[count++] = x;
    }
  };

  // The faces of a body over which the point of its heights reaches the threshold. Bit k of `below`
  // says that point k lies too deep for the face.
  struct Alive {
    explicit Alive(int faceCount) : faces(faceCount + 1), below(faceCount + 1) {}

    int count = 0;
    Numbers faces;
    Numbers below;
  };

  static bool isBelow(const HullFace& face, const Vector3& point, Real toReach) {
    return face.normal.dot(point) < toReach + face.offset;
  }

  void collect(const HullView& hull, const Heights& heights, const Points& points,
               Alive& alive) const {
    const Real toReach = threshold();
    for (int k = 0; k < heights.aboveCount; ++k) {
      alive.faces[alive.count] = heights.above[k];
      alive.count += heights[heights.above[k]] >= toReach ? 1 : 0;
    }
    for (int k = 0; k < alive.count; ++k) {
      const HullFace& face = hull.faces[alive.faces[k]];
      std::int32_t below = 0;
      for (int p = 0; p < points.count; ++p) {
        below |= (isBelow(face, points.point[p], toReach) ? 1 : 0) << p;
      }
      alive.below[k] = below;
    }
  }

  // The corners of a face, and the neighbours of a vertex.
  template <class Place>
  static void addCorners(const HullView& hull, int face, const Place& place, Points& points) {
    for (int k = 0; k < std::min(hull.faces[face].count, Points::kMost); ++k) {
      points.add(place(hull.vertices[hull.halfEdges[hull.faces[face].firstHalfEdge + k].origin]));
    }
  }
  template <class Place>
  static void addNeighbours(const HullView& hull, int vertex, const Place& place, Points& points) {
    const int first = hull.anyHalfEdge[vertex];
    int side = first;
    do {
      const int twin = hull.halfEdges[side].twin;
      points.add(place(hull.vertices[hull.halfEdges[twin].origin]));
      side = hull.halfEdges[twin].next;
    } while (side != first && points.count < Points::kMost);
  }
  Vector3 toA(const Vector3& x) const {
    return pair_.R * x + pair_.t;
  }
  Vector3 toB(const Vector3& x) const {
    return pair_.R.transpose() * (x - pair_.t);
  }

  // Begins with the features that were best in the last step; false if they do not meet any more.
  bool beginWith(const HullHint& hint, Real enough) {
    const HullView& a = pair_.a;
    const HullView& b = pair_.b;
    const bool hasA = hint.featureA >= 0, hasB = hint.featureB >= 0;
    if (hint.kind == AxisKind::faceOfA && hasA && hint.featureA < a.faceCount) {
      const Vector3 lowest = tryFaceOfA(hint.featureA);
      if (best() > enough) return true;
      measure(a, lowest, threshold(), onA_);
      measure(b, toB(pulledInside(a, lowest, onA_)), threshold(), onB_);
      addNeighbours(
          b, lowestVertex_, [this](const Vector3& x) { return toA(x); }, pointsOfB_);
      addCorners(
          a, hint.featureA, [this](const Vector3& x) { return toB(x); }, pointsOfA_);
      return true;
    }
    if (hint.kind == AxisKind::faceOfB && hasB && hint.featureB < b.faceCount) {
      const Vector3 lowest_B = toB(tryFaceOfB(hint.featureB));
      if (best() > enough) return true;
      measure(b, lowest_B, threshold(), onB_);
      measure(a, toA(pulledInside(b, lowest_B, onB_)), threshold(), onA_);
      addNeighbours(
          a, lowestVertex_, [this](const Vector3& x) { return toB(x); }, pointsOfA_);
      addCorners(
          b, hint.featureB, [this](const Vector3& x) { return toA(x); }, pointsOfB_);
      return true;
    }
    if (hint.kind != AxisKind::edges || !hasA || !hasB || hint.featureA >= a.edgeCount ||
        hint.featureB >= b.edgeCount) {
      return false;
    }
    const Arc arcA = arcOfA(hint.featureA), arcB = arcOfB(hint.featureB);
    if (!arcsCross(arcA, arcB)) return false;
    tryEdgePair(arcA, arcB);
    if (best() <= enough) lookAtEdges(arcA, arcB);
    return true;
  }

  // Begins where the line of the centroids leaves A, and goes from there to the contact: to the
  // face that is highest over it, the face of B there, and the edges around the better of both.
  void beginAtCentroids(Real enough) {
    const HullView& a = pair_.a;
    const HullView& b = pair_.b;
    const Vector3 direction = pair_.R * b.centroid + pair_.t - a.centroid;
    int vertexB = farthestVertex(b, -(pair_.R.transpose() * direction));
    Vector3 pointB = pair_.R * b.vertices[vertexB] + pair_.t;
    measure(a, pointB, threshold(), onA_);
    int faceA = highestFace(onA_, a.faceCount);
    const Vector3 lowest = tryFaceOfA(faceA);
    if (best() > enough) return;
    if (lowest != pointB) {
      vertexB = lowestVertex_;
      pointB = lowest;
      measure(a, pointB, threshold(), onA_);
      faceA = highestFace(onA_, a.faceCount);
      if (onA_[faceA] >= threshold() && !triedA_.has(faceA)) tryFaceOfA(faceA);
      if (best() > enough) return;
    }
    const Vector3 pointA = pulledInside(a, pointB, onA_);
    measure(b, toB(pointA), threshold(), onB_);
    const int faceB = highestFace(onB_, b.faceCount);
    const Real before = best();
    int vertexA = -1;
    if (onB_[faceB] >= threshold()) {
      tryFaceOfB(faceB);
      vertexA = lowestVertex_;
      if (best() > enough) return;
    }

    // Edges of the better face with those at the vertex that is lowest over it.
    constexpr int kMost = 16;
    Arc ofA[kMost], ofB[kMost];
    int countA = 0, countB = 0;
    if (best() > before) {
      countA = arcsAt(
          a, vertexA, kMost, [this](int e) { return arcOfA(e); }, ofA);
      countB = arcsOf(
          b, faceB, kMost, [this](int e) { return arcOfB(e); }, ofB);
    } else {
      countA = arcsOf(
          a, faceA, kMost, [this](int e) { return arcOfA(e); }, ofA);
      countB = arcsAt(
          b, vertexB, kMost, [this](int e) { return arcOfB(e); }, ofB);
    }
    int bestA = -1, bestB = -1;
    for (int i = 0; i < countA; ++i) {
      for (int j = 0; j < countB; ++j) {
        if (!arcsCross(ofA[i], ofB[j])) continue;
        const Real old = best();
        tryEdgePair(ofA[i], ofB[j]);
        if (best() > old) {
          bestA = i;
          bestB = j;
        }
      }
    }
    if (bestA >= 0) {
      lookAtEdges(ofA[bestA], ofB[bestB]);
      return;
    }
    for (int i = 0; i < std::min(countA, 2); ++i) {
      pointsOfA_.add(toB(ofA[i].start));
      pointsOfA_.add(toB(ofA[i].start + ofA[i].along));
    }
    for (int j = 0; j < std::min(countB, 2); ++j) {
      pointsOfB_.add(ofB[j].start);
      pointsOfB_.add(ofB[j].start + ofB[j].along);
    }
  }

  // Measures both bodies from the points where two edges are nearest.
  template <class ArcType>
  void lookAtEdges(const ArcType& arcA, const ArcType& arcB) {
    const Vector3& u = arcA.along;
    const Vector3& v = arcB.along;
    const Vector3 between = arcB.start - arcA.start;
    const Vector3 axis = cross(u, v);
    const Real square = axis.squaredNorm();
    if (!(square > 0)) return;
    // Any points of the edges will do, so rounding does no harm.
    const Real s = std::clamp(cross(between, v).dot(axis) / square, Real(0), Real(1));
    const Real t = std::clamp(cross(between, u).dot(axis) / square, Real(0), Real(1));
    measure(pair_.a, arcB.start + t * v, threshold(), onA_);
    measure(pair_.b, toB(arcA.start + s * u), threshold(), onB_);
    pointsOfB_.count = pointsOfA_.count = 0;
    pointsOfB_.add(arcB.start);
    pointsOfB_.add(arcB.start + v);
    pointsOfA_.add(toB(arcA.start));
    pointsOfA_.add(toB(arcA.start + u));
  }

  // The gap on a face of A; returns the point of B that is lowest over it [frame of A].
  Vector3 tryFaceOfA(int f) {
    const HullFace& face = pair_.a.faces[f];
    lowestVertex_ = farthestVertex(pair_.b, -(pair_.R.transpose() * face.normal));
    const Vector3 point = pair_.R * pair_.b.vertices[lowestVertex_] + pair_.t;
    faces_.add(
        {face.normal.dot(point) - face.offset, AxisKind::faceOfA, f, lowestVertex_, face.normal});
    triedA_.add(f);
    return point;
  }

  // The gap on a face of B; returns the point of A that is lowest over it [frame of A].
  Vector3 tryFaceOfB(int f) {
    const HullFace& face = pair_.b.faces[f];
    const Vector3 normal = pair_.R * face.normal;
    lowestVertex_ = farthestVertex(pair_.a, -normal);
    const Vector3& point = pair_.a.vertices[lowestVertex_];
    faces_.add(
        {normal.dot(point - pair_.t) - face.offset, AxisKind::faceOfB, lowestVertex_, f, -normal});
    triedB_.add(f);
    return point;
  }

  // An edge whose faces both lie more than the best gap below the point cannot make the best axis:
  // its directions are n = x n1 + y n2 with x, y >= 0, and a point's height over the edge along n
  // is x h1 + y h2, where x + y >= 1; for gaps above zero x + y is at most 1 / cos(half the angle).
  static bool edgeMatters(const HullView& hull, const Heights& heights, const HullEdge& edge,
                          Real toReach) {
    const Real height = std::max(heights[edge.leftFace], heights[edge.rightFace]);
    if (height >= toReach) return true;
    if (toReach <= 0 || height <= 0) return false;
    const Real cosine = hull.faces[edge.leftFace].normal.dot(hull.faces[edge.rightFace].normal);
    return height * height >= toReach * toReach * (1 + cosine) / 2;
  }

  // An edge of one body, ready for the Gauss map. Without initial values, for lists on the stack.
  struct Arc {
    Vector3 start;  // first vertex [m, frame of A]
    Vector3 along;  // from the first to the second vertex
    Vector3 left;   // normal of its left face; of B: reversed
    Vector3 right;  // normal of its right face; of B: reversed
    int edge;
  };

  Arc arcOfA(int i) const {
    const HullView& a = pair_.a;
    const HullEdge& edge = a.edges[i];
    return {a.vertices[edge.from], a.vertices[edge.to] - a.vertices[edge.from],
            a.faces[edge.leftFace].normal, a.faces[edge.rightFace].normal, i};
  }
  Arc arcOfB(int j) const {
    const HullView& b = pair_.b;
    const HullEdge& edge = b.edges[j];
    const Vector3 from = pair_.R * b.vertices[edge.from];
    const Vector3 to = pair_.R * b.vertices[edge.to];
    return {from + pair_.t, to - from, -(pair_.R * b.faces[edge.leftFace].normal),
            -(pair_.R * b.faces[edge.rightFace].normal), j};
  }

  // Arcs of the edges of a face, and of those that meet in a vertex.
  template <class Make>
  static int arcsOf(const HullView& hull, int face, int most, const Make& make, Arc* arcs) {
    const int count = std::min(hull.faces[face].count, most);
    for (int k = 0; k < count; ++k) {
      arcs[k] = make(hull.halfEdges[hull.faces[face].firstHalfEdge + k].edge);
    }
    return count;
  }
  template <class Make>
  static int arcsAt(const HullView& hull, int vertex, int most, const Make& make, Arc* arcs) {
    int count = 0;
    const int first = hull.anyHalfEdge[vertex];
    int side = first;
    do {
      arcs[count++] = make(hull.halfEdges[side].edge);
      side = hull.halfEdges[hull.halfEdges[side].twin].next;
    } while (side != first && count < most);
    return count;
  }

  // Whether two arcs cross: the ends of each on different sides of the other, on the same half of
  // the sphere. The direction of an edge is that of the cross product of its normals.
  static bool arcsCross(const Arc& arcA, const Arc& arcB) {
    const Real l = arcB.left.dot(arcA.along), r = arcB.right.dot(arcA.along);
    const Real p = arcA.left.dot(arcB.along), q = arcA.right.dot(arcB.along);
    return (l * r < 0) & (p * q < 0) & (l * p < 0);
  }

  // Of gaps above zero: edges between two faces of which one lies below the point, and that matter.
  static int edgesThatMatter(const HullView& hull, const Heights& heights, Real toReach,
                             Numbers& list) {
    int count = 0;
    for (int k = 0; k < heights.aboveCount; ++k) {
      const std::int32_t f = heights.above[k];
      if (heights[f] <= 0) continue;
      const HullFace& face = hull.faces[f];
      for (int h = face.firstHalfEdge; h < face.firstHalfEdge + face.count; ++h) {
        const HullHalfEdge& side = hull.halfEdges[h];
        const std::int32_t other = hull.halfEdges[side.twin].face;
        // An edge between two such faces is met twice, and taken once.
        if ((heights[other] > 0) & (f > other)) continue;
        list[count] = side.edge;
        count += edgeMatters(hull, heights, hull.edges[side.edge], toReach) ? 1 : 0;
      }
    }
    return count;
  }

  // The edges of one body that the heights do not rule out: those of the faces that reach the
  // threshold, and for gaps above zero all that edgeMatters().
  int edgesThatMatter(const HullView& hull, const Heights& heights, const Alive& alive,
                      const Points& points, Numbers& list) const {
    const Real toReach = threshold();
    if (toReach > 0) return edgesThatMatter(hull, heights, toReach, list);
    int count = 0;
    for (int k = 0; k < alive.count; ++k) {
      const std::int32_t f = alive.faces[k];
      if (heights[f] < toReach) continue;
      const HullFace& face = hull.faces[f];
      for (int h = face.firstHalfEdge; h < face.firstHalfEdge + face.count; ++h) {
        const HullHalfEdge& side = hull.halfEdges[h];
        const std::int32_t other = hull.halfEdges[side.twin].face;
        // An edge between two such faces is met twice, and taken once.
        if ((heights[other] >= toReach) & (f > other)) continue;
        // Any other point that lies too deep for both faces rules the edge out.
        bool ruledOut = false;
        for (int p = 0; p < points.count && !ruledOut; ++p) {
          ruledOut = ((alive.below[k] >> p) & 1) != 0 &&
                     isBelow(hull.faces[other], points.point[p], toReach);
        }
        list[count] = side.edge;
        count += ruledOut ? 0 : 1;
      }
    }
    return count;
  }

  void tryEdges(const Alive& aliveA, const Alive& aliveB) {
    Numbers edgesA(2 * pair_.a.edgeCount + 1), edgesB(2 * pair_.b.edgeCount + 1);
    const int countA = edgesThatMatter(pair_.a, onA_, aliveA, pointsOfB_, edgesA);
    const int countB = edgesThatMatter(pair_.b, onB_, aliveB, pointsOfA_, edgesB);
    Scratch<Arc, 32> arcsB(countB);
    for (int k = 0; k < countB; ++k) arcsB[k] = arcOfB(edgesB[k]);
    Numbers crossing(countB + 1);
    for (int i = 0; i < countA; ++i) {
      const Arc arcA = arcOfA(edgesA[i]);
      int count = 0;
      for (int k = 0; k < countB; ++k) {
        crossing[count] = k;
        count += arcsCross(arcA, arcsB[k]) ? 1 : 0;
      }
      for (int k = 0; k < count; ++k) tryEdgePair(arcA, arcsB[crossing[k]]);
    }
  }

  void tryEdgePair(const Arc& arcA, const Arc& arcB) {
    const Vector3 axis = cross(arcA.along, arcB.along);
    const Real square = axis.squaredNorm();
    const Real sides = arcA.along.squaredNorm() * arcB.along.squaredNorm();
    if (square <= kParallelSine * kParallelSine * sides) {
      blur_ = std::max(blur_, 2 * kParallelSine * pair_.size);
      return;
    }
    const Real length = std::sqrt(square);
    Vector3 normal = axis / length;
    if (normal.dot(arcA.left + arcA.right) < 0) normal = -normal;
    if (arcA.left.dot(arcA.right) < kKnifeEdge || arcB.left.dot(arcB.right) < kKnifeEdge) {
      // Both ways are gaps that are surely there; the wrong one is a very negative one.
      edges_.add({gapAlong(normal), AxisKind::edges, arcA.edge, arcB.edge, normal});
      normal = -normal;
      edges_.add({gapAlong(normal), AxisKind::edges, arcA.edge, arcB.edge, normal});
      return;
    }
    Real gap = normal.dot(arcB.start - arcA.start);
    if (square < kSmallSine * kSmallSine * sides) {
      // The direction is off by rounding over sine, and with it the height of one edge over the
      // other. The farthest points along the direction as it is give a gap that is surely there.
      // Turning B by the angle between the edges would make them parallel, and then a face is as
      // good: that is the other limit to what can be missed.
      const Real sine = std::sqrt(square / sides);
      const Real blur = std::min(kRounding * pair_.reach / sine, 2 * sine * pair_.size);
      if (gap + blur < threshold()) return;
      blur_ = std::max(blur_, blur);
      gap = gapAlong(normal);
    }
    edges_.add({gap, AxisKind::edges, arcA.edge, arcB.edge, normal});
  }

  // The gap along a direction of the frame of A, from all points of both bodies.
  Real gapAlong(const Vector3& normal) const {
    const int lowest = farthestVertex(pair_.b, -(pair_.R.transpose() * normal));
    const Vector3 lowB = pair_.R * pair_.b.vertices[lowest] + pair_.t;
    return normal.dot(lowB - pair_.a.vertices[farthestVertex(pair_.a, normal)]);
  }

  // Area of a face, for ties.
  static Real areaOf(const HullView& hull, int f) {
    const HullFace& face = hull.faces[f];
    const Vector3& origin = hull.vertices[hull.halfEdges[face.firstHalfEdge].origin];
    Real doubled = 0;
    for (int k = 1; k + 1 < face.count; ++k) {
      const Vector3 p = hull.vertices[hull.halfEdges[face.firstHalfEdge + k].origin] - origin;
      const Vector3 q = hull.vertices[hull.halfEdges[face.firstHalfEdge + k + 1].origin] - origin;
      doubled += face.normal.dot(cross(p, q));
    }
    return doubled;
  }

  Real areaOf(const Candidate& c) const {
    return c.kind == AxisKind::faceOfA ? areaOf(pair_.a, c.featureA) : areaOf(pair_.b, c.featureB);
  }

  // Of one body's faces that tie the largest, then the first; of both bodies' the larger, then the
  // one with the higher score. Two steps, so that the order of the list has no say.
  const Candidate* bestFace() const {
    const auto better = [this](const Candidate& x, const Candidate& y) {
      const Real areaX = areaOf(x), areaY = areaOf(y);
      if (std::abs(areaX - areaY) > kAxisTie * std::max(areaX, areaY)) return areaX > areaY;
      return precedes(x, y);
    };
    const Candidate* ofA = faces_.choose(AxisKind::faceOfA, better);
    const Candidate* ofB = faces_.choose(AxisKind::faceOfB, better);
    if (ofA == nullptr || ofB == nullptr) return ofA != nullptr ? ofA : ofB;
    const Real areaA = areaOf(*ofA), areaB = areaOf(*ofB);
    if (std::abs(areaA - areaB) > kAxisTie * areaA) return areaA > areaB ? ofA : ofB;
    // Candidates' normals point from A to B: out of A, into B.
    const Real scoreA = tieScore(pair_.R_WA * ofA->normal);
    const Real scoreB = -tieScore(pair_.R_WA * ofB->normal);
    return scoreA >= scoreB ? ofA : ofB;
  }

  HullAxis answer(bool all) const {
    const Candidate* face = bestFace();
    const Candidate* edges = edges_.choose(AxisKind::edges, precedes);
    // A face unless edges are better by more than a tie; and never a face that hides a gap.
    const bool faceWins = edges == nullptr || (face != nullptr && face->gap >= threshold() &&
                                               !(best() > 0 && faces_.best() <= 0));
    const Candidate& chosen = faceWins ? *face : *edges;
    HullAxis result;
    result.separation = chosen.gap;
    result.normal = chosen.normal;
    result.kind = chosen.kind;
    result.featureA = chosen.featureA;
    result.featureB = chosen.featureB;
    result.error = kRounding * pair_.reach + blur_;
    result.all = all;
    return result;
  }

  const HullPair& pair_;
  Real tie_;
  Candidates faces_;
  Candidates edges_;
  Heights onA_;           // of one point of B over all faces of A
  Heights onB_;           // of one point of A over all faces of B
  int lowestVertex_ = 0;  // found by the last try of a face
  Tried triedA_, triedB_;
  Points pointsOfA_, pointsOfB_;  // in the frame of the other body
  Real blur_ = 0;
};

}  // namespace

int farthestVertex(const HullView& hull, const Vector3& direction) {
  // Two passes without a branch that depends on data: all products, then where the largest is.
  constexpr int kChunk = 64;
  const Two dx = {direction.x(), direction.x()};
  const Two dy = {direction.y(), direction.y()};
  const Two dz = {direction.z(), direction.z()};
  const auto load = [](const Real* from) {
    Two value;
    std::memcpy(&value, from, sizeof value);
    return value;
  };
  int farthest = 0;
  Real best = -kInfinity;
  for (int begin = 0; begin < hull.vertexCount; begin += kChunk) {
    const int count = std::min(kChunk, hull.vertexCount - begin);
    const Real* x = hull.x + begin;
    const Real* y = hull.y + begin;
    const Real* z = hull.z + begin;
    Real products[kChunk + 1];
    Two most = {-kInfinity, -kInfinity};
    int i = 0;
    for (; i + 1 < count; i += 2) {
      const Two product = load(x + i) * dx + load(y + i) * dy + load(z + i) * dz;
      std::memcpy(products + i, &product, sizeof product);
      most = product > most ? product : most;
    }
    Real largest = std::max(most[0], most[1]);
    if (i < count) {
      products[i] = x[i] * direction.x() + y[i] * direction.y() + z[i] * direction.z();
      largest = std::max(largest, products[i]);
    }
    if (largest > best) {
      best = largest;
      int k = 0;
      while (k + 1 < count && products[k] != largest) ++k;
      farthest = begin + k;
    }
  }
  return farthest;
}

HullPair hullPair(const HullView& a, const Pose& A, const HullView& b, const Pose& B) {
  HullPair pair;
  pair.a = a;
  pair.b = b;
  pair.R.noalias() = A.R_WB.transpose() * B.R_WB;
  pair.t.noalias() = A.R_WB.transpose() * (B.p_WB - A.p_WB);
  pair.R_WA = A.R_WB;
  pair.size = a.boundingRadius + b.boundingRadius;
  pair.reach = pair.size + a.centroid.cwiseAbs().sum() + b.centroid.cwiseAbs().sum() +
               pair.t.cwiseAbs().sum();
  return pair;
}

HullAxis bestHullAxis(const HullPair& pair, const HullHint* hint, Real enough) {
  Search search(pair);
  return search.run(hint, enough);
}

std::optional<HullAxis> axisOfFeatures(const HullPair& pair, const HullHint& hint) {
  Search search(pair);
  return search.runOn(hint);
}

}  // namespace carom::detail
