#include "parser/read_scene.h"

#include <algorithm>

#include "core/base/memory_stages.h"
#include "parser/grammar/productions.h"
#include "parser/grammar/scene.h"

namespace lentray::parser {

SceneDesc read_descriptions(const std::string& path, SourceManager& sources,
                            Diagnostics& diagnostics, const ParserOptions& options,
                            PictureReads* reads, std::uint64_t* only_read) {
  SceneDesc scene;
  std::uint64_t held = 0;
  {
    Grammar grammar;
    Parser parser(sources, diagnostics, options, grammar);
    parser.open(path);
    scene = parse_scene(parser, grammar);
    parser.finish();
    if (reads) *reads = parser.reads();
    if (only_read) held = core::heap_bytes();
  }
  if (only_read) *only_read = held - std::min(held, core::heap_bytes());
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
