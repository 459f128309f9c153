#include "core/function/internal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/pattern/noise.h"

namespace lentray::core {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kDegree = std::numbers::pi / 180.0;

using Evaluator = double (*)(const double* a);  // x, y, z, P0, P1 ...

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

// Several surfaces are held within +-10 times their field strength.
double limited(double value) { return std::clamp(value, -10.0, 10.0); }

double paraboloid(const double* a) {
  return limited(a[3] * (a[1] - a[0] * a[0] - a[2] * a[2]));
}

double pillow(const double* a) {
  const double x2 = a[0] * a[0], y2 = a[1] * a[1], z2 = a[2] * a[2];
  return limited(a[3] * (x2 * x2 + y2 * y2 + z2 * z2 - (x2 + y2 + z2)));
}

// The distance of a cross section: circle, diamond, rounded square, square as `shape` says.
double cross_section(double u, double v, double shape, double exponent_scale) {
  if (shape == 1.0) return std::sqrt(u * u + v * v);
  if (shape == 0.0) return std::max(std::fabs(u), std::fabs(v));
  const double p = 2.0 / shape;
  return std::pow(std::pow(std::fabs(u), p) + std::pow(std::fabs(v), p), exponent_scale * shape);
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
  return std::min(major + r, cross_section(u, v, a[8], 0.5)) - minor;
}

double spiral(const double* a) {
  const double x = a[0] == 0.0 && a[2] == 0.0 ? 1e-6 : a[0];
  const double turn = std::atan2(a[2], x);
  const double r = std::sqrt(a[0] * a[0] + a[2] * a[2]) + a[3] * turn / kTwoPi;
  const double within = std::fmod(r, a[3]) - a[3] * 0.5;
  const double thickness = cross_section(within, a[1], a[8], 0.5);
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

// Noise -----------------------------------------------------------------------------------------

int generator_of(double number) {
  const int generator = static_cast<int>(number) & 3;
  return generator == 0 ? 1 : generator;
}

// Without a number: what #version 3.5 and later have by default.
double noise3d(const double* a) { return noise({a[0], a[1], a[2]}, 2); }
double noise_of_generator(const double* a) {
  return noise({a[0], a[1], a[2]}, generator_of(a[3]));
}

double swing(const Vec3& p, int generator) { return noise(p, generator) * 2.0 - 1.0; }

// P0: H, P1: lacunarity, P2: octaves, P3: offset, P4: gain (of ridged) or mixing, P5: generator.
double ridged_multifractal(const double* a) {
  const int generator = generator_of(a[8]);
  const auto ridge = [&](const Vec3& p) {
    const double height = a[6] - std::fabs(swing(p, generator));
    return height * height;
  };
  Vec3 p{a[0], a[1], a[2]};
  const double fading = std::pow(a[4], -a[3]);
  double signal = ridge(p), result = signal, share = 1.0;
  for (int octave = 1; octave < a[5]; ++octave) {
    p *= a[4];
    share *= fading;
    signal = ridge(p) * std::clamp(signal * a[7], 0.0, 1.0);
    result += signal * share;
  }
  return result;
}

double hetero_multifractal(const double* a) {
  const int generator = generator_of(a[8]);
  Vec3 p{a[0], a[1], a[2]};
  const double fading = std::pow(a[4], -a[3]);
  double signal = swing(p, generator) + a[6], share = fading;
  p *= a[4];
  for (int octave = 1; octave < a[5]; ++octave) {
    double step = (swing(p, generator) + a[6]) * share;
    for (int i = static_cast<int>(a[7]); i > 0; --i) step *= signal;
    signal += step;
    p *= a[4];
    share *= fading;
  }
  const double rest = a[5] - static_cast<int>(a[5]);
  return rest == 0.0 ? signal : signal + rest * (swing(p, generator) + a[6]) * share * signal;
}

// P0: lambda, P1: octaves, P2: omega, P3: offset, P4: ridge, P5: generator.
double ridge(const double* a) {
  const int generator = generator_of(a[8]), octaves = static_cast<int>(a[4]);
  const Vec3 p{a[0], a[1], a[2]};
  const double offset = a[6], crest = a[7], scale = 1.0 / std::max(crest, 1.0 - crest);
  const auto height = [&](double frequency) {
    return std::fabs(noise(p * frequency, generator) - crest) * scale - offset;
  };
  double value = height(1.0), total = 1.0, frequency = a[3], share = a[5];
  for (int octave = 2; octave <= octaves; ++octave) {
    value += share * height(frequency);
    total += share;
    frequency *= a[3];
    share *= a[5];
  }
  const double rest = a[4] - octaves;
  if (rest != 0.0) {
    value += share * height(frequency) * rest;
    total += share * rest;
  }
  return value / (std::max(offset, 1.0 - offset) * total);
}

struct Entry {
  const char* name;
  int extra;  // parameters beside x, y, z
  Evaluator evaluator = nullptr;
};

constexpr Entry kEntries[] = {
    {"f_algbr_cyl1", 5}, {"f_algbr_cyl2", 5}, {"f_algbr_cyl3", 5}, {"f_algbr_cyl4", 5},
    {"f_bicorn", 2}, {"f_bifolia", 2}, {"f_blob", 5}, {"f_blob2", 4}, {"f_boy_surface", 2},
    {"f_comma", 1}, {"f_cross_ellipsoids", 4}, {"f_crossed_trough", 1}, {"f_cubic_saddle", 1},
    {"f_cushion", 1}, {"f_devils_curve", 1}, {"f_devils_curve_2d", 6}, {"f_dupin_cyclid", 6},
    {"f_ellipsoid", 3, ellipsoid}, {"f_enneper", 1}, {"f_flange_cover", 4},
    {"f_folium_surface", 3}, {"f_folium_surface_2d", 6}, {"f_glob", 1}, {"f_heart", 1},
    {"f_helical_torus", 10}, {"f_helix1", 7, helix1}, {"f_helix2", 7}, {"f_hex_x", 1, hex_x},
    {"f_hex_y", 1, hex_y}, {"f_hetero_mf", 6, hetero_multifractal}, {"f_hunt_surface", 1}, {"f_hyperbolic_torus", 3},
    {"f_isect_ellipsoids", 4}, {"f_kampyle_of_eudoxus", 3}, {"f_kampyle_of_eudoxus_2d", 6},
    {"f_klein_bottle", 1}, {"f_kummer_surface_v1", 1}, {"f_kummer_surface_v2", 4},
    {"f_lemniscate_of_gerono", 1}, {"f_lemniscate_of_gerono_2d", 6}, {"f_mesh1", 5},
    {"f_mitre", 1}, {"f_nodal_cubic", 1}, {"f_odd", 1}, {"f_ovals_of_cassini", 4},
    {"f_paraboloid", 1, paraboloid}, {"f_parabolic_torus", 3}, {"f_ph", 0, latitude},
    {"f_pillow", 1, pillow}, {"f_piriform", 1}, {"f_piriform_2d", 7}, {"f_poly4", 5},
    {"f_polytubes", 6}, {"f_quantum", 1}, {"f_quartic_paraboloid", 1}, {"f_quartic_saddle", 1},
    {"f_quartic_cylinder", 3}, {"f_r", 0, distance}, {"f_ridge", 6, ridge}, {"f_ridged_mf", 6, ridged_multifractal},
    {"f_rounded_box", 4, rounded_box}, {"f_sphere", 1, sphere}, {"f_spikes", 5},
    {"f_spikes_2d", 4}, {"f_spiral", 6, spiral}, {"f_steiners_roman", 1}, {"f_strophoid", 4},
    {"f_strophoid_2d", 7}, {"f_superellipsoid", 2, superellipsoid}, {"f_th", 0, longitude},
    {"f_torus", 2, torus}, {"f_torus2", 3}, {"f_torus_gumdrop", 1}, {"f_umbrella", 1},
    {"f_witch_of_agnesi", 2}, {"f_witch_of_agnesi_2d", 6}, {"f_noise3d", 0, noise3d}, {"f_pattern", 0},
    {"f_noise_generator", 1, noise_of_generator},
};

class Internal final : public Function {
 public:
  explicit Internal(const Entry& entry) : m_entry(entry) {}
  std::size_t parameters() const override { return static_cast<std::size_t>(m_entry.extra) + 3; }
  double evaluate(std::span<const double> arguments) const override {
    return m_entry.evaluator ? m_entry.evaluator(arguments.data()) : 0.0;
  }
  std::string not_yet() const override { return m_entry.evaluator ? "" : m_entry.name; }

 private:
  const Entry& m_entry;
};

}  // namespace

std::shared_ptr<const Function> internal_function(int number) {
  if (number < 0 || number >= static_cast<int>(std::size(kEntries))) return nullptr;
  return std::make_shared<Internal>(kEntries[number]);
}

}  // namespace lentray::core
