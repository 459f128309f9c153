// The compiled scene: flat, everything the kernel asks while rendering.
// World space. Built once (parser/compile), then shared const by all threads; between pictures its light
// buffers may be made anew.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/accel/accelerator.h"
#include "core/base/color.h"
#include "core/irradiance/settings.h"
#include "core/light/light.h"
#include "core/material/interior.h"
#include "core/material/texture.h"
#include "core/object/object.h"
#include "core/photon/photon_maps.h"
#include "core/photon/settings.h"
#include "core/photon/target.h"
#include "core/scene/atmosphere.h"
#include "core/scene/needs.h"
#include "core/subsurface/settings.h"

namespace lentray::core {

class Hierarchy;
class LightBuffer;

/// From global_settings and the atmosphere; defaults are those of `#version 3.7`.
struct SceneSettings {
  int max_trace_level = 5;
  double adc_bailout = 1.0 / 255.0;
  Rgb ambient_light{1.0f, 1.0f, 1.0f};
  double assumed_gamma = 1.0;  ///< 1: linear; scene colours are decoded by the parser already
  bool assumed_gamma_set = false;
  std::optional<RadiositySettings> radiosity;        ///< none: light sources alone light surfaces
  std::optional<PhotonSettings> photons;             ///< none: there are no photons
  std::shared_ptr<const PhotonMaps> loaded_photons;  ///< null: they are shot
  std::optional<SubsurfaceSettings> subsurface;      ///< none: translucent surfaces are as others
  double mm_per_unit = 10.0;                         ///< positive
  Colour background;                                 ///< opaque unless `alpha`
  bool alpha = false;         ///< +UA: the picture is as clear as what its rays see of the sky
  bool mirror_images = true;  ///< false: reflection dims what conserves energy, shows nothing
  double atmosphere_ior = 1.0;
  int noise_generator = 2;                 ///< for thin films of uneven thickness
  Vec3 irid_wavelength{0.70, 0.52, 0.48};  ///< of red, green, blue, in thousands of nanometres
  int language_version = 370;  ///< #version x 100, for the few renderings that depend on it
};

/// sky_sphere: pigments over the unit sphere of directions, later ones on top.
struct SkySphere {
  std::vector<std::shared_ptr<const Pigment>> pigments;
  Rgb emission{1.0f, 1.0f, 1.0f};
};

/// What a scene is made of, before compiling: the parser's build step fills this.
struct SceneParts {
  SceneSettings settings;
  std::vector<std::unique_ptr<Object>> objects;  ///< the top level, in scene order
  std::vector<Light> lights;
  std::vector<std::unique_ptr<Object>> projectors;  ///< that lights shine through
  std::unique_ptr<SkySphere> sky_sphere;            ///< null: none
  Atmosphere atmosphere;
  std::vector<std::shared_ptr<const Texture>> textures;  ///< owners of what Attributes point at
  std::vector<std::shared_ptr<const Interior>> interiors;
  std::vector<std::unique_ptr<const LightSelection>> light_selections;  ///< likewise
  std::vector<PassFlags> pass_flags{{}};                                ///< likewise; 0: defaults
  std::vector<PhotonTarget> photon_targets;  ///< in the order in which they are shot at
  std::uint64_t picture_bytes = 0;           ///< of pictures that textures hold
  std::size_t deepest = 1;                   ///< most levels of objects and textures in each other
};

struct CompileOptions {
  bool general_path = false;  ///< as if it had everything, at the same bits: to see what that saves
  Accelerator accelerator = Accelerator::kBvh;
};

class Scene {
 public:
  Scene(SceneParts parts,
        const CompileOptions& options);  ///< compiles: splits unions, builds the hierarchy
  ~Scene();
  /// Light_Buffer: cells of directions about each light, as fine as pays for so many camera rays,
  /// in place of those there were. Only beside the hierarchy: who asks for a grid or a list asks
  /// for its search. The one thing that changes in a scene: between pictures, never while one is
  /// rendered.
  void build_light_buffers(std::uint64_t camera_rays);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const SceneSettings& settings() const { return m_parts.settings; }
  std::size_t deepest() const { return m_parts.deepest; }
  const std::vector<Light>& lights() const { return m_parts.lights; }
  /// Indices of those that no light_group has.
  const std::vector<std::uint32_t>& global_lights() const { return m_global_lights; }
  const SkySphere* sky_sphere() const { return m_parts.sky_sphere.get(); }
  const Atmosphere& atmosphere() const { return m_parts.atmosphere; }
  /// What passes ask of an object, by Attributes::pass_flags.
  const PassFlags& pass_flags(const Attributes& attributes) const {
    return m_parts.pass_flags[attributes.pass_flags];
  }
  const std::vector<PhotonTarget>& photon_targets() const { return m_parts.photon_targets; }
  const Hierarchy& hierarchy() const { return *m_hierarchy; }
  /// Of that light, or null: the hierarchy answers for it.
  const LightBuffer* light_buffer(std::size_t light) const { return m_light_buffers[light].get(); }
  const Needs& needs() const { return m_needs; }
  /// What kMinHitDistance and kShadowTolerance are multiplied by: 1, but less where all objects
  /// together are less than a unit across: such scenes would lose shadows, then everything.
  double tolerance_scale() const { return m_tolerance_scale; }
  /// Objects after splitting top-level unions; the hierarchy and the cache speak of these.
  const std::vector<std::unique_ptr<Object>>& objects() const { return m_parts.objects; }

 private:
  SceneParts m_parts;
  std::unique_ptr<Hierarchy> m_hierarchy;
  const Accelerator m_accelerator;
  std::vector<std::unique_ptr<LightBuffer>> m_light_buffers;  ///< one a light, null where none
  std::vector<std::uint32_t> m_global_lights;
  Needs m_needs;
  double m_tolerance_scale = 1.0;
};

}  // namespace lentray::core
