#include "core/shape/superellipsoid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/numeric/bounds_help.h"
#include "core/numeric/bracket.h"
#include "core/shape/crossings.h"

namespace lentray::core {
namespace {

/// (a^p + b^p)^(1/p) for a, b >= 0, without overflow.
double norm(double a, double b, double p) {
  const double high = std::max(a, b), low = std::min(a, b);
  if (high == 0.0 || low == 0.0) return high;
  return high * std::pow(1.0 + std::pow(low / high, p), 1.0 / p);
}

/// Where along the ray the surface may turn: the faces of the cube bound it, the planes of its
/// symmetry part it.
struct Stations {
  std::array<double, 12> t;
  int count = 0;
  void add(double p, double d, double lo, double hi) {
    if (d == 0.0) return;
    const double at = -p / d;
    if (at > lo && at < hi) t[count++] = at;
  }
};

/// The dual of the norm: the most that a x + b y is where norm(x, y, p) is 1.
double dual_norm(double a, double b, double p) {
  return p <= 1.0 ? std::max(a, b) : norm(a, b, p / (p - 1.0));
}

/// A little outside: what rounding and the roots' errors never reach.
constexpr double kOut = 1.0 + 1e-9;

/// Keeps the part of [lo, hi] in which |p + t d| <= half. Of a ray along the planes all is kept.
void clip_to_slab(double p, double d, double half, double& lo, double& hi) {
  const double inverse = 1.0 / d, middle = -p * inverse, reach = std::fabs(half * inverse);
  lo = std::max(lo, middle - reach);
  hi = std::min(hi, middle + reach);
}

/// The part of the ray within the cube; false if it misses.
bool clip_to_cube(const Ray& ray, double& lo, double& hi) {
  for (int axis = 0; axis < 3; ++axis) {
    const double p = ray.origin[axis], d = ray.direction[axis];
    if (d == 0.0) {
      if (std::fabs(p) > kOut) return false;
      continue;
    }
    const double a = (-kOut - p) / d, b = (kOut - p) / d;
    lo = std::max(lo, std::min(a, b));
    hi = std::min(hi, std::max(a, b));
  }
  return lo < hi;
}

/// The least of |f| that a search by golden section finds between two points where f > 0 (`sign` 1)
/// or f < 0 (-1); stops as soon as f changes its sign.
template <class Function>
double turning_point(const Function& f, double lo, double hi, double sign) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSteps = 40;
  double a = hi - kGolden * (hi - lo), b = lo + kGolden * (hi - lo);
  double fa = sign * f(a), fb = sign * f(b);
  for (int i = 0; i < kSteps && fa > 0.0 && fb > 0.0; ++i) {
    if (fa < fb) {
      hi = b;
      b = a;
      fb = fa;
      a = hi - kGolden * (hi - lo);
      fa = sign * f(a);
    } else {
      lo = a;
      a = b;
      fa = fb;
      b = lo + kGolden * (hi - lo);
      fb = sign * f(b);
    }
  }
  return fa < fb ? a : b;
}

}  // namespace

Superellipsoid::Superellipsoid(double e, double n)
    : m_round_xy(2.0 / e), m_round_z(2.0 / n), m_convex(e <= 2.0 && n <= 2.0) {
  const double xy = dual_norm(1.0, 1.0, m_round_xy), z = dual_norm(1.0, 1.0, m_round_z);
  m_half_of_two = {kOut * xy, kOut * z, kOut * z};
  m_half_of_three = kOut * dual_norm(xy, 1.0, m_round_z);
}

double Superellipsoid::value(const Vec3& p) const {
  return norm(norm(std::fabs(p.x), std::fabs(p.y), m_round_xy), std::fabs(p.z), m_round_z) - 1.0;
}

/// The dual norm; a concave one reaches as far as the octahedron of its corners.
Bounds Superellipsoid::box_in(const Transform& t) const {
  if (keeps_axes(t)) return transformed(bounds(), t);
  return support_bounds(t, [&](const Vec3& d) {
    return dual_norm(dual_norm(std::fabs(d.x), std::fabs(d.y), m_round_xy), std::fabs(d.z),
                     m_round_z);
  });
}

/// A value along the ray, and its derivative.
struct Superellipsoid::Sloped {
  double value, slope;

