#include "core/shape/parametric.h"

#include <algorithm>
#include <cmath>

namespace lentray::core {
namespace {

constexpr int kLevels = 12;        ///< of halvings kept,
constexpr int kMostLevels = 15;    ///< or as many as are to be precomputed, up to here
constexpr int kMostHalvings = 96;  ///< in all: then a double's digits are used up
constexpr double kAlong = 1e-10;   ///< directions below this run along an axis' planes
constexpr double kEmptyPath = 1e-10;
/// Accuracies count along the ray: a surface that is scaled down would vanish in its own.
/// One coarser than this share of the surface's size is replaced by a fine one.
constexpr double kCoarsePiece = 0.05, kFinePiece = 5e-4;
constexpr double kSlow =
    0.05;  ///< sine of the angle to a plane, below which a ray creeps away from it

/// Written so that what is not a number is outside.
bool encloses(double lo, double hi, double inner_lo, double inner_hi) {
  return lo <= inner_lo && hi >= inner_hi;
}

}  // namespace

void Parametric::Piece::halve(Piece& lower, Piece& upper) const {
  lower = upper = *this;
  if (across_u()) {
    lower.u_hi = upper.u_lo = (u_hi + u_lo) / 2.0;
  } else {
    lower.v_hi = upper.v_lo = (v_hi + v_lo) / 2.0;
  }
}

/// The ranges of a piece: as the search takes them, and those of its parts.
struct Parametric::Bound {
  Ranges own, tight;
};

double Parametric::value(int axis, double u, double v) const {
  constexpr std::size_t kUsual = 4;
  const Function& f = *m_set.functions[static_cast<std::size_t>(axis)];
  if (f.parameters() <= kUsual) {
    const std::array<double, kUsual> few{u, v, 0.0, 0.0};
    return f.evaluate(std::span(few).first(f.parameters()));
  }
  std::array<double, kMostParameters> many{};
  many[0] = u;
  many[1] = v;
  return f.evaluate(std::span(many).first(f.parameters()));
}

Parametric::Corners Parametric::corners(int axis, const Piece& p) const {
  return {value(axis, p.u_lo, p.v_lo), value(axis, p.u_lo, p.v_hi), value(axis, p.u_hi, p.v_lo),
          value(axis, p.u_hi, p.v_hi)};
}

/// At the two points that halving the piece adds.
std::array<double, 2> Parametric::between(int axis, const Piece& p) const {
  if (p.across_u()) {
    const double u = (p.u_hi + p.u_lo) / 2.0;
    return {value(axis, u, p.v_lo), value(axis, u, p.v_hi)};
  }
  const double v = (p.v_hi + p.v_lo) / 2.0;
  return {value(axis, p.u_lo, v), value(axis, p.u_hi, v)};
}

void Parametric::halve(const Corners& f, const std::array<double, 2>& middle, bool across_u,
                       Corners& lower, Corners& upper) {
  if (across_u) {
    lower = {f[0], f[1], middle[0], middle[1]};
    upper = {middle[0], middle[1], f[2], f[3]};
  } else {
    lower = {f[0], middle[0], f[2], middle[1]};
    upper = {middle[0], f[1], middle[1], f[3]};
  }
}

/// Between two points a function can rise beyond both by half of what the gradient allows and the
/// points do not use: so along both sides, and from one side to the other.
Parametric::Range Parametric::range(const Corners& f, const Piece& p) const {
  const double gradient = m_set.max_gradient;
  const auto beyond = [&](double length, double a, double b) {
    return std::max(0.5 * (gradient * length - std::fabs(a - b)), 0.0);
  };
  const double v_size = p.v_hi - p.v_lo, u_size = p.u_hi - p.u_lo;
  const double first = beyond(v_size, f[0], f[1]), second = beyond(v_size, f[2], f[3]);
  const double lo0 = std::min(f[0], f[1]) - first, hi0 = std::max(f[0], f[1]) + first;
  const double lo1 = std::min(f[2], f[3]) - second, hi1 = std::max(f[2], f[3]) + second;
  return {std::min(lo0, lo1) - beyond(u_size, lo0, lo1) - m_set.accuracy,
          std::max(hi0, hi1) + beyond(u_size, hi0, hi1) - m_set.accuracy};
}

Parametric::Parametric(ParametricSettings settings)
    : m_set(std::move(settings)),
      m_levels(std::clamp(m_set.precompute_depth, kLevels, kMostLevels)) {
  if (m_set.lo.u > m_set.hi.u) std::swap(m_set.lo.u, m_set.hi.u);
  if (m_set.lo.v > m_set.hi.v) std::swap(m_set.lo.v, m_set.hi.v);
  const bool precomputes = m_set.precompute[0] || m_set.precompute[1] || m_set.precompute[2];
  const int levels = precomputes ? std::max(m_levels, m_set.precompute_depth) : m_levels;
  m_kept.resize(std::size_t{1} << m_levels);
  m_corners.resize(std::size_t{1} << (m_levels - 1));
  const Piece whole{m_set.lo.u, m_set.hi.u, m_set.lo.v, m_set.hi.v};
  const Bound all =
      keep(1, 1, whole, {corners(0, whole), corners(1, whole), corners(2, whole)}, levels);
  // A hit is within its piece's ranges along the ray, which may be longer than the piece.
  const double slack = 2.0 * m_set.accuracy * (1.0 + m_set.max_gradient);
  Bounds box = m_set.in_sphere
                   ? Bounds{m_set.centre - Vec3(m_set.radius), m_set.centre + Vec3(m_set.radius)}
                   : Bounds{m_set.box_lo, m_set.box_hi};
  Bounds found;
  for (int axis = 0; axis < 3; ++axis) {
    const Range& r = all.tight[static_cast<std::size_t>(axis)];
    found.lo[axis] = r.lo - slack;
    found.hi[axis] = r.hi + slack;
  }
  if (!m_too_flat) box.intersect(found);
  m_bounds = box;
}

Parametric::Bound Parametric::keep(std::size_t number, int level, const Piece& piece,
                                   const std::array<Corners, 3>& f, int levels) {
  Bound bound;
  for (std::size_t axis = 0; axis < 3; ++axis) bound.own[axis] = range(f[axis], piece);
  bound.tight = bound.own;
  if (level == m_levels) m_corners[number - m_corners.size()] = f;
  if (level < levels) {
    Piece lower, upper;
    piece.halve(lower, upper);
    std::array<Corners, 3> f_lower, f_upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      halve(f[axis], between(static_cast<int>(axis), piece), piece.across_u(), f_lower[axis],
            f_upper[axis]);
    }
    const Bound a = keep(2 * number, level + 1, lower, f_lower, levels);
    const Bound b = keep(2 * number + 1, level + 1, upper, f_upper, levels);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (m_set.precompute[axis] && level < m_set.precompute_depth) {
        bound.own[axis] = {std::min(a.own[axis].lo, b.own[axis].lo),
                           std::max(a.own[axis].hi, b.own[axis].hi)};
      }
      bound.tight[axis] = {std::min(a.tight[axis].lo, b.tight[axis].lo),
                           std::max(a.tight[axis].hi, b.tight[axis].hi)};
    }
  }
  if (level > m_levels) return bound;
  Kept& kept = m_kept[number];
  kept.tight = bound.tight;
  kept.own = bound.own;
  kept.narrowest = Bounds::kInf;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range &own = bound.own[axis], &parts = bound.tight[axis];
    kept.narrowest = std::min(kept.narrowest, own.hi - own.lo);
    if (!encloses(own.lo, own.hi, parts.lo, parts.hi)) kept.own_cuts = m_too_flat = true;
  }
  return bound;
}

