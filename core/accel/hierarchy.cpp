#include "core/accel/hierarchy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/accel/packs.h"
#include "core/accel/wide_bvh.h"
#include "core/geometry/sphere.h"
#include "core/geometry/triangle.h"

namespace lentray::core {
namespace {

enum Flag : std::uint8_t { kNoImage = 1, kNoReflection = 2, kNoShadow = 4, kTransparent = 8 };
enum Kind : std::uint8_t { kSpheres, kTriangles, kOthers };

std::uint8_t flags_of(const Object& object) {
  const Attributes& a = object.attributes();
  return static_cast<std::uint8_t>((a.no_image ? kNoImage : 0) |
                                   (a.no_reflection ? kNoReflection : 0) |
                                   (a.no_shadow ? kNoShadow : 0) |
                                   (object.is_opaque() ? 0 : kTransparent));
}

constexpr std::uint8_t unseen_by(RayKind kind) {
  switch (kind) {
    case RayKind::kCamera: return kNoImage;
    case RayKind::kReflection: return kNoReflection;
    case RayKind::kShadow: return kNoShadow;
  }
  return 0;
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

/// An object with what a search asks first, side by side.
struct Entry {
  const Object* object = nullptr;
  std::uint32_t index = 0;  ///< in the scene
  std::uint8_t flags = 0, type = 0;
};

bool has_nan(const Bounds& b) {
  const auto any = [](const Vec3& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); };
  return any(b.lo) || any(b.hi);
}

/// Only bare leaves whose shape is already in the world may be tested without the object.
Kind kind_of(const Object& object) {
  if (!object.clips().empty() || !object.bounding().empty()) return kOthers;
  const auto* leaf = dynamic_cast<const Leaf*>(&object);
  if (!leaf || leaf->transform()) return kOthers;
  if (dynamic_cast<const Sphere*>(&leaf->shape())) return kSpheres;
  const auto* triangle = dynamic_cast<const Triangle*>(&leaf->shape());
  return triangle && !triangle->is_degenerate() ? kTriangles : kOthers;
}

/// Nearest hit so far. Equal distances: the object first in the scene wins.
struct Best {
  double t;
  std::uint32_t index = 0;  ///< 0 before anything is found: the limit itself is out of reach
  const Entry* entry = nullptr;
  bool from_pack = false;
  double u = 0.0, v = 0.0;

  bool beats(double at, std::uint32_t i) const { return at < t || (at == t && i < index); }
};

/// What a search looks at, and for whom.
struct Query {
  const Ray& ray;
  double t_min, t_max;
  std::uint8_t unseen;  ///< objects with one of these flags are passed by
  bool check;           ///< there are such objects
  HitArena& arena;
  bool passes(const Entry& e) const { return check && (e.flags & unseen) != 0; }
};

template <class T>
struct NearestSearch {
  const Query& query;
  Hit& hit;
  T& tally;
  Best best;

  double limit() const { return best.t; }
  bool object(const Entry& e) {
    if (query.passes(e)) return false;
    tally.test(e.type);
    const double reach = e.index < best.index
                             ? std::nextafter(best.t, std::numeric_limits<double>::infinity())
                             : best.t;
    if (e.object->nearest(query.ray, query.t_min, reach, hit, query.arena)) {
      best = {hit.t, e.index, &e};
    }
    return false;
  }
  bool lanes(unsigned mask, const PackHits& hits, const Entry* entries) {
    for (; mask != 0; mask &= mask - 1) {
      const int i = std::countr_zero(mask);
      const Entry& e = entries[i];
      if (query.passes(e) || !best.beats(hits.t[i], e.index)) continue;
      best = {hits.t[i], e.index, &e, true, hits.u[i], hits.v[i]};
    }
    return false;
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
  const Query& query;
  T& tally;
  const Object* found = nullptr;

  double limit() const { return query.t_max; }
  bool object(const Entry& e) {
    if (query.passes(e)) return false;
    tally.test(e.type);
    if (!e.object->any(query.ray, query.t_min, query.t_max, query.arena)) return false;
    found = e.object;
    return true;
  }
  bool lanes(unsigned mask, const PackHits& hits, const Entry* entries) {
    for (; mask != 0; mask &= mask - 1) {
      const int i = std::countr_zero(mask);
      if (query.passes(entries[i]) || hits.t[i] == query.t_max) continue;
      found = entries[i].object;
      return true;
    }
    return false;
  }
};

template <class T>
struct AllSearch {
  const Query& query;
  std::vector<Hit>& hits;
  T& tally;

