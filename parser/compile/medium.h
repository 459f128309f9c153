// Descriptions of media -> the kernel's. Internal to parser/compile.
#pragma once

#include <functional>
#include <memory>

#include "core/material/medium.h"
#include "parser/descriptions/media.h"
#include "parser/descriptions/pigment.h"
#include "parser/options/scene_overrides.h"

namespace lentray::parser {

using AsPigmentMap = std::function<Ref<PigmentMapDesc>(const Ref<DensityMapDesc>&)>;

/// A density is a pigment whose colours are amounts. `as_map` gives the map of one that has a map.
PigmentDesc as_pigment(const DensityDesc& density, const AsPigmentMap& as_map);
Ref<PigmentMapDesc> as_pigment_map(const DensityMapDesc& densities);

/// `density` compiles one.
std::shared_ptr<const core::Medium> compile_medium(
    const MediaDesc& media, const MediaSettings& instead,
    const std::function<core::PigmentPtr(const DensityDesc&)>& density);

}  // namespace lentray::parser
