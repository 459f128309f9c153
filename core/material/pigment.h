// A pigment: a colour for each point. Space: world (a compiled pigment holds the inverse of its
// transforms). Immutable; any number of threads may ask at once.
#pragma once

#include <memory>
#include <utility>

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

/// The pigment whose colour at a point of a surface is formula(point, surface).
template <class Formula>
std::shared_ptr<const Pigment> pigment_of(bool is_opaque, Formula formula) {
  class Made final : public Pigment {
   public:
    Made(bool opaque, Formula f) : m_opaque(opaque), m_formula(std::move(f)) {}
    Colour colour(const Vec3& point, const SurfaceContext& surface) const override {
      return m_formula(point, surface);
    }
    bool is_opaque() const override { return m_opaque; }

   private:
    bool m_opaque;
    Formula m_formula;
  };
  return std::make_shared<Made>(is_opaque, std::move(formula));
}

}  // namespace lentray::core
