#include "core/shape/blob.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>

#include "core/numeric/bounds_help.h"
#include "core/numeric/roots.h"
#include "core/shape/crossings.h"

namespace lentray::core {

class Blob::Reaches : public boost::container::small_vector<Blob::Reach, 24> {};

namespace {

// In line, for rays have to be moved to the space of each field they may meet.
Vec3 vector_into(const Matrix& m, const Vec3& v) {
  return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0],
          v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
          v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
}
Vec3 point_into(const Matrix& m, const Vec3& p) {
  return vector_into(m, p) + Vec3{m[3][0], m[3][1], m[3][2]};
}

/// Keeps the part of [from, to] where p + t d lies between lo and hi.
void clip(double p, double d, double lo, double hi, double& from, double& to) {
  if (d == 0.0) {
    if (p < lo || p > hi) to = from;
    return;
  }
  const double a = (lo - p) / d, b = (hi - p) / d;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
}

}  // namespace

Blob::Blob(double threshold, std::vector<BlobField> fields)
    : m_threshold(threshold), m_fields(std::move(fields)) {
  for (const BlobField& f : m_fields) {
    // Of the inverse's square the largest sum of a row bounds the largest stretch.
    const Vec3 axes[3] = {f.to_blob.inverse_vector({1, 0, 0}), f.to_blob.inverse_vector({0, 1, 0}),
                          f.to_blob.inverse_vector({0, 0, 1})};
    double most = 0.0;
    for (const Vec3& a : axes) {
      double sum = 0.0;
      for (const Vec3& b : axes) sum += std::fabs(dot(a, b));
      most = std::max(most, sum);
    }
    m_scales.push_back(std::sqrt(most));
    const double scale = f.length == 0.0 ? similarity_scale(f.to_blob) * f.radius : 0.0;
    m_rounds.push_back({f.to_blob.point({}), scale > 0.0 ? 1.0 / (scale * scale) : 0.0});
  }
  m_bounds = bounds_in(Transform());
}

void Blob::drop_shortcuts() { m_fields.drop_shortcuts(); }

/// Whether the fields can add up to the threshold anywhere in the box.
bool Blob::may_hold(const Vec3& centre, const Vec3& half) const {
  const double reach = length(half);
  double most = 0.0;
  for (std::size_t i = 0; i < m_fields.size(); ++i) {
    const BlobField& f = m_fields[i];
    double share;  // the least for what adds, the most for what takes away
    if (const Round& round = m_rounds[i]; round.scale > 0.0) {
      const Vec3 to = centre - round.centre;
      const auto side = [&](double way, double by) {
        return f.strength > 0.0 ? std::max(0.0, std::fabs(way) - by) : std::fabs(way) + by;
      };
      share = length_squared({side(to.x, half.x), side(to.y, half.y), side(to.z, half.z)}) *
              round.scale;
    } else {
      Vec3 p = point_into(f.to_blob.inverse_rows(), centre);
      p.z -= std::clamp(p.z, 0.0, f.length);
      const double distance = length(p), stretch = reach * m_scales[i];
      const double at = f.strength > 0.0 ? std::max(0.0, distance - stretch) : distance + stretch;
      share = at * at / (f.radius * f.radius);
    }
    const double rest = 1.0 - share;
    if (rest > 0.0) most += f.strength * rest * rest;
  }
  constexpr double kSlack = 2e-6;  // more than that of inside()
  return most > m_threshold - kSlack;
}

Bounds Blob::bounds_in(const Transform& t) const {
  constexpr double kFine = 1.0 / 64.0;
  constexpr int kTests = 2500, kFewest = 32, kMost = 2000;
  if (!m_fields.reach().is_finite()) return transformed(m_fields.reach(), t);
  const int budget = std::clamp(kTests / static_cast<int>(m_fields.size()), kFewest, kMost);
  const Vec3 size = m_fields.reach().hi - m_fields.reach().lo;
  return support_bounds(t, [&](const Vec3& d) {
    const double wide = std::fabs(d.x) * size.x + std::fabs(d.y) * size.y + std::fabs(d.z) * size.z;
    return searched_support(
        m_fields.reach(), d, kFine * wide, budget,
        [&](const Vec3& centre, const Vec3& half) { return may_hold(centre, half); });
  });
}

/// Those that end beyond t_min.
void Blob::find_reaches(std::uint32_t index, const Ray& ray, double t_min, Reaches& out) const {
  const BlobField& field = m_fields[index];
  const auto add = [&](const Vec3& p, const Vec3& d, double scale, auto&& clip_it) {
    const double q2 = dot(d, d) * scale, q1 = 2.0 * dot(p, d) * scale, q0 = dot(p, p) * scale;
    double from = -Bounds::kInf, to = Bounds::kInf;
    if (q2 > 0.0) {
      // As solve_quadratic() does it, but for the tests that it needs.
      const double under = q1 * q1 - 4.0 * q2 * (q0 - 1.0);
      if (!(under > 0.0)) return;
      const double q = -0.5 * (q1 + std::copysign(std::sqrt(under), q1));
      const double a = (q0 - 1.0) / q, b = q / q2;
      from = std::min(a, b);
      to = std::max(a, b);
    } else if (q0 >= 1.0) {
      return;
    }
    clip_it(from, to);
    if (from < to && to > t_min) out.push_back({from, to, q2, q1, q0, field.strength, index});
  };
  if (const Round& round = m_rounds[index]; round.scale > 0.0) {
    add(ray.origin - round.centre, ray.direction, round.scale, [](double&, double&) {});
    return;
  }
  const Matrix& into = field.to_blob.inverse_rows();
  const Vec3 p = point_into(into, ray.origin), d = vector_into(into, ray.direction);
  const double scale = 1.0 / (field.radius * field.radius);
  if (field.length == 0.0) {
    add(p, d, scale, [](double&, double&) {});
    return;
  }
  // Distance from the ends, and from the axis between them.
  const auto within = [&](double lo, double hi) {
    return [&, lo, hi](double& from, double& to) { clip(p.z, d.z, lo, hi, from, to); };
  };
  add(p, d, scale, within(-Bounds::kInf, 0.0));
  add({p.x, p.y, 0.0}, {d.x, d.y, 0.0}, scale, within(0.0, field.length));
  add({p.x, p.y, p.z - field.length}, d, scale, within(field.length, Bounds::kInf));
}

