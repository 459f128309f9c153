#include "core/accel/hierarchy.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "core/accel/bundle_tree.h"
#include "core/accel/nearest_rule.h"
#include "core/accel/object_tree.h"
#include "core/numeric/box_ray.h"
#include "core/object/leaf.h"

namespace lentray::core {
namespace {

enum Flag : std::uint8_t {
  kNoImage = 1,
  kNoReflection = 2,
  kNoShadow = 4,
  kTransparent = 8,
  kNear = 16,
  kNoRadiosity = 32
};

std::uint8_t flags_of(const Object& object) {
  const Attributes& a = object.attributes();
  return static_cast<std::uint8_t>(
      (a.no_image ? kNoImage : 0) | (a.no_reflection ? kNoReflection : 0) |
      (a.no_radiosity ? kNoRadiosity : 0) | (a.no_shadow ? kNoShadow : 0) |
      (object.is_opaque() ? 0 : kTransparent) | (is_seen_afar(object) ? 0 : kNear));
}

constexpr std::uint8_t unseen_by(RayKind kind) {
  switch (kind) {
    case RayKind::kCamera:
    case RayKind::kTransmitted: return kNoImage;
    case RayKind::kReflection: return kNoReflection;
    case RayKind::kGather: return kNoRadiosity;
    case RayKind::kGatherTransmitted: return kNoRadiosity | kNoImage;
    case RayKind::kGatherReflection: return kNoRadiosity | kNoReflection;
    case RayKind::kPhoton: return kNoShadow | kNoImage;
    case RayKind::kPhotonReflection: return kNoShadow | kNoReflection;
    case RayKind::kShadow: return kNoShadow;
  }
  return 0;
}

bool has_nan(const Bounds& b) {
  const auto any = [](const Vec3& v) {
    return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z);
  };
  return any(b.lo) || any(b.hi);
}

constexpr std::size_t kMaxTypes = 64;  // more kinds of objects than SDL has

/// What a query counts; the other policy is empty and costs nothing.
struct Tally : CountBoxes {
  std::array<std::uint32_t, kMaxTypes> tests{};
  void test(std::uint8_t type, std::uint32_t n = 1) { tests[type] += n; }
};
struct NoTally : CountNothing {
  void test(std::uint8_t, std::uint32_t = 1) {}
};

/// Nearest hit so far; core/accel/nearest_rule.h.
struct Best {
  double t;
  const ObjectEntry* entry = nullptr;
  bool from_pack = false;
  double u, v;         ///< if so
  double asked_below;  ///< else: the reach when it was found

  explicit Best(double limit) : t(limit) {}
  /// Below which hits count: equal distances are found, but the limit itself is out of reach.
  double reach() const { return entry ? next_up(t) : t; }
};

template <class T>
struct NearestSearch {
  const Ray& ray;
  double t_min;
  std::uint8_t unseen;  ///< objects with one of these flags are passed by; 0 if there are none
  Hit& hit;
  RayQuery query;
  T& tally;
  Best best;

  double limit() const { return best.t; }
  bool beats(double t, const ObjectEntry& e) const {
    return t < best.t || (t == best.t && best.entry && wins_tie(e, *best.entry, ray));
  }
  bool object(const ObjectEntry& e) {
    if (e.flags & unseen) return false;
    tally.test(e.type);
    const double reach = best.reach();
    if (!e.object->nearest(ray, t_min, reach, hit, query)) return false;
    if (!beats(hit.t, e)) {
      find_again();
      return false;
    }
    best.t = hit.t;
    best.entry = &e;
    best.from_pack = false;
    best.asked_below = reach;
    return false;
  }
  /// The best one's hit, over which another was written: the same question has the same answer.
  [[gnu::noinline, gnu::cold]] void find_again() {
    if (!best.entry || best.from_pack) return;
    best.entry->object->nearest(ray, t_min, best.asked_below, hit, query);
  }
  bool lanes(unsigned mask, const PackHits& hits, const ObjectEntry* entries) {
    for (; mask != 0; mask &= mask - 1) {
      const int i = std::countr_zero(mask);
      const ObjectEntry& e = entries[i];
      if ((e.flags & unseen) || !beats(hits.t[i], e)) continue;
      take(e, hits.t[i], hits.u[i], hits.v[i]);
    }
    return false;
  }
  bool plane(double t, const ObjectEntry& e) {
    if (!(e.flags & unseen)) take(e, t, 0.0, 0.0);
    return false;
  }
  void take(const ObjectEntry& e, double t, double u, double v) {
    best.t = t;
    best.entry = &e;
    best.from_pack = true;
    best.u = u;
    best.v = v;
  }
  bool finish() {
    if (!best.entry) return false;
    if (best.from_pack) {
      hit.t = best.t;
      hit.leaf = static_cast<const Leaf*>(best.entry->object);
      hit.shape = {best.t, 0, best.u, best.v};
    }
    hit.object = best.entry->object;
    return true;
  }
};

template <class T>
struct AnySearch {
  const Ray& ray;
  double t_min, t_max;
  HitLists& lists;
  T& tally;
  const Object* found = nullptr;

