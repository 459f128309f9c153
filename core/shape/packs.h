// Four spheres, triangles or polygons of few edges tested together. World space. The bits of a
// hit are those of sphere_roots(), intersect_triangle() and Polygon::nearest(), whose formulae
// these repeat lane by lane (no fused operations); unit tests hold them to it.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <optional>

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
  double offset[kPack] = {};                   ///< of the plane along the normal
  double lo[2][kPack] = {}, hi[2][kPack] = {}; ///< in the projection
  std::int32_t axis[2][2 * kPack] = {};  ///< kept by the projection; a double's halves: 2a, 2a + 1
  std::uint32_t first = 0, count = 0;
  EvenOddLanes edges[kEdges];                  ///< empty ones span nothing

  /// False if the polygon has more edges than a lane holds (or nothing meets it).
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
  PackRay(const Ray& r, bool triangles)
      : ray(r), inverse_dd(1.0 / dot(r.direction, r.direction)) {
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

LENTRAY_AVX2 inline __m256d dot_lanes(__m256d ax, __m256d ay, __m256d az, __m256d bx, __m256d by,
                                      __m256d bz) {
  return _mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(ax, bx), _mm256_mul_pd(ay, by)),
                       _mm256_mul_pd(az, bz));
}

LENTRAY_AVX2 inline unsigned intersect_avx2(const SpherePack& pack, const PackRay& r,
                                            double t_min, double t_max, PackHits& hits) {
  const Vec3& o = r.ray.origin;
  const Vec3& d = r.ray.direction;
  const __m256d dx = _mm256_set1_pd(d.x), dy = _mm256_set1_pd(d.y), dz = _mm256_set1_pd(d.z);
  const __m256d inverse_dd = _mm256_set1_pd(r.inverse_dd);
  const __m256d ox = _mm256_sub_pd(_mm256_load_pd(pack.centre[0]), _mm256_set1_pd(o.x));
  const __m256d oy = _mm256_sub_pd(_mm256_load_pd(pack.centre[1]), _mm256_set1_pd(o.y));
  const __m256d oz = _mm256_sub_pd(_mm256_load_pd(pack.centre[2]), _mm256_set1_pd(o.z));
  const __m256d tm = _mm256_mul_pd(dot_lanes(ox, oy, oz, dx, dy, dz), inverse_dd);
  const __m256d px = _mm256_sub_pd(ox, _mm256_mul_pd(dx, tm));
  const __m256d py = _mm256_sub_pd(oy, _mm256_mul_pd(dy, tm));
  const __m256d pz = _mm256_sub_pd(oz, _mm256_mul_pd(dz, tm));
  const __m256d h = _mm256_sub_pd(_mm256_load_pd(pack.radius2), dot_lanes(px, py, pz, px, py, pz));
  const __m256d met = _mm256_cmp_pd(h, _mm256_setzero_pd(), _CMP_GE_OQ);
  if (_mm256_movemask_pd(met) == 0) return 0;
  const __m256d s = _mm256_sqrt_pd(_mm256_mul_pd(h, inverse_dd));
  const __m256d t0 = _mm256_sub_pd(tm, s), t1 = _mm256_add_pd(tm, s);
  const __m256d low = _mm256_set1_pd(t_min);
  const __m256d t = _mm256_blendv_pd(t1, t0, _mm256_cmp_pd(t0, low, _CMP_GT_OQ));
  const __m256d in = _mm256_and_pd(_mm256_cmp_pd(t, low, _CMP_GT_OQ),
                                   _mm256_cmp_pd(t, _mm256_set1_pd(t_max), _CMP_LE_OQ));
  _mm256_store_pd(hits.t, t);
  _mm256_store_pd(hits.u, _mm256_setzero_pd());
  _mm256_store_pd(hits.v, _mm256_setzero_pd());
  return static_cast<unsigned>(_mm256_movemask_pd(_mm256_and_pd(met, in)));
}

LENTRAY_AVX2 inline unsigned intersect_avx2(const TrianglePack& pack, const PackRay& r,
                                            double t_min, double t_max, PackHits& hits) {
  const ShearedRay& s = *r.sheared;
  const __m256d ox = _mm256_set1_pd(s.origin[s.kx]), oy = _mm256_set1_pd(s.origin[s.ky]),
                oz = _mm256_set1_pd(s.origin[s.kz]);
  const __m256d sx = _mm256_set1_pd(s.sx), sy = _mm256_set1_pd(s.sy);
  __m256d x[3], y[3], z[3];
  for (int c = 0; c < 3; ++c) {
    z[c] = _mm256_sub_pd(_mm256_load_pd(pack.corner[c][s.kz]), oz);
    x[c] = _mm256_sub_pd(_mm256_sub_pd(_mm256_load_pd(pack.corner[c][s.kx]), ox),
                         _mm256_mul_pd(sx, z[c]));
    y[c] = _mm256_sub_pd(_mm256_sub_pd(_mm256_load_pd(pack.corner[c][s.ky]), oy),
                         _mm256_mul_pd(sy, z[c]));
  }
  const __m256d u = _mm256_sub_pd(_mm256_mul_pd(x[2], y[1]), _mm256_mul_pd(y[2], x[1]));
  const __m256d v = _mm256_sub_pd(_mm256_mul_pd(x[0], y[2]), _mm256_mul_pd(y[0], x[2]));
  const __m256d w = _mm256_sub_pd(_mm256_mul_pd(x[1], y[0]), _mm256_mul_pd(y[1], x[0]));
  const __m256d zero = _mm256_setzero_pd();
  const __m256d below = _mm256_or_pd(_mm256_or_pd(_mm256_cmp_pd(u, zero, _CMP_LT_OQ),
                                                  _mm256_cmp_pd(v, zero, _CMP_LT_OQ)),
                                     _mm256_cmp_pd(w, zero, _CMP_LT_OQ));
  const __m256d above = _mm256_or_pd(_mm256_or_pd(_mm256_cmp_pd(u, zero, _CMP_GT_OQ),
                                                  _mm256_cmp_pd(v, zero, _CMP_GT_OQ)),
                                     _mm256_cmp_pd(w, zero, _CMP_GT_OQ));
  const __m256d det = _mm256_add_pd(_mm256_add_pd(u, v), w);
  const __m256d met =
      _mm256_andnot_pd(_mm256_and_pd(below, above), _mm256_cmp_pd(det, zero, _CMP_NEQ_UQ));
  if (_mm256_movemask_pd(met) == 0) return 0;
  const __m256d t = _mm256_div_pd(
      _mm256_mul_pd(_mm256_add_pd(_mm256_add_pd(_mm256_mul_pd(u, z[0]), _mm256_mul_pd(v, z[1])),
                                  _mm256_mul_pd(w, z[2])),
                    _mm256_set1_pd(s.sz)),
      det);
  const __m256d in = _mm256_and_pd(_mm256_cmp_pd(t, _mm256_set1_pd(t_min), _CMP_GT_OQ),
                                   _mm256_cmp_pd(t, _mm256_set1_pd(t_max), _CMP_LE_OQ));
  const __m256d hit = _mm256_and_pd(met, in);
  const int mask = _mm256_movemask_pd(hit);
  if (mask == 0) return 0;
  _mm256_store_pd(hits.t, t);
  _mm256_store_pd(hits.u, _mm256_div_pd(v, det));
  _mm256_store_pd(hits.v, _mm256_div_pd(w, det));
  return static_cast<unsigned>(mask);
}

