// A whole scene as its text described it, in the order of the text.
#pragma once

#include <optional>
#include <vector>

#include "parser/descriptions/atmosphere.h"
#include "parser/descriptions/camera.h"
#include "parser/descriptions/global.h"
#include "parser/descriptions/object.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct SceneObject {
  Ref<ObjectDesc> object;
  Ref<TextureDesc> default_texture;  ///< in force when the statement ended; null: built in
  double default_importance = 1.0;   ///< the same, of radiosity
};

struct SceneDesc {
  std::vector<SceneObject> objects;
  std::size_t dropped = 0;           ///< read, found sound and not kept (ParserOptions::only_check)
  std::optional<CameraDesc> camera;  ///< the last one wins, as in stock
  GlobalDesc global;
  core::Colour background;  ///< black and opaque unless the scene says otherwise
  bool has_background = false;
  int background_version = 370;  ///< #version x 100 where it stood: before 3.7 it is opaque
  std::vector<FogDesc> fogs;
  std::vector<RainbowDesc> rainbows;
  std::optional<SkySphereDesc> sky_sphere;
  std::vector<Ref<MediaDesc>> atmosphere_media;
  double atmosphere_ior = 1.0;
  std::size_t deepest = 1;     ///< most levels of objects and textures in each other, used or not
  int language_version = 370;  ///< x 100, at the end of the text; 362 if it has no #version
};

}  // namespace lentray::parser
