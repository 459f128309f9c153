#include "core/accel/bundle_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <typeinfo>

#include "core/accel/nearest_rule.h"
#include "core/bundle/pack_lanes.h"
#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"

namespace lentray::core {
namespace {

/// Whether all that is seen of an object lies within its bounds: what does not is seen or not as the order of a
/// search has it.
bool keeps_within_bounds(const Object& object) {
  if (typeid(object) == typeid(Leaf)) return true;
  if (typeid(object) == typeid(Gated)) {
    const auto& gated = static_cast<const Gated&>(object);
    const Bounds box = gated.content().bounds();
    return (box.is_empty() || box.is_finite()) && keeps_within_bounds(gated.content());
  }
  if (typeid(object) != typeid(Csg)) return false;
  for (const auto& child : static_cast<const Csg&>(object).children()) {
    if (!keeps_within_bounds(*child)) return false;
  }
  return true;
}

/// Nodes that a bundle visits at most: with more than a few for each ray its rays do better alone.
int most_nodes(int rays) { return 16 + rays; }

}  // namespace

BundleTree::BundleTree(const ObjectTree& tree) : m_tree(tree) {
  const auto all_keep = [](const std::vector<ObjectEntry>& entries) {
    for (const ObjectEntry& e : entries) {
      if (!keeps_within_bounds(*e.object)) return false;
    }
    return true;
  };
  m_works =
      tree.m_avx2 && !tree.m_tree.empty() && all_keep(tree.m_entries) && all_keep(tree.m_unbounded);
  if (!m_works) return;
  m_boxes.reserve(tree.m_entries.size());
  for (const ObjectEntry& e : tree.m_entries) {
    m_boxes.emplace_back(e.object->bounds(), tree.m_tree.frame());
  }
}

class BundleTree::Search {
 public:
  Search(const BundleTree& in, const RayBundle& rays, const BundleHull& hull, const Query& query,
         BundleHits& hits)
      : m_in(in), m_tree(in.m_tree), m_rays(rays), m_hull(hull), m_query(query), m_hits(hits),
        m_has_triangles(!m_tree.m_triangles.empty()),
        m_reach(rays.groups(), hull.upper(query.t_max)) {
    for (int i = 0; i < RayBundle::kMost; ++i) {
      m_best[i] = query.t_max;
      m_entry[i] = nullptr;
      m_found_by[i] = nullptr;
      m_u[i] = m_v[i] = 0.0;
    }
  }

  LENTRAY_AVX2 bool run() {
    unbounded();
    if (m_hull.misses) return true;
    for (int g = 0; g < m_rays.groups(); ++g) shorten(g);
    m_reach.update();
    return walk_bundle(m_tree.m_tree, m_hull, m_reach, most_nodes(m_rays.count()), *this);
  }

  LENTRAY_AVX2 bool operator()(std::uint32_t code) {
    const std::uint32_t index = code & ObjectTree::kIndexMask;
    m_changed = false;
    switch (code >> ObjectTree::kKindShift) {
      case ObjectTree::kSpheres: pack(m_tree.m_spheres[index]); break;
      case ObjectTree::kTriangles: pack(m_tree.m_triangles[index]); break;
      case ObjectTree::kPolygons: pack(m_tree.m_polygons[index]); break;
      default: others(code); break;
    }
    if (m_changed) m_reach.update();
    return true;
  }

  void finish() {
    for (int i = 0; i < m_rays.count(); ++i) {
      const auto place = static_cast<std::size_t>(i);
      const ObjectEntry* entry = m_entry[i];
      m_hits.answer[place] = entry ? BundleHits::Answer::kMet : BundleHits::Answer::kMissed;
      if (!entry) continue;
      Hit& hit = m_hits.hit[place];
      if (m_found_by[i] != entry) {
        hit.t = m_best[i];
        hit.leaf = static_cast<const Leaf*>(entry->object);
        hit.shape = {m_best[i], 0, m_u[i], m_v[i]};
      }
      hit.object = entry->object;
    }
  }

 private:
  bool is_unseen(const ObjectEntry& e) const { return (e.flags & m_query.unseen) != 0; }

  template <class Pack>
  LENTRAY_AVX2 void pack(const Pack& pack) {
    for (std::uint32_t lane = 0; lane < pack.count; ++lane) {
      const ObjectEntry& e = m_tree.m_entries[pack.first + lane];
      if (is_unseen(e)) continue;
      unsigned groups = m_reach.groups_at(m_hull, m_in.m_boxes[pack.first + lane]);
      for (; groups != 0; groups &= groups - 1) {
        const int g = std::countr_zero(groups);
        bool closer = false;
        for (int half = 0; half < 2; ++half) {
          const int first = g * RayBundle::kGroup + 4 * half;
          const LaneHits hits =
              meet_lane(pack, static_cast<int>(lane), RayLanes(m_rays, first), m_query.t_min);
          closer |= take(hits, first, e);
        }
        if (closer) shorten(g);
      }
    }
  }

