// A scene's descriptions -> what the kernel compiles.
#pragma once

#include "core/scene/scene.h"
#include "parser/compile/object_places.h"
#include "parser/compile/texture_compiler.h"
#include "parser/descriptions/scene.h"
#include "parser/source/diagnostics.h"

namespace lentray::parser {

struct BuildOptions {
  int quality = 9;     ///< +Q
  bool alpha = false;  ///< +UA
  SceneOverrides overrides{};
  ObjectPlaces* places = nullptr;  ///< gets those of SceneParts::objects; null: nobody wants them
};

/// Features that are kept and not rendered yet go to SceneParts::not_rendered, sorted, and are
/// named in one warning.
///
/// SceneSettings::assumed_gamma: a power, or 0 where colours are to be written as they are in the
/// sRGB file: `assumed_gamma srgb` (assumed_gamma_set), or none given before #version 3.7 (not
/// set: stock then does no gamma handling at all, whatever File_Gamma says). None given from
/// #version 3.7 on is 1.
///
/// The objects of the scene are used up: `objects` is empty afterwards.
core::SceneParts build_scene(SceneDesc& scene, Diagnostics& diagnostics,
                             const BuildOptions& options = {});

/// What the scene's textures are compiled with; `settings` of the scene that was built.
TextureSettings texture_settings(const SceneDesc& scene, const core::SceneSettings& settings,
                                 const BuildOptions& options);

}  // namespace lentray::parser
