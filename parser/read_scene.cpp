#include "parser/read_scene.h"

#include "parser/grammar/productions.h"
#include "parser/grammar/scene.h"

namespace lentray::parser {

SceneDesc read_descriptions(const std::string& path, SourceManager& sources,
                            Diagnostics& diagnostics, const ParserOptions& options,
                            PictureReads* reads) {
  Grammar grammar;
  Parser parser(sources, diagnostics, options, grammar);
  parser.open(path);
  SceneDesc scene = parse_scene(parser, grammar);
  parser.finish();
  if (reads) *reads = parser.reads();
  return scene;
}

ReadScene read_scene(const std::string& path, SourceManager& sources, Diagnostics& diagnostics,
                     const ParserOptions& options, const BuildOptions& build) {
  SceneDesc scene = read_descriptions(path, sources, diagnostics, options);
  ReadScene out;
  out.parts = build_scene(scene, diagnostics, build);
  out.has_camera = scene.camera.has_value();
  if (scene.camera) out.camera = *scene.camera;
  return out;
}

}  // namespace lentray::parser
