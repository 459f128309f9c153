#include "core/trace/area_shaft.h"

#include <algorithm>
#include <cmath>

#include "core/accel/hierarchy.h"
#include "core/scene/scene.h"
#include "core/scene/tolerances.h"
#include "core/trace/thread_context.h"

namespace lentray::core {
namespace {

/// How far samples lie from the light's position, in its axis: with the jitter of half a step.
double reach_of(int size) {
  constexpr double kOffCentre = 0.002;  // above that of a circular light
  return size > 1 ? 0.5 + 0.5 / (size - 1) + kOffCentre : kOffCentre;
}

}  // namespace

AreaShaft::AreaShaft(const ThreadContext& context)
    : m_context(context),
      // Tests are counted ray by ray.
      m_works(!context.tests && context.scene.hierarchy().takes_bundles()),
      m_tolerance(kShadowTolerance * context.scene.tolerance_scale()) {}

OnlyObject AreaShaft::only_object(const Vec3& point, const Vec3& position, const AreaLight& area,
                                  const AreaAxes& axes) {
  if (!m_works) return {};
  if (m_resting > 0) {
    --m_resting;
    return {};
  }
  const Vec3 middle = position - point;
  const double along1 = reach_of(area.size1), along2 = reach_of(area.size2);
  Vec3 lo, hi;
  double farthest = 0.0;
  for (int a = 0; a < 3; ++a) {
    constexpr double kRounding = 1e-9;
    const double reach = std::fabs(axes.first[a]) * along1 + std::fabs(axes.second[a]) * along2 +
                         kRounding * (std::fabs(point[a]) + std::fabs(position[a]));
    lo[a] = middle[a] - reach;
    hi[a] = middle[a] + reach;
    farthest += std::max(std::fabs(lo[a]), std::fabs(hi[a]));
  }
  if (!(farthest > 0.0 && farthest < 1e300)) return {};
  m_hull.clear();
  m_hull.add({point, lo});
  m_hull.add({point, hi});
  m_hull.fill_up();
  constexpr double kBeyondRounding = 0.5;
  OnlyObject only;
  only.is_known = m_context.scene.hierarchy().only_opaque(
      m_hull, kBeyondRounding * m_tolerance / farthest, only.object);
  constexpr std::uint32_t kMostRest = 256;
  m_rest = only.is_known ? 0 : std::min(2 * m_rest + 1, kMostRest);
  m_resting = m_rest;
  return only;
}

}  // namespace lentray::core