  bool object(const Entry& e) {
    if (query.passes(e) || (e.flags & kTransparent) == 0) return false;
    tally.test(e.type);
    const std::size_t before = hits.size();
    e.object->all(query.ray, query.t_min, query.t_max, hits, query.arena);
    for (std::size_t i = before; i < hits.size(); ++i) hits[i].object = e.object;
    return false;
  }
};

}  // namespace

struct Hierarchy::Impl {
  Impl(const std::vector<std::unique_ptr<Object>>& objects, bool linear, bool portable);

  // A leaf's code: a pack of spheres, a pack of triangles, or count and first place of others.
  static constexpr std::uint32_t kSphereBit = 1u << 30, kTriangleBit = 1u << 29;
  static constexpr std::uint32_t kIndexMask = kTriangleBit - 1;
  static constexpr std::uint32_t kFirstBits = 25;
  template <class Search> struct LeafPortable;
  template <class Search> struct LeafAvx2;
  template <class Search> struct LeafOfObjects;

  template <class Search>
  bool each(std::uint32_t code, Search& what) const {
    const Entry* e = entries.data() + (code & ((1u << kFirstBits) - 1));
    for (std::uint32_t left = code >> kFirstBits; left > 0; --left, ++e) {
      if (what.object(*e)) return true;
    }
    return false;
  }

  std::vector<Entry> entries;    ///< of the tree, by place
  std::vector<Entry> unbounded;  ///< objects tried one by one: the infinite ones, or all
  std::vector<SpherePack> spheres;
  std::vector<TrianglePack> triangles;
  std::vector<std::string> types;
  std::uint8_t any_flags = 0;  ///< of any object
  bool has_opaque = false;
  std::size_t infinite = 0;
  bool avx2;
  WideBvh tree;

  template <bool kOrdered, class Search, class T>
  bool search(const Query& query, Search& what, T& tally) const;
  template <class T>
  bool nearest(const Query& query, Hit& hit, T& tally) const;
  template <class T>
  const Object* any_opaque(const Query& query, T& tally) const;
  template <class T>
  void all_transparent(const Query& query, std::vector<Hit>& hits, T& tally) const;
  void flush(const Tally& tally, Counters& counters) const;

 private:
  std::uint8_t type_of(std::string_view name);
  std::uint32_t code_of(std::uint32_t first, std::uint32_t count, Kind kind);
};

/// Leaves of the searches. Packs are tested with and without AVX2 by the same text, because a
/// function does not take its caller's instruction set.
template <class Search>
struct Hierarchy::Impl::LeafPortable {
  const Impl& in;
  Search& what;
  const PackRay& ray;

  template <class Pack>
  bool pack(const Pack& p, double t_max) {
    PackHits hits;
    what.tally.test(in.entries[p.first].type, p.count);
    const unsigned mask = intersect_portable(p, ray, what.query.t_min, t_max, hits);
    return mask != 0 && what.lanes(mask, hits, in.entries.data() + p.first);
  }
  bool operator()(std::uint32_t code, double& t_max) {
    const std::uint32_t index = code & kIndexMask;
    const bool end = code & kSphereBit     ? pack(in.spheres[index], t_max)
                     : code & kTriangleBit ? pack(in.triangles[index], t_max)
                                           : in.each(code, what);
    t_max = what.limit();
    return end;
  }
};

template <class Search>
struct Hierarchy::Impl::LeafAvx2 {
  const Impl& in;
  Search& what;
  const PackRay& ray;

  template <class Pack>
  LENTRAY_AVX2 bool pack(const Pack& p, double t_max) {
    PackHits hits;
    what.tally.test(in.entries[p.first].type, p.count);
    const unsigned mask = intersect_avx2(p, ray, what.query.t_min, t_max, hits);
    return mask != 0 && what.lanes(mask, hits, in.entries.data() + p.first);
  }
  LENTRAY_AVX2 bool operator()(std::uint32_t code, double& t_max) {
    const std::uint32_t index = code & kIndexMask;
    const bool end = code & kSphereBit     ? pack(in.spheres[index], t_max)
                     : code & kTriangleBit ? pack(in.triangles[index], t_max)
                                           : in.each(code, what);
    t_max = what.limit();
    return end;
  }
};

/// Objects by virtual calls, of whatever kind the leaf is.
template <class Search>
struct Hierarchy::Impl::LeafOfObjects {
  const Impl& in;
  Search& what;

