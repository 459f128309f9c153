#include "parser/descriptions/object.h"

#include <utility>

#include "parser/descriptions/texture.h"

namespace lentray::parser {

void settle_texture(ObjectDesc& object) {
  if (!object.texture_waits) return;
  object.texture = transformed(std::move(object.texture), *object.transform);
  object.texture_waits = false;
}

}  // namespace lentray::parser
