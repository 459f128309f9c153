// A texture: for each point a list of layered textures with weights (one, unless texture maps
// blend), each a stack of layers, topmost last as in SDL. Entries of a map lie in the space of the map's
// pattern: textures that are placed in many ways share them. Immutable while rendering.
// Source: reference manual 3.7, "Texture".
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/material/finish.h"
#include "core/material/normal.h"
#include "core/material/pigment.h"
#include "core/pattern/placement.h"

namespace lentray::core {

class LayeredTexture;

/// The space of a map's entries, inside another; number 0 is the world, number n the n-th of a list.
struct TextureSpace {
  const Placement* placement = nullptr;
  std::uint32_t around = 0;
};

/// Where the layers of a texture are asked.
struct TexturePlace {
  Vec3 point;  ///< in its space
  std::uint32_t space = 0;
  /// The list, until the WeightedTextures that it is of are cleared.
  const TextureSpace* spaces = nullptr;

  /// A unit normal of the world -> the unit normal that a layer makes of it, in its space: as its pigment sees it.
  Vec3 perturbed(const NormalPerturbation& by, const Vec3& normal,
                 const SurfaceContext& surface) const {
    return by.perturb(point, space == 0 ? normal : inside(normal), surface);
  }
  /// Such a normal -> the world's.
  Vec3 outwards(const Vec3& normal) const { return space == 0 ? normal : outside(normal); }

 private:
  Vec3 inside(const Vec3& normal) const;
  Vec3 outside(Vec3 normal) const;
};

struct WeightedTexture {
  const LayeredTexture* texture = nullptr;
  double weight = 1.0;
  Vec3 point;  ///< where it is asked, in its space
  std::uint32_t space = 0;
};

/// What Texture::resolve() finds. Reused by the tracer; cleared by the caller.
class WeightedTextures {
 public:
  void clear() {
    m_textures.clear();
    m_spaces.clear();
  }
  void add(const LayeredTexture* texture, double weight, const Vec3& point) {
    m_textures.push_back({texture, weight, point, m_space});
  }
  /// What is added until leave() lies in a space inside the present one, whose number it gives to leave().
  std::uint32_t enter(const Placement& placement) {
    const std::uint32_t around = m_space;
    if (placement.is_none()) return around;
    m_spaces.push_back({&placement, around});
    m_space = static_cast<std::uint32_t>(m_spaces.size());
    return around;
  }
  void leave(std::uint32_t around) { m_space = around; }

  std::size_t size() const { return m_textures.size(); }
  const WeightedTexture& operator[](std::size_t i) const { return m_textures[i]; }
  const WeightedTexture& front() const { return m_textures.front(); }
  auto begin() const { return m_textures.begin(); }
  auto end() const { return m_textures.end(); }
  TexturePlace place(const WeightedTexture& one) const {
    return {one.point, one.space, m_spaces.data()};
  }

 private:
  std::vector<WeightedTexture> m_textures;
  std::vector<TextureSpace> m_spaces;
  std::uint32_t m_space = 0;
};

class Texture {
 public:
  virtual ~Texture() = default;
  /// Adds the layered textures that hold at a point of a surface; the weights added sum to
  /// `weight`. The point is the world's, or the surface's own (u, v, 0) under uv_mapping; for an entry
  /// of a map it lies in the map's space.
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
  void resolve(const Vec3& point, const SurfaceContext&, double weight,
               WeightedTextures& out) const override {
    out.add(this, weight, point);
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

 private:
  virtual std::span<const std::shared_ptr<const Texture>> parts() const = 0;
};

}  // namespace lentray::core
