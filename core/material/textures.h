// Textures that choose or blend others by a pattern, in whose space these lie.
// Source: reference manual 3.7, "Texture Maps", "Tiles"; `average` texture maps.
#pragma once

#include <memory>

#include "core/material/blend_map.h"
#include "core/material/placed_pattern.h"
#include "core/material/texture.h"

namespace lentray::core {

using TexturePtr = std::shared_ptr<const Texture>;

TexturePtr make_texture_map(PlacedPattern pattern, const BlendMap<TexturePtr>& map);
/// Weights need not sum to 1.
TexturePtr make_average_texture(Placement placement, const BlendMap<TexturePtr>& map);
/// A texture inside another space.
TexturePtr make_placed_texture(Placement placement, const TexturePtr& texture);

}  // namespace lentray::core
