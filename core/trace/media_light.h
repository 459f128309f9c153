// What media make of the light that comes along a ray: they take some of it, send out their own, and
// scatter that of the lights towards the ray's origin. World space; colours linear. One a thread.
// Source: reference manual 3.7, "Media".
#pragma once

#include <optional>
#include <vector>

#include "core/photon/photon_map.h"
#include "core/trace/light_loop.h"
#include "core/trace/media_attenuation.h"
#include "core/trace/media_sampling.h"
#include "core/trace/radiance.h"
#include "core/trace/ray_state.h"

namespace lentray::core {

class MediaLight {
 public:
  MediaLight(ThreadContext& context, ShadowTester& shadows);

  /// In the interiors that the ray lies in, up to a surface of that material.
  void pass_interiors(const RayState& state, double length, int level, const Attributes& attributes,
                      Radiance& light);
  /// In the air. `attributes`: of the surface that the ray meets; null: the sky.
  void pass_air(const RayState& state, double length, int level, const Attributes* attributes,
                Radiance& light);

 private:
  class Probe;
  /// `key`: of the random numbers.
  void pass(const RayState& state, double length, int level, const Attributes* attributes,
            std::uint64_t key, Radiance& light);
  void find_lit_parts(const LightLists& lists, const Ray& ray, double length);

  ThreadContext& m_context;
  LightLoop m_lights;
  const PhotonMap* const m_photons;  ///< null: there are none
  FoundPhotons m_found, m_more;
  LightsAtPoint m_at_point;
  MediaList m_media;
  std::vector<std::optional<RayPart>> m_part_of;  ///< of each light of the scene
  std::vector<RayPart> m_lit;
  IntervalCutter m_cutter;
  std::vector<MediaInterval> m_intervals;
};

}  // namespace lentray::core
