// The looks of a blob whose elements have textures of their own: at a point those of all elements
// that reach it, by the strength of their fields. World space. Immutable.
// Source: reference manual 3.7, "Blob"; compared with stock by image.shapes.
#pragma once

#include <vector>

#include "core/material/texture.h"
#include "core/shape/blob.h"

namespace lentray::core {

class BlobTexture final : public Texture {
 public:
  struct Element {
    BlobField field;  ///< `to_blob` leads to the world here
    std::shared_ptr<const Texture> texture;
  };
  /// Shares below `least` are left out, as adc_bailout says.
  BlobTexture(std::vector<Element> elements, double least)
      : m_elements(std::move(elements)), m_least(least) {}
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override;
  bool is_opaque() const override;
  void collect(std::vector<const LayeredTexture*>& out) const override;

 private:
  std::vector<Element> m_elements;
  double m_least;
};

}  // namespace lentray::core