/// A piece on the way to a ray's hit. Times along the ray, where it is within each range.
struct Parametric::Entry {
  Piece piece;
  std::array<Corners, 3> f;
  int halvings;
  double nearest;  ///< the latest time it enters a range
  double last;     ///< the time it enters the last one
  double longest;  ///< its longest way in a range
};

struct Parametric::Search {
  Search(const Parametric& parametric, const Ray& ray)
      : surface(parametric), accuracy(parametric.m_set.accuracy), speed(length(ray.direction)) {
    const double size = length(parametric.m_bounds.hi - parametric.m_bounds.lo) / speed;
    along = accuracy > kCoarsePiece * size ? kFinePiece * size : accuracy;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t i = static_cast<std::size_t>(axis);
      origin[i] = ray.origin[axis];
      runs_along[i] = std::fabs(ray.direction[axis]) < kAlong;
      inverse[i] = 1.0 / ray.direction[axis];
      if (!runs_along[i]) last_is_slow = std::fabs(ray.direction[axis]) < kSlow * speed;
    }
  }

  const Parametric& surface;
  double accuracy, speed;
  double along;  ///< the accuracy of times
  /// The ray hardly moves along the last axis: it may enter that range long before it is where the
  /// others are. That time would leave holes in the surface.
  bool last_is_slow = false;
  std::array<double, 3> origin, inverse;
  std::array<bool, 3> runs_along;
  double from = 0.0, to = 0.0;
  double best = Bounds::kInf, u = 0.0, v = 0.0;

  /// The ranges a ray has been through; times stay what they are for an axis that it runs along.
  struct Times {
    double nearest = -Bounds::kInf, farthest = Bounds::kInf, last = 0.0, longest = 0.0;
  };

  /// Whether the ray passes this axis' range together with those before.
  bool passes(std::size_t axis, const Range& range, Times& times) const {
    if (runs_along[axis]) return !(range.hi < origin[axis] || range.lo > origin[axis]);
    double in = (range.hi - origin[axis]) * inverse[axis];
    double out = (range.lo - origin[axis]) * inverse[axis];
    if (in > out) std::swap(in, out);
    if (in > to || out < from || in > best) return false;
    if (in > times.farthest || out < times.nearest) return false;
    times.nearest = std::max(times.nearest, in);
    times.farthest = std::min(times.farthest, out);
    times.longest = std::max(times.longest, out - in);
    times.last = in;
    return true;
  }

  bool passes(const Ranges& ranges) const {
    Times times;
    return passes(0, ranges[0], times) && passes(1, ranges[1], times) &&
           passes(2, ranges[2], times);
  }

  static void set(Entry& e, const Times& times) {
    e.nearest = times.nearest;
    e.last = times.last;
    e.longest = times.longest;
  }

  void through_kept();
  void refine(const Piece& piece, const std::array<Corners, 3>& f, int level);
  int split(const Entry& e, Entry* out) const;
};

