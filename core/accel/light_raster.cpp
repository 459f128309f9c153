#include "core/accel/light_raster.h"

#include <algorithm>

namespace lentray::core {

void LightWindow::include(const LightWindow& other) {
  if (other.is_empty()) return;
  for (int a = 0; a < 2; ++a) {
    lo[a] = std::min(lo[a], other.lo[a]);
    hi[a] = std::max(hi[a], other.hi[a]);
  }
}

void LightWindow::cut(double least, double most) {
  for (int a = 0; a < 2; ++a) {
    lo[a] = std::max(lo[a], least);
    hi[a] = std::min(hi[a], most);
  }
}

LightWindow window_of(const Bounds& box, int face) {
  LightWindow window;
  const int axis = face / 2;
  const double w1 = face & 1 ? -box.lo[axis] : box.hi[axis];
  const double w0 = std::max(face & 1 ? -box.hi[axis] : box.lo[axis], 0.0);
  if (!(w1 > 0.0)) return window;
  const int along[2] = {LightFace::u_axis(face), LightFace::v_axis(face)};
  for (int a = 0; a < 2; ++a) {
    const double lo = box.lo[along[a]], hi = box.hi[along[a]];
    // A quotient by w0 = 0 is infinite, or no number where the box reaches the light.
    const double least = lo / (lo < 0.0 ? w0 : w1), most = hi / (hi > 0.0 ? w0 : w1);
    window.lo[a] = std::isnan(least) ? -Bounds::kInf : least;
    window.hi[a] = std::isnan(most) ? Bounds::kInf : most;
  }
  window.cut(-1.0 - LightWindow::kSlack, 1.0 + LightWindow::kSlack);
  return window;
}

LightRaster::LightRaster(int face, const LightWindow& window, int columns, int rows)
    : m_face(face), m_u(LightFace::u_axis(face)), m_v(LightFace::v_axis(face)) {
  const int size[2] = {columns, rows};
  for (int a = 0; a < 2; ++a) {
    m_size[a] = size[a];
    m_lo[a] = window.lo[a] - 2.0 * LightWindow::kSlack;
    m_per_cell[a] = size[a] / (window.hi[a] + 2.0 * LightWindow::kSlack - m_lo[a]);
  }
}

Vec3 LightRaster::direction(double x, double y) const {
  Vec3 d;
  d[m_face / 2] = m_face & 1 ? -1.0 : 1.0;
  d[m_u] = place(0, x);
  d[m_v] = place(1, y);
  return d;
}

}  // namespace lentray::core
