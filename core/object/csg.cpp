#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/numeric/box_ray.h"
#include "core/object/csg_convex.h"
#include "core/object/csg_rounding.h"
#include "core/object/csg_search.h"

namespace lentray::core {
namespace {

std::string_view keyword(CsgKind kind) {
  switch (kind) {
    case CsgKind::kUnion: return "union";
    case CsgKind::kIntersection: return "intersection";
    case CsgKind::kDifference: return "difference";
    default: return "merge";
  }
}

/// One of the lists, from when it is asked for first for as long as it is needed.
class ScratchHits {
 public:
  explicit ScratchHits(HitLists& lists) : m_lists(lists) {}
  ~ScratchHits() {
    if (m_list) m_lists.release();
  }
  ScratchHits(const ScratchHits&) = delete;
  ScratchHits& operator=(const ScratchHits&) = delete;
  std::vector<Hit>& operator*() {
    if (!m_list) m_list = &m_lists.acquire();
    return *m_list;
  }

 private:
  HitLists& m_lists;
  std::vector<Hit>* m_list = nullptr;
};

}  // namespace

/// Where a ray is in the core, and what it meets of it.
struct Csg::Chord : Passage {
  const std::vector<Hit>& hits;  ///< all beyond t_min
};

/// Between which t of a ray many convex parts overlap: where it has entered the last of them and not left
/// the first.
struct Csg::Overlap {
  double enter[2] = {-Bounds::kInf, -Bounds::kInf};  ///< the two last, and of whom the last is
  double leave[2] = {Bounds::kInf, Bounds::kInf};    ///< the two first, likewise
  std::size_t enterer = kNobody, leaver = kNobody;

  void add(std::size_t part, double from, double to) {
    if (from > enter[0]) {
      enter[1] = std::exchange(enter[0], from);
      enterer = part;
    } else {
      enter[1] = std::max(enter[1], from);
    }
    if (to < leave[0]) {
      leave[1] = std::exchange(leave[0], to);
      leaver = part;
    } else {
      leave[1] = std::min(leave[1], to);
    }
  }
  bool is_empty(double slack) const { return enter[0] - slack > leave[0] + slack; }
  bool may_hold(double t, double slack) const {
    return t >= enter[0] - slack && t <= leave[0] + slack;
  }
  /// Whether all others hold the part's surface there.
  bool surely_holds(std::size_t part, double t, double slack) const {
    return t > enter[part == enterer] + slack && t < leave[part == leaver] - slack;
  }
};

Csg::Csg(CsgKind kind, std::vector<std::unique_ptr<Object>> children)
    : m_kind(kind), m_name(keyword(kind)), m_children(std::move(children)) {
  if (kind == CsgKind::kDifference) {
    for (std::size_t i = 1; i < m_children.size(); ++i) {
      m_children[i]->set_inverse(!m_children[i]->is_inverse());
    }
  }
  fence_children();
}

Csg::~Csg() = default;

std::string_view Csg::name() const { return m_name; }

void Csg::set_inverse(bool inverse) {
  if (inverse == is_inverse()) return;
  Object::set_inverse(inverse);
  for (auto& child : m_children) child->set_inverse(!child->is_inverse());
  m_kind = joins(m_kind) ? CsgKind::kIntersection : CsgKind::kMerge;
  fence_children();
}

/// Parts of unions and merges go by their own flags, those of other CSG by the whole's, and so do parts of a union
/// for rays straight from the camera.
bool Csg::is_unseen(std::size_t child, RayKind kind) const {
  if (!joins(m_kind)) return false;
  const Attributes& attributes = m_children[child]->attributes();
  switch (kind) {
    case RayKind::kCamera: return attributes.no_image && m_kind == CsgKind::kMerge;
    case RayKind::kTransmitted:
    case RayKind::kPhoton: return attributes.no_image;
    case RayKind::kPhotonReflection:
    case RayKind::kReflection: return attributes.no_reflection;
    case RayKind::kGather: return attributes.no_radiosity;
    case RayKind::kGatherTransmitted: return attributes.no_radiosity || attributes.no_image;
    case RayKind::kGatherReflection: return attributes.no_radiosity || attributes.no_reflection;
    case RayKind::kShadow: break;
  }
  return false;
}

void Csg::leaves(std::vector<const Leaf*>& out) const {
  for (const auto& child : m_children) child->leaves(out);
}

bool Csg::child_inside(std::size_t child, const Vec3& p) const {
  const Fence& fence = m_fences[child];
  return fence.decide.contains(p) ? m_children[child]->inside(p) : fence.beyond;
}

bool Csg::any_inside(const Vec3& p, std::size_t except) const {
  if (!m_search) {
    for (std::size_t i = 0; i < m_children.size(); ++i) {
      if (i != except && child_inside(i, p)) return true;
    }
    return false;
  }
  const Search& search = *m_search;
  for (const std::uint32_t i : search.open_solids) {
    if (i != except && m_children[i]->inside(p)) return true;
  }
  std::size_t beyond = search.in_beyond;  // of those whose box p turns out to be outside of
  if (except < m_fences.size() && m_fences[except].beyond && !m_fences[except].decide.contains(p))
    --beyond;
  const bool found = search.solids.at_point(p, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t place = first; place < first + count; ++place) {
      const std::uint32_t i = search.solids.order()[place];
      if (!m_fences[i].decide.contains(p)) continue;
      if (m_fences[i].beyond) --beyond;
      if (i != except && m_children[i]->inside(p)) return true;
    }
    return false;
  });
  return found || beyond > 0;
}