  LENTRAY_AVX2 void others(std::uint32_t code) {
    for (const ObjectEntry& e : m_tree.entries_of(code)) {
      if (is_unseen(e)) continue;
      const auto place = static_cast<std::size_t>(&e - m_tree.m_entries.data());
      unsigned groups = m_reach.groups_at(m_hull, m_in.m_boxes[place]);
      for (; groups != 0; groups &= groups - 1) {
        const int g = std::countr_zero(groups);
        if (object(e, g)) shorten(g);
      }
    }
  }

  /// Keeps hits that are nearer; true if there are any.
  LENTRAY_AVX2 bool take(const LaneHits& hits, int first, const ObjectEntry& e) {
    const Double4 best = simd::double4_at(m_best + first);
    const Long4 meet = hits.meet & (hits.t > simd::double4(m_query.t_min));
    const unsigned equal = simd::signs(meet & (hits.t == best));
    if (equal != 0) [[unlikely]]
      settle(equal, hits, first, e);
    const Long4 closer = meet & (hits.t < best);
    if (simd::signs(closer) == 0) return false;
    simd::store(m_best + first, simd::chosen(closer, hits.t, best));
    keep(closer, hits, first, e);
    return true;
  }
  LENTRAY_SIMD32 void keep(Long4 lanes, const LaneHits& hits, int first, const ObjectEntry& e) {
    const auto number = static_cast<long long>(reinterpret_cast<std::uintptr_t>(&e));
    auto* entries = reinterpret_cast<double*>(m_entry + first);
    simd::store(entries, simd::chosen(lanes, Double4(Long4{number, number, number, number}),
                                      simd::double4_at(entries)));
    if (!m_has_triangles) return;
    simd::store(m_u + first, simd::chosen(lanes, hits.u, simd::double4_at(m_u + first)));
    simd::store(m_v + first, simd::chosen(lanes, hits.v, simd::double4_at(m_v + first)));
  }
  [[gnu::noinline, gnu::cold]] LENTRAY_AVX2 void settle(unsigned equal, const LaneHits& hits,
                                                        int first, const ObjectEntry& e) {
    Long4 lanes{};
    for (int i = 0; i < 4; ++i) {
      const ObjectEntry* over = m_entry[first + i];
      if ((equal >> i & 1u) == 0 || !over || !wins_tie(e, *over, m_rays.ray(first + i))) continue;
      lanes[i] = -1;
    }
    keep(lanes, hits, first, e);
  }

  /// Asks an object for each ray of a group; true if one of them meets it first.
  bool object(const ObjectEntry& e, int group) {
    bool closer = false;
    const int first = group * RayBundle::kGroup;
    const int end = std::min(first + RayBundle::kGroup, m_rays.count());
    for (int i = first; i < end; ++i) {
      const Ray& ray = m_rays.ray(i);
      const double reach = m_entry[i] ? next_up(m_best[i]) : m_best[i];
      Hit hit;
      if (!e.object->nearest(ray, m_query.t_min, reach, hit, m_query.objects)) continue;
      if (!(hit.t < m_best[i]) &&
          !(hit.t == m_best[i] && m_entry[i] && wins_tie(e, *m_entry[i], ray))) {
        continue;
      }
      m_hits.hit[static_cast<std::size_t>(i)] = hit;
      m_best[i] = hit.t;
      m_entry[i] = m_found_by[i] = &e;
      closer = true;
    }
    if (closer) {
      for (int i = end; i < first + RayBundle::kGroup; ++i) m_best[i] = m_best[end - 1];
    }
    return closer;
  }

  /// The infinite objects: what ObjectTree::unbounded() does.
  LENTRAY_AVX2 void unbounded() {
    const auto& entries = m_tree.m_unbounded;
    for (std::size_t k = 0; k < m_tree.m_planes.size(); ++k) {
      const ObjectEntry& e = entries[k];
      if (is_unseen(e)) continue;
      const Vec3& n = m_tree.m_planes[k].normal;
      for (int first = 0; first < m_rays.groups() * RayBundle::kGroup; first += 4) {
        const RayLanes r(m_rays, first);
        const Double4 height = n.x * r.origin(0) + n.y * r.origin(1) + n.z * r.origin(2);
        const Double4 slope = n.x * r.direction(0) + n.y * r.direction(1) + n.z * r.direction(2);
        LaneHits hits{};
        hits.t = (m_tree.m_planes[k].distance - height) / slope;
        // Of planes at one distance the first has won.
        const Double4 best = simd::double4_at(m_best + first);
        const Long4 closer = (hits.t > simd::double4(m_query.t_min)) & (hits.t < best);
        if (simd::signs(closer) == 0) continue;
        simd::store(m_best + first, simd::chosen(closer, hits.t, best));
        keep(closer, hits, first, e);
      }
    }
    for (std::size_t k = m_tree.m_planes.size(); k < entries.size(); ++k) {
      if (is_unseen(entries[k])) continue;
      for (int g = 0; g < m_rays.groups(); ++g) object(entries[k], g);
    }
  }