  bool operator()(std::uint32_t code, double&) {
    const std::uint32_t index = code & kIndexMask;
    const auto each = [&](const auto& pack) {
      for (std::uint32_t i = 0; i < pack.count; ++i) what.object(in.entries[pack.first + i]);
      return false;
    };
    return code & kSphereBit     ? each(in.spheres[index])
           : code & kTriangleBit ? each(in.triangles[index])
                                 : in.each(code, what);
  }
};

template <bool kOrdered, class Search, class T>
bool Hierarchy::Impl::search(const Query& query, Search& what, T& tally) const {
  for (const Entry& e : unbounded) {
    if (what.object(e)) return true;
  }
  if (tree.empty()) return false;
  const PackRay ray(query.ray, !triangles.empty());
  if (avx2) {
    LeafAvx2<Search> leaf{*this, what, ray};
    return tree.traverse_avx2<kOrdered>(query.ray, query.t_min, what.limit(), leaf, tally);
  }
  LeafPortable<Search> leaf{*this, what, ray};
  return tree.traverse_portable(query.ray, query.t_min, what.limit(), leaf, tally);
}

template <class T>
bool Hierarchy::Impl::nearest(const Query& query, Hit& hit, T& tally) const {
  NearestSearch<T> what{query, hit, tally, {query.t_max}};
  search<true>(query, what, tally);
  return what.finish();
}

template <class T>
const Object* Hierarchy::Impl::any_opaque(const Query& query, T& tally) const {
  AnySearch<T> what{query, tally};
  search<false>(query, what, tally);
  return what.found;
}

template <class T>
void Hierarchy::Impl::all_transparent(const Query& query, std::vector<Hit>& hits, T& tally) const {
  AllSearch<T> what{query, hits, tally};
  for (const Entry& e : unbounded) what.object(e);
  LeafOfObjects<AllSearch<T>> leaf{*this, what};
  if (avx2) {
    tree.traverse_avx2<false>(query.ray, query.t_min, query.t_max, leaf, tally);
  } else {
    tree.traverse_portable(query.ray, query.t_min, query.t_max, leaf, tally);
  }
}

void Hierarchy::Impl::flush(const Tally& tally, Counters& counters) const {
  counters.bounds_tests += tally.boxes;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (tally.tests[i] == 0) continue;
    counters.primitive_tests += tally.tests[i];
    const auto at = counters.tests_by_type.find(types[i]);
    if (at != counters.tests_by_type.end()) {
      at->second += tally.tests[i];
    } else {
      counters.tests_by_type.emplace(types[i], tally.tests[i]);
    }
  }
}

std::uint8_t Hierarchy::Impl::type_of(std::string_view name) {
  const auto at = std::find(types.begin(), types.end(), name);
  if (at != types.end()) return static_cast<std::uint8_t>(at - types.begin());
  if (types.size() + 1 == kMaxTypes) name = "other";
  if (types.size() == kMaxTypes) return kMaxTypes - 1;
  types.emplace_back(name);
  return static_cast<std::uint8_t>(types.size() - 1);
}

Hierarchy::Impl::Impl(const std::vector<std::unique_ptr<Object>>& objects, bool linear,
                      bool portable)
    : avx2(!portable && WideBvh::has_avx2()) {
  std::vector<Entry> bounded;
  std::vector<Bounds> boxes;
  std::vector<std::uint8_t> kinds;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Object& object = *objects[i];
    const Entry entry{&object, static_cast<std::uint32_t>(i), flags_of(object),
                      type_of(object.name())};
    any_flags |= entry.flags;
    has_opaque = has_opaque || (entry.flags & (kTransparent | kNoShadow)) == 0;
    const Bounds box = object.bounds();
    if (box.is_empty() && !has_nan(box)) continue;  // nothing meets it
    if (!box.is_finite()) ++infinite;
    if (linear || !box.is_finite()) {
      unbounded.push_back(entry);
      continue;
    }
    bounded.push_back(entry);
    boxes.push_back(box);
    kinds.push_back(kind_of(object));
  }
  // In node tests: a pack costs about one, a virtual call with its test somewhat more.
  static constexpr WideBvh::Options::Kind kCosts[] = {{kPack, 1.0, kPack}, {kPack, 1.4, kPack},
                                                      {1, 1.5, 4}};
  WideBvh::Options options;
  options.kinds = kinds;
  options.kind_costs = kCosts;
  tree = WideBvh(boxes, options);
  entries.reserve(tree.order().size());
  for (const std::uint32_t part : tree.order()) entries.push_back(bounded[part]);
  if (entries.size() >> kFirstBits != 0) {
    throw std::length_error("more objects than a bounding hierarchy holds");
  }
  tree.relabel([&](std::uint32_t first, std::uint32_t count) {
    return code_of(first, count, static_cast<Kind>(kinds[tree.order()[first]]));
  });
  spheres.shrink_to_fit();
  triangles.shrink_to_fit();
}

