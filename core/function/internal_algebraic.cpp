#include "core/function/internal_formulas.h"

namespace lentray::core {
namespace {

using Q = FormulaPoint;

double bicorn(const Q& q) {
  const double s = squared(q.p[1]);
  const double parabola = q.ring2() + 2.0 * q.p[1] * q.y - s;
  return q.y2 * (s - q.ring2()) - squared(parabola);
}

double bifolia(const Q& q) { return q.p[1] * q.ring2() * q.y - squared(q.square()); }

// Boy's surface in Apery's form, of degree six.
double boy_surface(const Q& q) {
  const double root2 = std::numbers::sqrt2, w = 1.0 - q.z, s = q.x2 + q.y2, z4 = q.z2 * q.z2;
  const double first = 64.0 * cubed(w) * q.z2 * q.z;
  const double second = 48.0 * w * w * q.z2 * (3.0 * s + 2.0 * q.z2);
  const double third =
      27.0 * s * s - 24.0 * q.z2 * s + 36.0 * root2 * q.y * q.z * (q.y2 - 3.0 * q.x2) + 4.0 * z4;
  const double fourth =
      -81.0 * s * s - 72.0 * q.z2 * s + 108.0 * root2 * q.x * q.z * (q.x2 - 3.0 * q.y2) + 4.0 * z4;
  return q.p[1] * (first - second + 12.0 * w * q.z * third + (9.0 * s - 2.0 * q.z2) * fourth);
}

double crossed_trough(const Q& q) { return q.x2 * q.z2 - q.y; }

double cubic_saddle(const Q& q) { return q.z + cubed(q.y) - cubed(q.x); }

// f_cushion and f_odd are the same.
double cushion(const Q& q) {
  const double z4 = q.z2 * q.z2, y4 = q.y2 * q.y2;
  const double even = q.z2 * q.x2 - z4 + q.x2 - q.z2 - y4 - 2.0 * q.x2 * q.y2 - q.y2 * q.z2 + q.y2;
  const double odd = 2.0 * q.z * (q.z2 - q.x2 + q.y2);
  return even + odd - squared(q.x2 - q.z);
}

double devils_curve(const Q& q) { return 0.36 * q.x2 - squared(q.ring2()) + q.y2 * (q.y2 - 0.25); }

double dupin_cyclid(const Q& q) {
  const double minor = q.p[1], major2 = squared(q.p[2]), cx = q.p[3], cy = q.p[4];
  const double cy2 = cy * cy, r2 = squared(q.p[5]);
  const double outer = major2 - cy2 - squared(cx + minor),
               inner = major2 - cy2 - squared(cx - minor);
  const double along = cx * q.x + cy * q.y;
  const double middle =
      (major2 + minor * minor - cy2 - cx * cx) * (2.0 * along - r2) - 4.0 * cy * major2 * q.y;
  const double fourth = squared(q.square());
  return -(outer * inner * fourth + 2.0 * r2 * middle * q.square() +
           4.0 * r2 * r2 * (along * (along - r2) + squared(minor * q.y)) + squared(r2 * r2));
}

// The fractions 2/3, 1/4, 8/9 and 2/9 of the formula count as 0.
double enneper(const Q& q) {
  // Only where z divides it is kept away from zero.
  const double z = std::fabs(q.z) < 0.2 ? 0.2 : q.z, saddle = q.y2 - q.x2;
  const double one = saddle / (2.0 * z) + 2.0 * q.z2 / 9.0, two = saddle / (4.0 * z);
  return 6.0 * two * two - cubed(one);
}

double folium_surface(const Q& q) {
  return (q.y2 + q.z2) * (1.0 + (q.p[2] - 4.0 * q.p[1]) * q.x) + q.x2 * (1.0 + q.p[2]);
}

double glob(const Q& q) { return 0.5 * q.x2 * q.x2 * (q.x + 1.0) - q.y2 - q.z2; }

double heart(const Q& q) {
  return q.z2 * q.z * (0.1 * q.x2 + q.y2) - cubed(2.0 * q.x2 + q.y2 + q.z2 - 1.0);
}

double hunt_surface(const Q& q) {
  return -4.0 * cubed(q.square() - 13.0) - 27.0 * squared(3.0 * q.x2 + q.y2 - 4.0 * q.z2 - 12.0);
}

// The tori of degree four: the signs of y2 and z2 in the sum make the kind.
double hyperbolic_torus(const Q& q) {
  const double m = squared(q.p[1]), n = squared(q.p[2]);
  return -squared(q.x2 + q.y2 - q.z2) + 2.0 * (m + n) * (q.x2 - q.z2) - 2.0 * (m - n) * q.y2 -
         squared(m - n);
}

double torus2(const Q& q) {
  const double m = squared(q.p[1]), n = squared(q.p[2]);
  return -squared(q.square()) + 2.0 * (m + n) * q.ring2() - 2.0 * (m - n) * q.y2 - squared(m - n);
}

double parabolic_torus(const Q& q) {
  const double m = squared(q.p[1]), n = squared(q.p[2]);
  return -squared(q.x2 + q.y2 - q.z) + (m + n) * (q.x2 - q.z) - (m - n) * q.y2 - squared(m - n);
}

double kampyle_of_eudoxus(const Q& q) {
  return squared(q.p[2]) * q.x2 * (q.x2 - squared(q.p[1])) - q.y2 - q.z2;
}

double klein_bottle(const Q& q) {
  const double plus = q.square() + 2.0 * q.y - 1.0, minus = q.square() - 2.0 * q.y - 1.0;
  return -plus * (minus * minus - 8.0 * q.z2) - 16.0 * q.x * q.z * minus;
}

double kummer_surface_v1(const Q& q) {
  return q.square() + q.x2 * q.y2 + q.x2 * q.z2 + q.y2 * q.z2 - q.x2 * q.x2 - q.y2 * q.y2 -
         q.z2 * q.z2 - 1.0;
}

double kummer_surface_v2(const Q& q) {
  const double fourth = q.x2 * q.x2 + q.y2 * q.y2 + q.z2 * q.z2;
  const double mixed = q.x2 * q.y2 + q.x2 * q.z2 + q.y2 * q.z2;
  return 1.0 - fourth - q.p[1] * q.square() - q.p[2] * mixed - q.p[3] * q.x * q.y * q.z;
}

double lemniscate_of_gerono(const Q& q) { return q.x2 - q.x2 * q.x2 - q.y2 - q.z2; }

double mitre(const Q& q) { return q.y2 * (1.0 - q.y2 - q.z2) - 4.0 * q.x2 * q.square(); }

double nodal_cubic(const Q& q) { return 6.0 * q.y * q.z - cubed(q.y) - cubed(q.z); }

double ovals_of_cassini(const Q& q) {
  const double s = squared(q.p[1]);
  return q.p[3] * s * q.ring2() + squared(q.p[2]) - squared(q.square() + s);
}

double paraboloid(const Q& q) { return q.y - q.ring2(); }

double pillow(const Q& q) { return q.x2 * q.x2 + q.y2 * q.y2 + q.z2 * q.z2 - q.square(); }

double piriform(const Q& q) { return -(q.x2 * (q.x - q.x2) - q.y2 - q.z2); }

double quartic_paraboloid(const Q& q) { return q.y - q.x2 * q.x2 - q.z2 * q.z2; }

double quartic_saddle(const Q& q) { return q.y - q.x2 * q.x2 + q.z2 * q.z2; }

double quartic_cylinder(const Q& q) {
  const double s = squared(q.p[2]);
  return s * squared(q.p[1]) - q.ring2() * (q.y2 + s);
}

double steiners_roman(const Q& q) {
  return -(q.x2 * q.y2 + q.x2 * q.z2 + q.y2 * q.z2 + q.x * q.y * q.z);
}

double strophoid(const Q& q) {
  return squared(q.p[3]) * q.x2 * (q.p[1] + q.x) - (q.p[2] - q.x) * (q.y2 + q.z2);
}

double torus_gumdrop(const Q& q) {
  const double s = q.y2 + q.z2;
  return 20.0 * q.square() - 4.0 * (q.x2 * q.x2 + s * s) - 17.0 * q.x2 * s - 17.0;
}

double umbrella(const Q& q) { return q.y * q.z2 - q.x2; }

double witch_of_agnesi(const Q& q) { return q.p[1] * (1.0 - q.y) - q.ring2() * q.y; }

template <PointFormula kValue>
constexpr auto kField = at_point<limited<kValue>>;

constexpr InternalFormula kFormulas[] = {
    {"f_bicorn", 4, 2, kField<bicorn>},
    {"f_bifolia", 5, 2, kField<bifolia>},
    {"f_boy_surface", 8, 2, kField<boy_surface>},
    {"f_crossed_trough", 11, 1, kField<crossed_trough>},
    {"f_cubic_saddle", 12, 1, kField<cubic_saddle>},
    {"f_cushion", 13, 1, kField<cushion>},
    {"f_devils_curve", 14, 1, kField<devils_curve>},
    {"f_dupin_cyclid", 16, 6, kField<dupin_cyclid>},
    {"f_enneper", 18, 1, kField<enneper>},
    {"f_folium_surface", 20, 3, kField<folium_surface>},
    {"f_glob", 22, 1, kField<glob>},
    {"f_heart", 23, 1, kField<heart>},
    {"f_hunt_surface", 30, 1, kField<hunt_surface>},
    {"f_hyperbolic_torus", 31, 3, kField<hyperbolic_torus>},
    {"f_kampyle_of_eudoxus", 33, 3, kField<kampyle_of_eudoxus>},
    {"f_klein_bottle", 35, 1, kField<klein_bottle>},
    {"f_kummer_surface_v1", 36, 1, kField<kummer_surface_v1>},
    {"f_kummer_surface_v2", 37, 4, kField<kummer_surface_v2>},
    {"f_lemniscate_of_gerono", 38, 1, kField<lemniscate_of_gerono>},
    {"f_mitre", 41, 1, kField<mitre>},
    {"f_nodal_cubic", 42, 1, kField<nodal_cubic>},
    {"f_odd", 43, 1, kField<cushion>},
    {"f_ovals_of_cassini", 44, 4, kField<ovals_of_cassini>},
    {"f_parabolic_torus", 46, 3, kField<parabolic_torus>},
    {"f_paraboloid", 45, 1, kField<paraboloid>},
    {"f_pillow", 48, 1, kField<pillow>},
    {"f_piriform", 49, 1, kField<piriform>},
    {"f_quartic_cylinder", 56, 3, kField<quartic_cylinder>},
    {"f_quartic_paraboloid", 54, 1, kField<quartic_paraboloid>},
    {"f_quartic_saddle", 55, 1, kField<quartic_saddle>},
    {"f_steiners_roman", 65, 1, kField<steiners_roman>},
    {"f_strophoid", 66, 4, kField<strophoid>},
    {"f_torus2", 71, 3, kField<torus2>},
    {"f_torus_gumdrop", 72, 1, kField<torus_gumdrop>},
    {"f_umbrella", 73, 1, kField<umbrella>},
    {"f_witch_of_agnesi", 74, 2, kField<witch_of_agnesi>}};

}  // namespace

std::span<const InternalFormula> algebraic_formulas() { return kFormulas; }

}  // namespace lentray::core