  LENTRAY_AVX2 void shorten(int group) {
    const double* best = m_best + group * RayBundle::kGroup;
    const Double4 a = simd::max(simd::double4_at(best), simd::double4_at(best + 4));
    const Double4 b = simd::max(a, simd::shuffled<2, 3, 0, 1>(a));
    m_reach.set(group, m_hull.upper(std::max(b[0], b[1])));
    m_changed = true;
  }

  const BundleTree& m_in;
  const ObjectTree& m_tree;
  const RayBundle& m_rays;
  const BundleHull& m_hull;
  const Query& m_query;
  BundleHits& m_hits;  ///< of objects, as soon as they are found
  const bool m_has_triangles;
  BundleReach m_reach;
  bool m_changed = false;
  alignas(32) double m_best[RayBundle::kMost];
  alignas(32) double m_u[RayBundle::kMost], m_v[RayBundle::kMost];
  alignas(32) const ObjectEntry* m_entry[RayBundle::kMost];  ///< of the nearest hit; null: none yet
  const ObjectEntry* m_found_by[RayBundle::kMost];           ///< whose hit m_hits holds
};

namespace {

/// Whether a plane may be met between t_min and 1 by rays whose directions lie between two.
bool may_meet(const Vec3& normal, double distance, const RayBundle& rays, double t_min) {
  constexpr double kRounding = 1e-12, kBeyond = 1.0 + 1e-6;
  const Vec3& o = rays.ray(0).origin;
  const double sizes = std::fabs(distance) + std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z);
  const double height = distance - dot(normal, o);
  const double far = std::fabs(height) + kRounding * sizes;
  double least = 0.0, most = 0.0;  // of the slopes
  for (int a = 0; a < 3; ++a) {
    const double x = normal[a] * rays.ray(0).direction[a], y = normal[a] * rays.ray(1).direction[a];
    least += std::min(x, y);
    most += std::max(x, y);
  }
  const double steepest = std::max(std::fabs(least), std::fabs(most));
  if (std::fabs(height) - kRounding * sizes > kBeyond * steepest) return false;
  if (!(least > 0.0) && !(most < 0.0)) return true;
  const bool is_behind = (height < 0.0) == (least > 0.0) && std::fabs(height) > kRounding * sizes;
  return !is_behind && !(far < t_min * std::min(std::fabs(least), std::fabs(most)));
}

}  // namespace

/// The leaves of a walk.
class BundleTree::OnlyOne {
 public:
  OnlyOne(const BundleTree& in, const BundleHull& hull, std::uint8_t unseen)
      : m_in(in), m_hull(hull), m_unseen(unseen), m_reach(1, hull.upper(1.0)) {}

  /// False: it is the second one.
  bool take(const Object* object) {
    if (m_found) return false;
    m_found = object;
    return true;
  }
  bool unbounded(const RayBundle& rays, double t_min) {
    const auto& planes = m_in.m_tree.m_planes;
    const auto& entries = m_in.m_tree.m_unbounded;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].flags & m_unseen) continue;
      if (i < planes.size() && !may_meet(planes[i].normal, planes[i].distance, rays, t_min)) {
        continue;
      }
      if (!take(entries[i].object)) return false;
    }
    return true;
  }
  LENTRAY_AVX2 bool operator()(std::uint32_t code) {
    for (const ObjectEntry& e : m_in.m_tree.entries_of(code)) {
      if (e.flags & m_unseen) continue;
      const auto place = static_cast<std::size_t>(&e - m_in.m_tree.m_entries.data());
      if ((m_reach.groups_at(m_hull, m_in.m_boxes[place]) & 1u) == 0) continue;
      if (!take(e.object)) return false;
    }
    return true;
  }
  LENTRAY_AVX2 bool bounded() {
    m_reach.update();
    constexpr int kMostNodes = 8;
    return walk_bundle(m_in.m_tree.m_tree, m_hull, m_reach, kMostNodes, *this);
  }
  const Object* found() const { return m_found; }

 private:
  const BundleTree& m_in;
  const BundleHull& m_hull;
  const std::uint8_t m_unseen;
  BundleReach m_reach;
  const Object* m_found = nullptr;
};

bool BundleTree::only_one(const RayBundle& rays, double t_min, std::uint8_t unseen,
                          const Object*& object) const {
  const BundleHull hull(rays, m_tree.m_tree.frame());
  if (hull.fails) return false;
  OnlyOne only(*this, hull, unseen);
  if (!only.unbounded(rays, t_min) || (!hull.misses && !only.bounded())) return false;
  object = only.found();
  return true;
}

bool BundleTree::nearest(const RayBundle& rays, const Query& query, BundleHits& hits) const {
  const BundleHull hull(rays, m_tree.m_tree.frame());
  Search search(*this, rays, hull, query, hits);
  if (hull.fails || !search.run()) {
    hits.answer.fill(BundleHits::Answer::kUnknown);
    return false;
  }
  search.finish();
  return true;
}

}  // namespace lentray::core
