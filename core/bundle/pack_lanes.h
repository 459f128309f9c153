// Four rays of a bundle against one lane of a pack. World space. The bits are those of core/shape/packs.h, whose
// operations these repeat with the lanes' roles changed (no fused ones); a unit test holds them to it. Needs AVX2.
#pragma once

#include "core/bundle/ray_bundle.h"
#include "core/numeric/triangle_test.h"
#include "core/shape/packs.h"

namespace lentray::core {

/// Where four rays meet something. In lanes that do not `meet` it the others mean nothing.
struct LaneHits {
  Long4 meet;
  Double4 t, u, v;  ///< u, v: of triangles; else 0
};

/// Four rays of a bundle, the first of which is number `first`.
class RayLanes {
 public:
  LENTRAY_SIMD32 RayLanes(const RayBundle& rays, int first) : m_rays(rays), m_first(first) {}
  LENTRAY_SIMD32 Double4 origin(int axis) const {
    return simd::double4_at(m_rays.origin(axis) + m_first);
  }
  LENTRAY_SIMD32 Double4 direction(int axis) const {
    return simd::double4_at(m_rays.direction(axis) + m_first);
  }
  LENTRAY_SIMD32 Double4 inverse_dd() const {
    return simd::double4_at(m_rays.inverse_dd() + m_first);
  }
  const Ray& ray(int lane) const { return m_rays.ray(m_first + lane); }

 private:
  const RayBundle& m_rays;
  int m_first;
};

/// The crossing beyond t_min, as sphere_roots() has it.
LENTRAY_SIMD32 LaneHits meet_lane(const SpherePack& pack, int lane, const RayLanes& r,
                                  double t_min) {
  const Double4 dx = r.direction(0), dy = r.direction(1), dz = r.direction(2);
  const Double4 inverse_dd = r.inverse_dd();
  const Double4 ox = pack.centre[0][lane] - r.origin(0);
  const Double4 oy = pack.centre[1][lane] - r.origin(1);
  const Double4 oz = pack.centre[2][lane] - r.origin(2);
  const Double4 tm = dot_lanes(ox, oy, oz, dx, dy, dz) * inverse_dd;
  const Double4 px = ox - dx * tm;
  const Double4 py = oy - dy * tm;
  const Double4 pz = oz - dz * tm;
  const Double4 h = pack.radius2[lane] - dot_lanes(px, py, pz, px, py, pz);
  LaneHits hits{h >= Double4{}, {}, {}, {}};
  if (simd::signs(hits.meet) == 0) return hits;
  const Double4 s = simd::sqrt(h * inverse_dd);
  const Double4 t0 = tm - s, t1 = tm + s;
  hits.t = simd::chosen(t0 > simd::double4(t_min), t0, t1);
  return hits;
}

/// Polygon::nearest().
LENTRAY_SIMD32 LaneHits meet_lane(const PolygonPack& pack, int lane, const RayLanes& r, double) {
  const double nx = pack.normal[0][lane], ny = pack.normal[1][lane], nz = pack.normal[2][lane];
  const Double4 slope = nx * r.direction(0) + ny * r.direction(1) + nz * r.direction(2);
  const Double4 height = nx * r.origin(0) + ny * r.origin(1) + nz * r.origin(2);
  const Double4 t = (pack.offset[lane] - height) / slope;
  const int along_u = pack.axis[0][2 * lane] / 2, along_v = pack.axis[1][2 * lane] / 2;
  const Double4 u = r.origin(along_u) + t * r.direction(along_u);
  const Double4 v = r.origin(along_v) + t * r.direction(along_v);
  LaneHits hits{(u >= pack.lo[0][lane]) & (u <= pack.hi[0][lane]) & (v >= pack.lo[1][lane]) &
                    (v <= pack.hi[1][lane]),
                t,
                {},
                {}};
  if (simd::signs(hits.meet) == 0) return hits;
  Long4 odd{};
  for (const EvenOddLanes& e : pack.edges) {
    const double u0 = e.u0[lane], u1 = e.u1[lane], v0 = e.v0[lane], v1 = e.v1[lane];
    const Long4 spans = (v <= v0) ^ (v <= v1);
    const Long4 right = (u - u1) * (v1 - v0) <= (v1 - v) * (u0 - u1);
    odd ^= spans & right;
  }
  hits.meet &= odd;
  return hits;
}

/// intersect_triangle(), where not all four rays run longest along the same axis.
[[gnu::noinline, gnu::cold]] inline void meet_lane_apart(const TrianglePack& pack, int lane,
                                                         const RayLanes& r, TriangleHit (&hits)[4],
                                                         bool (&meet)[4]) {
  Vec3 corner[3];
  for (int c = 0; c < 3; ++c) {
    for (int a = 0; a < 3; ++a) corner[c][a] = pack.corner[c][a][lane];
  }
  for (int i = 0; i < 4; ++i) {
    meet[i] = intersect_triangle(ShearedRay(r.ray(i)), corner[0], corner[1], corner[2], hits[i]);
  }
}

/// intersect_triangle().
LENTRAY_SIMD32 LaneHits meet_lane(const TrianglePack& pack, int lane, const RayLanes& r, double) {
  const Double4 x_size = simd::abs(r.direction(0)), y_size = simd::abs(r.direction(1)),
                z_size = simd::abs(r.direction(2));
  const unsigned longest_x = simd::signs((x_size > y_size) & (x_size > z_size));
  const unsigned longest_y = simd::signs(~(x_size > y_size) & (y_size > z_size));
  LaneHits hits{};
  if ((longest_x != 0 && longest_x != 15) || (longest_y != 0 && longest_y != 15)) [[unlikely]] {
    TriangleHit each[4] = {};
    bool meet[4];
    meet_lane_apart(pack, lane, r, each, meet);
    for (int i = 0; i < 4; ++i) {
      hits.meet[i] = meet[i] ? -1 : 0;
      hits.t[i] = each[i].t;
      hits.u[i] = each[i].wb;
      hits.v[i] = each[i].wc;
    }
    return hits;
  }
  const int kz = longest_x != 0 ? 0 : longest_y != 0 ? 1 : 2;
  const int kx = kz == 2 ? 0 : kz + 1, ky = kx == 2 ? 0 : kx + 1;
  const Double4 sz = 1.0 / r.direction(kz);
  const Double4 sx = r.direction(kx) * sz, sy = r.direction(ky) * sz;
  const Double4 ox = r.origin(kx), oy = r.origin(ky), oz = r.origin(kz);
  Double4 x[3], y[3], z[3];
  for (int c = 0; c < 3; ++c) {
    z[c] = pack.corner[c][kz][lane] - oz;
    x[c] = pack.corner[c][kx][lane] - ox - sx * z[c];
    y[c] = pack.corner[c][ky][lane] - oy - sy * z[c];
  }
  const Double4 u = x[2] * y[1] - y[2] * x[1];
  const Double4 v = x[0] * y[2] - y[0] * x[2];
  const Double4 w = x[1] * y[0] - y[1] * x[0];
  const Double4 zero{};
  const Long4 below = (u < zero) | (v < zero) | (w < zero);
  const Long4 above = (u > zero) | (v > zero) | (w > zero);
  const Double4 det = u + v + w;
  hits.meet = ~(below & above) & (det != zero);
  if (simd::signs(hits.meet) == 0) return hits;
  hits.t = (u * z[0] + v * z[1] + w * z[2]) * sz / det;
  hits.u = v / det;
  hits.v = w / det;
  return hits;
}

}  // namespace lentray::core
