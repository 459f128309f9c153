// What the productions share besides the Parser: the defaults in force while a scene is read.
// One Context a scene; every production takes (Parser&, Context&).
#pragma once

#include <optional>

#include "parser/descriptions/camera.h"
#include "parser/value.h"

namespace lentray::parser {

struct Context {
  /// What `#default { texture / pigment / normal / finish }` has made so far; null: the built-in
  /// default. A texture, pigment ... statement starts from it; an object without a texture takes
  /// the one in force when its outermost statement ends.
  Ref<TextureDesc> default_texture;
  /// `#default { camera { ... } }`: where later camera statements start from.
  CameraDesc default_camera;
};

}  // namespace lentray::parser
