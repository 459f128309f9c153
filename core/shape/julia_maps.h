// What a Julia set iterates, for make_julia_fractal(): each map answers whether a point's orbit
// stays within the sphere, how far a ray may walk from a point, and where the surface faces.
// Space: the shape's own; lengths of directions are 1.
// Source: reference manual 3.7, "Julia Fractal"; which power of the derivative is taken, and
// how steps are chosen, are stock's, measured by tests/image/julia_test.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/base/simd.h"
#include "core/numeric/complex_functions.h"
#include "core/shape/julia_fractal.h"

namespace lentray::core::julia {

/// The cut through the four dimensions and what all maps have.
struct Common {
  explicit Common(const JuliaSettings& s);

  double fourth(const Vec3& p) const {
    if (is_upright) return height;
    return (distance - slice[0] * p.x - slice[1] * p.y - slice[2] * p.z) / slice[3];
  }

  /// How much longer steps are in four dimensions, at most.
  double stretch() const {
    const double across = slice[0] * slice[0] + slice[1] * slice[1] + slice[2] * slice[2];
    return std::sqrt(1.0 + across / (slice[3] * slice[3]));
  }

  std::array<double, 4> c;      ///< parameter
  std::array<double, 4> slice;  ///< of length 1
  double distance;
  bool is_upright;  ///< the cut is at right angles to the fourth axis, at `height`
  double height;
  double least_step;
  int rounds;
  double radius;  ///< of the sphere that holds the set
  double escape;  ///< orbits whose squared length is beyond are lost
};

/// What rounding can add to the size of an orbit, generously.
inline constexpr double kLoose = 1.0 + 1e-9;
inline constexpr double kExpMore =
    0.7183;  ///< e^r - 1 is less than r and this times the square of r, up to 1
inline constexpr double kTolerance = 1e-7;  ///< how near surfaces are found, along the ray

inline Common::Common(const JuliaSettings& s)
    : c(s.parameter), slice(s.slice), distance(s.slice_distance), rounds(s.max_iteration) {
  const auto& n = s.slice;
  const double size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] + n[3] * n[3]);
  for (double& part : slice) part /= size;
  is_upright = n[0] == 0.0 && n[1] == 0.0 && n[2] == 0.0;
  height = distance / slice[3];
  least_step = std::max(1.0 / s.precision, kTolerance);
  radius = julia_sphere(c, s.hypercomplex);
  escape = s.hypercomplex ? radius * radius : radius * radius + kTolerance;
}

/// A number of four parts, or the change of one; of Pairs two of them.
template <class Part>
struct Quaternions {
  Part x, y, z, w;
};
using Quaternion = Quaternions<double>;

inline double size_squared(const Quaternion& q) {
  return q.x * q.x + (q.y * q.y + q.z * q.z + q.w * q.w);
}

/// q2 + c and its derivative; constant factors of the derivative are left out.
struct QuaternionSquare {
  static constexpr double kDegree = 2.0;
  /// Radius of a ball about what a ball of radius r about a number of that size is mapped to.
  static double grown(double size, double r) { return r * (2.0 * size + r); }
  template <class Part>
  static Quaternions<Part> next(const Quaternions<Part>& q, const Part& xx, const Part& rest,
                                const std::array<double, 4>& c) {
    const Part twice = 2.0 * q.x;
    return {xx - rest + c[0], twice * q.y + c[1], twice * q.z + c[2], twice * q.w + c[3]};
  }
  static void carry(const Quaternion& q, Quaternion& d) {
    d = {d.x * q.x - d.y * q.y - d.z * q.z - d.w * q.w, d.x * q.y + q.x * d.y,
         d.x * q.z + q.x * d.z, d.x * q.w + q.x * d.w};
  }
};

/// q3 + c
struct QuaternionCube {
  static constexpr double kDegree = 3.0;
  static double grown(double size, double r) { return r * (3.0 * size * (size + r) + r * r); }
  template <class Part>
  static Quaternions<Part> next(const Quaternions<Part>& q, const Part& xx, const Part& rest,
                                const std::array<double, 4>& c) {
    const Part side = 3.0 * xx - rest;
    return {q.x * (xx - 3.0 * rest) + c[0], q.y * side + c[1], q.z * side + c[2],
            q.w * side + c[3]};
  }
  static void carry(const Quaternion& q, Quaternion& d) {
    const double rest = q.y * q.y + q.z * q.z + q.w * q.w, xx = q.x * q.x;
    const double turn = 2.0 * (d.y * q.y + d.z * q.z + d.w * q.w);
    const double side = 3.0 * xx - rest, along = 6.0 * q.x * d.x - turn;
    d = {(d.x * (xx - rest) - q.x * turn) * 3.0, d.y * side + q.y * along, d.z * side + q.z * along,
         d.w * side + q.w * along};
  }
};

