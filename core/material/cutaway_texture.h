// The texture of a surface that has none of its own in a CSG with cutaway_textures: the mean of the
// textures of those parts that the point is inside of; of a difference, or its first part, only
// the first. Where there is no such part nothing holds, and the surface is black.
// World space. Immutable; the objects it asks belong to the scene and live as long.
// Source: reference manual 3.7, "Cutaway Textures"; measured on stock (tests/image/cutaway_test.cpp).
#pragma once

#include <vector>

#include "core/material/texture.h"
#include "core/object/object.h"

namespace lentray::core {

class CutawayTexture final : public Texture {
 public:
  /// A part of the CSG; one with parts of its own has no texture.
  struct Part {
    const Object* object = nullptr;
    const Texture* texture = nullptr;  ///< null: it has none either
    bool only_first = false;           ///< a difference: the others cut
    std::vector<Part> parts;
  };
  /// Shares below `least` are left out, as adc_bailout says.
  CutawayTexture(Part whole, double least);
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override;
  bool is_opaque() const override { return m_opaque; }
  void collect(std::vector<const LayeredTexture*>& out) const override;

 private:
  Part m_whole;
  double m_least;
  bool m_opaque = true;
};

}  // namespace lentray::core