  static Sloped norm(const Sloped& a, const Sloped& b, double p) {
    const Sloped &high = a.value < b.value ? b : a, &low = a.value < b.value ? a : b;
    const double ratio = low.value / high.value;
    if (!(ratio > 0.0)) return high;
    // Half the price of pow, whose last digits are lost in the sums.
    const double share = std::exp(p * std::log(ratio)), sum = 1.0 + share;
    if (sum == 1.0) return high;
    const double root = std::exp(std::log(sum) / p);
    return {high.value * root, (high.slope + low.slope * (share / ratio)) * (root / sum)};
  }
};

/// value() at a point of the ray.
Superellipsoid::Sloped Superellipsoid::along(const Ray& ray, double t) const {
  const Vec3 p = ray.at(t), &d = ray.direction;
  const auto axis = [](double at, double by) { return Sloped{std::fabs(at), at < 0.0 ? -by : by}; };
  const Sloped across = Sloped::norm(axis(p.x, d.x), axis(p.y, d.y), m_round_xy);
  const Sloped whole = Sloped::norm(across, axis(p.z, d.z), m_round_z);
  return {whole.value - 1.0, whole.slope};
}

/// Where the ray enters a convex body on the way from `from`, outside, towards `to`; false if it
/// does not. Newton's steps on a convex function never pass the surface.
bool Superellipsoid::approach(const Ray& ray, double from, double to, double& t) const {
  constexpr int kMaxSteps = 100;
  constexpr double kClose = 4e-16;
  const double way = to - from;
  t = from;
  for (int i = 0; i < kMaxSteps; ++i) {
    const Sloped f = along(ray, t);
    if (!(f.value > 0.0)) return true;
    if (!(f.slope * way < 0.0)) return false;
    const double step = -f.value / f.slope;
    t += step;
    if (!((to - t) * way >= 0.0)) return false;
    if (std::fabs(step) <= kClose * std::fabs(way)) return true;
  }
  return true;
}

/// The part of the ray within the planes about a convex body; false if it misses.
bool Superellipsoid::clip(const Ray& ray, double& lo, double& hi) const {
  const Vec3 &p = ray.origin, &d = ray.direction;
  for (int i = 0; i < 3; ++i) clip_to_slab(p[i], d[i], kOut, lo, hi);
  if (!(lo < hi)) return false;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const double half = m_half_of_two[static_cast<std::size_t>(i)];
    clip_to_slab(p[i] + p[j], d[i] + d[j], half, lo, hi);
    clip_to_slab(p[i] - p[j], d[i] - d[j], half, lo, hi);
  }
  if (!(lo < hi)) return false;
  const double half = m_half_of_three;
  clip_to_slab(p.x + p.y + p.z, d.x + d.y + d.z, half, lo, hi);
  clip_to_slab(p.x + p.y - p.z, d.x + d.y - d.z, half, lo, hi);
  clip_to_slab(p.x - p.y + p.z, d.x - d.y + d.z, half, lo, hi);
  clip_to_slab(p.x - p.y - p.z, d.x - d.y - d.z, half, lo, hi);
  return lo < hi && std::isfinite(lo) && std::isfinite(hi);
}

/// The same from both ends of what the planes leave of the ray, counted from its middle, so that far
/// origins do not cost digits. A convex function lies above its tangents: those at the ray's start
/// and at the middle turn most rays away. `kAnywhere`: any t beyond the first crossing does for it.
template <bool kAnywhere, class Visit>
void Superellipsoid::convex_crossings(const Ray& ray, double t_min, double t_max,
                                      Visit&& visit) const {
  constexpr double kSure = 1e-12, kFar = 1e4;
  double lo = -Bounds::kInf, hi = Bounds::kInf;
  if (!clip(ray, lo, hi) || hi <= t_min || lo >= t_max) return;
  const double middle = 0.5 * (lo + hi), start = t_min - middle;
  const Ray near{ray.at(middle), ray.direction};
  const bool far = std::fabs(middle) > kFar * (hi - lo);
  lo = far ? -Bounds::kInf : lo - middle;
  hi = far ? Bounds::kInf : hi - middle;
  if (far && !clip(near, lo, hi)) return;
  bool starts_inside = false;
  if (start > lo && start < hi) {
    const Sloped f = along(near, start);
    if (f.value > kSure && f.slope >= 0.0) return;
    starts_inside = f.value < -kSure;
  }
  double in, out;
  if (!starts_inside) {
    const Sloped f = along(near, 0.0);
    if (f.value > kSure) {
      const double tangent = -f.value / f.slope;
      if (!(tangent > lo && tangent < hi)) return;
      (f.slope < 0.0 ? lo : hi) = tangent;
    } else if (kAnywhere && f.value < -kSure && start <= lo && middle > t_min && middle < t_max) {
      visit(middle);
      return;
    }
    if (!approach(near, lo, hi, in)) return;
    if (!visit(middle + in)) return;
  }
  // Where rounding says that it leaves nowhere it leaves there.
  if (approach(near, hi, lo, out)) {
    visit(middle + out);
  } else if (!starts_inside) {
    visit(middle + in);
  }
}

