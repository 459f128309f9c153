// Finish and interior descriptions -> the kernel's. Internal to parser/compile.
#pragma once

#include <memory>
#include <optional>

#include "core/material/finish.h"
#include "core/material/interior.h"
#include "parser/descriptions/interior.h"
#include "parser/descriptions/texture.h"

namespace lentray::parser {

/// `least_translucency`: what less is taken for, mm; none: the scene wants no subsurface light.
core::Finish compile_finish(const FinishDesc& finish,
                            std::optional<double> least_translucency = std::nullopt);
/// All but the media. Null if neither gives anything; an old scene's `ior` in the texture's finish wins,
/// as in stock.
std::shared_ptr<core::Interior> compile_interior(const Ref<InteriorDesc>& interior,
                                                 const Ref<TextureDesc>& texture);

}  // namespace lentray::parser
