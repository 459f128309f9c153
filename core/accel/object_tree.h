// Objects under one wide bounding hierarchy: packs of spheres, triangles and polygons in the
// leaves, other objects behind a virtual call, infinite ones in lists apart (planes without that
// call). Or, for comparison, in a uniform grid or a list. World space.
// Immutable once built; any number of threads. The searches are the caller's.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/accel/accelerator.h"
#include "core/accel/uniform_grid.h"
#include "core/bvh/wide_bvh.h"
#include "core/object/object.h"
#include "core/shape/packs.h"
#include "core/shape/plane.h"

namespace lentray::core {

/// An object with what a search asks first, side by side.
struct ObjectEntry {
  const Object* object = nullptr;
  std::uint32_t index = 0;  ///< who comes first where all else is equal; never 0 twice
  std::uint8_t flags = 0, type = 0;
};

/// What a tree is made of. Boxes are apart: a hierarchy needs them only while it is built.
struct ObjectList {
  std::vector<ObjectEntry> entries;
  std::vector<Bounds> boxes;  ///< one an entry

  void reserve(std::size_t n) {
    entries.reserve(n);
    boxes.reserve(n);
  }
  void add(const ObjectEntry& entry, const Bounds& box) {
    entries.push_back(entry);
    boxes.push_back(box);
  }
};

class ObjectTree {
  friend class BundleTree;

 public:
  /// `portable`: no AVX2 even where there is any.
  ObjectTree(ObjectList objects, Accelerator accelerator, bool portable);

  /// Calls what.object(entry) and, for packs, what.lanes(mask, hits, entries of the lanes) for
  /// all that the ray may meet between t_min and what.limit(); both return true to end the search.
  /// what.tally counts; what.ray is the ray.
  template <bool kOrdered, class Search>
  void search(Search& what) const;
  /// The same for objects alone.
  template <class Search>
  void search_objects(Search& what, double t_max) const;

  /// Calls visit(entry) for the objects with a box that may hold the point, in any order.
  template <class Visit>
  void at_point(const Vec3& point, Visit&& visit) const;

  bool empty() const { return m_entries.empty() && m_unbounded.empty(); }
  std::size_t objects() const { return m_entries.size() + m_unbounded.size(); }
  /// Empty with another accelerator.
  const WideBvh& tree() const { return m_tree; }
  const UniformGrid& grid() const { return m_grid; }
  std::size_t memory() const;

 private:
  // A leaf's code: two bits of kind, and the number of a pack or count and first place of others.
  static constexpr std::uint32_t kKindShift = 29;
  static constexpr std::uint32_t kIndexMask = (1u << kKindShift) - 1;
  static constexpr std::uint32_t kFirstBits = 25;
  /// A Gated object may be seen beyond its box. So its box counts from the ray's start on, and
  /// what.t_min is left to its hits.
  static constexpr double kBoxesFrom = 0.0;
  enum Kind : std::uint8_t { kOthers, kSpheres, kTriangles, kPolygons };

  template <class Search>
  struct LeafPortable;
  template <class Search>
  struct LeafAvx2;
  template <class Search>
  struct LeafOfObjects;

  static Kind kind_of(const Object& object);
  /// The objects of a leaf.
  std::span<const ObjectEntry> entries_of(std::uint32_t code) const {
    const std::uint32_t index = code & kIndexMask;
    const auto of_pack = [&](const auto& pack) {
      return std::span(m_entries).subspan(pack.first, pack.count);
    };
    switch (code >> kKindShift) {
      case kSpheres: return of_pack(m_spheres[index]);
      case kTriangles: return of_pack(m_triangles[index]);
      case kPolygons: return of_pack(m_polygons[index]);
      default:
        return std::span(m_entries).subspan(index & ((1u << kFirstBits) - 1), index >> kFirstBits);
    }
  }
  std::uint32_t code_of(std::uint32_t first, std::uint32_t count, Kind kind);