/// Fills out[0] with the upper half and the next with the lower, of those that the ray passes;
/// returns how many. The lower is searched first: of pieces at the same time the first counts.
int Parametric::Search::split(const Entry& e, Entry* out) const {
  Piece pieces[2];
  e.piece.halve(pieces[1], pieces[0]);
  const bool across_u = e.piece.across_u();
  std::array<Corners, 3> f[2];
  Times times[2];
  bool alive[2] = {true, true};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    halve(e.f[axis], surface.between(static_cast<int>(axis), e.piece), across_u, f[1][axis],
          f[0][axis]);
    for (int i = 0; i < 2; ++i) {
      alive[i] = alive[i] && passes(axis, surface.range(f[i][axis], pieces[i]), times[i]);
    }
    if (!alive[0] && !alive[1]) return 0;
  }
  int count = 0;
  for (int i = 0; i < 2; ++i) {
    if (!alive[i]) continue;
    Entry& child = out[count++];
    child.piece = pieces[i];
    child.f = f[i];
    child.halvings = e.halvings + 1;
    set(child, times[i]);
  }
  return count;
}

void Parametric::Search::refine(const Piece& piece, const std::array<Corners, 3>& f, int level) {
  Entry stack[kMostHalvings + 2];
  Times times;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!passes(axis, surface.range(f[axis], piece), times)) return;
  }
  stack[0].piece = piece;
  stack[0].f = f;
  stack[0].halvings = level;
  set(stack[0], times);
  for (int count = 1; count > 0;) {
    const Entry e = stack[--count];
    if (e.nearest > best) continue;
    if (e.piece.size() < accuracy || e.longest < along || e.halvings >= kMostHalvings) {
      const double t = last_is_slow ? e.nearest : e.last;
      if (t < best && t > from) {
        best = t;
        u = e.piece.u_lo;
        v = e.piece.v_lo;
      }
      continue;
    }
    count += split(e, stack + count);
  }
}

