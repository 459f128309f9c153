#include "core/object/csg_convex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <typeinfo>

#include "core/object/csg_rounding.h"
#include "core/shape/plane.h"

namespace lentray::core {
namespace {

// Far above the rounding of what begins within so many reaches, and above what a Passage is widened by.
constexpr double kMargin = 1e-6, kFarthestOrigin = 100.0;

Hit hit_of(const Leaf& leaf, const Crossing& found) {
  return {found.t, &leaf, nullptr, hit_at(found)};
}

/// How a part is placed: what the numbers of its place in the world add up to, and by how much at most lengths
/// grow on the way to its shape's space.
struct Placement {
  double reach = 0.0, growth = 1.0;
};

std::optional<Placement> placement_of(const Leaf& leaf) {
  const Bounds box = leaf.shape().bounds();
  const auto largest = [&](int axis) { return std::max(-box.lo[axis], box.hi[axis]); };
  if (const auto* plane = dynamic_cast<const Plane*>(&leaf.shape())) {
    if (leaf.transform()) return std::nullopt;
    return Placement{std::fabs(plane->distance()), 1.0};
  }
  if (!box.is_finite()) return std::nullopt;
  if (!leaf.transform()) return Placement{largest(0) + largest(1) + largest(2), 1.0};
  // Of worse matrices the way there and back leaves too much rounding.
  constexpr double kWorst = 1e4;
  const Matrix& out = leaf.transform()->rows();
  const Matrix& in = leaf.transform()->inverse_rows();
  Placement placement{std::fabs(out[3][0]) + std::fabs(out[3][1]) + std::fabs(out[3][2]), 0.0};
  double growth_back = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double row = std::fabs(out[i][0]) + std::fabs(out[i][1]) + std::fabs(out[i][2]);
    placement.reach += row * largest(static_cast<int>(i));
    growth_back = std::max(growth_back, row);
    placement.growth =
        std::max(placement.growth, std::fabs(in[0][i]) + std::fabs(in[1][i]) + std::fabs(in[2][i]));
  }
  if (!(placement.growth * growth_back < kWorst)) return std::nullopt;
  return placement;
}

}  // namespace

Answer ConvexParts::Part::holds(const Vec3& p) const {
  return holds_own(move ? move->inverse_point(p) : p);
}

Answer ConvexParts::Part::holds_own(const Vec3& p) const {
  const Side side = shape.side(p);
  if (side == Side::kNear) return Answer::kUnclear;
  return (side == Side::kInside) != is_inverse ? Answer::kYes : Answer::kNo;
}

/// A ray and where its line is in each part.
struct ConvexParts::Line {
  struct Stretch {
    Stretch() {}  // not defaulted: that would clear all
    Crossing found[2];
    int count;
    bool is_asked;  ///< the line passes the part's ball, and `own` is known
    union {
      Ray own;  ///< in the space of the part's shape
    };
    double from, to;  ///< empty where there is none beyond t_min
    bool has(double t) const { return t >= from && t <= to; }
  };
  const Ray& ray;
  double t_min;
  std::array<Stretch, kMost> in;

  Line(const Ray& the_ray, double from) : ray(the_ray), t_min(from) {}

  /// Whether two crossings beyond t_min may count as one, of those in the passage through the core.
  bool has_pairs(std::size_t parts, const Passage& passage) const {
    std::array<double, 2 * kMost> at;
    std::size_t count = 0;
    for (std::size_t i = 0; i < parts; ++i) {
      for (int k = 0; k < in[i].count; ++k) {
        const double t = in[i].found[k].t;
        if (!(t > t_min) || !passage.has(t)) continue;
        const double near = 2.0 * kCoincide * distances(ray, t);
        for (std::size_t m = 0; m < count; ++m) {
          if (std::fabs(at[m] - t) < near) return true;
        }
        at[count++] = t;
      }
    }
    return false;
  }

  /// Whether the part holds the place at t, where `p` is. Places on its own line are as near to `p` as rounding.
  Answer holds(const Part& part, const Stretch& stretch, double t, const Vec3& p) const {
    return stretch.is_asked ? part.holds_own(stretch.own.at(t)) : part.holds(p);
  }

  void meet(const Part& part, Stretch& stretch) const {
    stretch.count = 0;
    stretch.from = Bounds::kInf;
    stretch.to = -Bounds::kInf;
    stretch.is_asked = !part.leaf->ball().is_missed_by(ray);
    if (!stretch.is_asked) return;
    std::construct_at(&stretch.own, part.move ? Ray{part.move->inverse_point(ray.origin),
                                                    part.move->inverse_vector(ray.direction)}
                                              : ray);
    stretch.count = part.shape.crossings(stretch.own, t_min, stretch.found);
    if (stretch.count == 0) return;
    stretch.from = stretch.found[0].t;
    stretch.to = stretch.found[stretch.count - 1].t;
    if (!part.shape.is_half_space()) return;
    (part.shape.is_entered_along(ray.direction) ? stretch.to : stretch.from) =
        part.shape.is_entered_along(ray.direction) ? Bounds::kInf : -Bounds::kInf;
  }
};