  template <class Search>
  static bool each(std::span<const ObjectEntry> entries, Search& what) {
    for (const ObjectEntry& e : entries) {
      if (what.object(e)) return true;
    }
    return false;
  }
  /// The infinite objects, planes first; true ends the search. Nothing is found before planes, which come in the
  /// scene's order: of equal distances the first has won.
  template <class Search>
  bool unbounded(Search& what) const {
    for (std::size_t i = 0; i < m_planes.size(); ++i) {
      const ObjectEntry& e = m_unbounded[i];
      what.tally.test(e.type);
      const double t = plane_crossing(m_planes[i].normal, m_planes[i].distance, what.ray);
      if (t > what.t_min && t < what.limit() && what.plane(t, e)) return true;
    }
    return each(std::span(m_unbounded).subspan(m_planes.size()), what);
  }
  template <class Search>
  bool others(std::uint32_t code, Search& what) const {
    return each({m_entries.data() + (code & ((1u << kFirstBits) - 1)), code >> kFirstBits}, what);
  }

  void keep_bounded(ObjectList objects);
  void build_tree();
  /// Searches without a tree. An object's own box is asked first; `tally` counts boxes and cells.
  template <class Search, class Limit>
  void search_list(Search& what, const Limit& limit) const;
  template <class Search, class Limit>
  void search_grid(Search& what, const Limit& limit) const;
  template <class Search>
  void search_cells_at_once(Search& what, double t_max) const;
  static bool meets(const Bounds& box, const Ray& ray, double limit);

  std::vector<ObjectEntry> m_entries;    ///< of the tree, by place; of grid and list as given
  std::vector<Bounds> m_boxes;           ///< theirs; with a tree none
  std::vector<ObjectEntry> m_unbounded;  ///< the infinite ones, tried one by one, planes first
  struct BarePlane {
    Vec3 normal;  ///< unit
    double distance;
  };
  std::vector<BarePlane> m_planes;  ///< of the first of m_unbounded
  UniformGrid m_grid;
  std::vector<SpherePack> m_spheres;
  std::vector<TrianglePack> m_triangles;
  std::vector<PolygonPack> m_polygons;
  WideBvh m_tree;
  bool m_avx2;
};

/// Leaves of the searches. Packs are tested with and without AVX2 by the same text, because a
/// function does not take its caller's instruction set.
template <class Search>
struct ObjectTree::LeafPortable {
  const ObjectTree& in;
  Search& what;
  const PackRay& ray;

  template <class Pack>
  bool pack(const Pack& p, double t_max) {
    PackHits hits;
    what.tally.test(in.m_entries[p.first].type, p.count);
    const unsigned mask = intersect_portable(p, ray, what.t_min, t_max, hits);
    return mask != 0 && what.lanes(mask, hits, in.m_entries.data() + p.first);
  }
  bool operator()(std::uint32_t code, double& t_max) {
    const std::uint32_t index = code & kIndexMask;
    bool end = false;
    switch (code >> kKindShift) {
      case kSpheres: end = pack(in.m_spheres[index], t_max); break;
      case kTriangles: end = pack(in.m_triangles[index], t_max); break;
      case kPolygons: end = pack(in.m_polygons[index], t_max); break;
      default: end = in.others(index, what); break;
    }
    t_max = what.limit();
    return end;
  }
};

template <class Search>
struct ObjectTree::LeafAvx2 {
  const ObjectTree& in;
  Search& what;
  const PackRay& ray;

  template <class Pack>
  LENTRAY_AVX2 bool pack(const Pack& p, double t_max) {
    PackHits hits;
    what.tally.test(in.m_entries[p.first].type, p.count);
    const unsigned mask = intersect_avx2(p, ray, what.t_min, t_max, hits);
    return mask != 0 && what.lanes(mask, hits, in.m_entries.data() + p.first);
  }
  LENTRAY_AVX2 bool operator()(std::uint32_t code, double& t_max) {
    const std::uint32_t index = code & kIndexMask;
    bool end = false;
    switch (code >> kKindShift) {
      case kSpheres: end = pack(in.m_spheres[index], t_max); break;
      case kTriangles: end = pack(in.m_triangles[index], t_max); break;
      case kPolygons: end = pack(in.m_polygons[index], t_max); break;
      default: end = in.others(index, what); break;
    }
    t_max = what.limit();
    return end;
  }
};

/// Objects by virtual calls, of whatever kind the leaf is.
template <class Search>
struct ObjectTree::LeafOfObjects {
  const ObjectTree& in;
  Search& what;