  double limit() const { return t_max; }
  bool object(const ObjectEntry& e) {
    tally.test(e.type);
    if (!e.object->any(ray, t_min, t_max, {lists, RayKind::kShadow})) return false;
    found = e.object;
    return true;
  }
  bool lanes(unsigned mask, const PackHits& hits, const ObjectEntry* entries) {
    for (; mask != 0; mask &= mask - 1) {
      const int i = std::countr_zero(mask);
      if (hits.t[i] == t_max) continue;  // lanes include the limit
      found = entries[i].object;
      return true;
    }
    return false;
  }
  bool plane(double, const ObjectEntry& e) {
    found = e.object;
    return true;
  }
};

template <class T>
struct AllSearch {
  const Ray& ray;
  double t_min, t_max;
  bool nearest;  ///< of each object alone
  std::vector<Hit>& hits;
  HitLists& lists;
  T& tally;

  bool object(const ObjectEntry& e) {
    tally.test(e.type);
    const std::size_t before = hits.size();
    add_hits(*e.object, ray, t_min, t_max, nearest, hits, {lists, RayKind::kShadow});
    for (std::size_t i = before; i < hits.size(); ++i) {
      hits[i].object = e.object;
      hits[i].place = e.index;
    }
    return false;
  }
};

}  // namespace

[[gnu::noinline, gnu::cold]] bool wins_tie(const ObjectEntry& e, const ObjectEntry& over,
                                           const Ray& ray) {
  // As floats: by how much bounds are larger than what they hold does not count.
  const auto enters = static_cast<float>(entry_distance(e.object->bounds(), ray));
  const auto other = static_cast<float>(entry_distance(over.object->bounds(), ray));
  return enters < other || (enters == other && e.index < over.index);
}

struct Hierarchy::Impl {
  Impl(const std::vector<std::unique_ptr<Object>>& objects, Accelerator accelerator, bool portable);

  std::vector<std::string> types;
  std::uint8_t any_flags = 0;  ///< of any object
  std::uint32_t
      listed;  ///< objects of the scene; ObjectEntry::index of finite ones counts on from there
  std::size_t infinite = 0;
  Bounds bounds;
  std::optional<ObjectTree> all;
  // For shadow rays, where some objects cast no shadow or a filtered one: opaque casters alone,
  // and the others.
  std::optional<ObjectTree> opaque, filters;
  std::optional<BundleTree> bundles;  ///< of `all`; none: they do not pay

  double reach = 0.0;  ///< the farthest coordinate of any finite object

  const ObjectTree& opaque_casters() const { return opaque ? *opaque : *all; }

