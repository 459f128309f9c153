// Textures that choose or blend others by a pattern. Points are in the world; what the entries of
// a map are evaluated at is compiled into them (their pigments carry the pattern's placement).
// Source: reference manual 3.7, "Texture Maps", "Tiles"; `average` texture maps.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/material/blend_map.h"
#include "core/material/placed_pattern.h"
#include "core/material/texture.h"

namespace lentray::core {

using TexturePtr = std::shared_ptr<const Texture>;

TexturePtr make_texture_map(PlacedPattern pattern, BlendMap<TexturePtr> map);
/// Weights need not sum to 1.
TexturePtr make_average_texture(const std::vector<std::pair<double, TexturePtr>>& entries);

}  // namespace lentray::core
