#include "core/shape/isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/numeric/bounds_help.h"
#include "core/shape/sphere.h"

namespace lentray::core {
namespace {

constexpr std::uint32_t kSurface = 0;  ///< element; 1 .. 6 are the box's sides, lower first
constexpr double kSkin = 4.0;          ///< in accuracies: how far off the surface counts as on it
constexpr double kStep = 5.0;  ///< in accuracies: how far beyond a surface the search goes on
/// Accuracies count along the ray: a surface that is scaled down would vanish in its own.
/// One coarser than this share of the way through the container is replaced by a fine one.
constexpr double kCoarseAccuracy = 0.05, kFineAccuracy = 5e-4;

}  // namespace

/// The function less its threshold, for many points.
class Isosurface::Field {
 public:
  using Lanes = Program::Lanes;
  explicit Field(const Isosurface& surface)
      : m_surface(surface), m_is_ready(surface.m_program && m_frame.prepare(*surface.m_program)),
        m_is_wide(m_is_ready && m_wide.prepare(*surface.m_program)) {}
  double operator()(const Vec3& p) {
    return m_is_ready ? m_frame(p) - m_surface.m_set.threshold : m_surface.value(p);
  }
  /// Whether two points take little more time than one.
  bool is_wide() const { return m_is_wide; }
  Lanes along(const Ray& ray, Lanes t) {
    return m_wide(ray.origin.x + ray.direction.x * t, ray.origin.y + ray.direction.y * t,
                  ray.origin.z + ray.direction.z * t) -
           m_surface.m_set.threshold;
  }
  Lanes both(const Vec3& a, const Vec3& b) {
    if (m_is_wide)
      return m_wide(Lanes{a.x, b.x}, Lanes{a.y, b.y}, Lanes{a.z, b.z}) - m_surface.m_set.threshold;
    const double first = (*this)(a);
    return Lanes{first, (*this)(b)};
  }

 private:
  const Isosurface& m_surface;
  Program::Frame m_frame;
  Program::WideFrame m_wide;
  bool m_is_ready, m_is_wide;
};

/// The function along a ray, positive on the side where the search stands.
struct Isosurface::Search {
  const Isosurface& surface;
  Field& field;
  const Ray& ray;
  double speed;     ///< of the ray
  double gradient;  ///< steepest that counts
  double accuracy;
  double sign = 1.0;
  /// Times the speed: what need not be told, or was seen since. Beyond what other rays have shown a
  /// steeper piece is rare, and the processor does not expect it.
  double steepest = surface.m_watch ? surface.m_watch->steepest() * speed * kSurelyLess : kInf;
  const double told = steepest;

  ~Search() {
    if (steepest > told) surface.m_watch->note(steepest / speed);
  }

  double at(double t) { return sign * field(ray.at(t)); }

  static constexpr double kInf = std::numeric_limits<double>::infinity();
  static constexpr double kSurelyLess = 1.0 - 1e-12;  ///< whatever is rounded
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  /// The first t in [from, to] where the function is below 0. `reach`: how much it can fall there.
  /// `f_middle`: the function in the middle, if it is known already.
  template <bool kEvaluates>
  [[gnu::always_inline]] bool find(double from, double f_from, double to, double f_to, double reach,
                                   double f_middle, double& t) {
    const double span = to - from;
    const double rise = std::fabs(f_to - f_from);
    note(rise, span);
    if constexpr (kEvaluates) {
      const IsosurfaceSettings& set = surface.m_set;
      const double slope = rise / (speed * span);
      if (gradient < slope * set.growth) {
        gradient = slope * set.growth * set.growth;
        reach = gradient * speed * span;
      }
    }
    const bool is_free = !(f_from + f_to - reach < 0.0);  // so too where the function is no number
    if (is_free && f_to >= 0.0) return false;
    const double middle = from + 0.5 * span;
    if (span < accuracy || !(from < middle && middle < to)) {
      t = to;
      return f_to < 0.0;
    }
    return !is_free &&
           find_in_halves<kEvaluates>(from, f_from, middle, f_middle, to, f_to, reach, t);
  }