void Parametric::Search::through_kept() {
  struct Place {
    std::size_t number;
    Piece piece;
    int level;
  };
  Place stack[kMostLevels + 1];
  const Piece whole{surface.m_set.lo.u, surface.m_set.hi.u, surface.m_set.lo.v, surface.m_set.hi.v};
  stack[0] = {1, whole, 1};
  for (int count = 1; count > 0;) {
    const Place p = stack[--count];
    const Kept& kept = surface.m_kept[p.number];
    if (!passes(kept.tight) || (kept.own_cuts && !passes(kept.own))) continue;
    const bool may_end = p.piece.size() < accuracy || kept.narrowest < along * speed;
    if (p.level == surface.m_levels) {
      refine(p.piece, surface.m_corners[p.number - surface.m_corners.size()], p.level);
    } else if (may_end) {
      refine(
          p.piece,
          {surface.corners(0, p.piece), surface.corners(1, p.piece), surface.corners(2, p.piece)},
          p.level);
    } else {
      Place lower{2 * p.number, {}, p.level + 1}, upper{2 * p.number + 1, {}, p.level + 1};
      p.piece.halve(lower.piece, upper.piece);
      stack[count++] = upper;
      stack[count++] = lower;
    }
  }
}

bool Parametric::through_container(const Ray& ray, double& from, double& to) const {
  if (m_set.in_sphere) {
    const double speed = length(ray.direction);
    const Vec3 direction = ray.direction * (1.0 / speed), centre = m_set.centre - ray.origin;
    const double distance = dot(centre, centre), nearest = dot(centre, direction);
    const double square = m_set.radius * m_set.radius;
    if (distance >= square && nearest < kEmptyPath) return false;
    const double chord = square - length_squared(centre - direction * nearest);
    if (!(chord > kEmptyPath)) return false;
    from = (nearest - std::sqrt(chord)) / speed;
    to = (nearest + std::sqrt(chord)) / speed;
    return true;
  }
  constexpr double kNear = 1e-6;
  from = 0.0;
  to = Bounds::kInf;
  for (int axis = 0; axis < 3; ++axis) {
    const double p = ray.origin[axis], d = ray.direction[axis];
    if (std::fabs(d) <= kAlong) {
      if (p < m_set.box_lo[axis] || p > m_set.box_hi[axis]) return false;
      continue;
    }
    const double a = (m_set.box_lo[axis] - p) / d, b = (m_set.box_hi[axis] - p) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to && to >= kNear;
}

/// What is nearer than the ray asks for hides the rest.
bool Parametric::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  constexpr double kBegin = 4.0;  // in accuracies
  Search search(*this, ray);
  if (!through_container(ray, search.from, search.to)) return false;
  search.from += kBegin * search.along;
  if (search.from > search.to) return false;
  search.through_kept();
  if (!(search.best < search.to && search.best > t_min && search.best < t_max)) return false;
  hit = {search.best, 0, search.u, search.v};
  return true;
}

Vec3 Parametric::normal(const Vec3&, const ShapeHit& hit) const {
  Vec3 along_u, along_v;
  for (int axis = 0; axis < 3; ++axis) {
    const double here = value(axis, hit.u, hit.v);
    along_u[axis] = value(axis, hit.u + m_set.accuracy, hit.v) - here;
    along_v[axis] = value(axis, hit.u, hit.v + m_set.accuracy) - here;
  }
  return cross(along_u, along_v);
}

}  // namespace lentray::core