  /// Whether anything finite is farther than kFarthest from the ray's origin; sometimes wrongly true.
  bool may_see_afar(const Ray& ray) const {
    const Vec3& o = ray.origin;
    return 2.0 * (reach + std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z)) > kFarthest;
  }
  template <class T>
  [[gnu::always_inline]] bool nearest(const Ray& ray, double t_min, double t_max, RayKind kind,
                                      Hit& hit, HitLists& lists, T& tally) const {
    NearestSearch<T> what{ray,
                          t_min,
                          static_cast<std::uint8_t>(unseen_by(kind) & any_flags),
                          hit,
                          {lists, kind},
                          tally,
                          Best(std::min(t_max, kFarthest))};
    all->search<true>(what);
    if (!what.best.entry && t_max > kFarthest && may_see_afar(ray)) {
      what.best = Best(t_max);
      what.unseen |= kNear;
      all->search<true>(what);
    }
    return what.finish();
  }
  template <class T>
  const Object* any_opaque(const Ray& ray, double t_min, double t_max, HitLists& lists,
                           T& tally) const {
    AnySearch<T> what{ray, t_min, t_max, lists, tally};
    opaque_casters().template search<false>(what);
    return what.found;
  }
  template <class T>
  void all_transparent(const Ray& ray, double t_min, double t_max, bool nearest,
                       std::vector<Hit>& hits, HitLists& lists, T& tally) const {
    AllSearch<T> what{ray, t_min, t_max, nearest, hits, lists, tally};
    filters->search_objects(what, t_max);
  }
  template <class Query>
  auto counted(Counters& counters, Query&& query) const;

 private:
  void flush(const Tally& tally, Counters& counters) const;
  std::uint8_t type_of(const Object& object);
};

void Hierarchy::Impl::flush(const Tally& tally, Counters& counters) const {
  counters.bounds_tests += tally.boxes;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (tally.tests[i] != 0) counters.add_tests(types[i], tally.tests[i]);
  }
}

std::uint8_t Hierarchy::Impl::type_of(const Object& object) {
  std::string_view name = object.name();
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (types[i] == name) return static_cast<std::uint8_t>(i);
  }
  if (types.size() == kMaxTypes) return kMaxTypes - 1;
  if (types.size() + 1 == kMaxTypes) name = "other";
  types.emplace_back(name);
  return static_cast<std::uint8_t>(types.size() - 1);
}

Hierarchy::Impl::Impl(const std::vector<std::unique_ptr<Object>>& objects, Accelerator accelerator,
                      bool portable)
    : listed(static_cast<std::uint32_t>(objects.size())) {
  ObjectList list;
  list.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = *objects[i];
    const Bounds box = object.bounds();
    ObjectEntry entry{&object, static_cast<std::uint32_t>(i), flags_of(object), type_of(object)};
    if (!box.is_empty()) {
      bounds.include(box);
    } else if (!has_nan(box)) {
      continue;  // nothing hits it
    }
    // Of equal distances infinite objects win: a floor over a box that ends there.
    if (!box.is_finite()) {
      ++infinite;
    } else {
      entry.index += listed;
      for (int axis = 0; axis < 3; ++axis) {
        reach = std::max({reach, std::fabs(box.lo[axis]), std::fabs(box.hi[axis])});
      }
    }
    any_flags |= entry.flags;
    list.add(entry, box);
  }
  if ((any_flags & (kNoShadow | kTransparent)) != 0) {
    ObjectList casters, filtering;
    casters.reserve(list.entries.size());
    for (std::size_t i = 0; i < list.entries.size(); ++i) {
      const ObjectEntry& entry = list.entries[i];
      if (entry.flags & kNoShadow) continue;
      (entry.flags & kTransparent ? filtering : casters).add(entry, list.boxes[i]);
    }
    opaque.emplace(std::move(casters), accelerator, portable);
    filters.emplace(std::move(filtering), accelerator, portable);
  }
  all.emplace(std::move(list), accelerator, portable);
  if (!bundles.emplace(*all).works()) bundles.reset();
}

Hierarchy::Hierarchy(const std::vector<std::unique_ptr<Object>>& objects, Accelerator accelerator,
                     bool portable)
    : m_impl(std::make_unique<Impl>(objects, accelerator, portable)) {}

Hierarchy::~Hierarchy() = default;

/// Apart from the searches that do not count, which are the most: the tally is large.
template <class Query>
[[gnu::noinline]] auto Hierarchy::Impl::counted(Counters& counters, Query&& query) const {
  Tally tally;
  const auto found = query(tally);
  flush(tally, counters);
  return found;
}