bool Csg::every_inside(const Vec3& p, std::size_t except) const {
  if (!m_search) {
    for (std::size_t i = 0; i < m_children.size(); ++i) {
      if (i != except && !child_inside(i, p)) return false;
    }
    return true;
  }
  const Search& search = *m_search;
  for (const std::uint32_t i : search.open_solids) {
    if (i != except && !m_children[i]->inside(p)) return false;
  }
  std::size_t beyond = search.out_beyond;
  if (except < m_fences.size() && !m_fences[except].beyond) {
    const Bounds& decide = m_fences[except].decide;
    if (decide.is_empty() || (decide.is_finite() && !decide.contains(p))) --beyond;
  }
  const bool missing = search.solids.at_point(p, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t place = first; place < first + count; ++place) {
      const std::uint32_t i = search.solids.order()[place];
      if (!m_fences[i].decide.contains(p)) continue;
      if (!m_fences[i].beyond) --beyond;
      if (i != except && !m_children[i]->inside(p)) return true;
    }
    return false;
  });
  return !missing && beyond == 0;
}

bool Csg::inside(const Vec3& p) const {
  if (!clips().empty() && !passes_clips(p)) return false;
  return joins(m_kind) ? any_inside(p, kNobody) : every_inside(p, kNobody);
}

bool Csg::hides_parts() const {
  for (std::size_t i = 0; i < m_children.size(); ++i) {
    if (is_unseen(i, RayKind::kTransmitted) || is_unseen(i, RayKind::kReflection) ||
        is_unseen(i, RayKind::kGather)) {
      return true;
    }
  }
  return false;
}

[[gnu::noinline, gnu::cold]] bool Csg::any_seen_inside(const Vec3& p, std::size_t except,
                                                       RayKind kind) const {
  for (std::size_t i = 0; i < m_children.size(); ++i) {
    if (i != except && !is_unseen(i, kind) && m_children[i]->inside(p)) return true;
  }
  return false;
}

/// Hits of one ray that siblings seem to hide. Where surfaces coincide roundings say which is within the other,
/// and each may seem to hide the other.
struct Csg::Hidden {
  std::array<double, 8> at;
  unsigned count = 0;

  /// Whether there was one at the same t; it is remembered for the next.
  bool again(const Ray& ray, double t) {
    const double near = kCoincide * distances(ray, t);
    const unsigned known = std::min<unsigned>(count, at.size());
    for (unsigned i = 0; i < known; ++i) {
      if (std::fabs(at[i] - t) < near) return true;
    }
    at[count++ % at.size()] = t;
    return false;
  }
};

/// Whether the whole does so at the ray's t: then it has a surface there, whatever the parts hide.
[[gnu::noinline, gnu::cold]] bool Csg::begins_or_ends(const Ray& ray, double t) const {
  const double past = kCoincide * distances(ray, t);
  const Vec3 before = ray.at(t - past), behind = ray.at(t + past);
  return joins(m_kind) ? any_inside(before, kNobody) != any_inside(behind, kNobody)
                       : every_inside(before, kNobody) != every_inside(behind, kNobody);
}

