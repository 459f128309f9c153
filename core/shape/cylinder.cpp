#include "core/shape/cylinder.h"

#include "core/numeric/bounds_help.h"

namespace lentray::core {

/// The crossings of the whole line, 0 to 2, ascending; none if none is beyond t_min. A closed cylinder is convex: what lies
/// between the side's two crossings and between the ends' planes is one stretch of the line.
int Cylinder::crossings(const Ray& ray, double t_min, double, bool, Crossing* out) const {
  if (is_degenerate()) return 0;
  const double radius2 = m_base_radius * m_base_radius;
  const AboutIt at(*this, ray);
  const double a = dot(at.dp, at.dp), b = dot(at.op, at.dp);

  Crossing in{-Bounds::kInf, kSide}, leave{Bounds::kInf, kSide};
  if (a > 1e-30 * dot(ray.direction, ray.direction)) {
    const double middle = -b / a;
    const Vec3 foot = at.op + at.dp * middle;
    const double h = radius2 - dot(foot, foot);
    if (!(h >= 0.0)) return 0;
    const double half = std::sqrt(h / a);
    in.t = at.shift + (middle - half);
    leave.t = at.shift + (middle + half);
    if (!(leave.t > t_min)) return 0;
  } else if (dot(at.op, at.op) > radius2) {
    return 0;
  }
  if (m_open) {
    int n = 0;
    for (const Crossing& side : {in, leave}) {
      const double z = at.oz + at.dz * (side.t - at.shift);
      if (z >= 0.0 && z <= m_length) out[n++] = side;
    }
    return n;
  }
  Crossing first, last;
  if (!between_ends(at, first, last)) return 0;
  if (first.t > in.t) in = first;
  if (last.t < leave.t) leave = last;
  if (!(in.t <= leave.t)) return 0;
  out[0] = in;
  out[1] = leave;
  return 2;
}

std::unique_ptr<Shape> Cylinder::baked(const Transform& t) const {
  const double scale = similarity_scale(t);
  if (scale == 0.0) return nullptr;
  return std::make_unique<Cylinder>(t.point(m_base), t.point(cap()), m_base_radius * scale, m_open);
}

}  // namespace lentray::core
