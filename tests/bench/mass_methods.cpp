#include "bench/mass_methods.hpp"

#include <array>
#include <span>

namespace carom::bench {
namespace {

using Triangles = std::span<const std::array<std::int32_t, 3>>;

template <class S>
struct PlainSum {
  S sum = 0;
  void operator+=(S term) {
    sum += term;
  }
  S value() const {
    return sum;
  }
};

// Kahan 1965.
template <class S>
struct KahanSum {
  S sum = 0, lost = 0;
  void operator+=(S term) {
    const S corrected = term - lost;
    const S next = sum + corrected;
    lost = (next - sum) - corrected;
    sum = next;
  }
  S value() const {
    return sum;
  }
};

// 6 V, 24 V r and 120 times the second moments.
template <class Sum>
struct Moments {
  Sum v, x, y, z, xx, yy, zz, xy, yz, zx;
};

template <class S, class Sum>
void add(Moments<Sum>& m, const TriangleMesh& mesh, Triangles triangles, const Vector3& origin) {
  for (const auto& triangle : triangles) {
    S p[3][3];
    for (int k = 0; k < 3; ++k) {
      const Vector3& vertex = mesh.vertices[static_cast<std::size_t>(triangle[std::size_t(k)])];
      for (int i = 0; i < 3; ++i) p[k][i] = static_cast<S>(vertex[i] - origin[i]);
    }
    const S *a = p[0], *b = p[1], *c = p[2];
    const S v = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                a[2] * (b[0] * c[1] - b[1] * c[0]);
    const S s[3] = {a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]};
    const auto second = [&](int i, int j) {
      return v * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    };
    m.v += v;
    m.x += v * s[0];
    m.y += v * s[1];
    m.z += v * s[2];
    m.xx += second(0, 0);
    m.yy += second(1, 1);
    m.zz += second(2, 2);
    m.xy += second(0, 1);
    m.yz += second(1, 2);
    m.zx += second(2, 0);
  }
}

template <class Sum>
MassProperties bodyOf(const Moments<Sum>& m, const Vector3& origin) {
  const Real v = m.v.value();
  const Vector3 r = Vector3(m.x.value(), m.y.value(), m.z.value()) / (4 * v);
  Matrix3 C;  // 120 ∫ r rᵀ about the centre
  C << m.xx.value(), m.xy.value(), m.zx.value(), m.xy.value(), m.yy.value(), m.yz.value(),
      m.zx.value(), m.yz.value(), m.zz.value();
  C -= 20 * v * r * r.transpose();
  MassProperties body;
  body.volume = v / 6;
  body.mass = body.volume;
  body.center = origin + r;
  body.inertia = (C.trace() * Matrix3::Identity() - C) / 120;
  return body;
}

template <class S, class Sum>
MassProperties weigh(const TriangleMesh& mesh, const Vector3& origin) {
  Moments<Sum> moments;
  add<S>(moments, mesh, mesh.triangles, origin);
  return bodyOf(moments, origin);
}

Moments<PlainSum<Real>> pairwise(const TriangleMesh& mesh, Triangles triangles,
                                 const Vector3& origin) {
  Moments<PlainSum<Real>> moments;
  if (triangles.size() <= 64) {
    add<Real>(moments, mesh, triangles, origin);
    return moments;
  }
  const std::size_t half = triangles.size() / 2;
  moments = pairwise(mesh, triangles.first(half), origin);
  const auto other = pairwise(mesh, triangles.subspan(half), origin);
  using M = Moments<PlainSum<Real>>;
  for (const auto sum :
       {&M::v, &M::x, &M::y, &M::z, &M::xx, &M::yy, &M::zz, &M::xy, &M::yz, &M::zx}) {
    moments.*sum += (other.*sum).value();
  }
  return moments;
}

}  // namespace

Vector3 gatherCorners(const TriangleMesh& mesh) {
  Vector3 sum = Vector3::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Corners corners = cornersOf(mesh, triangle);
    sum += corners.a + corners.b + corners.c;
  }
  return sum;
}

MassProperties onePass(const TriangleMesh& mesh) {
  return weigh<Real, PlainSum<Real>>(mesh, Vector3::Zero());
}

MassProperties onePassFloat(const TriangleMesh& mesh) {
  return weigh<float, PlainSum<float>>(mesh, Vector3::Zero());
}

MassProperties shiftedPass(const TriangleMesh& mesh) {
  return weigh<Real, PlainSum<Real>>(mesh, mesh.vertices.front());
}

MassProperties shiftedKahan(const TriangleMesh& mesh) {
  return weigh<Real, KahanSum<Real>>(mesh, mesh.vertices.front());
}

MassProperties shiftedPairwise(const TriangleMesh& mesh) {
  return bodyOf(pairwise(mesh, mesh.triangles, mesh.vertices.front()), mesh.vertices.front());
}

}  // namespace carom::bench