  /// Each number by itself, in a register: they would be read two at a time from where they were just
  /// written one by one, which holds the processor up.
  template <bool kEvaluates>
  [[gnu::noinline]] bool find_in_halves(double from, double f_from, double middle, double f_middle,
                                        double to, double f_to, double reach, double& t) {
    const double half = 0.5 * reach;
    double f_first = kUnknown, f_last = kUnknown;
    if (std::isnan(f_middle)) {
      // Which half is probably looked at next, as if the function were linear.
      const double mean = 0.5 * (f_from + f_to);
      const bool first = f_from + mean < half, last = mean + f_to < half;
      if (field.is_wide() && (first || last) && 0.5 * (to - from) >= accuracy) {
        const double next = first ? from + 0.5 * (middle - from) : middle + 0.5 * (to - middle);
        const Field::Lanes f = sign * field.along(ray, Field::Lanes{middle, next});
        f_middle = f[0];
        (first ? f_first : f_last) = f[1];
      } else {
        f_middle = at(middle);
      }
    }
    return find<kEvaluates>(from, f_from, middle, f_middle, half, f_first, t) ||
           find<kEvaluates>(middle, f_middle, to, f_to, half, f_last, t);
  }
  void note(double rise, double span) {
    if (rise > steepest * span) steepest = rise / span;
  }

  /// f_from and f_to: the function there, without the sign.
  bool next(double from, double f_from, double to, double f_to, double& t) {
    f_from *= sign;
    if (surface.m_set.open && f_from < 0.0) {
      sign = -sign;
      f_from = -f_from;
    }
    f_to *= sign;
    const IsosurfaceSettings& set = surface.m_set;
    if (!set.evaluates)
      return find<false>(from, f_from, to, f_to, gradient * speed * (to - from), kUnknown, t);
    if (gradient > set.max_gradient) gradient *= set.shrinking;
    return find<true>(from, f_from, to, f_to, gradient * speed * (to - from), kUnknown, t);
  }
};

Isosurface::Isosurface(IsosurfaceSettings settings)
    : m_set(std::move(settings)), m_program(dynamic_cast<const Program*>(m_set.function.get())) {}

Bounds Isosurface::own_box() const {
  if (!m_set.in_sphere) return {m_set.lo, m_set.hi};
  return {m_set.centre - Vec3(m_set.radius), m_set.centre + Vec3(m_set.radius)};
}

Bounds Isosurface::box_in(const Transform& t) const {
  if (!m_set.in_sphere) return transformed(own_box(), t);
  return support_bounds(
      t, [&](const Vec3& d) { return dot(d, m_set.centre) + m_set.radius * length(d); });
}

double Isosurface::value(const Vec3& p) const {
  const std::array<double, 3> at{p.x, p.y, p.z};
  return m_set.function->evaluate(at) - m_set.threshold;
}

bool Isosurface::through_container(const Ray& ray, double& from, double& to, std::uint32_t& side_in,
                                   std::uint32_t& side_out) const {
  side_in = side_out = kSurface;
  if (m_set.in_sphere) {
    const double inverse_dd = 1.0 / dot(ray.direction, ray.direction);
    if (!sphere_roots(ray, inverse_dd, m_set.centre, m_set.radius * m_set.radius, from, to))
      return false;
    return to > 0.0;
  }
  from = -Bounds::kInf;
  to = Bounds::kInf;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const int i = static_cast<int>(axis);
    const double p = ray.origin[i], d = ray.direction[i];
    if (d == 0.0) {
      if (p < m_set.lo[i] || p > m_set.hi[i]) return false;
      continue;
    }
    const double low = (m_set.lo[i] - p) / d, high = (m_set.hi[i] - p) / d;
    const std::uint32_t first = d > 0.0 ? 1 + 2 * axis : 2 + 2 * axis;
    if (std::min(low, high) > from) {
      from = std::min(low, high);
      side_in = first;
    }
    if (std::max(low, high) < to) {
      to = std::max(low, high);
      side_out = 3 + 4 * axis - first;
    }
  }
  return from < to && to > 0.0;
}