bool Hierarchy::nearest(const Ray& ray, double t_min, double t_max, RayKind kind, Hit& hit,
                        HitLists& lists, Counters* counters) const {
  if (counters) {
    return m_impl->counted(*counters, [&](Tally& tally) {
      return m_impl->nearest(ray, t_min, t_max, kind, hit, lists, tally);
    });
  }
  NoTally none;
  return m_impl->nearest(ray, t_min, t_max, kind, hit, lists, none);
}

bool Hierarchy::takes_bundles() const { return m_impl->bundles.has_value(); }

bool Hierarchy::nearest(const RayBundle& rays, double t_min, RayKind kind, BundleHits& hits,
                        HitLists& lists) const {
  const BundleTree::Query query{t_min,
                                kFarthest,
                                static_cast<std::uint8_t>(unseen_by(kind) & m_impl->any_flags),
                                {lists, kind}};
  if (!m_impl->bundles->nearest(rays, query, hits)) return false;
  for (int i = 0; i < rays.count(); ++i) {
    BundleHits::Answer& answer = hits.answer[static_cast<std::size_t>(i)];
    if (answer == BundleHits::Answer::kMissed && m_impl->may_see_afar(rays.ray(i))) {
      answer = BundleHits::Answer::kUnknown;
    }
  }
  return true;
}

const Object* Hierarchy::any_opaque(const Ray& ray, double t_min, double t_max, HitLists& lists,
                                    Counters* counters) const {
  if (counters) {
    return m_impl->counted(*counters, [&](Tally& tally) {
      return m_impl->any_opaque(ray, t_min, t_max, lists, tally);
    });
  }
  NoTally none;
  return m_impl->any_opaque(ray, t_min, t_max, lists, none);
}

bool Hierarchy::only_opaque(const RayBundle& rays, double t_min, const Object*& object) const {
  return m_impl->bundles->only_one(rays, t_min, kNoShadow | kTransparent, object);
}

void Hierarchy::all_transparent(const Ray& ray, double t_min, double t_max, bool nearest,
                                std::vector<Hit>& hits, HitLists& lists, Counters* counters) const {
  if (!m_impl->filters || m_impl->filters->empty()) return;
  if (counters) {
    m_impl->counted(*counters, [&](Tally& tally) {
      m_impl->all_transparent(ray, t_min, t_max, nearest, hits, lists, tally);
      return true;
    });
    return;
  }
  NoTally none;
  m_impl->all_transparent(ray, t_min, t_max, nearest, hits, lists, none);
}

void Hierarchy::containing(const Vec3& p, std::vector<const Object*>& out) const {
  out.clear();
  std::vector<const ObjectEntry*> found;  // no memory unless there are any
  m_impl->all->at_point(p, [&](const ObjectEntry& e) {
    const Bounds box = e.object->solid_bounds();
    if (!box.contains(p)) return;
    if (!box.is_finite()) {
      const Bounds surface = e.object->bounds();
      if (surface.is_finite() && !surface.contains(p)) return;
    }
    if (e.object->inside(p)) found.push_back(&e);
  });
  const auto place = [n = m_impl->listed](const ObjectEntry* e) { return e->index % n; };
  std::sort(found.begin(), found.end(),
            [&place](const ObjectEntry* a, const ObjectEntry* b) { return place(a) < place(b); });
  for (const ObjectEntry* e : found) out.push_back(e->object);
}

const Bounds& Hierarchy::bounds() const { return m_impl->bounds; }

bool Hierarchy::has_infinite() const { return m_impl->infinite > 0; }

std::size_t Hierarchy::memory() const {
  std::size_t bytes = sizeof(Impl) + m_impl->all->memory();
  if (m_impl->bundles) bytes += m_impl->bundles->memory();
  if (m_impl->opaque) bytes += m_impl->opaque->memory() + m_impl->filters->memory();
  return bytes;
}

Hierarchy::Statistics Hierarchy::statistics() const {
  const WideBvh::Statistics& s = m_impl->all->tree().statistics();
  const UniformGrid& grid = m_impl->all->grid();
  return {s.nodes, s.leaves,     m_impl->all->objects(), m_impl->infinite,
          s.depth, grid.cells(), grid.entries()};
}

}  // namespace lentray::core
