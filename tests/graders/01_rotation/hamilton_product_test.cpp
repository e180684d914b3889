// Grader of 01.hamilton_product: the table of units, the matrix of a left factor, and what every algebra of
// quaternions must obey. None of it computes a Hamilton product by the formula that is asked for.

#include "carom/rotation/hamilton_product.hpp"

#include "carom/core/cross.hpp"
#include "grading/fields_rotation.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

const Quaternion one{1, 0, 0, 0};
const Quaternion i{0, 1, 0, 0};
const Quaternion j{0, 0, 1, 0};
const Quaternion k{0, 0, 0, 1};

Quaternion minus(const Quaternion& q) {
  return {-q.w, -q.x, -q.y, -q.z};
}

Quaternion pure(const Vector3& v) {
  return {0, v.x(), v.y(), v.z()};
}

Quaternion anyQuaternion(Random& random) {
  const Real w = random.between(-2, 2);
  const Vector3 v = random.vector(2);
  return {w, v.x(), v.y(), v.z()};
}

Real squaredNorm(const Quaternion& q) {
  return q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
}

constexpr const char* kExact = "products and sums of 0 and 1 are exact";
constexpr const char* kRounding =
    "four products and three sums of numbers up to 4, each rounded once";

}  // namespace

TEST_CASE("units") {
  // Each unit times itself is -1, and the real unit changes nothing.
  GRADE(hamiltonProduct(i, i), minus(one), within(0, kExact), given("q", i), given("r", i));
  GRADE(hamiltonProduct(j, j), minus(one), within(0, kExact), given("q", j), given("r", j));
  GRADE(hamiltonProduct(k, k), minus(one), within(0, kExact), given("q", k), given("r", k));
  GRADE(hamiltonProduct(one, k), k, within(0, kExact), given("q", one), given("r", k));
  GRADE(hamiltonProduct(i, one), i, within(0, kExact), given("q", i), given("r", one));
  // Every direction is such a unit. These differ from student to student.
  Random random(seed());
  for (int n = 0; n < 5; ++n) {
    const Quaternion u = pure(random.direction());
    GRADE(hamiltonProduct(u, u), minus(one), within(2e-15, kRounding), given("q", u), given("r", u),
          about("an imaginary quaternion of length 1, times itself"));
  }
}

TEST_CASE("order") {
  // i j = k, but j i = -k: the order counts.
  GRADE(hamiltonProduct(i, j), k, within(0, kExact), given("q", i), given("r", j));
  GRADE(hamiltonProduct(j, i), minus(k), within(0, kExact), given("q", j), given("r", i));
  GRADE(hamiltonProduct(j, k), i, within(0, kExact), given("q", j), given("r", k));
  GRADE(hamiltonProduct(k, i), j, within(0, kExact), given("q", k), given("r", i));
  Random random(seed() + 1);
  for (int n = 0; n < 5; ++n) {
    const Quaternion a = pure(random.vector(2));
    GRADE(hamiltonProduct(a, k), (Quaternion{-a.z, a.y, -a.x, 0}), within(0, kExact), given("q", a),
          given("r", k));
    GRADE(hamiltonProduct(k, a), (Quaternion{-a.z, -a.y, a.x, 0}), within(0, kExact), given("q", k),
          given("r", a));
  }
}

TEST_CASE("signs") {
  // Products whose z has a part from each of the four pairs, so that one wrong sign shows.
  GRADE(hamiltonProduct({1, 2, 3, 4}, {5, 6, 7, 8}), (Quaternion{-60, 12, 30, 24}),
        within(0, "small integers are exact"), given("q", Quaternion{1, 2, 3, 4}),
        given("r", Quaternion{5, 6, 7, 8}));
  GRADE(hamiltonProduct({0, 1, 2, 3}, {0, 4, 5, 6}), (Quaternion{-32, -3, 6, -3}),
        within(0, "small integers are exact"), given("q", Quaternion{0, 1, 2, 3}),
        given("r", Quaternion{0, 4, 5, 6}),
        about("without real parts the product is -(a . b) and a x b"));
  Random random(seed() + 2);
  for (int n = 0; n < 5; ++n) {
    const Vector3 a = random.vector(2);
    const Vector3 b = random.vector(2);
    const Vector3 v = cross(a, b);
    GRADE(hamiltonProduct(pure(a), pure(b)), (Quaternion{-a.dot(b), v.x(), v.y(), v.z()}),
          within(1e-14, kRounding), given("q", pure(a)), given("r", pure(b)),
          about("without real parts the product is -(a . b) and a x b"));
  }
}

TEST_CASE("norm") {
  // |q r| = |q| |r|: what makes rotations stay rotations.
  Random random(seed());
  for (int n = 0; n < 50; ++n) {
    const Quaternion q = anyQuaternion(random);
    const Quaternion r = anyQuaternion(random);
    GRADE(squaredNorm(hamiltonProduct(q, r)), squaredNorm(q) * squaredNorm(r),
          withinRelative(4e-15, kRounding), given("q", q), given("r", r));
    // The norm alone would let q stand for q r.
    GRADE(hamiltonProduct(hamiltonProduct(q, r), {r.w, -r.x, -r.y, -r.z}),
          (Quaternion{q.w * squaredNorm(r), q.x * squaredNorm(r), q.y * squaredNorm(r),
                      q.z * squaredNorm(r)}),
          within(3e-14, kRounding), given("q", q), given("r", r), about("(q r) r* = q |r|^2"));
  }
}

PROBES() {
  Random random(7);
  for (int n = 0; n < 24; ++n) {
    const Quaternion q = anyQuaternion(random);
    const Quaternion r = anyQuaternion(random);
    PROBE(hamiltonProduct(q, r));
  }
}
