// A scene file -> what the kernel compiles and the camera to look through: parsing and building
// in one call, for the programs and the tests.
#pragma once

#include <string>

#include "core/scene/scene.h"
#include "parser/compile/scene.h"
#include "parser/descriptions/scene.h"
#include "parser/interpreter/parser.h"
#include "parser/source/diagnostics.h"

namespace lentray::parser {

struct ReadScene {
  core::SceneParts parts;
  CameraDesc camera;  ///< stock's default camera if the scene has none
  bool has_camera = false;
};

/// Throws ParseError. Warnings and the scene's own messages go to `diagnostics`.
ReadScene read_scene(const std::string& path, SourceManager& sources, Diagnostics& diagnostics,
                     const ParserOptions& options, const BuildOptions& build = {});

/// The descriptions alone. `reads`: gets what of its picture the scene has asked for; null: nobody
/// wants to know. `only_read`: the same of the bytes that reading held besides: tokens, symbols, values.
SceneDesc read_descriptions(const std::string& path, SourceManager& sources,
                            Diagnostics& diagnostics, const ParserOptions& options,
                            PictureReads* reads = nullptr, std::uint64_t* only_read = nullptr);

}  // namespace lentray::parser
