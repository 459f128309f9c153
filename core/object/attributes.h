// What an object looks like and what it is seen by, after inheritance through CSG is resolved.
// Textures, interiors and selections of lights are borrowed: the scene owns them.
// Source: reference manual 3.7, "Object Modifiers".
#pragma once

#include <compare>
#include <cstdint>
#include <optional>

namespace lentray::core {

class Texture;
struct Interior;
struct LightSelection;

/// Which objects a ray passes by unseen. The rule is written twice: unseen_by() in core/accel/hierarchy.cpp
/// for the scene's objects, Csg::is_unseen() for parts of CSG, where it is another in places.
enum class RayKind : std::uint8_t {
  kCamera,       ///< not yet through anything; skips no_image
  kTransmitted,  ///< gone on through surfaces alone; skips no_image
  kReflection,   ///< reflected once or more; skips no_reflection
  // The same of rays that gather light for a surface, which skip no_radiosity too. The first of them skips
  // that alone.
  kGather,
  kGatherTransmitted,
  kGatherReflection,
  // Photons, which skip no_shadow, and besides no_image until they are reflected, then no_reflection.
  kPhoton,
  kPhotonReflection,
  kShadow,  ///< skips no_shadow
};

/// Of a ray that goes on straight or bent, and of one that is mirrored.
constexpr RayKind transmitted(RayKind kind) {
  if (kind == RayKind::kCamera) return RayKind::kTransmitted;
  return kind == RayKind::kGather ? RayKind::kGatherTransmitted : kind;
}
constexpr RayKind reflected(RayKind kind) {
  if (kind >= RayKind::kPhoton) return RayKind::kPhotonReflection;
  return kind >= RayKind::kGather ? RayKind::kGatherReflection : RayKind::kReflection;
}

/// What passes ask of an object (radiosity, photons); most objects have the defaults.
struct PassFlags {
  double importance = 1.0;     ///< of radiosity, 0..1
  double photon_target = 0.0;  ///< its factor of the photons' spacing; 0: it is no target
  std::optional<bool> photon_reflection, photon_refraction;  ///< empty: not said
  bool photon_collect = true, photon_pass_through = false;
  /// The target that it is or is a part of, in Scene::photon_targets(), from 1; 0: none.
  std::uint32_t photon_target_number = 0;
  auto operator<=>(const PassFlags&) const = default;
};

/// Looks and switches of an object, after inheritance through CSG is resolved.
struct Attributes {
  const Texture* texture = nullptr;           ///< owned by the scene; never null after compiling
  const Texture* interior_texture = nullptr;  ///< null: the same as `texture`
  const Interior* interior = nullptr;         ///< null: none was given
  const LightSelection* lights = nullptr;     ///< null: the global ones; owned by the scene
  std::uint32_t pass_flags = 0;               ///< their number in Scene::pass_flags()
  bool no_shadow : 1 = false, no_image : 1 = false, no_reflection : 1 = false;
  bool no_radiosity : 1 = false;
  bool hollow : 1 = false, double_illuminate : 1 = false;
  bool uv_mapping : 1 = false;  ///< textures lie in texture coordinates
};
// There may be a million of them.
static_assert(sizeof(Attributes) == 4 * sizeof(void*) + 8);

}  // namespace lentray::core