std::unique_ptr<const ConvexParts> ConvexParts::of(const Children& children, std::size_t core,
                                                   bool pairs_count) {
  if (children.size() > kMost) return nullptr;
  std::vector<std::size_t> order{core};
  for (std::size_t i = children.size(); i-- > 0;) {
    if (i != core) order.push_back(i);
  }
  std::vector<Placement> placements;
  double reach = 0.0;
  for (const std::size_t i : order) {
    if (typeid(*children[i]) != typeid(Leaf)) return nullptr;
    const auto& leaf = static_cast<const Leaf&>(*children[i]);
    if (!leaf.clips().empty() || !Convex::holds(leaf.shape())) return nullptr;
    const auto placement = placement_of(leaf);
    if (!placement) return nullptr;
    placements.push_back(*placement);
    reach += placement->reach;
  }
  std::vector<Part> parts;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& leaf = static_cast<const Leaf&>(*children[order[k]]);
    parts.push_back({&leaf, leaf.transform(),
                     Convex(leaf.shape(), kMargin * reach * placements[k].growth),
                     leaf.is_inverse()});
  }
  return std::unique_ptr<const ConvexParts>(new ConvexParts(std::move(parts), reach, pairs_count));
}

/// Whether the part's crossing at t is in all others. The stretches say which of them to ask; the point decides.
Answer ConvexParts::keeps(const Line& line, std::size_t part, double t) const {
  const Vec3 p = line.ray.at(t);
  bool seems_kept = true;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (i == part || line.in[i].has(t) != m_parts[i].is_inverse) continue;
    if (line.holds(m_parts[i], line.in[i], t, p) == Answer::kNo) return Answer::kNo;
    seems_kept = false;
  }
  if (!seems_kept) return Answer::kUnclear;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    if (i == part) continue;
    const Answer answer = line.holds(m_parts[i], line.in[i], t, p);
    if (answer != Answer::kYes) return answer;
  }
  return Answer::kYes;
}

/// Calls visit(leaf, crossing, answer) for the crossings in the range that are kept or may be, until it answers
/// true; `limit`, t_max at first, may be lowered meanwhile. With `first_alone` the nearest may be the only one.
/// False: these parts cannot tell.
template <class Visit>
bool ConvexParts::for_crossings(const Ray& ray, double t_min, const double& limit, bool first_alone,
                                Visit&& visit) const {
  if (!(sum_of_sizes(ray.origin) < kFarthestOrigin * m_reach)) return false;
  Line line(ray, t_min);
  const Part& core = m_parts[0];
  line.meet(core, line.in[0]);
  const Line::Stretch& whole = line.in[0];
  int before = 0;
  while (before < whole.count && !(whole.found[before].t > t_min)) ++before;
  if (before == whole.count) return true;
  const Passage passage(ray, t_min, whole.found[before].t, whole.to, whole.count - before > 1);
  if (!(passage.from < limit)) return true;
  // What lies in all others where the core is entered is the first of all.
  if (first_alone && whole.count - before > 1 && whole.found[before].t < limit) {
    const Vec3 p = ray.at(whole.found[before].t);
    const auto holds = [&](const Part& part) { return part.holds(p) == Answer::kYes; };
    if (std::all_of(m_parts.begin() + 1, m_parts.end(), holds)) {
      visit(*core.leaf, whole.found[before], Answer::kYes);
      return true;
    }
  }
  for (std::size_t i = 1; i < m_parts.size(); ++i) line.meet(m_parts[i], line.in[i]);
  if (m_pairs_count && line.has_pairs(m_parts.size(), passage)) return false;
  for (std::size_t i = 0; i < m_parts.size(); ++i) {
    for (int k = 0; k < line.in[i].count; ++k) {
      const Crossing& found = line.in[i].found[k];
      if (!(found.t > t_min && found.t < limit) || (i > 0 && !passage.has(found.t))) continue;
      const Answer answer = keeps(line, i, found.t);
      if (answer != Answer::kNo && visit(*m_parts[i].leaf, found, answer)) return true;
    }
  }
  return true;
}

Answer ConvexParts::nearest(const Ray& ray, double t_min, double t_max, Hit& hit) const {
  const Leaf* owner = nullptr;
  Crossing best{};
  double limit = t_max, unclear = Bounds::kInf;
  const bool can_tell = for_crossings(ray, t_min, limit, true,
                                      [&](const Leaf& leaf, const Crossing& found, Answer answer) {
                                        if (answer == Answer::kUnclear) {
                                          unclear = std::min(unclear, found.t);
                                        } else {
                                          owner = &leaf;
                                          best = found;
                                          limit = found.t;
                                        }
                                        return false;
                                      });
  if (!can_tell || (unclear < Bounds::kInf && unclear <= limit)) return Answer::kUnclear;
  if (!owner) return Answer::kNo;
  hit = hit_of(*owner, best);
  return Answer::kYes;
}

Answer ConvexParts::any(const Ray& ray, double t_min, double t_max) const {
  Answer found = Answer::kNo;
  const bool can_tell =
      for_crossings(ray, t_min, t_max, true, [&](const Leaf&, const Crossing&, Answer answer) {
        found = answer;
        return answer == Answer::kYes;
      });
  return can_tell ? found : Answer::kUnclear;
}

bool ConvexParts::all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits) const {
  const std::size_t before = hits.size();
  bool is_clear = true;
  const bool can_tell = for_crossings(ray, t_min, t_max, false,
                                      [&](const Leaf& leaf, const Crossing& found, Answer answer) {
                                        hits.push_back(hit_of(leaf, found));
                                        is_clear = answer == Answer::kYes;
                                        return !is_clear;
                                      });
  if (can_tell && is_clear) return true;
  hits.resize(before);
  return false;
}

}  // namespace lentray::core
