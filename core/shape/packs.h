// Four spheres, triangles or polygons of few edges tested together. World space. The bits of a
// hit are those of sphere_roots(), intersect_triangle() and Polygon::nearest(), whose formulae
// these repeat lane by lane (no fused operations); unit tests hold them to it.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/simd.h"
#include "core/bvh/wide_bvh.h"
#include "core/numeric/triangle_test.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"

namespace lentray::core {

inline constexpr int kPack = 4;

/// Empty lanes have a negative radius2: nothing meets them.
struct alignas(32) SpherePack {
  double centre[3][kPack] = {};
  double radius2[kPack] = {-1.0, -1.0, -1.0, -1.0};
  std::uint32_t first = 0, count = 0;  ///< places of the lanes' objects

  void set(int lane, const Sphere& sphere) {
    for (int a = 0; a < 3; ++a) centre[a][lane] = sphere.centre()[a];
    radius2[lane] = sphere.radius2();
  }
};

/// Empty lanes have all corners alike: nothing meets them.
struct alignas(64) TrianglePack {
  double corner[3][3][kPack] = {};  ///< corner, axis
  std::uint32_t first = 0, count = 0;

  void set(int lane, const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int axis = 0; axis < 3; ++axis) {
      corner[0][axis][lane] = a[axis];
      corner[1][axis][lane] = b[axis];
      corner[2][axis][lane] = c[axis];
    }
  }
};

/// An edge of each lane, EvenOdd::Edge: v0 < v1.
struct alignas(32) EvenOddLanes {
  double u0[kPack] = {}, u1[kPack] = {};
  double v0[kPack] = {Bounds::kInf, Bounds::kInf, Bounds::kInf, Bounds::kInf};
  double v1[kPack] = {Bounds::kInf, Bounds::kInf, Bounds::kInf, Bounds::kInf};
};

/// Polygons whose even-odd test has at most four edges. Empty lanes have a null normal: the
/// distance is no number then and nothing meets them.
struct alignas(64) PolygonPack {
  static constexpr int kEdges = 4;
  double normal[3][kPack] = {};
  double offset[kPack] = {};                    ///< of the plane along the normal
  double lo[2][kPack] = {}, hi[2][kPack] = {};  ///< in the projection
  std::int32_t axis[2][2 * kPack] = {};  ///< kept by the projection; a double's halves: 2a, 2a + 1
  std::uint32_t first = 0, count = 0;
  EvenOddLanes edges[kEdges];  ///< empty ones span nothing

  /// False if the polygon has more edges than a lane holds (or nothing hits it).
  static bool fits(const Polygon& polygon);
  void set(int lane, const Polygon& polygon);
};

/// What the lanes gave; only those in the returned mask are set meaningfully.
struct alignas(32) PackHits {
  double t[kPack];
  double u[kPack], v[kPack];  ///< triangles: weights of corners b and c
};

/// A ray with what the batches share.
struct PackRay {
  PackRay(const Ray& r, bool triangles) : ray(r), inverse_dd(1.0 / dot(r.direction, r.direction)) {
    if (triangles) sheared.emplace(r);
  }
  const Ray& ray;
  double inverse_dd;
  std::optional<ShearedRay> sheared;  ///< there are triangles
};

/// Lanes with a nearest crossing t_min < t <= t_max. The limit is included: the caller decides
/// about equal distances.
inline unsigned intersect_portable(const SpherePack& pack, const PackRay& r, double t_min,
                                   double t_max, PackHits& hits) {
  unsigned mask = 0;
  for (int i = 0; i < kPack; ++i) {
    double t0 = 0.0, t1 = 0.0;
    const Vec3 centre{pack.centre[0][i], pack.centre[1][i], pack.centre[2][i]};
    if (!sphere_roots(r.ray, r.inverse_dd, centre, pack.radius2[i], t0, t1)) continue;
    const double t = t0 > t_min ? t0 : t1;
    if (!(t > t_min && t <= t_max)) continue;
    hits.t[i] = t;
    hits.u[i] = hits.v[i] = 0.0;
    mask |= 1u << i;
  }
  return mask;
}

