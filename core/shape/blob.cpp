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

bool meet(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  both.intersect(b);
  return !both.is_empty();
}

}  // namespace

Blob::Blob(double threshold, std::vector<BlobField> fields)
    : m_threshold(threshold), m_fields(std::move(fields)) {
  for (const BlobField& f : m_fields) {
    const double scale = f.length == 0.0 ? similarity_scale(f.to_blob) * f.radius : 0.0;
    m_rounds.push_back({f.to_blob.point({}), scale > 0.0 ? 1.0 / (scale * scale) : 0.0});
  }
  m_bounds = box_in(Transform());
}

/// The fields that add something, as a direction d sees them.
class Blob::Support {
 public:
  explicit Support(const Blob& blob);
  /// The most that d.p becomes on the surface or in the solid, rounded up; d of any length.
  double operator()(const Vec3& d);

 private:
  struct Part {
    const BlobField* field;
    const Bounds* box;
    Vec3 middle, half;         ///< of its axis
    double radius;             ///< if it is round; else 0
    double falls, reach, end;  ///< of d.p: from where on it falls, over how long, its end
  };
  struct Near {
    const Part* part;
    double beside;  ///< how far from the first part's axis it is at least, seen along d
  };
  static double distance(const Part& a, const Part& b, const Vec3& d);
  bool may_hold(double c) const;

  double m_threshold;
  Vec3 m_middle;
  boost::container::small_vector<Part, 16> m_parts;
  boost::container::small_vector<Near, 16> m_near;  ///< to one part, that first
};

Blob::Support::Support(const Blob& blob)
    : m_threshold(blob.m_threshold), m_middle(blob.m_fields.reach().centre()) {
  for (std::size_t i = 0; i < blob.m_fields.size(); ++i) {
    const BlobField& f = blob.m_fields[i];
    if (!(f.strength > 0.0)) continue;
    const Vec3 half = f.to_blob.vector({0.0, 0.0, 0.5 * f.length});
    m_parts.push_back({&f, &blob.m_fields.box(i), f.to_blob.point({}) + half, half,
                       similarity_scale(f.to_blob) * f.radius, 0.0, 0.0, 0.0});
  }
}

/// Of their axes, seen along d: not too large.
double Blob::Support::distance(const Part& a, const Part& b, const Vec3& d) {
  const Vec3 to = b.middle - a.middle;
  const auto gap = [&](const Vec3& way) {
    const double size = length(way);
    if (!(size > 0.0)) return 0.0;
    return (std::fabs(dot(to, way)) - std::fabs(dot(a.half, way)) - std::fabs(dot(b.half, way))) /
           size;
  };
  return std::max({0.0, gap(cross(cross(d, to), d)), gap(cross(d, a.half)), gap(cross(d, b.half))});
}

/// Whether the parts near the first one can add up to the threshold where d.p >= c. A part has there at most what it
/// has as near to its axis as that lets. So it is asked ring by ring about the axis of the first.
bool Blob::Support::may_hold(double c) const {
  constexpr double kSlack = 2e-6;  // more than that of inside()
  constexpr int kRings = 8;
  const Part& first = *m_near.front().part;
  for (int ring = 0; ring < kRings; ++ring) {
    const double inner = first.radius * ring / kRings, outer = first.radius * (ring + 1) / kRings;
    double sum = 0.0;
    for (const Near& near : m_near) {
      const Part& part = *near.part;
      const double past = c > part.falls ? (c - part.falls) / part.reach : 0.0;
      double beside = &part == &first ? inner : std::max(0.0, near.beside - outer);
      if (beside > 0.0) beside /= part.radius;
      const double rest = 1.0 - past * past - beside * beside;
      if (rest > 0.0) sum += part.field->strength * rest * rest;
    }
    if (sum > m_threshold - kSlack) return true;
    if (first.radius == 0.0) break;
  }
  return false;
}

double Blob::Support::operator()(const Vec3& d) {
  constexpr int kSteps = 8;  // to a part of 256
  if (m_parts.empty()) return dot(d, m_middle);
  for (Part& part : m_parts) {
    const Transform& t = part.field->to_blob;
    const Vec3 n{dot(d, t.vector({1, 0, 0})), dot(d, t.vector({0, 1, 0})),
                 dot(d, t.vector({0, 0, 1}))};
    part.falls = dot(d, part.middle) + std::fabs(dot(d, part.half));
    part.reach = part.field->radius * length(n);
    part.end = part.falls + part.reach;
  }
  std::sort(m_parts.begin(), m_parts.end(),
            [](const Part& a, const Part& b) { return a.end > b.end; });
  double most = -Bounds::kInf;
  for (const Part& part : m_parts) {
    if (part.end <= most) break;
    m_near.assign(1, {&part, 0.0});
    double from = part.falls;
    for (const Part& other : m_parts) {
      if (other.end <= most) break;
      if (&other == &part || !meet(*part.box, *other.box)) continue;
      const bool round = part.radius > 0.0 && other.radius > 0.0;
      m_near.push_back({&other, round ? distance(part, other, d) : 0.0});
      from = std::min(from, other.falls);
    }
    from = std::max(from, most);
    if (!may_hold(from)) continue;
    double to = part.end;
    for (int step = 0; step < kSteps; ++step) {
      const double middle = 0.5 * (from + to);
      (may_hold(middle) ? from : to) = middle;
    }
    most = to;
  }
  return most > -Bounds::kInf ? most : m_parts.front().end;  // nothing at all: any answer holds
}

Bounds Blob::box_in(const Transform& t) const {
  if (!m_fields.reach().is_finite()) return transformed(m_fields.reach(), t);
  Support support(*this);
  return support_bounds(t, [&](const Vec3& d) { return support(d); });
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
  // Nearer ones do not count for any ray, as in stock (tests/image/blob_start_test.cpp).
  constexpr double kNearest = 0.01;
  t_min = std::max(t_min, kNearest);
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
  return first_of_ordered(*this, ray, t_min, t_max, hit);
}

void Blob::all(const Ray& ray, double t_min, double t_max, ShapeHits& hits) const {
  append_ordered(*this, ray, t_min, t_max, hits);
}

bool Blob::within(const Vec3& p) const {
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
