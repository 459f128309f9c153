#include "parser/grammar/scene.h"

#include "parser/descriptions/soundness.h"
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

/// A setting that stands as a statement.
void warn_of_setting(Parser& parser, const char* word, int since) {
  if (parser.language_version() < since) return;
  parser.warn(std::string(word) + " belongs in global_settings");
}

constexpr std::array kStatements{
    StatementEntry{Keyword::kBackground, read_background},
    StatementEntry{Keyword::kCamera, read_camera},
    StatementEntry{Keyword::kDefault, [](Parser& p, Grammar& g, SceneDesc&) { g.set_default(p); }},
    StatementEntry{
        Keyword::kFog,
        [](Parser& p, Grammar& g, SceneDesc& s) { s.fogs.push_back(parse_fog(p, g.context())); }},
    StatementEntry{Keyword::kGlobalSettings,
                   [](Parser& p, Grammar& g, SceneDesc& s) {
                     parse_global_settings(p, g.context(), s.global);
                   }},
    StatementEntry{Keyword::kMaxIntersections,
                   [](Parser& p, Grammar&, SceneDesc&) {
                     (void)p.parse_float();
                     warn_of_setting(p, "max_intersections", 370);
                   }},
    StatementEntry{Keyword::kMaxTraceLevel,
                   [](Parser& p, Grammar&, SceneDesc& s) {
                     warn_of_setting(p, "max_trace_level", 300);
                     parse_max_trace_level(p, s.global);
                   }},
    StatementEntry{Keyword::kMedia,
                   [](Parser& p, Grammar& g, SceneDesc& s) {
                     s.atmosphere_media.push_back(parse_media(p, g.context().materials));
                   }},
    StatementEntry{Keyword::kRainbow,
                   [](Parser& p, Grammar& g, SceneDesc& s) {
                     s.rainbows.push_back(parse_rainbow(p, g.context()));
                   }},
    StatementEntry{Keyword::kSkySphere, read_sky_sphere},
};

/// One statement of the scene.
void read_statement(Parser& parser, Grammar& grammar, SceneDesc& scene) {
  if (const StatementEntry* entry = find_entry<kStatements>(parser.peek())) {
    parser.next();
    entry->read(parser, grammar, scene);
    return;
  }
  Ref<ObjectDesc> object = accept_object(parser, grammar.context());
  if (!object) {
    parser.fail_expected("an object or a statement: one of " + word_list(kStatements) + ", " +
                         object_words());
  }
  const Context& context = grammar.context();
  const Ref<TextureDesc>& default_texture = context.materials.default_texture;
  if (parser.options().only_check && is_sound(*object, default_texture)) {
    ++scene.dropped;
    object.reset();
  } else {
    scene.objects.push_back({std::move(object), default_texture, context.default_importance});
  }
  // A semicolon behind an object is an error in stock; it harms nobody. Looking for it comes last:
  // it runs the directives that follow.
  parser.accept(Punct::kSemicolon);
}

void warn_about_version(Parser& parser) {
  Diagnostics& diagnostics = parser.diagnostics();
  if (!parser.language_version_set()) {
    diagnostics.warn({},
                     "the scene has no #version: it is read with today's grammar and rendered as "
                     "one from before 3.7");
  } else if (!parser.has_own_version()) {
    diagnostics.warn({}, "the scene has no #version of its own: its include files leave it at " +
                             std::to_string(parser.language_version() / 100) + "." +
                             std::to_string(parser.language_version() % 100 / 10));
  } else if (parser.is_version_late()) {
    diagnostics.warn({},
                     "the #version of the scene stands behind other declarations: they were "
                     "read with another one");
  }
  if (parser.language_version() <= 310) {
    diagnostics.warn({},
                     "the scene ends with a #version of 3.1 or earlier: faults of those programs "
                     "are not imitated");
  }
}

}  // namespace

SceneDesc parse_scene(Parser& parser, Grammar& grammar) {
  SceneDesc scene;
  while (!parser.at_end()) {
    parser.stop_if_asked();
    read_statement(parser, grammar, scene);
  }
  if (scene.objects.empty() && scene.dropped == 0) parser.warn("there are no objects in the scene");
  scene.language_version = rendered_version(parser);
  scene.deepest = parser.deepest();
  if (scene.global.radiosity) {
    scene.global.radiosity->default_importance = grammar.context().default_importance;
  }
  warn_about_version(parser);
  return scene;
}

}  // namespace lentray::parser
