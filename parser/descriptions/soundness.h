// Which objects can be made without a mistake coming to light, told without making them: the simple
// shapes with plain colours, and meshes. For checking a scene that is not rendered.
#pragma once

#include "parser/descriptions/object.h"

namespace lentray::parser {

/// False: it must be made to see. `default_texture` is what it wears if it has none; may be null.
bool is_sound(const ObjectDesc& object, const Ref<TextureDesc>& default_texture);

}  // namespace lentray::parser