/// Whether the child's surface at the ray's t belongs to the whole's, as far as the ray sees it.
template <bool kHides>
[[gnu::always_inline]] inline bool Csg::keeps(std::size_t child, const Ray& ray, double t,
                                              const Chord* chord, Hidden& hidden,
                                              const RayQuery& query) const {
  if (m_kind == CsgKind::kUnion) return true;
  if (kHides) return !any_seen_inside(ray.at(t), child, query.kind);
  if (m_kind == CsgKind::kMerge) {
    if (!any_inside(ray.at(t), child)) return true;
  } else {
    if ((!chord || chord->has(t)) && every_inside(ray.at(t), child)) return true;
    if (m_kind == CsgKind::kDifference) return false;
  }
  return hidden.again(ray, t) && begins_or_ends(ray, t);
}

/// Those whose box the ray meets, the core and then the last child first where they are few; visit may
/// lower t_max, and answers true to end. `chord` is null where nothing is known.
template <bool kHides, class Visit>
void Csg::for_children_met(const Ray& ray, double t_min, double t_max, const RayQuery& query,
                           Visit&& visit) const {
  if constexpr (kHides) {
    return for_boxes_met(ray, t_min, t_max, [&](std::size_t i, double& limit, const Chord* chord) {
      return !is_unseen(i, query.kind) && visit(i, limit, chord);
    });
  }
  if (m_core != kNobody) {
    const Object& core = *m_children[m_core];
    ScratchHits scratch(query.lists);
    std::vector<Hit>& found = *scratch;
    core.all(ray, t_min, Bounds::kInf, found, query);
    if (found.empty()) return;  // nowhere beyond t_min
    const auto [first, last] = std::minmax_element(
        found.begin(), found.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
    const bool is_whole = found.size() > 1 && core.convexity() == Convexity::kConvex;
    const Chord chord{{ray, t_min, first->t, last->t, is_whole}, found};
    if (!(chord.from < t_max) || visit(m_core, t_max, &chord)) return;
    for (std::size_t i = m_children.size(); i-- > 0;) {
      if (i != m_core && visit(i, t_max, &chord)) return;
    }
    return;
  }
  for_boxes_met(ray, t_min, t_max, visit);
}

/// The same without a core.
template <class Visit>
void Csg::for_boxes_met(const Ray& ray, double t_min, double t_max, Visit&& visit) const {
  constexpr Chord* kNone = nullptr;
  // A gated part is seen beyond its box by rays that meet that, from their start on.
  const double boxes_from = std::min(t_min, 0.0);
  if (!m_search && !m_asks_boxes && ball().is_finite()) {
    // Who met the whole's ball meets most of the parts' boxes: their own tests are as quick.
    for (std::size_t i = m_children.size(); i-- > 0;) {
      if (visit(i, t_max, kNone)) return;
    }
    return;
  }
  if (!m_search) {
    const BoxRay box_ray(ray);
    for (std::size_t i = m_children.size(); i-- > 0;) {
      if (box_ray.meets(m_fences[i].surface, boxes_from, t_max) && visit(i, t_max, kNone)) return;
    }
    return;
  }
  const Search& search = *m_search;
  for (const std::uint32_t i : search.open_surfaces) {
    if (visit(i, t_max, kNone)) return;
  }
  search.surfaces.traverse(ray, boxes_from, t_max,
                           [&](std::uint32_t first, std::uint32_t count, double& limit) {
                             for (std::uint32_t place = first; place < first + count; ++place) {
                               if (visit(search.surfaces.order()[place], limit, kNone)) return true;
                             }
                             return false;
                           });
}

/// A child's, in the list that is given unless the chord has them; then some are beyond t_max.
[[gnu::always_inline]] inline const std::vector<Hit>& Csg::crossings(std::size_t i, const Ray& ray,
                                                                     double t_min, double t_max,
                                                                     const Chord* chord,
                                                                     std::vector<Hit>& list,
                                                                     const RayQuery& query) const {
  if (chord && i == m_core) return chord->hits;
  list.clear();
  m_children[i]->all(ray, t_min, t_max, list, query);
  return list;
}

/// Calls visit(child, hit) for the whole's crossings, some of them beyond t_max, until it answers true.
/// What lies clearly in all parts or beyond one of them, by more than rounding, needs no inside().
template <class Visit>
[[gnu::noinline]] void Csg::for_kept_of_overlap(const Ray& ray, double t_min, double t_max,
                                                const RayQuery& query, Visit&& visit) const {
  const double of_place = rounding_of_place(ray);
  Overlap overlap;
  double far = 0.0, slack = 0.0;
  ScratchHits scratch(query.lists);
  std::vector<Hit>& hits = *scratch;
  for (std::size_t i = 0; i < m_children.size(); ++i) {
    const std::size_t first = hits.size();
    m_children[i]->all(ray, t_min, Bounds::kInf, hits, query);
    if (hits.size() == first) return;  // nowhere beyond t_min
    double from = Bounds::kInf, to = -Bounds::kInf;
    for (std::size_t k = first; k < hits.size(); ++k) {
      hits[k].place = static_cast<std::uint32_t>(i);
      from = std::min(from, hits[k].t);
      to = std::max(to, hits[k].t);
    }
    far = std::max({far, std::fabs(from), std::fabs(to)});
    slack = 2.0 * kOfFar * far + of_place;
    overlap.add(i, hits.size() - first > 1 ? from : -Bounds::kInf, to);
    if (overlap.is_empty(slack) || overlap.enter[0] - slack > t_max) return;
  }
  Hidden hidden;
  for (Hit& hit : hits) {
    const std::size_t part = std::exchange(hit.place, 0);
    if (!overlap.may_hold(hit.t, slack)) continue;
    if (!overlap.surely_holds(part, hit.t, slack) &&
        !keeps<false>(part, ray, hit.t, nullptr, hidden, query)) {
      continue;
    }
    if (visit(part, hit)) return;
  }
}

bool Csg::nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                  const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return false;
  if (clips().empty()) return kept_nearest(ray, t_min, t_max, hit, query);
  Hit found;  // the caller's hit stays as it is unless there is one
  while (kept_nearest(ray, t_min, t_max, found, query)) {
    if (passes_clips(ray.at(found.t))) {
      hit = found;
      return true;
    }
    t_min = found.t;
  }
  return false;
}

