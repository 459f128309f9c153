#include "core/trace/first_hits.h"

#include <algorithm>
#include <cmath>

#include "core/accel/hierarchy.h"
#include "core/scene/tolerances.h"
#include "core/trace/thread_context.h"
#include "core/trace/unit_ray.h"

namespace lentray::core {
namespace {

constexpr std::size_t kFewest = 6;       ///< rays that are searched together
constexpr std::uint32_t kMostRest = 64;  ///< finds

/// How many of the rays run side by side with the first: up to where a step from one to the next is much longer than
/// the steps at the beginning, as from one column of a lens sheet to the next.
std::size_t count_together(std::span<const Ray> rays) {
  constexpr double kMuch = 16.0 * 16.0, kNothing = 1e-20;
  if (rays.size() < 3) return rays.size();
  const auto turn = [&](std::size_t i) {
    return length_squared(rays[i].direction - rays[i - 1].direction);
  };
  const auto move = [&](std::size_t i) {
    return length_squared(rays[i].origin - rays[i - 1].origin);
  };
  const double most_turn = kMuch * std::min(turn(1), turn(2)) + kNothing;
  const double moved = std::min(move(1), move(2));
  const double most_move = kMuch * moved + kNothing * length_squared(rays[0].origin);
  for (std::size_t i = 1; i < rays.size(); ++i) {
    if (!(turn(i) <= most_turn && move(i) <= most_move)) return i;
  }
  return rays.size();
}

bool has_finite_numbers(const Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  return std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z) + std::fabs(d.x) + std::fabs(d.y) +
             std::fabs(d.z) <
         1e300;  // no number is not less
}

}  // namespace

FirstHits::FirstHits(ThreadContext& context)
    : m_context(context),
      // Tests are counted ray by ray.
      m_works(!context.tests && context.scene.hierarchy().takes_bundles()),
      m_min_distance(kMinHitDistance * context.scene.tolerance_scale()) {}

std::size_t FirstHits::find(std::span<const Ray> rays) {
  if (m_resting > 0) {
    --m_resting;
    m_hits.answer.fill(BundleHits::Answer::kUnknown);
    return rays.size();
  }
  const std::size_t count = count_together(rays);
  if (count < kFewest || !find_together(rays.first(count))) {
    m_hits.answer.fill(BundleHits::Answer::kUnknown);
  }
  return count;
}

bool FirstHits::find_together(std::span<const Ray> rays) {
  m_bundle.clear();
  for (const Ray& ray : rays) {
    if (!has_finite_numbers(ray)) return false;
    m_bundle.add(unit_ray(ray));
  }
  m_bundle.fill_up();
  const bool is_found = m_context.scene.hierarchy().nearest(
      m_bundle, m_min_distance, RayKind::kCamera, m_hits, m_context.lists);
  if (is_found) {
    m_rest = 0;
  } else {
    m_rest = std::min(2 * m_rest + 1, kMostRest);
    m_resting = m_rest;
  }
  return is_found;
}

}  // namespace lentray::core
