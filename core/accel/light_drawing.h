// How each kind of object shows from a light: what its own outline is, rather than that of its box.
// World space in. For building light buffers; one a thread.
#pragma once

#include <cstdint>
#include <vector>

#include "core/accel/light_outline.h"
#include "core/accel/light_volume.h"
#include "core/object/object.h"

namespace lentray::core {

/// What a light buffer tests without a detour.
enum class CasterKind : std::uint8_t { kAny, kSphere, kPolygon, kTriangle, kBox };
CasterKind caster_kind(const Shape* shape);

/// The box relative to the light.
inline Bounds relative(const Bounds& b, const Vec3& light) { return {b.lo - light, b.hi - light}; }

class LightDrawing {
 public:
  explicit LightDrawing(const Vec3& light) : m_light(light) {}

  /// An object, its plain_shape() and caster_kind() of that, its box relative to the light.
  struct Subject {
    const Object& object;
    const Shape* shape;
    CasterKind kind;
    const Bounds& box;
    double distance;  ///< of the box
  };
  /// Appends the cells it may darken, each once. `window`: of the box, on the outline's face.
  void outline(const Subject& subject, const LightWindow& window, LightOutline& outline,
               std::vector<LightCell>& out);
  /// Of what was drawn last.
  LightVolume volume(const Subject& subject, const LightVolumes& volumes) const;

 private:
  LightVolume unknown_volume(const Subject& subject, const LightVolumes& volumes) const;
  void triangle_ends(const Shape& shape);
  void polygon_ends(const Shape& shape);

  Vec3 m_light;
  std::vector<Vec3> m_points;  ///< what was drawn last by: ends of edges, a hull, or none
};

}  // namespace lentray::core