inline unsigned intersect_portable(const TrianglePack& pack, const PackRay& r, double t_min,
                                   double t_max, PackHits& hits) {
  unsigned mask = 0;
  const auto corner = [&](int c, int i) {
    return Vec3{pack.corner[c][0][i], pack.corner[c][1][i], pack.corner[c][2][i]};
  };
  for (int i = 0; i < kPack; ++i) {
    TriangleHit hit;
    if (!intersect_triangle(*r.sheared, corner(0, i), corner(1, i), corner(2, i), hit)) continue;
    if (!(hit.t > t_min && hit.t <= t_max)) continue;
    hits.t[i] = hit.t;
    hits.u[i] = hit.wb;
    hits.v[i] = hit.wc;
    mask |= 1u << i;
  }
  return mask;
}

inline unsigned intersect_portable(const PolygonPack& pack, const PackRay& r, double t_min,
                                   double t_max, PackHits& hits) {
  unsigned mask = 0;
  for (int i = 0; i < kPack; ++i) {
    const Vec3 normal{pack.normal[0][i], pack.normal[1][i], pack.normal[2][i]};
    const double t = (pack.offset[i] - dot(normal, r.ray.origin)) / dot(normal, r.ray.direction);
    if (!(t > t_min && t <= t_max)) continue;
    const int along_u = pack.axis[0][2 * i] / 2, along_v = pack.axis[1][2 * i] / 2;
    const double u = r.ray.origin[along_u] + t * r.ray.direction[along_u];
    const double v = r.ray.origin[along_v] + t * r.ray.direction[along_v];
    if (!(u >= pack.lo[0][i] && u <= pack.hi[0][i] && v >= pack.lo[1][i] && v <= pack.hi[1][i])) {
      continue;
    }
    bool odd = false;
    for (const EvenOddLanes& e : pack.edges) {
      odd ^= EvenOdd::crosses({e.u0[i], e.v0[i], e.u1[i], e.v1[i]}, u, v);
    }
    if (!odd) continue;
    hits.t[i] = t;
    hits.u[i] = hits.v[i] = 0.0;
    mask |= 1u << i;
  }
  return mask;
}

LENTRAY_AVX2 inline Double4 dot_lanes(Double4 ax, Double4 ay, Double4 az, Double4 bx, Double4 by,
                                      Double4 bz) {
  return ax * bx + ay * by + az * bz;
}

LENTRAY_AVX2 inline unsigned intersect_avx2(const SpherePack& pack, const PackRay& r, double t_min,
                                            double t_max, PackHits& hits) {
  const Vec3& o = r.ray.origin;
  const Vec3& d = r.ray.direction;
  const Double4 dx = simd::double4(d.x), dy = simd::double4(d.y), dz = simd::double4(d.z);
  const Double4 inverse_dd = simd::double4(r.inverse_dd);
  const Double4 ox = simd::double4_at(pack.centre[0]) - o.x;
  const Double4 oy = simd::double4_at(pack.centre[1]) - o.y;
  const Double4 oz = simd::double4_at(pack.centre[2]) - o.z;
  const Double4 tm = dot_lanes(ox, oy, oz, dx, dy, dz) * inverse_dd;
  const Double4 px = ox - dx * tm;
  const Double4 py = oy - dy * tm;
  const Double4 pz = oz - dz * tm;
  const Double4 h = simd::double4_at(pack.radius2) - dot_lanes(px, py, pz, px, py, pz);
  const Long4 met = h >= Double4{};
  if (simd::signs(met) == 0) return 0;
  const Double4 s = simd::sqrt(h * inverse_dd);
  const Double4 t0 = tm - s, t1 = tm + s;
  const Double4 low = simd::double4(t_min);
  const Double4 t = simd::chosen(t0 > low, t0, t1);
  const Long4 in = (t > low) & (t <= t_max);
  simd::store(hits.t, t);
  simd::store(hits.u, Double4{});
  simd::store(hits.v, Double4{});
  return simd::signs(met & in);
}