  bool operator()(std::uint32_t code, double&) { return in.each(in.entries_of(code), what); }
};

template <class Search, class Limit>
void ObjectTree::search_list(Search& what, const Limit& limit) const {
  for (std::size_t i = 0; i < m_entries.size(); ++i) {
    what.tally.add(1);
    if (meets(m_boxes[i], what.ray, limit()) && what.object(m_entries[i])) return;
  }
}

template <class Search, class Limit>
void ObjectTree::search_grid(Search& what, const Limit& limit) const {
  // What was asked lately need not be asked again in the next cell.
  constexpr std::size_t kRemembered = 32;
  std::array<std::uint32_t, kRemembered> asked;
  asked.fill(~0u);
  m_grid.walk(what.ray, limit, [&](std::span<const std::uint32_t> parts) {
    what.tally.add(1);
    for (const std::uint32_t part : parts) {
      if (std::exchange(asked[part % kRemembered], part) == part) continue;
      what.tally.add(1);
      if (meets(m_boxes[part], what.ray, limit()) && what.object(m_entries[part])) return true;
    }
    return false;
  });
}

/// For searches that must not be told an object twice.
template <class Search>
void ObjectTree::search_cells_at_once(Search& what, double t_max) const {
  std::vector<std::uint32_t> found;
  m_grid.walk(
      what.ray, [&] { return t_max; },
      [&](std::span<const std::uint32_t> parts) {
        what.tally.add(1);
        found.insert(found.end(), parts.begin(), parts.end());
        return false;
      });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  for (const std::uint32_t part : found) {
    what.tally.add(1);
    if (meets(m_boxes[part], what.ray, t_max) && what.object(m_entries[part])) return;
  }
}

template <bool kOrdered, class Search>
void ObjectTree::search(Search& what) const {
  if (unbounded(what)) return;
  if (m_tree.empty()) {
    const auto limit = [&what] { return what.limit(); };
    m_grid.empty() ? search_list(what, limit) : search_grid(what, limit);
    return;
  }
  const PackRay ray(what.ray, !m_triangles.empty());
  if (m_avx2) {
    LeafAvx2<Search> leaf{*this, what, ray};
    m_tree.traverse_avx2<kOrdered>(what.ray, kBoxesFrom, what.limit(), leaf, what.tally);
  } else {
    LeafPortable<Search> leaf{*this, what, ray};
    m_tree.traverse_portable(what.ray, kBoxesFrom, what.limit(), leaf, what.tally);
  }
}

template <class Search>
void ObjectTree::search_objects(Search& what, double t_max) const {
  if (each(m_unbounded, what)) return;
  if (m_tree.empty()) {
    const auto limit = [t_max] { return t_max; };
    m_grid.empty() ? search_list(what, limit) : search_cells_at_once(what, t_max);
    return;
  }
  LeafOfObjects<Search> leaf{*this, what};
  if (m_avx2) {
    m_tree.traverse_avx2<false>(what.ray, kBoxesFrom, t_max, leaf, what.tally);
  } else {
    m_tree.traverse_portable(what.ray, kBoxesFrom, t_max, leaf, what.tally);
  }
}

template <class Visit>
void ObjectTree::at_point(const Vec3& point, Visit&& visit) const {
  for (const ObjectEntry& e : m_unbounded) visit(e);
  if (m_tree.empty()) {
    for (const ObjectEntry& e : m_entries) visit(e);
    return;
  }
  m_tree.at_point(point, [&](std::uint32_t code) {
    for (const ObjectEntry& e : entries_of(code)) visit(e);
    return false;
  });
}

}  // namespace lentray::core