template <class Visit>
void Isosurface::crossings(const Ray& ray, Visit&& visit) const {
  double from, to;
  std::uint32_t side_in, side_out;
  if (!through_container(ray, from, to, side_in, side_out)) return;
  from = std::max(from, 0.0);
  const double speed = length(ray.direction), widest = length(bounds().hi - bounds().lo) / speed;
  const double accuracy =
      m_set.accuracy > kCoarseAccuracy * widest ? kFineAccuracy * widest : m_set.accuracy;
  if (to - from < accuracy) return;
  Field field(*this);
  Search search{*this, field, ray, speed, m_set.max_gradient, accuracy};
  const double skin = m_set.max_gradient * m_set.accuracy * kSkin;
  const double beyond = accuracy * kStep;
  int found = 0;
  std::optional<double> there;
  double here;  // at `from`, always
  if (field.is_wide()) {
    const auto ends = field.along(ray, Field::Lanes{from, to});
    here = ends[0];
    there = ends[1];
  } else {
    here = field(ray.at(from));
  }
  const auto begin_behind = [&] {
    from = beyond;
    here = field(ray.at(from));
    if (here < 0.0) search.sign = -1.0;
  };
  const auto at_end = [&] { return there ? *there : there.emplace(field(ray.at(to))); };
  if (!m_set.open) {
    if (from > accuracy) {
      if (here < 0.0) {
        if (!visit(from, side_in)) return;
        ++found;
        search.sign = -1.0;
      }
    } else {
      // The ray starts within the container, perhaps on the surface.
      if (here < skin) begin_behind();
      if (at_end() < 0.0 && !visit(to, side_out)) return;
    }
  }
  if (from < accuracy && search.sign == 1.0 && std::fabs(here) < skin) begin_behind();
  while (found < m_set.max_trace && to - from >= accuracy) {
    double t;
    if (!search.next(from, here, to, at_end(), t)) return;
    if (!visit(t, kSurface) || ++found == m_set.max_trace) return;
    from = t + beyond;
    here = field(ray.at(from));
    search.sign = -search.sign;
  }
}

bool Isosurface::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  bool any = false;
  crossings(ray, [&](double t, std::uint32_t element) {
    if (!(t > t_min && t < t_max)) return true;
    hit = {t, element, 0.0, 0.0};
    t_max = t;
    any = true;
    return true;
  });
  return any;
}

bool Isosurface::any(const Ray& ray, double t_min, double t_max) const {
  bool any = false;
  crossings(ray, [&](double t, std::uint32_t) { return !(any = t > t_min && t < t_max); });
  return any;
}

void Isosurface::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  crossings(ray, [&](double t, std::uint32_t element) {
    if (t > t_min && t < t_max) hits.push_back({t, element, 0.0, 0.0});
    return true;
  });
}

bool Isosurface::within(const Vec3& p) const {
  if (m_set.in_sphere) {
    if (length_squared(p - m_set.centre) > m_set.radius * m_set.radius) return false;
  } else if (!Bounds{m_set.lo, m_set.hi}.contains(p)) {
    return false;
  }
  return !(value(p) > 0.0);
}

Vec3 Isosurface::normal(const Vec3& p, const ShapeHit& hit) const {
  constexpr double kOnSphere = 1e-10;
  if (hit.element != kSurface) {
    Vec3 side;
    side[static_cast<int>((hit.element - 1) / 2)] = hit.element % 2 == 1 ? -1.0 : 1.0;
    return side;
  }
  if (m_set.in_sphere) {
    const Vec3 out = p - m_set.centre;
    if (std::fabs(length(out) - m_set.radius) < kOnSphere) return out;
  }
  Field field(*this);
  const double step = m_set.accuracy;
  const Field::Lanes first = field.both(p, p + Vec3{step, 0, 0});
  const Field::Lanes second = field.both(p + Vec3{0, step, 0}, p + Vec3{0, 0, step});
  const double here = first[0];
  const Vec3 slope{first[1] - here, second[0] - here, second[1] - here};
  return slope == Vec3{} ? Vec3{1, 0, 0} : slope;
}

}  // namespace lentray::core
