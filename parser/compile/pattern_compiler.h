// Descriptions of patterns and their placement -> the kernel's. Internal to parser/compile.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "core/material/blend_map.h"
#include "core/material/picture.h"
#include "core/material/pigment.h"
#include "core/material/placed_pattern.h"
#include "core/pattern/density_grid.h"
#include "core/pattern/single.h"
#include "parser/compile/texture_compiler.h"
#include "parser/descriptions/maps.h"
#include "parser/descriptions/pattern.h"

namespace lentray::parser {

struct PatternBuild {
  const TextureSettings& settings;
  std::set<std::string>& not_yet;
  /// For the pattern of a pigment's grey.
  std::function<std::shared_ptr<const core::Pigment>(const Ref<PigmentDesc>&)> pigment;
  /// For image_pattern.
  std::function<core::MappedPicturePtr(const ImageDesc&)> picture;
  /// For density_file.
  std::function<std::shared_ptr<const core::DensityGrid>(const FoundFile&)> density;
};

using core::single;

core::Placement compile_placement(const PatternDesc& pattern);
/// Never null: a pattern that is not rendered yet is named and gives 1/2 everywhere.
core::PatternPtr compile_pattern(const PatternDesc& pattern, const PatternBuild& build);
core::Wave compile_wave(const PatternDesc& pattern);
/// The whole.
core::PlacedPattern compile_placed(const PatternDesc& pattern, const PatternBuild& build);
int noise_generator(const PatternDesc& pattern, const TextureSettings& settings);
/// The colours of a pattern that was given no map.
core::BlendMap<core::Colour> default_colours(PatternKind kind);

}  // namespace lentray::parser
