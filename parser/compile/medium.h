// Descriptions of media -> the kernel's. Internal to parser/compile.
#pragma once

#include <functional>
#include <memory>

#include "core/material/medium.h"
#include "parser/descriptions/media.h"
#include "parser/descriptions/pigment.h"
#include "parser/options/scene_overrides.h"

namespace lentray::parser {

/// `pigment` compiles one: a density is a pigment whose colours are amounts.
std::shared_ptr<const core::Medium> compile_medium(
    const MediaDesc& media, const MediaSettings& instead,
    const std::function<core::PigmentPtr(const Ref<PigmentDesc>&)>& pigment);

}  // namespace lentray::parser
