#include "core/shape/julia_fractal.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "core/numeric/bounds_help.h"
#include "core/numeric/box_ray.h"
#include "core/shape/julia_maps.h"

namespace lentray::core {
namespace {

using julia::kTolerance;

/// The part of a ray of unit direction in the sphere around the origin; false if it misses.
bool through_sphere(const Vec3& from, const Vec3& direction, double radius, double& in,
                    double& out) {
  constexpr double kNone = 1e-10;
  const double distance = dot(from, from), nearest = -dot(from, direction);
  if (distance >= radius * radius && nearest < kNone) return false;
  const double chord = radius * radius - distance + nearest * nearest;
  if (!(chord > kNone)) return false;
  in = nearest - std::sqrt(chord);
  out = nearest + std::sqrt(chord);
  return true;
}

template <class Map>
class JuliaFractal final : public Shape {
 public:
  explicit JuliaFractal(Map map) : m_map(std::move(map)), m_box(box_in(Transform())) {}
  JuliaFractal(Map map, const Bounds& box) : m_map(std::move(map)), m_box(box) {}

  /// Where y stands for z the solid has no end along z.
  ShapeTraits traits() const override {
    return {.name = "julia_fractal", .solid_is_unbounded = Map::kRemembers, .tells_all = false};
  }
  Bounds box(const Transform* move) const override { return move ? box_in(*move) : m_box; }
  bool nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const override;
  void all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const override;
  bool any(const Ray& ray, double t_min, double t_max) const override;
  bool holds(const Vec3& p, bool inverse) const override { return m_map.holds(p) != inverse; }
  Vec3 normal(const Vec3& p, const ShapeHit& hit) const override {
    return m_map.normal(p, {hit.u, hit.v});
  }

 private:
  using Memory = typename Map::Memory;
  Bounds box_in(const Transform& t) const;
  double refined(Vec3 p, const Vec3& direction, double step, bool within, Memory& memory) const;
  template <class Visit, class Anywhere>
  void crossings(const Ray& ray, Visit&& visit, Anywhere&& anywhere) const;
  template <class Visit>
  void crossings(const Ray& ray, Visit&& visit) const {
    crossings(ray, visit, [](double, double) { return false; });
  }

  static constexpr double kSureStep = 1.0 + 1e-6;  ///< whatever is rounded

