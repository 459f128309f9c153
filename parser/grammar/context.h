// What the productions share besides the Parser: the defaults in force while a scene is read.
// One Context a scene; every production takes (Parser&, Context&).
#pragma once

#include <map>
#include <string>

#include "parser/descriptions/camera.h"
#include "parser/files/files.h"
#include "parser/grammar/material.h"

namespace lentray::parser {

struct Context {
  /// Looks: `#default { texture / pigment / normal / finish }` and what patterns need of objects.
  MaterialContext materials;
  /// `#default { camera { ... } }`: where later camera statements start from.
  CameraDesc default_camera;
  /// `#default { radiosity { importance n } }`.
  double default_importance = 1.0;
  /// Fonts of texts, by the names that the scene gives: each is looked for once.
  std::map<std::string, FoundFile> fonts;
};

}  // namespace lentray::parser