/// Puts a leaf's objects into a pack, if they go into one.
std::uint32_t Hierarchy::Impl::code_of(std::uint32_t first, std::uint32_t count, Kind kind) {
  if (kind == kOthers) return count << kFirstBits | first;
  const auto shape = [&](std::uint32_t i) -> const core::Shape& {
    return static_cast<const Leaf*>(entries[first + i].object)->shape();
  };
  if (kind == kSpheres) {
    SpherePack& pack = spheres.emplace_back();
    pack.first = first;
    pack.count = count;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& sphere = static_cast<const Sphere&>(shape(i));
      for (int a = 0; a < 3; ++a) pack.centre[a][i] = sphere.centre()[a];
      pack.radius2[i] = sphere.radius2();
    }
    return kSphereBit | static_cast<std::uint32_t>(spheres.size() - 1);
  }
  TrianglePack& pack = triangles.emplace_back();
  pack.first = first;
  pack.count = count;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto& corners = static_cast<const Triangle&>(shape(i)).vertices();
    for (std::size_t c = 0; c < 3; ++c) {
      for (int a = 0; a < 3; ++a) pack.corner[c][a][i] = corners[c][a];
    }
  }
  return kTriangleBit | static_cast<std::uint32_t>(triangles.size() - 1);
}

Hierarchy::Hierarchy(const std::vector<std::unique_ptr<Object>>& objects, bool linear,
                     bool portable)
    : m_impl(std::make_unique<Impl>(objects, linear, portable)) {}

Hierarchy::~Hierarchy() = default;

bool Hierarchy::nearest(const Ray& ray, double t_min, double t_max, RayKind kind, Hit& hit,
                        HitArena& arena, Counters* counters) const {
  const std::uint8_t unseen = unseen_by(kind);
  const Query query{ray, t_min, t_max, unseen, (m_impl->any_flags & unseen) != 0, arena};
  if (!counters) {
    NoTally none;
    return m_impl->nearest(query, hit, none);
  }
  Tally tally;
  const bool found = m_impl->nearest(query, hit, tally);
  m_impl->flush(tally, *counters);
  return found;
}

const Object* Hierarchy::any_opaque(const Ray& ray, double t_min, double t_max, HitArena& arena,
                                    Counters* counters) const {
  if (!m_impl->has_opaque) return nullptr;
  constexpr std::uint8_t kUnseen = kNoShadow | kTransparent;
  const Query query{ray, t_min, t_max, kUnseen, (m_impl->any_flags & kUnseen) != 0, arena};
  if (!counters) {
    NoTally none;
    return m_impl->any_opaque(query, none);
  }
  Tally tally;
  const Object* found = m_impl->any_opaque(query, tally);
  m_impl->flush(tally, *counters);
  return found;
}

void Hierarchy::all_transparent(const Ray& ray, double t_min, double t_max,
                                std::vector<Hit>& hits, HitArena& arena,
                                Counters* counters) const {
  if ((m_impl->any_flags & kTransparent) == 0) return;
  const Query query{ray, t_min, t_max, kNoShadow, (m_impl->any_flags & kNoShadow) != 0, arena};
  if (!counters) {
    NoTally none;
    m_impl->all_transparent(query, hits, none);
    return;
  }
  Tally tally;
  m_impl->all_transparent(query, hits, tally);
  m_impl->flush(tally, *counters);
}

std::size_t Hierarchy::memory() const {
  const Impl& in = *m_impl;
  return sizeof(Impl) + in.tree.memory() +
         (in.entries.capacity() + in.unbounded.capacity()) * sizeof(Entry) +
         in.spheres.capacity() * sizeof(SpherePack) +
         in.triangles.capacity() * sizeof(TrianglePack);
}

Hierarchy::Shape Hierarchy::statistics() const {
  const WideBvh::Statistics& s = m_impl->tree.statistics();
  return {s.nodes, s.leaves, m_impl->entries.size() + m_impl->unbounded.size(), m_impl->infinite,
          s.depth};
}

}  // namespace lentray::core