  Map m_map;
  Bounds m_box;
};

/// Cells that the set has no part in are ruled out by their orbits. Where those say nothing it is
/// the sphere's box; the solid may leave it there.
template <class Map>
Bounds JuliaFractal<Map>::box_in(const Transform& t) const {
  constexpr double kFine = 1.0 / 64.0, kNear = 10.0 * kTolerance;
  constexpr int kTests = 3000;
  const double r = m_map.common().radius;
  const Bounds all{Vec3(-r), Vec3(r)};
  if (Map::kRemembers) return transformed(all, t);
  return support_bounds(t, [&](const Vec3& d) {
    const double size = length(d), widest = (r + kNear) * size;
    const double far =
        searched_support(all, d, kFine * widest, kTests, [&](const Vec3& p, const Vec3& half) {
          const double reach = length(half);
          return length(p) - reach <= r && m_map.may_hold(p, reach);
        });
    return std::min(widest, far + kNear * size);
  });
}

/// How far from p, on this side of the surface, to where the other side begins (or this one ends,
/// from within), at most `step`.
template <class Map>
double JuliaFractal<Map>::refined(Vec3 p, const Vec3& direction, double step, bool within,
                                  Memory& memory) const {
  double reached = 0.0;
  bool same = false;
  if constexpr (Map::kThreeAtOnce) {
    // Both middles that may come next are asked for with this one.
    while (0.5 * step > kTolerance) {
      const double half = 0.5 * step;
      step = 0.5 * half;
      const Vec3 middle = p + direction * half;
      const std::array<Vec3, 3> asked{middle, middle + direction * step, p + direction * step};
      const std::array<bool, 3> held = m_map.hold(asked);
      same = held[0] == within;
      if (same) reached += half;
      const int next = same ? 1 : 2;
      if (same) p = middle;
      same = held[next] == within;
      if (!same) continue;
      p = asked[next];
      reached += step;
    }
  }
  while (step > kTolerance) {
    step *= 0.5;
    const Vec3 middle = p + direction * step;
    same = m_map.holds(middle, memory) == within;
    if (same) {
      p = middle;
      reached += step;
    }
  }
  if (!within) {
    p += direction * step;
    reached += step;
  }
  // The orbit that the hit remembers.
  if (Map::kRemembers && (!within || !same)) m_map.holds(p, memory);
  return reached;
}

/// Calls visit(t, what the hit remembers) for the crossings in order, until that returns false. One that
/// anywhere(from, to) wants to know no better is not refined, and the last.
template <class Map>
template <class Visit, class Anywhere>
void JuliaFractal<Map>::crossings(const Ray& ray, Visit&& visit, Anywhere&& anywhere) const {
  const double size = length_squared(ray.direction);
  if (size == 0.0) return;
  constexpr double kUnit = 1e-14;
  const double scale = std::fabs(size - 1.0) < kUnit ? 1.0 : 1.0 / std::sqrt(size);
  const Vec3 direction = ray.direction * scale;
  double depth, end;
  if (!through_sphere(ray.origin, direction, m_map.common().radius, depth, end)) return;
  if (end < kTolerance) return;
  // There is nothing outside the box: no need to walk where the ray has left it.
  double enters = -Bounds::kInf, leaves = Bounds::kInf;
  if (!BoxRay({ray.origin, direction}).cut(m_box, enters, leaves)) return;
  depth = std::max(depth, kTolerance);
  Memory memory(m_map);
  Vec3 p = ray.origin + direction * depth;
  double step;
  bool within = m_map.step(p, direction, step, memory);
  if (within) {
    // Rays that leave the surface start a little inside it.
    depth += 2.0 * kTolerance;
    p += direction * (2.0 * kTolerance);
    if (depth > end) return;
    within = m_map.step(p, direction, step, memory);
  }
  const double least = m_map.common().least_step;
  // Steps from p on that are known to end within, and whether the memory is of p, or of a point before some
  // that were not asked for.
  double sure = 0.0;
  bool is_of_p = within, is_old = false;
  while (depth < end && (within || depth <= leaves)) {
    if (!(step >= least)) step = least;
    if (depth + step > end) return;
    const Vec3 next = p + direction * step;
    double next_step = least;
    if constexpr (Map::kForesees) {
      if (is_of_p) sure = m_map.room(memory, least) / least;
      is_of_p = false;
    }
    if (Map::kForesees && sure >= kSureStep) {
      sure -= 1.0;
      is_old = true;
    } else {
      is_of_p = m_map.step(next, direction, next_step, memory);
      if (is_of_p != within) {
        if (anywhere(depth * scale, (depth + step) * scale)) return;
        if (is_old) {
          double unused;
          m_map.step(p, direction, unused, memory);
          m_map.step(next, direction, unused, memory);
        }
        const double reached = refined(p, direction, step, within, memory);
        if (!visit((depth + reached) * scale, m_map.remembered(memory))) return;
        within = !within;
        is_of_p = false;
        sure = 0.0;
      }
      is_old = false;
    }
    depth += step;
    p = next;
    step = next_step;
  }
}

/// A crossing that is too near for the ray hides all others: a ray finds no more than the first of a Julia set.
/// A search that goes on where it found one, beyond a clipped hit, gets the next.
template <class Map>
bool JuliaFractal<Map>::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  bool found = false, hidden = false;
  crossings(ray, [&](double t, const Vec2& remembered) {
    if (!(t > t_min)) {
      hidden = t != t_min;
      return true;
    }
    found = !hidden && t < t_max;
    if (found) hit = {t, 0, remembered.u, remembered.v};
    return false;
  });
  return found;
}

/// The same answer. Where in the range the crossing is does not matter then.
template <class Map>
bool JuliaFractal<Map>::any(const Ray& ray, double t_min, double t_max) const {
  constexpr double kRounding = 1e-12;
  bool found = false, hidden = false;
  crossings(
      ray,
      [&](double t, const Vec2&) {
        if (!(t > t_min)) {
          hidden = t != t_min;
          return true;
        }
        found = !hidden && t < t_max;
        return false;
      },
      [&](double from, double to) {
        if (!(from > t_min && to + kRounding * std::fabs(to) < t_max)) return false;
        found = !hidden;
        return true;
      });
  return found;
}

template <class Map>
void JuliaFractal<Map>::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  crossings(ray, [&](double t, const Vec2& remembered) {
    if (t > t_min && t < t_max) hits.push_back({t, 0, remembered.u, remembered.v});
    return t < t_max;
  });
}