template <class Rule>
class QuaternionMap {
 public:
  static constexpr bool kRemembers = false, kThreeAtOnce = true, kForesees = false;
  struct Memory {
    explicit Memory(const QuaternionMap&) {}
  };

  explicit QuaternionMap(const JuliaSettings& s) : m_common(s) {}
  const Common& common() const { return m_common; }

  bool holds(const Vec3& p) const {
    Quaternion q = start(p);
    for (int i = 0; i < m_common.rounds; ++i) {
      const double rest = q.y * q.y + q.z * q.z + q.w * q.w, xx = q.x * q.x;
      if (rest + xx > m_common.escape) return false;
      q = Rule::next(q, xx, rest, m_common.c);
    }
    return true;
  }
  bool holds(const Vec3& p, Memory&) const { return holds(p); }

  /// holds() of three points. Each orbit waits for its last number: side by side they take little
  /// longer than one.
  std::array<bool, 3> hold(const std::array<Vec3, 3>& p) const {
    Quaternions<Pair> q[2];
    for (int i = 0; i < 2; ++i) {
      const Vec3 &a = p[i == 0 ? 0 : 2], &b = p[i == 0 ? 1 : 2];
      q[i] = {Pair{a.x, b.x}, Pair{a.y, b.y}, Pair{a.z, b.z},
              Pair{m_common.fourth(a), m_common.fourth(b)}};
    }
    PairBits lost[2] = {};
    for (int round = 0; round < m_common.rounds; ++round) {
      for (int i = 0; i < 2; ++i) {
        const Pair rest = q[i].y * q[i].y + q[i].z * q[i].z + q[i].w * q[i].w, xx = q[i].x * q[i].x;
        lost[i] |= rest + xx > m_common.escape;
        q[i] = Rule::next(q[i], xx, rest, m_common.c);
      }
      if (simd::signs(lost[0] & lost[1]) == 3) break;
    }
    const unsigned first = simd::signs(lost[0]), second = simd::signs(lost[1]);
    return {(first & 1) == 0, (first & 2) == 0, (second & 1) == 0};
  }

  /// As holds(); `step`: the least distance to the set. Of the product of the orbit, which divides
  /// it, only the length is wanted, and lengths of quaternions multiply.
  bool step(const Vec3& p, const Vec3&, double& step, Memory&) const {
    Quaternion q = start(p);
    double product = 1.0, power = 1.0 / Rule::kDegree;
    for (int i = 0; i < m_common.rounds; ++i) {
      const double rest = q.y * q.y + q.z * q.z + q.w * q.w, xx = q.x * q.x, size = rest + xx;
      if (size > m_common.escape) {
        step = power * std::log(size) / std::sqrt(product);
        return false;
      }
      product *= size;
      power *= 1.0 / Rule::kDegree;
      q = Rule::next(q, xx, rest, m_common.c);
    }
    step = m_common.least_step;
    return true;
  }

  /// Whether a ball can have a part in the set: its orbit, as a ball that grows with each round.
  bool may_hold(const Vec3& centre, double reach) const {
    Quaternion q = start(centre);
    double r = reach * m_common.stretch();
    for (int i = 0; i < m_common.rounds; ++i) {
      const double rest = q.y * q.y + q.z * q.z + q.w * q.w, xx = q.x * q.x;
      const double size = std::sqrt(rest + xx), least = size - r;
      if (least > 0.0 && least * least > m_common.escape * kLoose) return false;
      r = Rule::grown(size, r);
      q = Rule::next(q, xx, rest, m_common.c);
    }
    return true;
  }

  Vec3 gradient(const Vec3& p) const {
    Quaternion q = start(p), dx{1, 0, 0, 0}, dy{0, 1, 0, 0}, dz{0, 0, 1, 0};
    for (int i = 0; i < m_common.rounds; ++i) {
      const double rest = q.y * q.y + q.z * q.z + q.w * q.w, xx = q.x * q.x;
      if (rest + xx > m_common.escape) break;
      Rule::carry(q, dx);
      Rule::carry(q, dy);
      Rule::carry(q, dz);
      q = Rule::next(q, xx, rest, m_common.c);
    }
    const auto along = [&](const Quaternion& d) {
      return d.x * q.x + d.y * q.y + d.z * q.z + d.w * q.w;
    };
    return {along(dx), along(dy), along(dz)};
  }
  /// What a hit remembers of its surface: nothing, it is found again.
  Vec2 remembered(const Memory&) const { return {}; }
  Vec3 normal(const Vec3& p, const Vec2&) const { return gradient(p); }

