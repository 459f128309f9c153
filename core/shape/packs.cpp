#include "core/shape/packs.h"

namespace lentray::core {

bool PolygonPack::fits(const Polygon& polygon) {
  static_assert(kEdges == Polygon::kFew);
  return polygon.m_few_edges != 0;
}

void PolygonPack::set(int lane, const Polygon& polygon) {
  for (int a = 0; a < 3; ++a) normal[a][lane] = polygon.m_normal[a];
  offset[lane] = polygon.m_offset;
  const int kept[2] = {polygon.m_u, polygon.m_v};
  for (int a = 0; a < 2; ++a) {
    axis[a][2 * lane] = 2 * kept[a];
    axis[a][2 * lane + 1] = 2 * kept[a] + 1;
  }
  lo[0][lane] = polygon.m_lo_u;
  hi[0][lane] = polygon.m_hi_u;
  lo[1][lane] = polygon.m_lo_v;
  hi[1][lane] = polygon.m_hi_v;
  for (std::size_t i = 0; i < polygon.m_few_edges; ++i) {
    const EvenOdd::Edge& e = polygon.m_few[i];
    edges[i].u0[lane] = e.u0;
    edges[i].v0[lane] = e.v0;
    edges[i].u1[lane] = e.u1;
    edges[i].v1[lane] = e.v1;
  }
}

}  // namespace lentray::core
