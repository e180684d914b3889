// What does it cost to turn a point, to combine two turns, and to repair one?
//
// The formulas are run with numbers that count what is done to them (counted.hpp).

#include <array>
#include <filesystem>
#include <iostream>
#include <vector>

#include "carom/rotation/axis_angle_to_quaternion.hpp"
#include "carom/rotation/rotate_point.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/table.hpp"
#include "counted.hpp"

using carom::Real;
using carom::Vector3;
using carom::Work;
using carom::workOf;

using S = carom::Counted;
using Point = std::array<S, 3>;
using Four = std::array<S, 4>;  // a quaternion: w, x, y, z
using Nine = std::array<Point, 3>;

S dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Four product(const Four& p, const Four& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Point byMatrix(const Nine& R, const Point& v) {
  return {dot(R[0], v), dot(R[1], v), dot(R[2], v)};
}

//! [sandwich]
// q v q*, as it stands in a book.
Point bySandwich(const Four& q, const Point& v) {
  const Four star = {q[0], {-q[1].value}, {-q[2].value}, {-q[3].value}};
  const Four p = product(product(q, {S{0}, v[0], v[1], v[2]}), star);
  return {p[1], p[2], p[3]};
}

// The same, multiplied out, with u the vector part of q:
// t = 2 u x v, then v + w t + u x t.
Point byTwoCrosses(const Four& q, const Point& v) {
  const Point u = {q[1], q[2], q[3]};
  Point t = cross(u, v);
  for (S& x : t) x = x + x;
  Point p = cross(u, t);
  for (std::size_t i = 0; i < 3; ++i) p[i] = v[i] + q[0] * t[i] + p[i];
  return p;
}
//! [sandwich]

Nine matrixOf(const Four& q) {
  const S x = q[1] + q[1], y = q[2] + q[2], z = q[3] + q[3], one{1};
  const S wx = q[0] * x, wy = q[0] * y, wz = q[0] * z, xx = q[1] * x, xy = q[1] * y, xz = q[1] * z;
  const S yy = q[2] * y, yz = q[2] * z, zz = q[3] * z;
  return {{{one - (yy + zz), xy - wz, xz + wy},
           {xy + wz, one - (xx + zz), yz - wx},
           {xz - wy, yz + wx, one - (xx + yy)}}};
}

Nine product(const Nine& A, const Nine& B) {
  Nine C;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) C[i][j] = dot(A[i], {B[0][j], B[1][j], B[2][j]});
  return C;
}

S dot(const Four& q) {
  return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
}

template <class Numbers>
void normalise(Numbers& numbers, S squared) {
  const S factor = S{1} / squareRoot(squared);
  for (S& x : numbers) x = x * factor;
}

// Rows at right angles again, one after the other (Gram and Schmidt).
void repair(Nine& R) {
  normalise(R[0], dot(R[0], R[0]));
  const S off = dot(R[0], R[1]);
  for (std::size_t k = 0; k < 3; ++k) R[1][k] = R[1][k] - off * R[0][k];
  normalise(R[1], dot(R[1], R[1]));
  R[2] = cross(R[0], R[1]);
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  const carom::Quaternion turn = carom::axisAngleToQuaternion({1, 2, 3}, 2.5);
  const Four q = {S{turn.w}, S{turn.x}, S{turn.y}, S{turn.z}};
  const Point v = {S{0.3}, S{-1.2}, S{2.5}};
  const Nine R = matrixOf(q);
  Point p;

  carom::io::Table turning;
  turning.column("turning a point").column("products").column("sums");
  for (const char* axis : {"x", "y", "z"}) turning.column(axis, carom::io::fixed(6));
  const auto turned = [&](const char* way, const Work& w) {
    turning.row({way, w.products, w.sums, p[0].value, p[1].value, p[2].value});
    return w.products + w.sums;
  };
  const int matrix = turned("matrix", workOf([&] { p = byMatrix(R, v); }));
  const int sandwich = turned("sandwich, q v q*", workOf([&] { p = bySandwich(q, v); }));
  const int crosses = turned("two cross products", workOf([&] { p = byTwoCrosses(q, v); }));
  const Vector3 library = carom::rotatePoint(turn, {0.3, -1.2, 2.5});
  turning.row({"carom::rotatePoint", "", "", library.x(), library.y(), library.z()});

  carom::io::Table others;
  others.column("doing something else").column("products").column("sums").column("roots");
  const auto other = [&others](const char* what, const Work& w) {
    others.row({what, w.products, w.sums, w.roots});
    return w.products + w.sums;
  };
  Four unit = q;
  Nine repaired = R;
  const int conversion = other("matrix of a quaternion", workOf([&] { matrixOf(q); }));
  other("two quaternions combined", workOf([&] { product(q, q); }));
  other("two matrices combined", workOf([&] { product(R, R); }));
  other("quaternion repaired", workOf([&] { normalise(unit, dot(q)); }));
  other("matrix repaired", workOf([&] { repair(repaired); }));
  std::cout << turning << "\n" << others << "\n";

  // A matrix has to be made first. From how many points on does it pay?
  carom::io::Plot plot("Products and sums to turn points by a quaternion");
  plot.describe("Three straight lines. That of the matrix starts higher and rises least.");
  plot.xAxis("points").yAxis("products and sums");
  const std::vector<Real> ends = {0, 6};
  const auto line = [&](const char* way, int first, int each) {
    plot.curve(way, ends, {Real(first), Real(first + 6 * each)});
  };
  line("sandwich", 0, sandwich);
  line("two cross products", 0, crosses);
  line("matrix, made first", conversion, matrix);
  plot.writeSvg(folder / "cost_of_turning.svg");
  int points = 1;
  while (conversion + points * matrix >= points * crosses) ++points;
  std::cout << "Making a matrix first is less work from " << points << " points on.\n";
}