/// Whether the fields can add up to the threshold there.
bool Blob::may_hold(const Reach* const* active, std::size_t count, double from, double to) const {
  constexpr double kSlack = 1e-9;
  double most = 0.0, size = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Reach& r = *active[i];
    size += std::fabs(r.strength);
    const double rest =
        1.0 - (r.strength > 0.0 ? r.least(from, to) : std::max(r.share(from), r.share(to)));
    if (rest > 0.0) most += r.strength * rest * rest;
  }
  return most > m_threshold - kSlack * size;
}

template <class Visit>
void Blob::crossings(const Ray& from_afar, double t_min, double t_max, Visit&& visit) const {
  // Counted from the point nearest to the blob, so that far origins do not cost digits.
  const double shift = dot(m_fields.reach().centre() - from_afar.origin, from_afar.direction) /
                       dot(from_afar.direction, from_afar.direction);
  const Ray ray{from_afar.at(shift), from_afar.direction};
  t_min -= shift;
  t_max -= shift;
  Reaches reaches;
  m_fields.on_ray(ray, t_min,
                  [&](std::uint32_t field) { find_reaches(field, ray, t_min, reaches); });
  if (reaches.empty()) return;
  // In the order of their beginnings; those that have begun and not ended are `active`.
  boost::container::small_vector<const Reach*, 24> order(reaches.size(),
                                                         boost::container::default_init);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = &reaches[i];
  std::sort(order.begin(), order.end(), [](const Reach* a, const Reach* b) {
    return a->from < b->from || (a->from == b->from && a->field < b->field);
  });
  boost::container::small_vector<const Reach*, 24> active(order.size(),
                                                          boost::container::default_init);
  std::size_t begun = 0, count = 0;
  double from = order[0]->from;
  while (true) {
    // From here on: those that end leave, those that begin come.
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (active[i]->to > from) active[left++] = active[i];
    }
    count = left;
    while (begun < order.size() && order[begun]->from <= from) active[count++] = order[begun++];
    if (count == 0) {
      if (begun == order.size()) return;
      from = order[begun]->from;
      continue;
    }
    double to = begun < order.size() ? order[begun]->from : Bounds::kInf;
    for (std::size_t i = 0; i < count; ++i) to = std::min(to, active[i]->to);
    const double start = from;
    from = to;
    if (to <= t_min) continue;
    if (start >= t_max) return;
    if (!may_hold(active.data(), count, start, to)) continue;
    // The sum of the fields here, counted from the middle: a quartic.
    const double middle = 0.5 * (start + to);
    double c[5] = {0.0, 0.0, 0.0, 0.0, -m_threshold};
    for (std::size_t i = 0; i < count; ++i) {
      const Reach& r = *active[i];
      const double a = r.q2, b = r.q1 + 2.0 * r.q2 * middle;
      const double rest = 1.0 - r.share(middle);
      c[0] += r.strength * a * a;
      c[1] += r.strength * 2.0 * a * b;
      c[2] += r.strength * (b * b - 2.0 * a * rest);
      c[3] -= r.strength * 2.0 * b * rest;
      c[4] += r.strength * rest * rest;
    }
    double roots[4];
    const int n = solve_between(c, 4, std::max(start, t_min) - middle, to - middle, roots);
    for (int k = 0; k < n; ++k) {
      if (!visit(roots[k] + middle + shift)) return;
    }
  }
}

bool Blob::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  const auto each = [&](auto&& visit) { crossings(ray, t_min, t_max, visit); };
  return first_of_ordered(each, t_min, t_max, hit);
}

void Blob::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  const auto each = [&](auto&& visit) { crossings(ray, t_min, t_max, visit); };
  append_ordered(each, t_min, t_max, hits);
}

bool Blob::inside(const Vec3& p) const {
  constexpr double kSlack = 1e-6;
  double sum = 0.0;
  m_fields.at_point(
      p, [&](std::uint32_t i) { sum += m_fields[i].at(m_fields[i].to_blob.inverse_point(p)); });
  return sum > m_threshold - kSlack;
}

Vec3 Blob::normal(const Vec3& p, const ShapeHit&) const {
  Vec3 sum;
  m_fields.at_point(p, [&](std::uint32_t i) {
    const BlobField& field = m_fields[i];
    Vec3 at = field.to_blob.inverse_point(p);
    at.z -= std::clamp(at.z, 0.0, field.length);
    const double share = length_squared(at) / (field.radius * field.radius);
    if (share >= 1.0) return;
    const double steep = field.strength * (1.0 - share) / (field.radius * field.radius);
    sum += field.to_blob.normal(at * steep);
  });
  return sum == Vec3{} ? Vec3{1, 0, 0} : sum;
}

}  // namespace lentray::core
