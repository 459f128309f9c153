#include <array>

#include "core/function/internal_formulas.h"

namespace lentray::core {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180.0;

double radius(double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }

double sphere(const double* a) { return radius(a[0], a[1], a[2]) - a[3]; }
double distance(const double* a) { return radius(a[0], a[1], a[2]); }
double longitude(const double* a) { return std::atan2(a[0], a[2]); }
double latitude(const double* a) { return std::atan2(std::sqrt(a[0] * a[0] + a[2] * a[2]), a[1]); }

double ellipsoid(const double* a) { return radius(a[0] * a[3], a[1] * a[4], a[2] * a[5]); }

double torus(const double* a) {
  const double ring = std::sqrt(a[0] * a[0] + a[2] * a[2]) - a[3];
  return std::sqrt(ring * ring + a[1] * a[1]) - a[4];
}

double superellipsoid(const double* a) {
  const double p = 2.0 / a[3], n = 1.0 / a[4];
  const double plane = std::pow(std::fabs(a[0]), p) + std::pow(std::fabs(a[1]), p);
  return 1.0 - std::pow(std::pow(plane, a[3] * n) + std::pow(std::fabs(a[2]), 2.0 * n), a[4] * 0.5);
}

// How far outside the inner box whose edges are rounded by P0.
double rounded_box(const double* a) {
  const auto outside = [&](double x, double half) {
    const double inner = half - a[3];
    const double above = x < inner ? 0.0 : x - inner;
    const double below = x > -inner ? 0.0 : -inner - x;
    return std::max(above, below);
  };
  return radius(outside(a[0], a[4]), outside(a[1], a[5]), outside(a[2], a[6])) - a[3] - 1e-6;
}

// The distance of a cross section: circle, diamond, rounded square, square as `shape` says.
double cross_section(double u, double v, double shape) {
  if (shape == 1.0) return std::sqrt(u * u + v * v);
  if (shape == 0.0) return std::max(std::fabs(u), std::fabs(v));
  const double p = 2.0 / shape;
  return std::pow(std::pow(std::fabs(u), p) + std::pow(std::fabs(v), p), 0.5 * shape);
}

double helix1(const double* a) {
  const double strands = a[3], turns = a[4], minor = a[5], major = a[6];
  const double r = std::sqrt(a[0] * a[0] + a[2] * a[2]);
  const double x = a[0] == 0.0 && a[2] == 0.0 ? 1e-6 : a[0];
  double angle = std::fmod(std::atan2(a[2], x) * strands + a[1] * turns * strands, kTwoPi);
  if (angle < 0.0) angle += kTwoPi;
  double v = (angle - std::numbers::pi) / a[7] / (turns * strands);
  double u = r - major;
  if (a[8] != 1.0 && a[9] != 0.0) {
    const double c = std::cos(a[9] * kDegree), s = std::sin(a[9] * kDegree);
    const double turned = u * c - v * s;
    v = u * s + v * c;
    u = turned;
  }
  return std::min(major + r, cross_section(u, v, a[8])) - minor;
}

double spiral(const double* a) {
  const double x = a[0] == 0.0 && a[2] == 0.0 ? 1e-6 : a[0];
  const double turn = std::atan2(a[2], x);
  const double r = std::sqrt(a[0] * a[0] + a[2] * a[2]) + a[3] * turn / kTwoPi;
  const double within = std::fmod(r, a[3]) - a[3] * 0.5;
  const double thickness = cross_section(within, a[1], a[8]);
  const double whole = radius(x, a[1], a[2]);
  return -std::min(a[5] - whole, a[4] - std::min(thickness, whole));
}

// The nearest point of a hexagonal lattice, folded into one sixth.
void hexagon(const double* a, double& u, double& v) {
  const double half = std::sqrt(3.0) / 2.0;
  u = std::fabs(std::fmod(std::fabs(a[0]), 2.0 * half) - half);
  v = std::fabs(std::fmod(std::fabs(a[1]), 3.0) - 1.5);
  const double u2 = half - u, v2 = 1.5 - v;
  if (u * u + v * v > u2 * u2 + v2 * v2) {
    u = u2;
    v = v2;
  }
}

double hex_x(const double* a) {
  double u = 0.0, v = 0.0;
  hexagon(a, u, v);
  if (std::atan2(v, u) < std::numbers::pi / 6.0) return u;
  return std::cos(std::numbers::pi / 3.0) * u + std::sin(std::numbers::pi / 3.0) * v;
}

double hex_y(const double* a) {
  double u = 0.0, v = 0.0;
  hexagon(a, u, v);
  if (std::atan2(v, u) < std::numbers::pi / 6.0) return v;
  return std::fabs(std::cos(std::numbers::pi / 3.0) * v - std::sin(std::numbers::pi / 3.0) * u);
}

// A screw of its own axis: P1 turns, P2 and P3 minor and major radius, P5 cross section.
double helix2(const FormulaPoint& q) {
  const double c = std::cos(q.y * q.p[1]), s = std::sin(q.y * q.p[1]);
  const double x = q.x - q.p[3] * c, z = q.z - q.p[3] * s;
  return cross_section(x * c + z * s, z * c - x * s, q.p[5]) - q.p[2];
}

double helical_torus(const FormulaPoint& q) {
  const double major = q.p[0], hole = q.p[5], ring = q.ring();
  const double x = q.x == 0.0 && q.z == 0.0 ? 1e-6 : q.x;
  const double around = std::atan2(x, q.z);
  const double from_tube = std::hypot(ring - major, q.y);
  double turn = std::fmod(around * q.p[1] + std::atan2(ring - major, q.y) * q.p[2], kTwoPi);
  if (turn < 0.0) turn += kTwoPi;
  turn -= std::numbers::pi;
  const double groove = std::atan2(turn * q.p[8], from_tube - hole);
  const double width = std::cos(groove * q.p[7] + around * q.p[9]) * q.p[3] + q.p[4];
  const double strand = std::sqrt(squared(from_tube - hole) + turn * turn * q.p[6]);
  return -std::max(q.p[4] + hole - major - ring, width - std::min(strand, from_tube + hole));
}

double blob(const FormulaPoint& q) {
  const auto ball = [&](double centre, double strength, double inverse_radius) {
    const double d2 = (squared(q.x - centre) + q.y2 + q.z2) * squared(inverse_radius);
    return strength * squared(1.0 - std::min(d2, 1.0));
  };
  const double half = q.p[0] * 0.5;
  return -(ball(-half, q.p[1], q.p[2]) + ball(half, q.p[3], q.p[4]));
}

double blob2(const FormulaPoint& q) {
  const double far2 = squared(q.x - q.p[0]) + q.y2 + q.z2;
  return q.p[3] - q.p[2] * (std::exp(-q.square() * q.p[1]) + std::exp(-far2 * q.p[1]));
}

double comma(const FormulaPoint& q) {
  const double size = q.p[0], x = q.x == 0.0 && q.z == 0.0 ? 1e-4 : q.x;
  const double from_tail = std::hypot(x + size * 0.25, q.z);
  const double width = std::cos(std::atan2(q.z, x) * 0.5) * size * 0.5;
  const double tail = std::min(q.z, width - std::sqrt(squared(from_tail - size * 0.75) + q.y2));
  const double head = size * 0.5 - std::sqrt(squared(x - size * 0.5) + q.y2 + q.z2);
  return -std::max(tail, head);
}

// Three ellipsoids across each other: the densities along x, y and z, P0 flat and P1 sharp.
std::array<double, 3> ellipsoid_densities(const FormulaPoint& q) {
  const auto density = [&](double along, double across) {
    return std::exp(-(across * q.p[0] + along) * q.p[1]);
  };
  return {density(q.x2, q.y2 + q.z2), density(q.y2, q.x2 + q.z2), density(q.z2, q.x2 + q.y2)};
}

double cross_ellipsoids(const FormulaPoint& q) {
  const auto e = ellipsoid_densities(q);
  return q.p[3] - q.p[2] * std::max({e[0], e[1], e[2]});
}

double isect_ellipsoids(const FormulaPoint& q) {
  const auto e = ellipsoid_densities(q);
  return q.p[3] - q.p[2] * std::min({e[0], e[1], e[2]});
}

double flange_cover(const FormulaPoint& q) {
  const auto e = ellipsoid_densities(q);
  return q.p[3] - q.p[2] * (e[0] + e[1] + e[2]);
}

double spikes(const FormulaPoint& q) {
  const auto e = ellipsoid_densities(q);
  return q.p[2] * (e[0] + e[1] + e[2] - std::exp(-q.square() * q.p[3]) * q.p[4]);
}

double spikes_2d(const FormulaPoint& q) {
  return q.y -
         q.p[0] * std::cos(q.p[1] * q.x) * std::cos(q.p[2] * q.z) * std::exp(-q.p[3] * q.ring2());
}

// Woven threads: P0 and P1 their distances along x and z, P2 width, P3 wave height, P4 thickness.
double mesh1(const FormulaPoint& q) {
  const auto thread = [&](double across, double distance, double height) {
    double d = std::fmod(across, 2.0 * distance);
    if (d < 0.0) d += 2.0 * distance;
    return std::hypot(std::fabs(d - distance) * q.p[2], (q.y - height) * q.p[4]);
  };
  const double wave_z = std::cos(q.z * std::numbers::pi / q.p[1]) * q.p[3];
  const double wave_x = std::cos(q.x * std::numbers::pi / q.p[0]) * q.p[3];
  return std::min({thread(q.x, q.p[0], wave_z), thread(q.x - q.p[0], q.p[0], -wave_z),
                   thread(q.z, q.p[1], -wave_x), thread(q.z - q.p[1], q.p[1], wave_x)});
}

double polynomial4(const double* c, double y) {
  return c[0] + y * (c[1] + y * (c[2] + y * (c[3] + y * c[4])));
}

double poly4(const FormulaPoint& q) { return q.ring() - std::max(polynomial4(q.p, q.y), -5.0); }

double polytubes(const FormulaPoint& q) {
  const double out = polynomial4(q.p + 1, q.y);
  constexpr double kMostTubes = 1e6;  // and a number that is none makes none
  const int tubes = q.p[0] > 0.0 ? static_cast<int>(std::min(q.p[0], kMostTubes)) : 0;
  double nearest = 10000.0;
  for (int i = 0; i < tubes; ++i) {
    const double angle = kTwoPi / q.p[0] * i;
    nearest =
        std::min(nearest, std::hypot(q.x - out * std::sin(angle), q.z - out * std::cos(angle)));
  }
  return nearest;
}

// An orbital of the hydrogen atom.
double quantum(const FormulaPoint& q) {
  const double ring = q.x == 0.0 && q.z == 0.0 ? 1e-6 : q.ring();
  const double c = std::cos(std::atan2(ring, q.y)), r = 2.0 * std::hypot(ring, q.y);
  const double wave = r * r * std::exp(-r * 0.33333333) * (3.0 * c * c - 1.0);
  return 0.1 * (12.0 - wave * wave);
}

constexpr InternalFormula kFormulas[] = {{"f_ellipsoid", 17, 3, ellipsoid},
                                         {"f_helix1", 25, 7, helix1},
                                         {"f_hex_x", 27, 1, hex_x},
                                         {"f_hex_y", 28, 1, hex_y},
                                         {"f_ph", 47, 0, latitude},
                                         {"f_r", 57, 0, distance},
                                         {"f_rounded_box", 60, 4, rounded_box},
                                         {"f_sphere", 61, 1, sphere},
                                         {"f_spiral", 64, 6, spiral},
                                         {"f_superellipsoid", 68, 2, superellipsoid},
                                         {"f_th", 69, 0, longitude},
                                         {"f_torus", 70, 2, torus},
                                         {"f_helix2", 26, 7, at_point<helix2>},
                                         {"f_helical_torus", 24, 10, at_point<helical_torus>},
                                         {"f_blob", 6, 5, at_point<blob>},
                                         {"f_blob2", 7, 4, at_point<blob2>},
                                         {"f_comma", 9, 1, at_point<comma>},
                                         {"f_cross_ellipsoids", 10, 4, at_point<cross_ellipsoids>},
                                         {"f_isect_ellipsoids", 32, 4, at_point<isect_ellipsoids>},
                                         {"f_flange_cover", 19, 4, at_point<flange_cover>},
                                         {"f_spikes", 62, 5, at_point<spikes>},
                                         {"f_spikes_2d", 63, 4, at_point<spikes_2d>},
                                         {"f_mesh1", 40, 5, at_point<mesh1>},
                                         {"f_poly4", 51, 5, at_point<poly4>},
                                         {"f_polytubes", 52, 6, at_point<polytubes>},
                                         {"f_quantum", 53, 1, at_point<quantum>}};

}  // namespace

std::span<const InternalFormula> solid_formulas() { return kFormulas; }

}  // namespace lentray::core
