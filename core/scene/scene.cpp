#include "core/scene/scene.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <typeinfo>
#include <utility>

#include "core/accel/hierarchy.h"
#include "core/accel/light_buffer.h"
#include "core/accel/light_buffer_builder.h"
#include "core/accel/test_cost.h"
#include "core/base/memory_limit.h"
#include "core/object/csg.h"
#include "core/scene/many_lights.h"
#include "core/scene/needs_finder.h"
#include "core/scene/tolerances.h"

namespace lentray::core {
namespace {

/// An unclipped union's surface is that of its parts, so that each part may stand alone in the
/// hierarchy, unless the scene wants it whole. (A merge's is not: it has no surfaces inside.)
Csg* splittable(Object& object) {
  if (object.is_inverse() || !object.clips().empty()) return nullptr;
  if (typeid(object) != typeid(Csg)) return nullptr;
  auto& csg = static_cast<Csg&>(object);
  return csg.kind() == CsgKind::kUnion && !csg.is_kept_whole() ? &csg : nullptr;
}

struct Splitter {
  std::vector<std::unique_ptr<Object>> objects;

  /// `whole`: which object of the source it comes from.
  void add(std::unique_ptr<Object> object, std::uint32_t whole) {
    if (Csg* csg = splittable(*object)) {
      auto children = csg->take_children();
      make_room(children.size());
      for (auto& child : children) add(std::move(child), whole);
      return;
    }
    object->set_whole(whole);
    objects.push_back(std::move(object));
  }

 private:
  /// For a large union at once; many small ones grow the list as ever.
  void make_room(std::size_t more) {
    if (objects.capacity() - objects.size() >= more) return;
    objects.reserve(std::max(objects.size() + more, 2 * objects.capacity()));
  }
};

/// Those all of whose shadow rays end in one point, and all of whose occluders count.
bool suits_buffer(const Light& light) {
  return !light.shadowless && !light.projector && !light.has_area && !light.parallel &&
         light.kind != Light::Kind::kCylinder;
}

/// Filling a buffer costs about what it spares in some ten shadow rays an object: small pictures of
/// many objects are quicker by the hierarchy alone. (Measured with +UL and -UL: balls, gears and rings at 4
/// to 40 pixels an object, 100,000 spheres at 1 to 14.)
bool worth_buffers(std::size_t objects, std::uint64_t pixels) {
  constexpr std::size_t kFew = 1u << 10;
  constexpr std::uint64_t kPixelsAnObject = 10;
  return objects <= kFew || pixels >= kPixelsAnObject * objects;
}

/// More objects and more pixels are worth finer cells; of many lights all together get no more than a few
/// would: what does not stay in the processor's caches is slower than coarse cells.
std::uint32_t buffer_cells(std::size_t objects, std::uint64_t pixels, std::size_t lights) {
  constexpr std::uint64_t kLeast = 1u << 10, kMost = 1u << 18, kFewLights = 16;
  const std::uint64_t wanted = std::min<std::uint64_t>(6 * objects + 8192, pixels / 24);
  const std::uint64_t shares = std::max<std::uint64_t>(lights, kFewLights);
  return static_cast<std::uint32_t>(std::clamp(wanted, kLeast, kMost) * kFewLights / shares);
}

/// Whether they take no more than half of what Max_Memory leaves, about.
bool has_room(std::size_t lights, std::size_t objects, std::uint32_t cells) {
  constexpr double kBytesAnObject = 150.0, kBytesACell = 64.0, kShare = 0.5, kSmall = 1e7;
  const double bytes =
      static_cast<double>(lights) *
      (kBytesAnObject * static_cast<double>(objects) + kBytesACell * static_cast<double>(cells));
  return bytes < kSmall || bytes < kShare * (memory_limit() - resident_bytes());
}

/// do_range(first, end) for all of [0, count), on all threads where there is much to do.
template <class DoRange>
void in_ranges(std::size_t count, std::size_t cost_each, DoRange&& do_range) {
#ifdef __SANITIZE_THREAD__
  // What oneTBB's library synchronises inside is not seen.
  constexpr std::size_t kMuch = ~std::size_t{0};
#else
  constexpr std::size_t kMuch = 1u << 16;
#endif
  if (count == 1 || count * cost_each < kMuch) return do_range(0, count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count),
                    [&](const auto& range) { do_range(range.begin(), range.end()); });
}

double tolerance_scale_of(const Bounds& all) {
  if (all.is_empty() || !all.is_finite()) return 1.0;
  const double across = length(all.hi - all.lo);
  return across > 0.0 ? std::min(1.0, across) : 1.0;
}

}  // namespace

Scene::Scene(SceneParts parts, const CompileOptions& options)
    : m_parts(std::move(parts)), m_accelerator(options.accelerator) {
  Splitter split;
  std::uint32_t whole = 0;
  for (auto& object : m_parts.objects) split.add(std::move(object), whole++);
  m_parts.objects = std::move(split.objects);
  set_opacity(m_parts.objects);
  constexpr std::size_t kCompletion = 16;
  in_ranges(m_parts.objects.size(), kCompletion, [this](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      complete(*m_parts.objects[i]);
      m_parts.objects[i]->set_test_cost(test_cost(*m_parts.objects[i]));
    }
  });
  for (std::uint32_t i = 0; i < m_parts.lights.size(); ++i) {
    if (!m_parts.lights[i].grouped) m_global_lights.push_back(i);
  }
  m_hierarchy = std::make_unique<Hierarchy>(m_parts.objects, options.accelerator);
  m_tolerance_scale = tolerance_scale_of(m_hierarchy->bounds());
  m_needs = find_needs(m_parts);
  m_needs.infinite_objects = m_hierarchy->has_infinite();
  if (options.general_path) m_needs = everything_needed(std::move(m_needs), m_parts.settings);
  m_light_buffers.resize(m_parts.lights.size());
}

void Scene::build_light_buffers(std::uint64_t camera_rays) {
  for (auto& buffer : m_light_buffers) buffer.reset();
  if (m_accelerator != Accelerator::kBvh) return;
  if (!worth_buffers(m_parts.objects.size(), camera_rays)) return;
  std::vector<std::size_t> suited;
  for (std::size_t i = 0; i < m_light_buffers.size(); ++i) {
    if (suits_buffer(m_parts.lights[i])) suited.push_back(i);
  }
  if (suited.empty() || has_many_lights(*this)) return;
  const std::uint32_t cells = buffer_cells(m_parts.objects.size(), camera_rays, suited.size());
  if (!has_room(suited.size(), m_parts.objects.size(), cells)) return;
  const LightCasters casters(m_parts.objects);
  in_ranges(suited.size(), casters.size(), [&](std::size_t first, std::size_t end) {
    LightBufferBuilder builder(casters, kShadowTolerance * m_tolerance_scale);
    for (std::size_t i = first; i < end; ++i) {
      auto buffer = std::make_unique<LightBuffer>(m_parts.lights[suited[i]].position);
      builder.build(*buffer, cells);
      if (!buffer->crowded()) m_light_buffers[suited[i]] = std::move(buffer);
    }
  });
}

Scene::~Scene() = default;

}  // namespace lentray::core
