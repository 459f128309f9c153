// Rays of a place, as samples ask a camera for them.
#pragma once

#include <algorithm>

#include "core/render/ray_source.h"

namespace lentray::test {

/// Ray `number` of a place's pixel. False: there is none.
inline bool place_ray(const core::RaySource& camera, const core::PixelPlace& place,
                      std::uint32_t number, core::Ray& out) {
  const core::EyePlace at = camera.eye_place(static_cast<std::uint32_t>(std::max(place.column, 0)),
                                             static_cast<std::uint32_t>(std::max(place.row, 0)));
  return camera.one_ray_at(place, camera.ray_of(at, number), out);
}

}  // namespace lentray::test