 private:
  Quaternion start(const Vec3& p) const { return {p.x, p.y, p.z, m_common.fourth(p)}; }

  Common m_common;
};

/// A hypercomplex number <x, y, z, w> as the two complex numbers <x - w, y + z>, <x + w, y - z>
/// which its functions map one by one.
using Duplex = ComplexPair;

/// The first number of an orbit. Where a ray enters the sphere the last bit of its size decides
/// whether it starts inside the set, so the order of that sum matters.
struct DuplexStart {
  Duplex z;
  double size;
};

inline Duplex operator*(const Duplex& a, const Duplex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Duplex operator+(const Duplex& a, const Duplex& b) { return {a.re + b.re, a.im + b.im}; }
inline Duplex duplex(double x, double y, double z, double w) {
  return {Pair{x - w, x + w}, Pair{y + z, y - z}};
}
inline double size_squared(const Duplex& z) {
  const Pair squares = z.re * z.re + z.im * z.im;
  return 0.5 * (squares[0] + squares[1]);
}

inline DuplexStart start_at(const Common& common, const Vec3& p) {
  const double w = common.fourth(p);
  return {duplex(p.x, p.y, p.z, w), p.x * p.x + p.y * p.y + p.z * p.z + w * w};
}

/// f(z), and by what the product of the orbit grows there, which stands for the derivative.
template <bool kDoubles>
struct DuplexSquare {
  static constexpr bool kScaled = kDoubles;  ///< whether the product counts the factors 2
  explicit DuplexSquare(const JuliaSettings&) {}
  static DuplexStart start(const Common& common, const Vec3& p) {
    DuplexStart s = start_at(common, p);
    if (kDoubles) {
      const double w = common.fourth(p);
      s.size = (p.x * p.x + w * w) + (p.y * p.y + p.z * p.z);
    }
    return s;
  }
  Duplex value(const Duplex& z) const { return {z.re * z.re - z.im * z.im, 2.0 * (z.re * z.im)}; }
  static Duplex factor(const Duplex& z, const Duplex&) { return z; }
  /// As for quaternions, of both numbers; false where it is not known.
  static bool grow(const Pair& size, Pair& r) {
    r = r * (2.0 * size + r);
    return true;
  }
};

struct DuplexReciprocal {
  static constexpr bool kScaled = false;
  explicit DuplexReciprocal(const JuliaSettings&) {}
  static DuplexStart start(const Common& common, const Vec3& p) { return start_at(common, p); }
  Duplex value(const Duplex& z) const {
    const Pair inverse = 1.0 / (z.re * z.re + z.im * z.im);
    return {z.re * inverse, -z.im * inverse};
  }
  static Duplex factor(const Duplex&, const Duplex& value) {
    const Duplex square = value * value;
    return {-square.re, -square.im};
  }
  static bool grow(const Pair& size, Pair& r) {
    if (!(size[0] > r[0] && size[1] > r[1])) return false;  // the pole is in it
    r = r / (size * (size - r));
    return true;
  }
};

/// The product along an orbit, and where that ends.
struct Trail {
  Duplex product, last;
  int rounds = 0;
  double size = 0.0;  ///< of `last`, squared
  bool escaped = false;

  /// Slopes of half the size along x, y, z.
  Vec3 gradient() const {
    const Pair re = product.re * last.re + product.im * last.im;
    const Pair im = product.re * last.im - product.im * last.re;
    return {0.5 * (re[0] + re[1]), 0.5 * (im[0] + im[1]), 0.5 * (im[0] - im[1])};
  }
};

/// The step that a slope allows: no shorter than the least, no longer than 30 of them.
inline double step_by_slope(double size, double slope, double least) {
  constexpr double kFlat = 1e-8, kLongest = 30.0;
  if (!(slope < -kFlat)) return least;
  const double fall = -2.0 * slope;
  return size > least * fall && size < kLongest * least * fall ? size / fall : least;
}

/// 2^exponent, of which only large ones need the system.
inline double power_of_two(int exponent) {
  constexpr int kBias = 1023, kMantissaBits = 52;
  if (exponent > kBias) return std::ldexp(1.0, exponent);
  return std::bit_cast<double>(static_cast<std::uint64_t>(kBias + exponent) << kMantissaBits);
}

template <class Rule>
class HypercomplexMap {
 public:
  static constexpr bool kRemembers = false, kThreeAtOnce = false, kForesees = false;
  struct Memory {
    explicit Memory(const HypercomplexMap&) {}
  };

  explicit HypercomplexMap(const JuliaSettings& s)
      : m_common(s), m_rule(s),
        m_c(duplex(s.parameter[0], s.parameter[1], s.parameter[2], s.parameter[3])) {}
  const Common& common() const { return m_common; }

  bool holds(const Vec3& p) const {
    auto [z, size] = Rule::start(m_common, p);
    for (int i = 0; i < m_common.rounds; ++i) {
      if (size > m_common.escape) return false;
      z = m_rule.value(z) + m_c;
      size = size_squared(z);
    }
    return true;
  }
  bool holds(const Vec3& p, Memory&) const { return holds(p); }

  /// Whether a ball can have a part in the set: the orbits of both numbers, as discs that grow.
  bool may_hold(const Vec3& centre, double reach) const {
    Duplex z = Rule::start(m_common, centre).z;
    const double widest = std::sqrt(2.0) * reach * m_common.stretch();
    Pair r{widest, widest};
    for (int i = 0; i < m_common.rounds; ++i) {
      const Pair squares = z.re * z.re + z.im * z.im;
      const Pair size{std::sqrt(squares[0]), std::sqrt(squares[1])};
      const double a = std::max(0.0, size[0] - r[0]), b = std::max(0.0, size[1] - r[1]);
      if (0.5 * (a * a + b * b) > m_common.escape * kLoose) return false;
      if (!Rule::grow(size, r)) return true;
      z = m_rule.value(z) + m_c;
    }
    return true;
  }

  bool step(const Vec3& p, const Vec3& direction, double& step, Memory&) const {
    const Trail trail = follow(p);
    step = m_common.least_step;
    if (!trail.escaped) return true;
    double slope = dot(trail.gradient(), direction);
    if (Rule::kScaled) slope *= power_of_two(std::max(trail.rounds, 1));
    step = step_by_slope(trail.size, slope, m_common.least_step);
    return false;
  }
  Vec2 remembered(const Memory&) const { return {}; }
  Vec3 normal(const Vec3& p, const Vec2&) const { return follow(p).gradient(); }

 private:
  /// The first and the last number of the orbit have no factor of their own.
  Trail follow(const Vec3& p) const {
    const DuplexStart start = Rule::start(m_common, p);
    Trail t;
    t.product = t.last = start.z;
    t.size = start.size;
    for (; t.rounds < m_common.rounds; ++t.rounds) {
      t.escaped = t.size > m_common.escape;
      if (t.escaped) break;
      const Duplex value = m_rule.value(t.last);
      if (t.rounds > 0) t.product = t.product * Rule::factor(t.last, value);
      t.last = value + m_c;
      t.size = size_squared(t.last);
    }
    return t;
  }

  Common m_common;
  Rule m_rule;
  Duplex m_c;
};

/// Any other function of hypercomplex numbers. Two things are odd here, and scenes show them: the search
/// refines a hit with y in the place of z, and where that orbit is lost it takes the rest of the
/// last longer one for the normal, of which the function itself is the derivative. So the orbits are
/// kept, and a hit remembers its normal.
template <class F>
class FunctionMap {
 public:
  static constexpr bool kRemembers = true, kThreeAtOnce = false;
  /// Whether room() is known.
  static constexpr bool kForesees = requires(const Pair& size) { F::slope_squared(size); };
  /// The numbers of the last orbits, each over the start of those before.
  class Memory {
   public:
    explicit Memory(const FunctionMap& map) {
      if (map.m_common.rounds < kOwn) return;
      m_more.resize(static_cast<std::size_t>(map.m_common.rounds) + 1);
      m_orbit = m_more.data();
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    Duplex& operator[](int round) { return m_orbit[round]; }
    const Duplex& operator[](int round) const { return m_orbit[round]; }

   private:
    static constexpr int kOwn = 32;
    Duplex m_few[kOwn];
    std::vector<Duplex> m_more;
    Duplex* m_orbit = m_few;
  };

  FunctionMap(const JuliaSettings& s, F function)
      : m_common(s), m_function(function),
        m_c(duplex(s.parameter[0], s.parameter[1], s.parameter[2], s.parameter[3])) {}
  const Common& common() const { return m_common; }
  /// Not known: hits lie up to a step beyond the set.
  bool may_hold(const Vec3&, double) const { return true; }

  bool holds(const Vec3& p) const {
    auto [z, size] = start_at(m_common, {p.x, p.y, p.y});
    for (int i = 0; i < m_common.rounds; ++i) {
      if (size > m_common.escape) return false;
      z = value(z) + m_c;
      size = size_squared(z);
    }
    return true;
  }
  bool holds(const Vec3& p, Memory& orbit) const {
    double size;
    return escape({p.x, p.y, p.y}, orbit, size) == m_common.rounds;
  }
  bool step(const Vec3& p, const Vec3& direction, double& step, Memory& orbit) const {
    double size;
    const int rounds = escape(p, orbit, size);
    step = m_common.least_step;
    if (rounds == m_common.rounds) return true;
    const auto value_at = [&](int i) {
      return Duplex{orbit[i + 1].re - m_c.re, orbit[i + 1].im - m_c.im};
    };
    const double slope = dot(gradient(orbit, rounds, value_at), direction);
    step = step_by_slope(size, slope, m_common.least_step);
    return false;
  }
  /// Radius of a ball about a point within that is within too, of the point's orbit: the orbit of the ball,
  /// as discs that grow; about a number the function's slope grows no faster than the exponential. 0 where it
  /// would be less than `wanted`.
  double room(const Memory& orbit, double wanted) const {
    constexpr int kMost = 31;
    constexpr double kRounding = 1e-12;
    if (m_common.rounds > kMost) return 0.0;
    const double edge = std::sqrt(m_common.escape) / kLoose,
                 widest = std::sqrt(2.0) * m_common.stretch();
    double left[kMost], slope[kMost], growth = widest, least = edge / widest;
    for (int i = 0; i < m_common.rounds; ++i) {
      const Pair re = orbit[i + 1].re - m_c.re, im = orbit[i + 1].im - m_c.im;
      const Pair squares = F::slope_squared(re * re + im * im);
      slope[i] = std::sqrt(std::max(squares[0], squares[1]));
      left[i] = edge - std::sqrt(size_squared(orbit[i]));
      if (!(left[i] > wanted * growth)) return 0.0;
      least = std::min(least, left[i] / growth);
      growth *= slope[i];
    }
    const auto stays = [&](double reach) {
      double r = reach * widest;
      for (int i = 0; i < m_common.rounds; ++i) {
        r += kRounding;
        if (!(r < left[i] && r < 1.0)) return false;
        r = slope[i] * (r + kExpMore * r * r);
      }
      return true;
    };
    for (const double share : {0.7, 0.4}) {
      if (stays(share * least)) return share * least;
    }
    return 0.0;
  }
  /// The direction of the normal, as a point of the octahedron unfolded to a square.
  Vec2 remembered(const Memory& orbit) const {
    const Vec3 n = gradient(orbit, m_common.rounds, [&](int i) { return value(orbit[i]); });
    const double size = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
    if (!(size > 0.0) || !std::isfinite(size)) return {};
    const double u = n.x / size, v = n.y / size;
    if (n.z >= 0.0) return {u, v};
    return {std::copysign(1.0 - std::fabs(v), n.x), std::copysign(1.0 - std::fabs(u), n.y)};
  }
  Vec3 normal(const Vec3&, const Vec2& at) const {
    const double z = 1.0 - std::fabs(at.u) - std::fabs(at.v);
    if (z >= 0.0) return {at.u, at.v, z};
    return {std::copysign(1.0 - std::fabs(at.v), at.u), std::copysign(1.0 - std::fabs(at.u), at.v),
            z};
  }

 private:
  Duplex value(const Duplex& z) const {
    if constexpr (std::is_invocable_v<const F&, const Duplex&>)
      return m_function(z);
    else
      return of_each(z);
  }
  Duplex of_each(const Duplex& z) const {
    const Complex a = m_function({z.re[0], z.im[0]}), b = m_function({z.re[1], z.im[1]});
    return {Pair{a.re, b.re}, Pair{a.im, b.im}};
  }

  /// The number of rounds done before the orbit was lost, `size` its square there.
  int escape(const Vec3& p, Memory& orbit, double& size) const {
    const DuplexStart start = start_at(m_common, p);
    orbit[0] = start.z;
    size = start.size;
    for (int i = 0; i < m_common.rounds; ++i) {
      if (size > m_common.escape) return i;
      orbit[i + 1] = value(orbit[i]) + m_c;
      size = size_squared(orbit[i + 1]);
    }
    return m_common.rounds;
  }

  template <class ValueAt>
  Vec3 gradient(const Memory& orbit, int rounds, const ValueAt& value_at) const {
    Trail t;
    t.product = orbit[0];
    t.last = orbit[rounds];
    for (int i = 1; i < rounds; ++i) t.product = t.product * value_at(i);
    return t.gradient();
  }

  Common m_common;
  F m_function;
  Duplex m_c;
};

}  // namespace lentray::core::julia
