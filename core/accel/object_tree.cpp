#include "core/accel/object_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <typeinfo>

#include "core/object/leaf.h"
#include "core/shape/plane.h"
#include "core/shape/polygon.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"

namespace lentray::core {

ObjectTree::Kind ObjectTree::kind_of(const Object& object) {
  const Shape* bare = plain_shape(object);
  if (!bare) return kOthers;
  const Shape& shape = *bare;
  const std::type_info& type = typeid(shape);
  if (type == typeid(Sphere)) return kSpheres;
  if (type == typeid(Triangle))
    return static_cast<const Triangle&>(shape).is_degenerate() ? kOthers : kTriangles;
  return type == typeid(Polygon) && PolygonPack::fits(static_cast<const Polygon&>(shape))
             ? kPolygons
             : kOthers;
}

ObjectTree::ObjectTree(ObjectList objects, Accelerator accelerator, bool portable)
    : m_avx2(!portable && has_avx2()) {
  keep_bounded(std::move(objects));
  std::stable_partition(m_unbounded.begin(), m_unbounded.end(), [](const ObjectEntry& entry) {
    return plain_plane(*entry.object) != nullptr;
  });
  for (const ObjectEntry& entry : m_unbounded) {
    const Plane* plane = plain_plane(*entry.object);
    if (!plane) break;
    m_planes.push_back({plane->unit_normal(), plane->distance()});
  }
  if (accelerator == Accelerator::kList) return;
  if (accelerator == Accelerator::kGrid) {
    m_grid = UniformGrid(m_boxes);
    return;
  }
  build_tree();
}

/// In place: there may be a million.
void ObjectTree::keep_bounded(ObjectList objects) {
  m_entries = std::move(objects.entries);
  m_boxes = std::move(objects.boxes);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < m_entries.size(); ++i) {
    if (!m_boxes[i].is_finite()) {
      m_unbounded.push_back(m_entries[i]);
      continue;
    }
    if (kept != i) {
      m_entries[kept] = m_entries[i];
      m_boxes[kept] = m_boxes[i];
    }
    ++kept;
  }
  m_entries.resize(kept);
  m_boxes.resize(kept);
}

void ObjectTree::build_tree() {
  if (m_entries.size() >> kFirstBits != 0) {
    throw std::length_error("more objects than a bounding hierarchy holds");
  }
  std::vector<std::uint8_t> kinds;
  kinds.reserve(m_entries.size());
  for (const ObjectEntry& entry : m_entries) kinds.push_back(kind_of(*entry.object));
  // In node tests: a pack costs about one, a virtual call with its test somewhat more.
  static constexpr WideBvh::Options::Kind kCosts[] = {
      {1, 1.5, 4}, {kPack, 1.0, kPack}, {kPack, 1.4, kPack}, {kPack, 1.4, kPack}};
  WideBvh::Options options;
  options.kinds = kinds;
  options.kind_costs = kCosts;
  m_tree = WideBvh(std::move(m_boxes), options);
  std::vector<ObjectEntry> placed;
  placed.reserve(m_tree.order().size());
  for (const std::uint32_t part : m_tree.order()) placed.push_back(m_entries[part]);
  m_entries = std::move(placed);
  std::size_t leaves[4] = {};
  m_tree.for_each_leaf(
      [&](std::uint32_t first, std::uint32_t) { ++leaves[kinds[m_tree.order()[first]]]; });
  m_spheres.reserve(leaves[kSpheres]);
  m_triangles.reserve(leaves[kTriangles]);
  m_polygons.reserve(leaves[kPolygons]);
  m_tree.relabel([&](std::uint32_t first, std::uint32_t count) {
    return code_of(first, count, static_cast<Kind>(kinds[m_tree.order()[first]]));
  });
  m_tree.drop_order();
}

/// Whether the ray comes near the box between 0 and the limit, rounding counted in.
bool ObjectTree::meets(const Bounds& box, const Ray& ray, double limit) {
  constexpr double kSlack = 1e-9;  // of the coordinates involved
  double enters = kBoxesFrom, leaves = limit;
  for (int a = 0; a < 3; ++a) {
    const double o = ray.origin[a], d = ray.direction[a];
    const double slack = kSlack * std::max({std::fabs(o), std::fabs(box.lo[a]),
                                            std::fabs(box.hi[a]), box.hi[a] - box.lo[a]});
    const double lo = box.lo[a] - slack - o, hi = box.hi[a] + slack - o;
    if (d == 0.0) {
      if (lo > 0.0 || hi < 0.0) return false;
      continue;
    }
    const double t0 = lo / d, t1 = hi / d;
    enters = std::max(enters, std::min(t0, t1));
    leaves = std::min(leaves, std::max(t0, t1));
  }
  return enters <= leaves + kSlack * std::fabs(leaves);
}

/// Puts a leaf's objects into a pack, if they go into one.
std::uint32_t ObjectTree::code_of(std::uint32_t first, std::uint32_t count, Kind kind) {
  if (kind == kOthers) return count << kFirstBits | first;
  const auto fill = [&](auto& packs, auto&& set) {
    auto& pack = packs.emplace_back();
    pack.first = first;
    pack.count = count;
    for (std::uint32_t i = 0; i < count; ++i) {
      set(pack, static_cast<int>(i),
          static_cast<const Leaf*>(m_entries[first + i].object)->shape());
    }
    return static_cast<std::uint32_t>(kind) << kKindShift |
           static_cast<std::uint32_t>(packs.size() - 1);
  };
  if (kind == kSpheres) {
    return fill(m_spheres, [](SpherePack& pack, int lane, const Shape& shape) {
      pack.set(lane, static_cast<const Sphere&>(shape));
    });
  }
  if (kind == kTriangles) {
    return fill(m_triangles, [](TrianglePack& pack, int lane, const Shape& shape) {
      const auto& v = static_cast<const Triangle&>(shape).vertices();
      pack.set(lane, v[0], v[1], v[2]);
    });
  }
  return fill(m_polygons, [](PolygonPack& pack, int lane, const Shape& shape) {
    pack.set(lane, static_cast<const Polygon&>(shape));
  });
}

std::size_t ObjectTree::memory() const {
  return m_tree.memory() + m_grid.memory() +
         (m_entries.capacity() + m_unbounded.capacity()) * sizeof(ObjectEntry) +
         m_boxes.capacity() * sizeof(Bounds) + m_planes.capacity() * sizeof(BarePlane) +
         m_spheres.capacity() * sizeof(SpherePack) + m_triangles.capacity() * sizeof(TrianglePack) +
         m_polygons.capacity() * sizeof(PolygonPack);
}

}  // namespace lentray::core
