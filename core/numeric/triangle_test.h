// Where a ray meets a triangle: the one formula that triangles, smooth triangles, meshes and
// batches of triangles share, bit for bit. Watertight: neighbours that share an edge's end
// points leave no gap between them (Woop, Benthin, Wald: "Watertight Ray/Triangle
// Intersection", JCGT 2(1), 2013). Any space; t in multiples of the direction.
#pragma once

#include "core/base/ray.h"

namespace lentray::core {

/// A ray made ready: axes permuted so that z is where the direction is longest, then sheared so
/// that the direction is (0, 0, 1).
struct ShearedRay {
  explicit ShearedRay(const Ray& ray) : origin(ray.origin) {
    const Vec3 d{std::fabs(ray.direction.x), std::fabs(ray.direction.y),
                 std::fabs(ray.direction.z)};
    kz = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    sz = 1.0 / ray.direction[kz];
    sx = ray.direction[kx] * sz;
    sy = ray.direction[ky] * sz;
  }
  Vec3 origin;
  int kx, ky, kz;
  double sx, sy, sz;
};

/// Weights are of the corners a, b, c and sum to 1.
struct TriangleHit {
  double t, wb, wc;
};

/// The formula, whose bits a batched test must repeat: with A = a - origin (B, C alike),
///   ax = A[kx] - sx * A[kz], ay = A[ky] - sy * A[kz];  u = cx*by - cy*bx, v = ax*cy - ay*cx,
///   w = bx*ay - by*ax; miss if of u, v, w one is negative and one positive, or det = 0;
///   det = (u + v) + w; t = ((u*A[kz] + v*B[kz]) + w*C[kz]) * sz / det; wb = v/det, wc = w/det.
/// Does not look at the range of t.
inline bool intersect_triangle(const ShearedRay& ray, const Vec3& a, const Vec3& b, const Vec3& c,
                               TriangleHit& hit) {
  const double az = a[ray.kz] - ray.origin[ray.kz];
  const double bz = b[ray.kz] - ray.origin[ray.kz];
  const double cz = c[ray.kz] - ray.origin[ray.kz];
  const double ax = (a[ray.kx] - ray.origin[ray.kx]) - ray.sx * az;
  const double ay = (a[ray.ky] - ray.origin[ray.ky]) - ray.sy * az;
  const double bx = (b[ray.kx] - ray.origin[ray.kx]) - ray.sx * bz;
  const double by = (b[ray.ky] - ray.origin[ray.ky]) - ray.sy * bz;
  const double cx = (c[ray.kx] - ray.origin[ray.kx]) - ray.sx * cz;
  const double cy = (c[ray.ky] - ray.origin[ray.ky]) - ray.sy * cz;
  const double u = cx * by - cy * bx;
  const double v = ax * cy - ay * cx;
  const double w = bx * ay - by * ax;
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return false;
  const double det = (u + v) + w;
  if (det == 0.0) return false;
  hit.t = ((u * az + v * bz) + w * cz) * ray.sz / det;
  hit.wb = v / det;
  hit.wc = w / det;
  return true;
}

/// No area at all: shapes leave such triangles out.
bool triangle_is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace lentray::core