/// Nearest before own clips. Where surfaces coincide the last child's counts.
bool Csg::kept_nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                       const RayQuery& query) const {
  if (m_way != Way::kParts) return special_nearest(ray, t_min, t_max, hit, query);
  return nearest_of_parts<false>(ray, t_min, t_max, hit, query);
}

[[gnu::noinline]] bool Csg::special_nearest(const Ray& ray, double t_min, double t_max, Hit& hit,
                                            const RayQuery& query) const {
  if (m_way == Way::kHidden) return nearest_of_parts<true>(ray, t_min, t_max, hit, query);
  if (m_way == Way::kConvex) {
    const Answer answer = m_convex->nearest(ray, t_min, t_max, hit);
    return answer == Answer::kUnclear ? nearest_of_parts<false>(ray, t_min, t_max, hit, query)
                                      : answer == Answer::kYes;
  }
  std::size_t owner = kNobody;
  for_kept_of_overlap(ray, t_min, t_max, query, [&](std::size_t part, const Hit& next) {
    if (!(next.t < t_max || (next.t == t_max && owner != kNobody && part > owner))) return false;
    hit = next;
    t_max = next.t;
    owner = part;
    return false;
  });
  return owner != kNobody;
}

template <bool kHides>
[[gnu::always_inline]] inline bool Csg::nearest_of_parts(const Ray& ray, double t_min, double t_max,
                                                         Hit& hit, const RayQuery& query) const {
  const bool keep_all = m_kind == CsgKind::kUnion;
  std::size_t owner = kNobody;
  Hidden hidden;
  ScratchHits scratch(query.lists);
  const auto visit = [&](std::size_t i, double& limit, const Chord* chord) {
    const bool wins_ties = owner != kNobody && i > owner;
    const double to = wins_ties ? std::nextafter(limit, Bounds::kInf) : limit;
    if (keep_all) {
      Hit next;
      if (!m_children[i]->nearest(ray, t_min, to, next, query)) return false;
      hit = next;
      limit = next.t;
      owner = i;
      return false;
    }
    double best = to;
    for (const Hit& next : crossings(i, ray, t_min, to, chord, *scratch, query)) {
      if (!(next.t < best) || !keeps<kHides>(i, ray, next.t, chord, hidden, query)) continue;
      hit = next;
      best = limit = next.t;
      owner = i;
    }
    return false;
  };
  for_children_met<kHides>(ray, t_min, t_max, query, visit);
  return owner != kNobody;
}

