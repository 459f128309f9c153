// What an object looks like and what it is seen by, after inheritance through CSG is resolved.
// Textures, interiors and selections of lights are borrowed: the scene owns them.
// Source: reference manual 3.7, "Object Modifiers".
#pragma once

#include <cstdint>

namespace lentray::core {

class Texture;
struct Interior;
struct LightSelection;

/// Which objects a ray passes by unseen.
enum class RayKind : std::uint8_t {
  kCamera,       ///< not yet through anything; skips no_image
  kTransmitted,  ///< gone on through surfaces alone; skips no_image
  kReflection,   ///< reflected once or more; skips no_reflection
  kShadow,       ///< skips no_shadow
};

/// Looks and switches of an object, after inheritance through CSG is resolved.
struct Attributes {
  const Texture* texture = nullptr;           ///< owned by the scene; never null after compiling
  const Texture* interior_texture = nullptr;  ///< null: the same as `texture`
  const Interior* interior = nullptr;         ///< null: none was given
  const LightSelection* lights = nullptr;     ///< null: the global ones; owned by the scene
  bool no_shadow = false, no_image = false, no_reflection = false;
  bool hollow = false, double_illuminate = false;
  bool uv_mapping = false;  ///< textures lie in texture coordinates
};

}  // namespace lentray::core
