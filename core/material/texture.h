// A texture: for each point a list of layered textures with weights (one, unless texture maps
// blend), each a stack of layers, topmost last as in SDL. Immutable while rendering.
// Source: reference manual 3.7, "Texture".
#pragma once

#include <memory>
#include <vector>

#include "core/material/finish.h"
#include "core/material/normal.h"
#include "core/material/pigment.h"

namespace lentray::core {

class LayeredTexture;

struct WeightedTexture {
  const LayeredTexture* texture = nullptr;
  double weight = 1.0;
};
/// Reused by the tracer; cleared by the caller.
using WeightedTextures = std::vector<WeightedTexture>;

class Texture {
 public:
  virtual ~Texture() = default;
  /// Appends the layered textures that hold at a point of a surface; the weights added sum to
  /// `weight`. The point is the world's, or the surface's own (u, v, 0) under uv_mapping.
  virtual void resolve(const Vec3& point, const SurfaceContext& surface, double weight,
                       WeightedTextures& out) const = 0;
  /// The layered texture that holds at every point, or null.
  virtual const LayeredTexture* everywhere() const { return nullptr; }
  virtual bool is_opaque() const = 0;
  /// Every layered texture that resolve() can give.
  virtual void collect(std::vector<const LayeredTexture*>& out) const = 0;
};

struct TextureLayer {
  std::shared_ptr<const Pigment> pigment;  ///< never null
  std::shared_ptr<const Finish> finish;    ///< the same; layers that answer light alike share it
  std::shared_ptr<const NormalPerturbation> normal = nullptr;  ///< null: the surface's own normal
};

class LayeredTexture final : public Texture {
 public:
  explicit LayeredTexture(std::vector<TextureLayer> layers) : m_layers(std::move(layers)) {}
  void resolve(const Vec3&, const SurfaceContext&, double weight,
               WeightedTextures& out) const override {
    out.push_back({this, weight});
  }
  const LayeredTexture* everywhere() const override { return this; }
  /// A stack is opaque if one of its layers is.
  bool is_opaque() const override;
  void collect(std::vector<const LayeredTexture*>& out) const override { out.push_back(this); }
  const std::vector<TextureLayer>& layers() const { return m_layers; }

 private:
  std::vector<TextureLayer> m_layers;
};

/// Chooses among other textures, or blends them.
class CompositeTexture : public Texture {
 public:
  bool is_opaque() const final;
  void collect(std::vector<const LayeredTexture*>& out) const final;

 protected:
  CompositeTexture() = default;
  explicit CompositeTexture(std::vector<std::shared_ptr<const Texture>> textures)
      : m_textures(std::move(textures)) {}
  std::vector<std::shared_ptr<const Texture>> m_textures;
};

}  // namespace lentray::core
