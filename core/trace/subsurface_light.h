// The light that a surface sends on after it went through the solid below: scattered there many times, once,
// or never. World space; colours linear. One a thread.
//
// Many times: from a point below the surface, directions all around find places of the same solid where light
// enters; the dipole says what of it leaves here. Once: places along the refracted ray are lit through the
// surface, straight. Never: the refracted ray goes on; that one is left to whoever follows rays.
// Source: reference manual 3.7, "Subsurface Light Transport"; Jensen, Marschner, Levoy, Hanrahan: "A Practical
// Model for Subsurface Light Transport", SIGGRAPH 2001; what is sampled and how it is weighed gives stock's
// pictures (tests/image/subsurface_test.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/material/finish.h"
#include "core/subsurface/scattering.h"
#include "core/trace/light_loop.h"
#include "core/trace/path_rules.h"
#include "core/trace/ray_state.h"

namespace lentray::core {

/// A ray that goes on through the solid, and what is left of its light.
struct UnscatteredRay {
  Ray ray;
  Rgb left;   ///< black: there is none
  Rgb share;  ///< of that, which the layers above let through
};

class SubsurfaceLight {
 public:
  SubsurfaceLight(ThreadContext& context, ShadowTester& shadows, const PathRules& rules);

  /// A layer's. `share`: what of it counts in the ray's light; `through`: what comes on top.
  Rgb at(const Surface& surface, const SubsurfaceFinish& finish, const Rgb& pigment,
         const Rgb& share, UnscatteredRay& through);

 private:
  /// Where the light leaves.
  struct Exit;
  struct Receiver;
  struct AllLights;
  /// Where light is scattered once, mm of the refracted ray from the exit.
  struct InnerPlace {
    Vec3 point;
    double depth;
    std::size_t channel;
  };
  struct AskedQuery {
    std::uint32_t number;
    Rgb share;
  };

  const ReducedAlbedo& albedo(double ior);
  Exit exit_at(const Surface& surface, const SubsurfaceFinish& finish, const Rgb& pigment);
  bool nearest(const Ray& ray, double from, double to, Hit& hit);
  Vec3 below(const Exit& exit);
  Rgb scattered_often(const Exit& exit, int samples, const Rgb& share);
  Rgb leaving(const Exit& exit, const Vec3& point, double area) const;
  Rgb entering(const Exit& exit, const Vec3& point, const Vec3& normal, const LightLists& lights,
               std::uint64_t key);
  Rgb indirectly(const Exit& exit, const Vec3& point, const Vec3& normal, double area,
                 const Rgb& leaves);
  Rgb scattered_once(const Exit& exit, const Vec3& direction, double length, int samples);
  float of_one(const Exit& exit, const InnerPlace& place, const std::uint32_t& light,
               std::uint64_t key);
  void pass_through(const Exit& exit, const Vec3& direction, const Hit& behind,
                    UnscatteredRay& through) const;

  ThreadContext& m_context;
  const SceneSettings& m_settings;
  const PathRules m_rules;
  const double m_min_distance;  ///< kMinHitDistance in this scene
  LightLoop m_lights;
  LightsAtPoint m_known;                 ///< nothing: each place is asked for once
  std::vector<ReducedAlbedo> m_albedos;  ///< those met so far
  std::vector<AskedQuery> m_asked;       ///< of radiosity, for the surface
};

}  // namespace lentray::core
