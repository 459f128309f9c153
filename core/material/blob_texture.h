// The texture of a blob whose elements have textures of their own: at a point those of all elements
// that reach it, by the strength of their fields. World space. Immutable.
// Source: reference manual 3.7, "Blob"; compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <vector>

#include "core/material/texture.h"
#include "core/shape/blob_fields.h"

namespace lentray::core {

class BlobTexture final : public CompositeTexture {
 public:
  struct Element {
    BlobField field;  ///< `to_blob` leads to the world here
    std::shared_ptr<const Texture> texture;
  };
  /// Shares below `least` are left out, as adc_bailout says.
  BlobTexture(std::vector<Element> elements, double least);
  void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
               WeightedTextures& out) const override;

 private:
  std::span<const std::shared_ptr<const Texture>> parts() const override { return m_textures; }

  BlobFields m_fields;  ///< one a texture
  std::vector<std::shared_ptr<const Texture>> m_textures;
  double m_least;
};

}  // namespace lentray::core
