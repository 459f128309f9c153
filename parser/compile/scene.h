// A scene's descriptions -> what the kernel compiles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "parser/compile/object_places.h"
#include "parser/compile/slope_watches.h"
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

/// What the user is told of a scene besides its picture.
struct BuildReport {
  std::vector<std::string> not_rendered;  ///< features parsed and kept but not rendered yet, sorted
  std::vector<WatchedSlope> slopes;       ///< to report on after rendering
  std::uint64_t texture_bytes = 0;        ///< TextureCompiler::texture_bytes()
};

/// Features that are kept and not rendered yet are named in one warning. `report`: null: nobody
/// wants it.
///
/// SceneSettings::assumed_gamma: a power, or 0 where colours are to be written as they are in the
/// sRGB file: `assumed_gamma srgb` (assumed_gamma_set), or none given before #version 3.7 (not
/// set: stock then does no gamma handling at all, whatever File_Gamma says). None given from
/// #version 3.7 on is 1.
///
/// The objects of the scene are used up: `objects` is empty afterwards.
core::SceneParts build_scene(SceneDesc& scene, Diagnostics& diagnostics,
                             const BuildOptions& options = {}, BuildReport* report = nullptr);

/// What the scene's textures are compiled with; `settings` of the scene that was built.
TextureSettings texture_settings(const SceneDesc& scene, const core::SceneSettings& settings,
                                 const BuildOptions& options);

}  // namespace lentray::parser
