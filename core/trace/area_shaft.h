// What stands between a point and an area light: the shaft that holds all shadow rays from the point to the light is
// searched once, and where at most one object stands in it no ray asks any other. World space. One a thread.
// Earlier shafts decide whether a shaft is searched, never what a ray meets: a shaft only tells what cannot be met.
#pragma once

#include <cstdint>

#include "core/bundle/ray_bundle.h"
#include "core/light/area_light.h"

namespace lentray::core {

class Object;
struct ThreadContext;

/// The only opaque object that rays may meet.
struct OnlyObject {
  bool is_known = false;           ///< false: there may be others
  const Object* object = nullptr;  ///< null: none is met
};

class AreaShaft {
 public:
  explicit AreaShaft(const ThreadContext& context);
  /// Of the rays from a point to the samples of a light at `position`.
  OnlyObject only_object(const Vec3& point, const Vec3& position, const AreaLight& area,
                         const AreaAxes& axes);

 private:
  const ThreadContext& m_context;
  const bool m_works;
  const double m_tolerance;  ///< of shadows
  RayBundle m_hull;
  /// Where several objects stand in a shaft they do so in the next ones, too, most often: so many are not searched,
  /// more each time.
  std::uint32_t m_resting = 0, m_rest = 0;
};

}  // namespace lentray::core
