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
template <PointFormula kValue>
double limited_by_p1(const FormulaPoint& q) {
  return std::min(q.p[1], std::max(q.p[0] * kValue(q), -q.p[1]));
}

template <PointFormula kValue>
double negated(const FormulaPoint& q) {
  return -kValue(q);
}

template <int kAt, PointFormula kValue>
double on_curve(const double* a) {
  return kValue(in_plane(a, kAt));
}

double algbr_cyl1(const FormulaPoint& q) { return q.x2 - q.x2 * std::fabs(q.x) - q.y2; }

double algbr_cyl2(const FormulaPoint& q) {
  return 3.0 * q.x2 * q.y - 2.0 * q.x2 * q.x2 - q.y2 * squared(q.y - 1.0);
}

double algbr_cyl3(const FormulaPoint& q) {
  return 2.0 * q.x2 * q.y - q.x2 * (q.x2 + q.y2) + q.y2 * (q.x - 1.0);
}

double algbr_cyl4(const FormulaPoint& q) {
  return q.y * (q.y2 - 3.0 * q.x2) - squared(q.x2 + q.y2);
}

double devils_curve_2d(const FormulaPoint& q) {
  return q.y2 * (q.y2 - squared(q.p[2])) - q.x2 * (q.x2 - squared(q.p[1]));
}

double folium_surface_2d(const FormulaPoint& q) {
  return -q.y2 * (1.0 + (q.p[2] - 4.0 * q.p[1]) * q.x) - q.x2 * (1.0 + q.p[2]);
}

// P2 multiplies where the name suggests P1.
double kampyle_of_eudoxus_2d(const FormulaPoint& q) {
  return squared(q.p[2]) * q.x2 * (q.x2 - q.p[1] * q.p[2]) - q.y2;
}

double lemniscate_of_gerono_2d(const FormulaPoint& q) {
  return squared(q.p[2]) * q.x2 * (squared(q.p[1]) - q.x2) - q.y2;
}

double piriform_2d(const FormulaPoint& q) {
  return squared(q.p[3]) * q.x2 * (q.p[1] * q.x + q.p[2] * q.x2) - q.y2;
}

double strophoid_2d(const FormulaPoint& q) {
  return squared(q.p[3]) * q.x2 * (q.p[1] + q.x) - (q.p[2] - q.x) * q.y2;
}

double witch_of_agnesi_2d(const FormulaPoint& q) { return q.p[2] - q.y * (squared(q.p[1]) + q.x2); }

constexpr InternalFormula kFormulas[] = {
    {"f_algbr_cyl1", 0, 5, on_curve<2, negated<limited_by_p1<algbr_cyl1>>>},
    {"f_algbr_cyl2", 1, 5, on_curve<2, limited_by_p1<algbr_cyl2>>},
    {"f_algbr_cyl3", 2, 5, on_curve<2, limited_by_p1<algbr_cyl3>>},
    {"f_algbr_cyl4", 3, 5, on_curve<2, limited_by_p1<algbr_cyl4>>},
    {"f_devils_curve_2d", 15, 6, on_curve<3, limited<devils_curve_2d>>},
    {"f_folium_surface_2d", 21, 6, on_curve<3, limited<folium_surface_2d>>},
    {"f_kampyle_of_eudoxus_2d", 34, 6, on_curve<3, limited<kampyle_of_eudoxus_2d>>},
    {"f_lemniscate_of_gerono_2d", 39, 6, on_curve<3, limited<lemniscate_of_gerono_2d>>},
    {"f_piriform_2d", 50, 7, on_curve<4, limited<piriform_2d>>},
    {"f_strophoid_2d", 67, 7, on_curve<4, limited<strophoid_2d>>},
    {"f_witch_of_agnesi_2d", 75, 6, on_curve<3, limited<witch_of_agnesi_2d>>}};

}  // namespace

std::span<const InternalFormula> curve_formulas() { return kFormulas; }

}  // namespace lentray::core
