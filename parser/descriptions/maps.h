// Blend maps as written: values of a pattern (0..1) with what holds there, in the order given.
// A list without values (`checker pigment {A} pigment {B}`) is a map with values 0, 1, 2 ...
// Source: reference manual 3.7, "Color Maps", "Pigment Maps", "Normal Maps", "Slope Maps",
// "Texture Maps", "Density Maps".
#pragma once

#include <vector>

#include "core/base/color.h"
#include "core/material/blend_map.h"
#include "parser/source/source.h"
#include "parser/values/value.h"

namespace lentray::parser {

template <typename Item>
struct BlendEntry {
  double value = 0.0;  ///< pattern value; in `average` maps the weight
  Item item{};
};

template <typename Item>
struct BlendMapDesc {
  Location where;
  std::vector<BlendEntry<Item>> entries;
};
struct ColourMapDesc : BlendMapDesc<core::Colour> {};
struct PigmentMapDesc : BlendMapDesc<Ref<PigmentDesc>> {};
struct NormalMapDesc : BlendMapDesc<Ref<NormalDesc>> {};
struct SlopeMapDesc : BlendMapDesc<core::SlopePoint> {};
struct TextureMapDesc : BlendMapDesc<Ref<TextureDesc>> {};
struct DensityMapDesc : BlendMapDesc<Ref<DensityDesc>> {};

}  // namespace lentray::parser
