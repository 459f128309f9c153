#include "core/shape/packs.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

/// The axes that Polygon projects along: without the one its normal is nearest to.
struct Kept {
  int u, v;
};

Kept kept_axes(const Vec3& normal) {
  const Vec3 n{std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
  const int dropped = n.x > n.y ? (n.x > n.z ? 0 : 2) : (n.y > n.z ? 1 : 2);
  return {dropped == 0 ? 1 : 0, dropped == 2 ? 1 : 2};
}

/// Edges that can count: not level ones; contours end where their first point comes again.
template <class Visit>
void visit_edges(const Polygon& polygon, const Kept& axes, Visit&& visit) {
  const std::vector<Vec3>& points = polygon.points();
  std::size_t start = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec3 &a = points[i - 1], &b = points[i];
    const EvenOdd::Edge edge{a[axes.u], a[axes.v], b[axes.u], b[axes.v]};
    if (edge.v0 < edge.v1) visit(edge);
    if (edge.v1 < edge.v0) visit({edge.u1, edge.v1, edge.u0, edge.v0});
    if (b == points[start]) start = ++i;
  }
}

}  // namespace

bool PolygonPack::fits(const Polygon& polygon) {
  if (polygon.is_degenerate()) return false;
  int edges = 0;
  visit_edges(polygon, kept_axes(polygon.normal({}, {})), [&](const EvenOdd::Edge&) { ++edges; });
  return edges <= kEdges;
}

void PolygonPack::set(int lane, const Polygon& polygon) {
  const Vec3 n = polygon.normal({}, {});
  const Kept axes = kept_axes(n);
  for (int a = 0; a < 3; ++a) normal[a][lane] = n[a];
  offset[lane] = dot(n, polygon.points().front());
  for (int a = 0; a < 2; ++a) {
    const int kept = a == 0 ? axes.u : axes.v;
    axis[a][2 * lane] = 2 * kept;
    axis[a][2 * lane + 1] = 2 * kept + 1;
    double least = Bounds::kInf, greatest = -Bounds::kInf;
    for (const Vec3& p : polygon.points()) {
      least = std::min(least, p[kept]);
      greatest = std::max(greatest, p[kept]);
    }
    lo[a][lane] = least;
    hi[a][lane] = greatest;
  }
  int i = 0;
  visit_edges(polygon, axes, [&](const EvenOdd::Edge& e) {
    edges[i].u0[lane] = e.u0;
    edges[i].v0[lane] = e.v0;
    edges[i].u1[lane] = e.u1;
    edges[i].v1[lane] = e.v1;
    ++i;
  });
}

}  // namespace lentray::core
