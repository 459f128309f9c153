#include "core/shape/cone.h"

#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"

namespace lentray::core {

/// The crossings of the whole line, 0 to 2, ascending; none if none is beyond t_min. Between its ends' planes the cone is
/// convex, so that its solid is one stretch of the line: f = (distance from axis)^2 - radius^2
/// is not positive there.
int Cone::crossings(const Ray& ray, double t_min, double, bool, Crossing* out) const {
  if (is_degenerate()) return 0;
  const AboutIt at(*this, ray);
  const double ro = m_base_radius + m_slope * at.oz, rd = m_slope * at.dz;
  const double a = dot(at.dp, at.dp) - rd * rd, b = 2.0 * (dot(at.op, at.dp) - ro * rd);
  const double c = dot(at.op, at.op) - ro * ro;
  double root[2];
  const int n = solve_quadratic(a, b, c, root);
  if (n == 0 && c > 0.0) return 0;
  const bool rising =
      n > 0 && (a == 0.0 ? b > 0.0 : 2.0 * a * root[0] + b > 0.0);  // f at the first
  for (int i = 0; i < n; ++i) root[i] += at.shift;
  if (n == 2 && a > 0.0 && !(root[1] > t_min)) return 0;
  Crossing in, leave;
  if (!between_ends(at, in, leave)) return 0;
  double lo = -Bounds::kInf, hi = Bounds::kInf;  // where f <= 0
  if (n == 2 && a > 0.0) {
    lo = root[0];
    hi = root[1];
  } else if (n == 2) {
    // Outside the roots, on two different halves of the double cone: take the one between the ends.
    const double before = std::min(root[0], leave.t) - in.t,
                 after = leave.t - std::max(root[1], in.t);
    (before > after ? hi : lo) = before > after ? root[0] : root[1];
  } else if (n == 1) {
    (rising ? hi : lo) = root[0];
    if (a > 0.0 && b == 0.0) lo = hi = root[0];
  }
  if (m_open) {
    int kept = 0;
    for (int i = 0; i < n; ++i) {
      if (root[i] >= in.t && root[i] <= leave.t) out[kept++] = {root[i], kSide};
    }
    return kept;
  }
  if (lo > in.t) in = {lo, kSide};
  if (hi < leave.t) leave = {hi, kSide};
  if (!(in.t <= leave.t) || !std::isfinite(in.t) || !std::isfinite(leave.t)) return 0;
  out[0] = in;
  out[1] = leave;
  return 2;
}

std::unique_ptr<Shape> Cone::baked(const Transform& t) const {
  const double scale = similarity_scale(t);
  if (scale == 0.0) return nullptr;
  return std::make_unique<Cone>(t.point(m_base), m_base_radius * scale, t.point(cap()),
                                m_cap_radius * scale, m_open);
}

}  // namespace lentray::core
