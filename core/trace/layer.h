// A layer of a texture at a place of a surface, evaluated: all of it but the light that comes from elsewhere. World
// space; colours linear. Plain values.
// Source: reference manual 3.7, "Finish", "Layered Textures".
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec3.h"
#include "core/material/finish.h"
#include "core/trace/reflectance.h"

namespace lentray::core {

struct Layer {
  Layer() {}  // not defaulted: that would clear all
  const Finish* finish;
  Vec3 normal;  ///< unit, facing the ray
  Rgb pigment;
  Rgb own;              ///< light that needs no other: ambient and emission
  double opacity;       ///< its share of the light
  double diffuse;       ///< of the finish, that share
  Reflectivity mirror;  ///< colour black: none
  Rgb below;            ///< of what is seen behind, what passes this layer and those above it
  double clear;         ///< the same as a number, 0..1
  bool is_turned;       ///< it has a normal of its own
  bool is_lit;          ///< by lights
  bool shines;          ///< highlights
};

/// From the top.
using Layers = std::span<const Layer>;

/// One of several textures that blend at a place.
struct TexturePart {
  double weight;
  std::uint32_t layers;  ///< of the place's, in their order
};

/// The layers of places, one place after the other. Used again; no allocation once it has grown.
struct LayerBuffer {
  std::vector<Layer> layers;
  std::vector<TexturePart> parts;
  void clear() {
    layers.clear();
    parts.clear();
  }
};

/// Of one place, in a buffer.
struct PlaceLayers {
  std::uint32_t first = 0, count = 0;
  std::uint32_t first_part = 0, parts = 0;  ///< none: one texture
  bool is_plain = false;                    ///< core/trace/plain_lights.h can light them all
  Layers of(const LayerBuffer& buffer) const { return {buffer.layers.data() + first, count}; }
  std::span<const TexturePart> parts_of(const LayerBuffer& buffer) const {
    return {buffer.parts.data() + first_part, parts};
  }
};

}  // namespace lentray::core