bool Csg::any(const Ray& ray, double t_min, double t_max, const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return false;
  if (m_way != Way::kParts) return special_any(ray, t_min, t_max, query);
  return any_of_parts<false>(ray, t_min, t_max, query);
}

[[gnu::noinline]] bool Csg::special_any(const Ray& ray, double t_min, double t_max,
                                        const RayQuery& query) const {
  if (m_way == Way::kHidden) return any_of_parts<true>(ray, t_min, t_max, query);
  if (m_way == Way::kConvex) {
    const Answer answer = clips().empty() ? m_convex->any(ray, t_min, t_max) : Answer::kUnclear;
    return answer == Answer::kUnclear ? any_of_parts<false>(ray, t_min, t_max, query)
                                      : answer == Answer::kYes;
  }
  bool found = false;
  for_kept_of_overlap(ray, t_min, t_max, query, [&](std::size_t, const Hit& h) {
    return found = h.t < t_max && passes_clips(ray.at(h.t));
  });
  return found;
}

template <bool kHides>
[[gnu::always_inline]] inline bool Csg::any_of_parts(const Ray& ray, double t_min, double t_max,
                                                     const RayQuery& query) const {
  const bool keep_all = m_kind == CsgKind::kUnion && clips().empty();
  bool found = false;
  Hidden hidden;
  ScratchHits scratch(query.lists);
  const auto visit = [&](std::size_t i, double&, const Chord* chord) {
    if (keep_all) return found = m_children[i]->any(ray, t_min, t_max, query);
    for (const Hit& h : crossings(i, ray, t_min, t_max, chord, *scratch, query)) {
      if (chord && !(h.t < t_max)) continue;
      if (keeps<kHides>(i, ray, h.t, chord, hidden, query) && passes_clips(ray.at(h.t)))
        return found = true;
    }
    return false;
  };
  for_children_met<kHides>(ray, t_min, t_max, query, visit);
  return found;
}

void Csg::all(const Ray& ray, double t_min, double t_max, std::vector<Hit>& hits,
              const RayQuery& query) const {
  if (ball().is_missed_by(ray)) return;
  if (m_way != Way::kParts) return special_all(ray, t_min, t_max, hits, query);
  all_of_parts<false>(ray, t_min, t_max, hits, query);
}

[[gnu::noinline]] void Csg::special_all(const Ray& ray, double t_min, double t_max,
                                        std::vector<Hit>& hits, const RayQuery& query) const {
  if (m_way == Way::kHidden) return all_of_parts<true>(ray, t_min, t_max, hits, query);
  if (m_way == Way::kConvex) {
    if (clips().empty() && m_convex->all(ray, t_min, t_max, hits)) return;
    return all_of_parts<false>(ray, t_min, t_max, hits, query);
  }
  for_kept_of_overlap(ray, t_min, t_max, query, [&](std::size_t, const Hit& h) {
    if (h.t < t_max && passes_clips(ray.at(h.t))) hits.push_back(h);
    return false;
  });
}

template <bool kHides>
[[gnu::always_inline]] inline void Csg::all_of_parts(const Ray& ray, double t_min, double t_max,
                                                     std::vector<Hit>& hits,
                                                     const RayQuery& query) const {
  Hidden hidden;
  const auto visit = [&](std::size_t i, double&, const Chord* chord) {
    // Where nothing can be dropped the child's hits need no list of their own.
    const std::size_t first = hits.size();
    m_children[i]->all(ray, t_min, t_max, hits, query);
    if (m_kind == CsgKind::kUnion && clips().empty()) return false;
    const auto drop = [&](const Hit& h) {
      return !keeps<kHides>(i, ray, h.t, chord, hidden, query) ||
             (!clips().empty() && !passes_clips(ray.at(h.t)));
    };
    hits.erase(std::remove_if(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), drop),
               hits.end());
    return false;
  };
  for_children_met<kHides>(ray, t_min, t_max, query, visit);
}

}  // namespace lentray::core