/// Copies of a declared set follow one another: each thread keeps the last one's box.
template <class Map>
std::unique_ptr<Shape> made(const JuliaSettings& s, Map map) {
  thread_local std::optional<std::pair<JuliaSettings, Bounds>> last;
  if (last && last->first == s)
    return std::make_unique<JuliaFractal<Map>>(std::move(map), last->second);
  auto shape = std::make_unique<JuliaFractal<Map>>(std::move(map));
  last.emplace(s, shape->bounds());
  return shape;
}

template <class F>
std::unique_ptr<Shape> made_of(const JuliaSettings& s, F function) {
  return made(s, julia::FunctionMap<F>(s, function));
}

std::unique_ptr<Shape> make_hypercomplex(const JuliaSettings& s) {
  namespace f = complex_functions;
  using julia::HypercomplexMap;
  switch (s.function) {
    case JuliaFunction::kSqr: return made(s, HypercomplexMap<julia::DuplexSquare<true>>(s));
    // This squares as well, but walks by other steps. Source: stock's.
    case JuliaFunction::kCube: return made(s, HypercomplexMap<julia::DuplexSquare<false>>(s));
    case JuliaFunction::kReciprocal: return made(s, HypercomplexMap<julia::DuplexReciprocal>(s));
    case JuliaFunction::kExp: return made_of(s, f::Exp());
    case JuliaFunction::kLn: return made_of(s, f::Ln());
    case JuliaFunction::kSin: return made_of(s, f::Sin());
    case JuliaFunction::kAsin: return made_of(s, f::Asin());
    case JuliaFunction::kCos: return made_of(s, f::Cos());
    case JuliaFunction::kAcos: return made_of(s, f::Acos());
    case JuliaFunction::kTan: return made_of(s, f::Tan());
    case JuliaFunction::kAtan: return made_of(s, f::Atan());
    case JuliaFunction::kSinh: return made_of(s, f::Sinh());
    case JuliaFunction::kAsinh: return made_of(s, f::Asinh());
    case JuliaFunction::kCosh: return made_of(s, f::Cosh());
    case JuliaFunction::kAcosh: return made_of(s, f::Acosh());
    case JuliaFunction::kTanh: return made_of(s, f::Tanh());
    case JuliaFunction::kAtanh: return made_of(s, f::Atanh());
    case JuliaFunction::kPwr: return made_of(s, f::Power{{s.exponent.u, s.exponent.v}});
  }
  return nullptr;
}

}  // namespace

double julia_sphere(const std::array<double, 4>& c, bool hypercomplex) {
  if (hypercomplex) return 4.0;
  constexpr double kMost = 2.0;  // enough for the square whatever the parameter
  const double reach = std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + c[3] * c[3]);
  return std::min(1.0 + reach + kTolerance, kMost);
}

std::unique_ptr<Shape> make_julia_fractal(const JuliaSettings& s) {
  if (s.hypercomplex) return make_hypercomplex(s);
  switch (s.function) {
    case JuliaFunction::kSqr: return made(s, julia::QuaternionMap<julia::QuaternionSquare>(s));
    case JuliaFunction::kCube: return made(s, julia::QuaternionMap<julia::QuaternionCube>(s));
    default:
      throw std::invalid_argument("quaternion fractals have the functions sqr and cube only");
  }
}

}  // namespace lentray::core
