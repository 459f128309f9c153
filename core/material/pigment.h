// A pigment: a colour for each point. Space: world (a compiled pigment holds the inverse of its
// transforms). Immutable; any number of threads may ask at once.
#pragma once

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/pattern/surface_context.h"

namespace lentray::core {

class Pigment {
 public:
  virtual ~Pigment() = default;
  virtual Colour colour(const Vec3& point, const SurfaceContext& surface) const = 0;
  /// Of a point in space.
  Colour colour(const Vec3& point) const { return colour(point, kNoSurface); }
  /// True only if every colour it can give has filter = transmit = 0.
  virtual bool is_opaque() const = 0;
  /// The one colour it has everywhere, or null.
  virtual const Colour* constant() const { return nullptr; }
};

}  // namespace lentray::core