LENTRAY_AVX2 inline unsigned intersect_avx2(const PolygonPack& pack, const PackRay& r,
                                            double t_min, double t_max, PackHits& hits) {
  const Vec3& o = r.ray.origin;
  const Vec3& d = r.ray.direction;
  const __m256d nx = _mm256_load_pd(pack.normal[0]), ny = _mm256_load_pd(pack.normal[1]),
                nz = _mm256_load_pd(pack.normal[2]);
  const __m256d slope =
      dot_lanes(nx, ny, nz, _mm256_set1_pd(d.x), _mm256_set1_pd(d.y), _mm256_set1_pd(d.z));
  const __m256d height =
      dot_lanes(nx, ny, nz, _mm256_set1_pd(o.x), _mm256_set1_pd(o.y), _mm256_set1_pd(o.z));
  const __m256d t = _mm256_div_pd(_mm256_sub_pd(_mm256_load_pd(pack.offset), height), slope);
  __m256d met = _mm256_and_pd(_mm256_cmp_pd(t, _mm256_set1_pd(t_min), _CMP_GT_OQ),
                              _mm256_cmp_pd(t, _mm256_set1_pd(t_max), _CMP_LE_OQ));
  if (_mm256_movemask_pd(met) == 0) return 0;
  // The ray's numbers as two registers, (o, dx) and (oz, d): d is one place further up.
  const __m256i from = _mm256_castpd_si256(_mm256_loadu_pd(&o.x));
  const __m256i along = _mm256_castpd_si256(_mm256_loadu_pd(&o.z));
  __m256d at[2];
  for (int a = 0; a < 2; ++a) {
    const __m256i axis = _mm256_load_si256(reinterpret_cast<const __m256i*>(pack.axis[a]));
    const __m256i next = _mm256_add_epi32(axis, _mm256_set1_epi32(2));
    const __m256d oa = _mm256_castsi256_pd(_mm256_permutevar8x32_epi32(from, axis));
    const __m256d da = _mm256_castsi256_pd(_mm256_permutevar8x32_epi32(along, next));
    at[a] = _mm256_add_pd(oa, _mm256_mul_pd(t, da));
    met = _mm256_and_pd(met, _mm256_cmp_pd(at[a], _mm256_load_pd(pack.lo[a]), _CMP_GE_OQ));
    met = _mm256_and_pd(met, _mm256_cmp_pd(at[a], _mm256_load_pd(pack.hi[a]), _CMP_LE_OQ));
  }
  if (_mm256_movemask_pd(met) == 0) return 0;
  const __m256d u = at[0], v = at[1];
  __m256d odd = _mm256_setzero_pd();
  for (const EvenOddLanes& e : pack.edges) {
    const __m256d u0 = _mm256_load_pd(e.u0), u1 = _mm256_load_pd(e.u1);
    const __m256d v0 = _mm256_load_pd(e.v0), v1 = _mm256_load_pd(e.v1);
    const __m256d spans = _mm256_xor_pd(_mm256_cmp_pd(v0, v, _CMP_GE_OQ),
                                        _mm256_cmp_pd(v1, v, _CMP_GE_OQ));
    const __m256d right =
        _mm256_cmp_pd(_mm256_mul_pd(_mm256_sub_pd(u, u1), _mm256_sub_pd(v1, v0)),
                      _mm256_mul_pd(_mm256_sub_pd(v1, v), _mm256_sub_pd(u0, u1)), _CMP_LE_OQ);
    odd = _mm256_xor_pd(odd, _mm256_and_pd(spans, right));
  }
  const int mask = _mm256_movemask_pd(_mm256_and_pd(met, odd));
  if (mask == 0) return 0;
  _mm256_store_pd(hits.t, t);
  _mm256_store_pd(hits.u, _mm256_setzero_pd());
  _mm256_store_pd(hits.v, _mm256_setzero_pd());
  return static_cast<unsigned>(mask);
}

}  // namespace lentray::core