[[gnu::always_inline]] LENTRAY_AVX2 inline unsigned intersect_avx2(const TrianglePack& pack,
                                                                   const PackRay& r, double t_min,
                                                                   double t_max, PackHits& hits) {
  const ShearedRay& s = *r.sheared;
  const Double4 ox = simd::double4(s.origin[s.kx]), oy = simd::double4(s.origin[s.ky]),
                oz = simd::double4(s.origin[s.kz]);
  const Double4 sx = simd::double4(s.sx), sy = simd::double4(s.sy);
  Double4 x[3], y[3], z[3];
  for (int c = 0; c < 3; ++c) {
    z[c] = simd::double4_at(pack.corner[c][s.kz]) - oz;
    x[c] = simd::double4_at(pack.corner[c][s.kx]) - ox - sx * z[c];
    y[c] = simd::double4_at(pack.corner[c][s.ky]) - oy - sy * z[c];
  }
  const Double4 u = x[2] * y[1] - y[2] * x[1];
  const Double4 v = x[0] * y[2] - y[0] * x[2];
  const Double4 w = x[1] * y[0] - y[1] * x[0];
  const Double4 zero{};
  const Long4 below = (u < zero) | (v < zero) | (w < zero);
  const Long4 above = (u > zero) | (v > zero) | (w > zero);
  const Double4 det = u + v + w;
  const Long4 met = ~(below & above) & (det != zero);
  if (simd::signs(met) == 0) return 0;
  const Double4 t = (u * z[0] + v * z[1] + w * z[2]) * s.sz / det;
  const Long4 in = (t > t_min) & (t <= t_max);
  const Long4 hit = met & in;
  const unsigned mask = simd::signs(hit);
  if (mask == 0) return 0;
  simd::store(hits.t, t);
  simd::store(hits.u, v / det);
  simd::store(hits.v, w / det);
  return mask;
}

LENTRAY_AVX2 inline unsigned intersect_avx2(const PolygonPack& pack, const PackRay& r, double t_min,
                                            double t_max, PackHits& hits) {
  const Vec3& o = r.ray.origin;
  const Vec3& d = r.ray.direction;
  const Double4 nx = simd::double4_at(pack.normal[0]), ny = simd::double4_at(pack.normal[1]),
                nz = simd::double4_at(pack.normal[2]);
  const Double4 slope = nx * d.x + ny * d.y + nz * d.z;
  const Double4 height = nx * o.x + ny * o.y + nz * o.z;
  const Double4 t = (simd::double4_at(pack.offset) - height) / slope;
  Long4 met = (t > t_min) & (t <= t_max);
  if (simd::signs(met) == 0) return 0;
  // The ray's numbers as two registers, (o, dx) and (oz, d): d is one place further up.
  const Int8 from = Int8(simd::double4_at(&o.x)), along = Int8(simd::double4_at(&o.z));
  Double4 at[2];
  for (int a = 0; a < 2; ++a) {
    const Int8 axis = simd::int8_at(pack.axis[a]);
    const Double4 oa = Double4(simd::picked(from, axis)),
                  da = Double4(simd::picked(along, axis + 2));
    at[a] = oa + t * da;
    met &= at[a] >= simd::double4_at(pack.lo[a]);
    met &= at[a] <= simd::double4_at(pack.hi[a]);
  }
  if (simd::signs(met) == 0) return 0;
  const Double4 u = at[0], v = at[1];
  Long4 odd{};
  for (const EvenOddLanes& e : pack.edges) {
    const Double4 u0 = simd::double4_at(e.u0), u1 = simd::double4_at(e.u1);
    const Double4 v0 = simd::double4_at(e.v0), v1 = simd::double4_at(e.v1);
    const Long4 spans = (v0 >= v) ^ (v1 >= v);
    const Long4 right = (u - u1) * (v1 - v0) <= (v1 - v) * (u0 - u1);
    odd ^= spans & right;
  }
  const unsigned mask = simd::signs(met & odd);
  if (mask == 0) return 0;
  simd::store(hits.t, t);
  simd::store(hits.u, Double4{});
  simd::store(hits.v, Double4{});
  return mask;
}

}  // namespace lentray::core
