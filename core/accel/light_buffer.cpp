#include "core/accel/light_buffer.h"

#include <algorithm>
#include <cmath>

#include "core/accel/light_buffer_builder.h"
#include "core/accel/light_caster_test.h"
#include "core/shape/plane.h"

namespace lentray::core {
namespace {

constexpr double kNearLight = 1e-5;  ///< of the light's coordinates: nearer, rounding counts

}  // namespace

LightBuffer::LightBuffer(const Vec3& light)
    : m_light(light),
      m_least_distance(kNearLight * std::max({std::fabs(light.x), std::fabs(light.y),
                                              std::fabs(light.z), 1.0})) {}

LightBuffer::LightBuffer(const Vec3& light, const LightCasters& casters, double tolerance,
                         std::uint32_t cells)
    : LightBuffer(light) {
  LightBufferBuilder(casters, tolerance).build(*this, cells);
}

template <class Count>
const Object* LightBuffer::plane_blocker(const Ray& ray, double t_min, double t_max,
                                         Count count) const {
  for (const Flat& plane : m_planes) {
    count.test(plane.object);
    const double t = plane_crossing(plane.normal, plane.distance, ray);
    if (t > t_min && t < t_max) return plane.object;
  }
  return nullptr;
}

/// Not inlined, so that any_opaque() needs no frame where there are planes alone.
template <class Count>
[[gnu::noinline]] LightBuffer::Answer LightBuffer::other_blocker(const Spot& spot, const Ray& ray,
                                                                 double t_min, double t_max,
                                                                 HitLists& lists,
                                                                 Count count) const {
  if (const Cell* cell = spot.cell) {
    const Entry* begin = m_entries.data() + cell->first;
    if (cell->covered) {
      if (spot.w > begin->near_w) return {m_casters[begin->caster].object, true};
      ++begin;
    }
    const Entry* const end = begin + cell->opaque;
    if (begin < end && begin->near_w < spot.w) {
      const LightProbe point(ray.origin - m_light, spot.w, t_min, m_reach);
      bool foreseen = true;
      const Entry* entry = begin;
      do {
        if (point.is_outside(m_volumes[entry->caster])) {
          count.outside();
          continue;
        }
        const Caster& caster = m_casters[entry->caster];
        if (caster.object == spot.unmet) {
          foreseen = false;
          continue;
        }
        const Probe answer = probe(caster, ray, t_min, t_max, lists, count);
        if (answer == Probe::kBlocks) return {caster.object, foreseen};
        if (answer == Probe::kMisses) foreseen = false;
      } while (++entry < end && entry->near_w < spot.w);
    }
  }
  for (const Caster& caster : m_always_opaque) {
    count.test(caster.object);
    if (caster.object->any(ray, t_min, t_max, {lists, RayKind::kShadow}))
      return {caster.object, false};
  }
  return {};
}

LightBuffer::Answer LightBuffer::any_opaque_counted(const Spot& spot, const Ray& ray, double t_min,
                                                    double t_max, HitLists& lists,
                                                    Counters& counters) const {
  ++counters.bounds_tests;
  const Tally counted{counters};
  if (const Object* plane = plane_blocker(ray, t_min, t_max, counted)) return {plane, true};
  return other_blocker(spot, ray, t_min, t_max, lists, counted);
}

LightBuffer::Answer LightBuffer::any_opaque(const Spot& spot, const Ray& ray, double t_min,
                                            double t_max, HitLists& lists,
                                            Counters* counters) const {
  if (counters) {
    return any_opaque_counted(spot, ray, t_min, t_max, lists, *counters);
  }
  const NoTally uncounted;
  if (const Object* plane = plane_blocker(ray, t_min, t_max, uncounted)) return {plane, true};
  if (!spot.cell && m_always_opaque.empty()) return {};
  return other_blocker(spot, ray, t_min, t_max, lists, uncounted);
}

/// Appends the crossings of one caster. What a ray meets once at most is asked without a detour.
[[gnu::always_inline]] inline void LightBuffer::add_all(const Caster& caster, const Ray& ray,
                                                        double t_min, double t_max, bool nearest,
                                                        std::vector<Hit>& hits, HitLists& lists) {
  ShapeHit hit;
  switch (caster.kind) {
    case CasterKind::kPolygon:
      if (!static_cast<const Polygon*>(caster.shape)->Polygon::nearest(ray, t_min, t_max, hit))
        return;
      break;
    case CasterKind::kTriangle:
      if (!static_cast<const TriangleShape*>(caster.shape)->nearest(ray, t_min, t_max, hit)) return;
      break;
    default: {
      const std::size_t before = hits.size();
      add_hits(*caster.object, ray, t_min, t_max, nearest, hits, {lists, RayKind::kShadow});
      for (std::size_t i = before; i < hits.size(); ++i) {
        hits[i].object = caster.object;
        hits[i].place = caster.place;
      }
      return;
    }
  }
  hits.push_back(
      {hit.t, static_cast<const Leaf*>(caster.object), caster.object, hit, caster.place});
}

void LightBuffer::all_transparent(const Spot& spot, const Ray& ray, double t_min, double t_max,
                                  bool nearest, std::vector<Hit>& hits, HitLists& lists,
                                  Counters* counters) const {
  for (const Caster& caster : m_always_transparent) {
    if (caster.object == spot.unmet) continue;
    if (counters) counters->add_tests(caster.object->name(), 1);
    add_all(caster, ray, t_min, t_max, nearest, hits, lists);
  }
  if (!spot.cell) return;
  const Entry* entry = first_transparent(*spot.cell);
  const Entry* const end = entry + spot.cell->transparent;
  if (!(entry < end && entry->near_w < spot.w)) return;
  // Of a ray that begins nearer to the light w is too large, which widens the volumes.
  const LightProbe point(ray.origin - m_light, spot.w, t_min, m_reach);
  do {
    if (point.is_outside(m_volumes[entry->caster])) {
      if (counters) ++counters->bounds_tests;
      continue;
    }
    const Caster& caster = m_casters[entry->caster];
    if (caster.object == spot.unmet) continue;
    if (counters) counters->add_tests(caster.object->name(), 1);
    add_all(caster, ray, t_min, t_max, nearest, hits, lists);
  } while (++entry < end && entry->near_w < spot.w);
}

std::size_t LightBuffer::memory() const {
  std::size_t bytes = sizeof(*this) + m_casters.capacity() * sizeof(Caster) +
                      m_volumes.capacity() * sizeof(LightVolume) +
                      m_planes.capacity() * sizeof(Flat) + m_spheres.capacity() * sizeof(Round) +
                      m_entries.capacity() * sizeof(Entry);
  for (const std::vector<Grid>& grids : m_faces) {
    for (const Grid& g : grids) bytes += g.cells.capacity() * sizeof(Cell);
  }
  return bytes;
}

LightBuffer::Statistics LightBuffer::statistics() const {
  Statistics s;
  s.entries = m_entries.size();
  s.always = m_planes.size() + m_always_opaque.size() + m_always_transparent.size();
  for (const std::vector<Grid>& grids : m_faces) {
    for (const Grid& g : grids) {
      s.cells += g.cells.size();
      for (const Cell& c : g.cells) s.dark_cells += c.covered ? 1 : 0;
    }
  }
  return s;
}

}  // namespace lentray::core
