#include "core/function/internal_formulas.h"

namespace lentray::core {
namespace {

/// Where a plane curve is asked: in the xy plane, or (P[at] > 0) in the half plane through the y
/// axis and the point, P[at + 1] away from the axis and turned by P[at + 2] degrees.
FormulaPoint in_plane(const double* a, int at) {
  FormulaPoint q(a);
  if (!(q.p[at] > 0.0)) return q;
  const double out = q.ring() - q.p[at + 1], angle = q.p[at + 2] * (std::numbers::pi / 180.0);
  q.x = angle == 0.0 ? out : out * std::cos(angle) - q.y * std::sin(angle);
  if (angle != 0.0) q.y = out * std::sin(angle) + q.y * std::cos(angle);
  q.x2 = q.x * q.x;
  q.y2 = q.y * q.y;
  return q;
}

/// As limited(), within +-P1.
double limited_by(const FormulaPoint& q, double value) {
  return std::min(q.p[1], std::max(q.p[0] * value, -q.p[1]));
}

double algbr_cyl1(const double* a) {
  const FormulaPoint q = in_plane(a, 2);
  return -limited_by(q, q.x2 - q.x2 * std::fabs(q.x) - q.y2);
}

double algbr_cyl2(const double* a) {
  const FormulaPoint q = in_plane(a, 2);
  return limited_by(q, 3.0 * q.x2 * q.y - 2.0 * q.x2 * q.x2 - q.y2 * squared(q.y - 1.0));
}

double algbr_cyl3(const double* a) {
  const FormulaPoint q = in_plane(a, 2);
  return limited_by(q, 2.0 * q.x2 * q.y - q.x2 * (q.x2 + q.y2) + q.y2 * (q.x - 1.0));
}

double algbr_cyl4(const double* a) {
  const FormulaPoint q = in_plane(a, 2);
  return limited_by(q, q.y * (q.y2 - 3.0 * q.x2) - squared(q.x2 + q.y2));
}

double devils_curve_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 3);
  return limited(q, q.y2 * (q.y2 - squared(q.p[2])) - q.x2 * (q.x2 - squared(q.p[1])));
}

double folium_surface_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 3);
  return limited(q, -q.y2 * (1.0 + (q.p[2] - 4.0 * q.p[1]) * q.x) - q.x2 * (1.0 + q.p[2]));
}

// P2 multiplies where the name suggests P1.
double kampyle_of_eudoxus_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 3);
  return limited(q, squared(q.p[2]) * q.x2 * (q.x2 - q.p[1] * q.p[2]) - q.y2);
}

double lemniscate_of_gerono_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 3);
  return limited(q, squared(q.p[2]) * q.x2 * (squared(q.p[1]) - q.x2) - q.y2);
}

double piriform_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 4);
  return limited(q, squared(q.p[3]) * q.x2 * (q.p[1] * q.x + q.p[2] * q.x2) - q.y2);
}

double strophoid_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 4);
  return limited(q, squared(q.p[3]) * q.x2 * (q.p[1] + q.x) - (q.p[2] - q.x) * q.y2);
}

double witch_of_agnesi_2d(const double* a) {
  const FormulaPoint q = in_plane(a, 3);
  return limited(q, q.p[2] - q.y * (squared(q.p[1]) + q.x2));
}

constexpr InternalFormula kFormulas[] = {{"f_algbr_cyl1", algbr_cyl1},
                                         {"f_algbr_cyl2", algbr_cyl2},
                                         {"f_algbr_cyl3", algbr_cyl3},
                                         {"f_algbr_cyl4", algbr_cyl4},
                                         {"f_devils_curve_2d", devils_curve_2d},
                                         {"f_folium_surface_2d", folium_surface_2d},
                                         {"f_kampyle_of_eudoxus_2d", kampyle_of_eudoxus_2d},
                                         {"f_lemniscate_of_gerono_2d", lemniscate_of_gerono_2d},
                                         {"f_piriform_2d", piriform_2d},
                                         {"f_strophoid_2d", strophoid_2d},
                                         {"f_witch_of_agnesi_2d", witch_of_agnesi_2d}};

}  // namespace

std::span<const InternalFormula> curve_formulas() { return kFormulas; }

}  // namespace lentray::core