template <bool kAnywhere, class Visit>
void Superellipsoid::crossings(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  if (m_convex) return convex_crossings<kAnywhere>(ray, t_min, t_max, visit);
  double lo = -Bounds::kInf, hi = Bounds::kInf;
  if (!clip_to_cube(ray, lo, hi) || hi <= t_min || lo >= t_max) return;
  Stations stations;
  stations.t[stations.count++] = lo;
  const Vec3 &p = ray.origin, &d = ray.direction;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    stations.add(p[i], d[i], lo, hi);
    stations.add(p[i] - p[j], d[i] - d[j], lo, hi);
    stations.add(p[i] + p[j], d[i] + d[j], lo, hi);
  }
  std::sort(stations.t.begin() + 1, stations.t.begin() + stations.count);
  stations.t[stations.count++] = hi;
  const auto f = [&](double t) { return value(ray.at(t)); };
  std::array<double, 12> values;
  for (int i = 0; i < stations.count; ++i) values[i] = f(stations.t[i]);
  for (int i = 0; i + 1 < stations.count; ++i) {
    const double a = stations.t[i], fa = values[i], b = stations.t[i + 1], fb = values[i + 1];
    if ((fa > 0.0) != (fb > 0.0)) {
      if (!visit(bracketed_root(f, a, fa, b, fb))) return;
      continue;
    }
    if (fa != 0.0 && b > a) {
      const double m = turning_point(f, a, b, fa > 0.0 ? 1.0 : -1.0), fm = f(m);
      if ((fm > 0.0) != (fa > 0.0)) {
        if (!visit(bracketed_root(f, a, fa, m, fm))) return;
        if (!visit(bracketed_root(f, m, fm, b, fb))) return;
      }
    }
  }
}

bool Superellipsoid::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  return first_of_ordered(*this, ray, t_min, t_max, hit);
}

bool Superellipsoid::any(const Ray& ray, double t_min, double t_max) const {
  bool found = false;
  crossings<true>(ray, t_min, t_max, [&](double t) {
    found = t > t_min && t < t_max;
    return !(t > t_min);
  });
  return found;
}

void Superellipsoid::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  append_ordered(*this, ray, t_min, t_max, hits);
}

bool Superellipsoid::within(const Vec3& p) const {
  constexpr double kSlack = 1e-10;
  return value(p) < kSlack;
}

Vec3 Superellipsoid::normal(const Vec3& p, const ShapeHit&) const {
  const double x = std::fabs(p.x), y = std::fabs(p.y), z = std::fabs(p.z);
  const double across = norm(x, y, m_round_xy);
  if (across == 0.0) return {0, 0, p.z < 0.0 ? -1.0 : 1.0};
  // Of the norm, but for a common factor: d/dx = (across/whole)^(q-1) (x/across)^(p-1).
  const double high = std::max(across, z);
  const double slope = std::pow(across / high, m_round_z - 1.0);
  const Vec3 n{slope * std::pow(x / across, m_round_xy - 1.0),
               slope * std::pow(y / across, m_round_xy - 1.0), std::pow(z / high, m_round_z - 1.0)};
  // Edges sharper than a cone's have no slope there.
  const auto safe = [](double v) { return std::isfinite(v) ? v : 1e10; };
  return {std::copysign(safe(n.x), p.x), std::copysign(safe(n.y), p.y),
          std::copysign(safe(n.z), p.z)};
}

}  // namespace lentray::core
