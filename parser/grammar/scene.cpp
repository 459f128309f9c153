#include "parser/grammar/scene.h"

#include "parser/grammar/atmosphere.h"
#include "parser/grammar/camera.h"
#include "parser/grammar/global.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"

namespace lentray::parser {
namespace {

using Statement = void (*)(Parser&, Grammar&, SceneDesc&);
struct StatementEntry {
  Keyword keyword;
  Statement read;
};

void read_camera(Parser& parser, Grammar& grammar, SceneDesc& scene) {
  const bool fresh = parser.language_version() >= 350 || !scene.camera;
  if (scene.camera && parser.language_version() >= 350) {
    parser.warn("More than one camera in the scene; the last one is used.");
  }
  const CameraDesc start = fresh ? grammar.context().default_camera : *scene.camera;
  scene.camera = parse_camera(parser, grammar.context(), start);
}

/// The version that holds for rendering. Measured on stock: a scene without #version, though read
/// with today's grammar, is rendered as one of 3.62.
int rendered_version(const Parser& parser) {
  return parser.language_version_set() ? parser.language_version() : 362;
}

void read_background(Parser& parser, Grammar& grammar, SceneDesc& scene) {
  scene.background = parse_background(parser, grammar.context());
  scene.background_version = rendered_version(parser);
  scene.has_background = true;
}

void read_sky_sphere(Parser& parser, Grammar& grammar, SceneDesc& scene) {
  if (scene.sky_sphere) parser.warn("Only one sky_sphere allowed; the last one is used.");
  scene.sky_sphere = parse_sky_sphere(parser, grammar.context());
}

const std::array kStatements{
    StatementEntry{Keyword::kBackground, read_background},
    StatementEntry{Keyword::kCamera, read_camera},
    StatementEntry{Keyword::kDefault, [](Parser& p, Grammar& g, SceneDesc&) { g.set_default(p); }},
    StatementEntry{Keyword::kFog, [](Parser& p, Grammar& g, SceneDesc& s) {
                     s.fogs.push_back(parse_fog(p, g.context()));
                   }},
    StatementEntry{Keyword::kGlobalSettings, [](Parser& p, Grammar& g, SceneDesc& s) {
                     parse_global_settings(p, g.context(), s.global);
                   }},
    StatementEntry{Keyword::kMaxIntersections,
                   [](Parser& p, Grammar&, SceneDesc&) { (void)p.parse_float(); }},
    StatementEntry{Keyword::kMaxTraceLevel,
                   [](Parser& p, Grammar&, SceneDesc& s) { parse_max_trace_level(p, s.global); }},
    StatementEntry{Keyword::kMedia, [](Parser& p, Grammar& g, SceneDesc& s) {
                     s.atmosphere_media.push_back(parse_media(p, g.context().materials));
                   }},
    StatementEntry{Keyword::kRainbow, [](Parser& p, Grammar& g, SceneDesc& s) {
                     s.rainbows.push_back(parse_rainbow(p, g.context()));
                   }},
    StatementEntry{Keyword::kSkySphere, read_sky_sphere},
};

/// One statement of the scene.
void read_statement(Parser& parser, Grammar& grammar, SceneDesc& scene) {
  if (const StatementEntry* entry = find_entry(kStatements, parser.peek())) {
    parser.next();
    entry->read(parser, grammar, scene);
    return;
  }
  Ref<ObjectDesc> object = accept_object(parser, grammar.context());
  if (!object) {
    parser.fail_expected("an object or a statement: one of " + word_list(kStatements) + ", " +
                         object_words());
  }
  scene.objects.push_back({std::move(object), grammar.context().materials.default_texture});
  // A semicolon behind an object is an error in stock; it harms nobody. Looking for it comes last:
  // it runs the directives that follow.
  parser.accept(Punct::kSemicolon);
}

}  // namespace

SceneDesc parse_scene(Parser& parser, Grammar& grammar) {
  SceneDesc scene;
  while (!parser.at_end()) read_statement(parser, grammar, scene);
  scene.language_version = rendered_version(parser);
  return scene;
}

}  // namespace lentray::parser
